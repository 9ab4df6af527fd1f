// Every model of the registry on arrays, for one instruction set. Compiled once for each, with FRESNEL_ISA_NAMESPACE,
// FRESNEL_ISA_LANES, FRESNEL_ISA_BATCHES (how many batches are computed side by side; FRESNEL_ISA_EXACT_BATCHES of the
// exact models and a few more, FRESNEL_ISA_LONG_BATCHES of gulbrandsen, FRESNEL_ISA_POWER_BATCHES of those with pow,
// FRESNEL_ISA_ANGLES in a spectral table) and FRESNEL_ISA_KERNELS (the name of its table) set, and FRESNEL_ISA_IN_HALVES
// where exact models are to be taken in two halves. No function of the standard library may be called here: see simd.hpp.

#include "batch/kernels.hpp"

#include <fresnel/models.hpp>
#include <fresnel/types/halved.hpp>
#include <fresnel/types/wide.hpp>

namespace fresnel {
inline namespace FRESNEL_ISA_NAMESPACE {
namespace {

using single = batch<float, FRESNEL_ISA_LANES>;

/// How many batches a model's kernel computes side by side: of the exact models, whose roots and divisions wait for each
/// other, many, as of three more whose steps do, and of one so short that the loop around it counts; more of gulbrandsen,
/// which takes two roots and ends in one of them; of conductor_precise, which has work besides, and of others as many as the
/// registers hold, which with the steps of pow are few.
template <class Row>
consteval int side_by_side(const Row& row) {
    if (row.name == "gulbrandsen") return FRESNEL_ISA_LONG_BATCHES;
    if (row.name == "conductor_precise") return FRESNEL_ISA_BATCHES;
    if (row.kind == model_kind::exact || row.parameters.empty()) return FRESNEL_ISA_EXACT_BATCHES;
    for (const std::string_view name : {"powers_3_6_9", "schlick_internal", "spherical_gaussian"})
        if (row.name == name) return FRESNEL_ISA_EXACT_BATCHES;
    for (const parameter& p : row.parameters)
        if (p.name == "power" || p.name == "alpha") return FRESNEL_ISA_POWER_BATCHES;
    return FRESNEL_ISA_BATCHES;
}

/// How many of those batches take their roots by products, beside the divider: one of four where everything waits for it,
/// as in models of one root and two divisions.
template <class Row>
consteval int roots_by_products(const Row& row) {
    return row.name == "dielectric" || row.name == "dielectric_fast" || row.name == "schlick_internal";
}

/// Where a model is cut in two: the exact ones but the cheapest, where registers are few. What the second half takes over
/// is by measurement; all else that it needs of the first, it computes again.
template <class Row>
consteval cut where_cut([[maybe_unused]] const Row& row) {
#ifdef FRESNEL_ISA_IN_HALVES
    if (row.name == "conductor") return {4, {"E", "Z", "t0", "A"}};
    if (row.name == "conductor_fast") return {2, {"t0", "A"}};
    if (row.name == "conductor_precise") return {4, {"E", "q2", "N", "A"}};
    if (row.name == "dielectric") return {2, {"E", "g"}};
#endif
    return {};
}

/// How far ahead of its use memory is asked for an input: 1 KiB, by measurement.
constexpr std::size_t values_ahead = 256;

template <int n>
FRESNEL_INLINE bool all_arrays(const batch_argument* inputs) {
    bool all = true;
    for (int k = 0; k < n; ++k)
        all = all && inputs[k].stride != 0;
    return all;
}

/// Where the values of a call lie, known when its loop is compiled: a test in it costs cheap models more than memory does.
enum class reach {
    caches,
    memory,  ///< results are written past the caches
    fetched, ///< likewise, and memory is asked for the inputs, all arrays, before they are read
};

/// The arrays of a call, at the place its loop has reached, which goes `step` values on at a time and reads `ahead` of them.
/// Where none of the inputs is a single value (`arrays`), their steps are known, which spares cheap models registers.
template <class value, int step, int ahead, int inputs, int outputs, bool arrays, reach values>
class place {
public:
    FRESNEL_INLINE explicit place(const kernel_call& call) : end_(call.outputs[0] + call.end) {
        for (int k = 0; k < inputs; ++k) {
            const auto [data, stride] = call.inputs[k];
            in_[k] = data + call.begin * stride;
            steps_[k] = arrays || stride ? std::size_t{step * value::size} : 0;
            if constexpr (!arrays)
                if (stride == 0) {
                    for (int n = 0; n < ahead; ++n)
                        value::broadcast(*data).store(repeated_[k] + n * value::size);
                    in_[k] = repeated_[k];
                }
        }
        for (int k = 0; k < outputs; ++k)
            out_[k] = call.outputs[k] + call.begin;
    }
    place(const place&) = delete; // in_ may point into it

    /// Whether exactly n are left, each of value::size values.
    FRESNEL_INLINE bool left(int n) const { return out_[0] + n * value::size == end_; }
    /// Reads the inputs of those n on from here.
    FRESNEL_INLINE void load(value* x, int n = 0) const {
        for (int k = 0; k < inputs; ++k)
            x[k] = value::load(in_[k] + n * value::size);
    }
    /// Asks memory for inputs that will be read.
    FRESNEL_INLINE void fetch(int n = 0) const {
        if constexpr (values == reach::fetched)
            for (int k = 0; k < inputs; ++k)
                for (int l = 0; l < value::size; l += 16) // a cache line has 16 values
                    __builtin_prefetch(in_[k] + n * value::size + values_ahead + l);
    }
    FRESNEL_INLINE void store(const value* y, int n = 0) const {
        for (int k = 0; k < outputs; ++k) {
            if constexpr (values == reach::caches)
                y[k].store(out_[k] + n * value::size);
            else
                y[k].store_past_caches(out_[k] + n * value::size);
        }
    }
    FRESNEL_INLINE void advance() {
        for (int k = 0; k < inputs; ++k)
            in_[k] += steps_[k];
        for (int k = 0; k < outputs; ++k)
            out_[k] += step * value::size;
    }

private:
    const float* in_[inputs];
    std::size_t steps_[inputs];
    float repeated_[arrays ? 1 : inputs][arrays ? 1 : ahead * value::size];
    float* out_[outputs];
    const float* end_;
};

/// How the loop of a call evaluates: f(inputs, outputs) for a value at a time.
template <class value, class F>
struct whole {
    F f;

    template <int inputs, int outputs, bool arrays, reach values>
    FRESNEL_INLINE void loop(const kernel_call& call) const {
        place<value, 1, 1, inputs, outputs, arrays, values> at(call);
        while (!at.left(0)) {
            value x[inputs], y[outputs];
            at.fetch();
            at.load(x);
            f(x, y);
            at.store(y);
            at.advance();
        }
    }
};

/// A half of f(inputs, outputs), a model that is cut: the first leaves what it keeps, and no results.
template <bool second, class Cut, class V, int inputs, int outputs, class F>
FRESNEL_INLINE void take_half(const F& f, const V (&inputs_of)[inputs], kept_of<V, Cut>& kept,
                              V (&results)[outputs]) {
    using number = halved<V, Cut, second>;
    kept_of<V, Cut> mine; // known to nothing else, so that it stays in registers
    if constexpr (second) mine = kept;
    number x[inputs], y[outputs];
    for (int k = 0; k < inputs; ++k)
        x[k] = number(inputs_of[k], mine);
    f(x, y);
    if constexpr (!second) kept = mine;
    if constexpr (second)
        for (int k = 0; k < outputs; ++k)
            results[k] = y[k].value();
}

/// Or f in two halves, the first for the next values before the second for these: of `batches` V in turn.
template <class V, int batches, class Cut, class F>
struct in_halves {
    F f;

    /// The half of f for those n on from here.
    template <bool second, int inputs, int outputs, class Place>
    FRESNEL_INLINE void take(const Place& at, int n, kept_of<V, Cut>& kept) const {
        V x[inputs], y[outputs];
        at.load(x, n);
        take_half<second, Cut>(f, x, kept, y);
        if constexpr (second) at.store(y, n);
    }

    template <int inputs, int outputs, bool arrays, reach values>
    FRESNEL_INLINE void loop(const kernel_call& call) const {
        place<V, batches, 2 * batches, inputs, outputs, arrays, values> at(call);
        if (at.left(0)) return;
        kept_of<V, Cut> these[batches];
        each_of<batches>([&](int j) FRESNEL_INLINE_LAMBDA { take<false, inputs, outputs>(at, j, these[j]); });
        while (!at.left(batches)) {
            each_of<batches>([&](int j) FRESNEL_INLINE_LAMBDA {
                kept_of<V, Cut> next;
                at.fetch(batches + j);
                take<false, inputs, outputs>(at, batches + j, next);
                take<true, inputs, outputs>(at, j, these[j]);
                these[j] = next;
            });
            at.advance();
        }
        each_of<batches>([&](int j) FRESNEL_INLINE_LAMBDA { take<true, inputs, outputs>(at, j, these[j]); });
    }
};

/// Runs the loop of a call.
template <int inputs, int outputs, bool arrays = false, class Evaluation>
FRESNEL_INLINE void run(const kernel_call& call, const Evaluation& evaluation) {
    if (!call.past_caches) return evaluation.template loop<inputs, outputs, arrays, reach::caches>(call);
    if (!arrays || !call.fetch_ahead)
        evaluation.template loop<inputs, outputs, arrays, reach::memory>(call);
    else if constexpr (arrays)
        evaluation.template loop<inputs, outputs, arrays, reach::fetched>(call);
    lanes::fence();
}

/// The model in row i of the registry.
template <std::size_t i>
struct row_at {
    static constexpr const auto& row = std::get<i>(registry);
    static constexpr int parameters = static_cast<int>(row.parameters.size());
    static constexpr bool polarised = row.kind == model_kind::exact;
    static constexpr cut place = where_cut(row);
    /// What it is computed with, and how many values are at a time.
    using number = wide<single, side_by_side(row), roots_by_products(row)>;
    static constexpr int size = number::size;

    template <class T>
    FRESNEL_INLINE static auto result(const T* x, const T& cos_i) {
        return [&]<std::size_t... k>(std::index_sequence<k...>) {
            return row.evaluate(x[k]..., cos_i);
        }(std::make_index_sequence<static_cast<std::size_t>(parameters)>{});
    }
    template <class F>
    FRESNEL_INLINE static auto evaluation(const F& f) {
        if constexpr (place.size > 0)
            return in_halves<single, side_by_side(row), row_at, F>{f};
        else
            return whole<number, F>{f};
    }
};

/// Runs f over a call, with the loop of those whose steps are known where they are.
template <std::size_t i, int inputs, int outputs, class F>
FRESNEL_INLINE void run_any(const kernel_call& call, const F& f) {
    if (all_arrays<inputs>(call.inputs))
        run<inputs, outputs, true>(call, row_at<i>::evaluation(f));
    else
        run<inputs, outputs>(call, row_at<i>::evaluation(f));
}

/// Runs f(result, outputs) with what the model of a row gives. Where the medium outside is vacuum, n_i = 1 for all of
/// a call, multiplications by it are left out, which changes no bit.
template <std::size_t i, int outputs, class F>
FRESNEL_INLINE void run_row(const kernel_call& call, F f) {
    using row = row_at<i>;
    constexpr int n = row::parameters;
    const auto evaluate = [=](const auto* x, auto* y) { f(row::result(x, x[n]), y); };
    if constexpr (!row::polarised) {
        run_any<i, n + 1, outputs>(call, evaluate);
    } else if (call.inputs[0].stride == 0 && *call.inputs[0].data == 1) {
        kernel_call of_vacuum = call;
        ++of_vacuum.inputs;
        run_any<i, n, outputs>(of_vacuum, [=]<class T>(const T* x, T* y) {
            T all[n + 1];
            all[0] = 1;
            for (int k = 0; k < n; ++k)
                all[k + 1] = x[k];
            evaluate(all, y);
        });
    } else {
        run<n + 1, outputs>(call, row::evaluation(evaluate));
    }
}

template <std::size_t i>
[[gnu::flatten]] void reflectance(const kernel_call& call) {
    run_row<i, 1>(call, [](const auto& result, auto* y) { y[0] = reflectance(result); });
}

/// The channels are independent of each other already: one batch of each.
template <std::size_t i>
[[gnu::flatten]] void rgb(const kernel_call& call) {
    using row = row_at<i>;
    constexpr int n = row::parameters;
    const auto evaluate = [](const single* x, single* y) {
        for (int channel = 0; channel < 3; ++channel)
            y[channel] = reflectance(row::result(x + channel * n, x[3 * n]));
    };
    run<3 * n + 1, 3>(call, whole<single, decltype(evaluate)>{evaluate});
}

template <std::size_t i>
[[gnu::flatten]] void polarised(const kernel_call& call) {
    run_row<i, 2>(call, [](const auto& result, auto* y) { y[0] = result.R_s, y[1] = result.R_p; });
}

template <std::size_t i>
[[gnu::flatten]] void powers(const kernel_call& call) {
    run_row<i, 4>(call, [](const auto& result, auto* y) {
        y[0] = result.R_s, y[1] = result.R_p;
        y[2] = result.T_s, y[3] = result.T_p;
    });
}

template <std::size_t i>
constexpr model_kernels kernels_of() {
    constexpr std::size_t lanes = row_at<i>::size;
    static_assert(lanes <= most_lanes && (lanes & (lanes - 1)) == 0);
    if constexpr (row_at<i>::polarised)
        return {lanes, &reflectance<i>, &rgb<i>, &polarised<i>, &powers<i>};
    else
        return {lanes, &reflectance<i>, &rgb<i>, nullptr, nullptr};
}

template <class>
struct table;

template <std::size_t... i>
struct table<std::index_sequence<i...>> {
    static constexpr model_kernels rows[] = {kernels_of<i>()...};
};

using every_model = table<std::make_index_sequence<std::tuple_size_v<decltype(registry)>>>;

struct spectral_cut {
    static constexpr cut place{2, {"t0", "A"}};
};

/// A spectral table, many angles at a time, which share what depends on the wavelength alone: of each the first half for the
/// next wavelength before the second for this.
[[gnu::flatten]] void spectral(const spectral_call& call) {
    constexpr int batches = FRESNEL_ISA_ANGLES;
    using kept_values = kept_of<single, spectral_cut>;
    for (std::size_t begin = 0; begin < call.angles; begin += batches * single::size) {
        single sum[batches][3];
        kept_values these[batches];
        const auto take = [&]<bool second>(std::size_t i, int j, kept_values& kept) FRESNEL_INLINE_LAMBDA {
            using number = halved<single, spectral_cut, second>;
            kept_values mine;
            if constexpr (second) mine = kept;
            const number n_i(single::broadcast(call.n_i), mine);
            const number n_t(single::broadcast(call.n_t[i]), mine), k_t(single::broadcast(call.k_t[i]), mine);
            const number cos_i(single::load(call.cos_i + begin + j * single::size), mine);
            const single R = conductor(n_i, n_t, k_t, cos_i).reflectance().value();
            if constexpr (!second) kept = mine;
            return R;
        };
        const auto add = [&](std::size_t i, int j) FRESNEL_INLINE_LAMBDA {
            const single R = take.template operator()<true>(i, j, these[j]);
            for (int channel = 0; channel < 3; ++channel)
                sum[j][channel] = sum[j][channel] + single::broadcast(call.weights[channel][i]) * R;
        };
        each_of<batches>([&](int j) FRESNEL_INLINE_LAMBDA {
            for (single& channel : sum[j])
                channel = 0;
            if (call.wavelengths > 0) take.template operator()<false>(0, j, these[j]);
        });
        std::size_t i = 0;
        for (; i + 1 < call.wavelengths; ++i)
            each_of<batches>([&](int j) FRESNEL_INLINE_LAMBDA {
                kept_values next;
                take.template operator()<false>(i + 1, j, next);
                add(i, j);
                these[j] = next;
            });
        if (call.wavelengths > 0) each_of<batches>([&](int j) FRESNEL_INLINE_LAMBDA { add(i, j); });
        each_of<batches>([&](int j) FRESNEL_INLINE_LAMBDA {
            for (int channel = 0; channel < 3; ++channel)
                sum[j][channel].store(call.rgb[channel] + begin + j * single::size);
        });
    }
}

} // namespace
} // namespace FRESNEL_ISA_NAMESPACE

static_assert(FRESNEL_ISA_ANGLES * single::size <= most_lanes);

kernel_table FRESNEL_ISA_KERNELS() {
    return {every_model::rows, std::size_t{FRESNEL_ISA_ANGLES} * single::size, &spectral};
}

} // namespace fresnel
