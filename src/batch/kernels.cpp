// Every model of the registry on arrays, for one instruction set. Compiled once for each, with FRESNEL_ISA_NAMESPACE,
// FRESNEL_ISA_LANES, FRESNEL_ISA_BATCHES (how many batches are computed side by side; FRESNEL_ISA_EXACT_BATCHES of the
// exact models and a few more, FRESNEL_ISA_LONG_BATCHES of gulbrandsen, FRESNEL_ISA_POWER_BATCHES of those with pow,
// FRESNEL_ISA_ANGLES in a spectral table) and FRESNEL_ISA_KERNELS (the name of its table) set. No function of the standard
// library may be called here: see simd.hpp.

#include "batch/kernels.hpp"

#include <fresnel/models.hpp>
#include <fresnel/types/wide.hpp>

namespace fresnel {
inline namespace FRESNEL_ISA_NAMESPACE {
namespace {

using single = batch<float, FRESNEL_ISA_LANES>;

/// How many batches a model's kernel computes side by side: of the exact models, whose roots and divisions wait for each
/// other, many, as of two more whose steps do, and of one so short that the loop around it counts; more of gulbrandsen,
/// which takes two roots and ends in one of them; of others as many as the registers hold, which with the steps of pow
/// are few.
template <class Row>
consteval int side_by_side(const Row& row) {
    if (row.name == "gulbrandsen") return FRESNEL_ISA_LONG_BATCHES;
    if (row.kind == model_kind::exact || row.parameters.empty()) return FRESNEL_ISA_EXACT_BATCHES;
    if (row.name == "powers_3_6_9" || row.name == "spherical_gaussian") return FRESNEL_ISA_EXACT_BATCHES;
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

/// Runs f(inputs, outputs) over the arrays of a call, a value at a time. Where none of the inputs is a single value
/// (`arrays`), their steps are known, which spares cheap models registers.
template <class value, int inputs, int outputs, bool arrays, reach values, class F>
FRESNEL_INLINE void loop(const kernel_call& call, F f) {
    const float* in[inputs];
    std::size_t steps[inputs];
    float repeated[arrays ? 1 : inputs][value::size];
    float* out[outputs];
    for (int k = 0; k < inputs; ++k) {
        const auto [data, stride] = call.inputs[k];
        in[k] = data + call.begin * stride;
        steps[k] = arrays || stride ? std::size_t{value::size} : 0;
        if constexpr (!arrays)
            if (stride == 0) {
                value::broadcast(*data).store(repeated[k]);
                in[k] = repeated[k];
            }
    }
    for (int k = 0; k < outputs; ++k)
        out[k] = call.outputs[k] + call.begin;

    for (const float* const end = call.outputs[0] + call.end; out[0] != end;) {
        value x[inputs], y[outputs];
        for (int k = 0; k < inputs; ++k) {
            if constexpr (values == reach::fetched)
                for (int l = 0; l < value::size; l += 16) // a cache line has 16 values
                    __builtin_prefetch(in[k] + values_ahead + l);
            x[k] = value::load(in[k]);
            in[k] += steps[k];
        }
        f(x, y);
        for (int k = 0; k < outputs; ++k) {
            if constexpr (values == reach::caches)
                y[k].store(out[k]);
            else
                y[k].store_past_caches(out[k]);
            out[k] += value::size;
        }
    }
    if constexpr (values != reach::caches) lanes::fence();
}

template <class value, int inputs, int outputs, bool arrays = false, class F>
FRESNEL_INLINE void run(const kernel_call& call, F f) {
    if (!call.past_caches)
        loop<value, inputs, outputs, arrays, reach::caches>(call, f);
    else if (!arrays || !call.fetch_ahead)
        loop<value, inputs, outputs, arrays, reach::memory>(call, f);
    else if constexpr (arrays)
        loop<value, inputs, outputs, arrays, reach::fetched>(call, f);
}

/// The model in row i of the registry on `value`, a number type of several lanes.
template <std::size_t i, class value>
struct row_at {
    using number = value;
    static constexpr const auto& row = std::get<i>(registry);
    static constexpr int parameters = static_cast<int>(row.parameters.size());
    static constexpr bool polarised = row.kind == model_kind::exact;

    FRESNEL_INLINE static auto result(const value* x, const value& cos_i) {
        return [&]<std::size_t... k>(std::index_sequence<k...>) {
            return row.evaluate(x[k]..., cos_i);
        }(std::make_index_sequence<static_cast<std::size_t>(parameters)>{});
    }
};

template <std::size_t i>
using wide_row =
    row_at<i, wide<single, side_by_side(std::get<i>(registry)), roots_by_products(std::get<i>(registry))>>;

/// `run`, with the loop of those whose steps are known where they are.
template <class value, int inputs, int outputs, class F>
FRESNEL_INLINE void run_any(const kernel_call& call, F f) {
    if (all_arrays<inputs>(call.inputs))
        run<value, inputs, outputs, true>(call, f);
    else
        run<value, inputs, outputs>(call, f);
}

/// Runs f(result, outputs) with what the model of a row gives. Where the medium outside is vacuum, n_i = 1 for all of
/// a call, multiplications by it are left out, which changes no bit.
template <std::size_t i, int outputs, class F>
FRESNEL_INLINE void run_row(const kernel_call& call, F f) {
    using row = wide_row<i>;
    using value = typename row::number;
    constexpr int n = row::parameters;
    const auto evaluate = [&](const value* x, value* y) { f(row::result(x, x[n]), y); };
    if constexpr (!row::polarised) {
        run_any<value, n + 1, outputs>(call, evaluate);
    } else if (call.inputs[0].stride == 0 && *call.inputs[0].data == 1) {
        kernel_call of_vacuum = call;
        ++of_vacuum.inputs;
        run_any<value, n, outputs>(of_vacuum, [&](const value* x, value* y) {
            value all[n + 1];
            all[0] = 1;
            for (int k = 0; k < n; ++k)
                all[k + 1] = x[k];
            evaluate(all, y);
        });
    } else {
        run<value, n + 1, outputs>(call, evaluate);
    }
}

template <std::size_t i>
[[gnu::flatten]] void reflectance(const kernel_call& call) {
    run_row<i, 1>(call, [](const auto& result, auto* y) { y[0] = reflectance(result); });
}

/// The channels are independent of each other already: one batch of each.
template <std::size_t i>
[[gnu::flatten]] void rgb(const kernel_call& call) {
    using row = row_at<i, single>;
    constexpr int n = row::parameters;
    run<single, 3 * n + 1, 3>(call, [](const single* x, single* y) {
        for (int channel = 0; channel < 3; ++channel)
            y[channel] = reflectance(row::result(x + channel * n, x[3 * n]));
    });
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
    constexpr std::size_t lanes = wide_row<i>::number::size;
    static_assert(lanes <= most_lanes && (lanes & (lanes - 1)) == 0);
    if constexpr (wide_row<i>::polarised)
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

/// A spectral table, many angles at a time: they share what depends on the wavelength alone.
[[gnu::flatten]] void spectral(const spectral_call& call) {
    using angles = wide<single, FRESNEL_ISA_ANGLES>;
    const angles n_i = angles::broadcast(call.n_i);
    for (std::size_t begin = 0; begin < call.angles; begin += angles::size) {
        const angles cos_i = angles::load(call.cos_i + begin);
        angles sum[3] = {0, 0, 0};
        for (std::size_t i = 0; i < call.wavelengths; ++i) {
            const angles n_t = angles::broadcast(call.n_t[i]), k_t = angles::broadcast(call.k_t[i]);
            const angles R = conductor(n_i, n_t, k_t, cos_i).reflectance();
            for (int channel = 0; channel < 3; ++channel)
                sum[channel] = sum[channel] + angles::broadcast(call.weights[channel][i]) * R;
        }
        for (int channel = 0; channel < 3; ++channel)
            sum[channel].store(call.rgb[channel] + begin);
    }
}

} // namespace
} // namespace FRESNEL_ISA_NAMESPACE

static_assert(FRESNEL_ISA_ANGLES * single::size <= most_lanes);

kernel_table FRESNEL_ISA_KERNELS() {
    return {every_model::rows, std::size_t{FRESNEL_ISA_ANGLES} * single::size, &spectral};
}

} // namespace fresnel
