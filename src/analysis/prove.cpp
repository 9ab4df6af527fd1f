#include "analysis/prove.hpp"

#include "analysis/conductor_enclosure.hpp"
#include "analysis/fit.hpp"
#include "analysis/measure.hpp"
#include "analysis/multi.hpp"

#include <fresnel/models.hpp>
#include <fresnel/types/dual.hpp>
#include <fresnel/types/interval.hpp>
#include <fresnel/types/rounding.hpp>

#include <fmt/format.h>

#include <array>
#include <atomic>
#include <cmath>
#include <future>
#include <queue>
#include <random>
#include <thread>

namespace fresnel {

namespace {

// ---- branch and bound -------------------------------------------------------------------------------------

template <std::size_t D>
using box = std::array<interval, D>;

template <std::size_t D>
std::array<interval, D> middle_of(const box<D>& b) {
    std::array<interval, D> m;
    for (std::size_t i = 0; i < D; ++i)
        m[i] = interval(b[i].middle());
    return m;
}

/// An enclosure of f over a box and at its middle, and the dimension along which to split it.
struct estimate {
    interval value, centre;
    std::size_t widest;
};

/// Natural intervals intersected with the mean value form f(m) + f'(box) (box - m), where the slope is bounded.
template <std::size_t D, class F>
estimate enclose_over(const F& f, const box<D>& b) {
    using number = dual<interval, static_cast<int>(D)>;
    std::array<number, D> x;
    for (std::size_t i = 0; i < D; ++i)
        x[i] = number::variable(b[i], static_cast<int>(i));
    bool first = true;
    number over;
    for_each_branch([&] { return f(x); },
                    [&](const number& one) {
                        if (first) over = one;
                        over.value = hull(over.value, one.value);
                        for (std::size_t i = 0; i < D; ++i)
                            over.d[i] = hull(over.d[i], one.d[i]);
                        first = false;
                    });
    const interval centre = enclose([&] { return f(middle_of(b)); });
    interval centred = centre;
    std::size_t widest = 0;
    double most = -1;
    for (std::size_t i = 0; i < D; ++i) {
        const interval move = over.d[i] * (b[i] - interval(b[i].middle()));
        centred = centred + move;
        const double size = std::isfinite(move.width()) ? move.width() : 1e9 * b[i].width();
        if (size > most) most = size, widest = i;
    }
    const bool bounded = std::isfinite(centred.lo) && std::isfinite(centred.hi);
    return {bounded ? intersection(over.value, centred) : over.value, centre, widest};
}

template <std::size_t D>
struct maximum {
    certified value;
    std::array<double, D> at;
};

/// The largest |f| over a box, enclosed to within `width`; boxes that cannot reach `floor` are not looked into.
template <std::size_t D, class F>
maximum<D> largest_over(const F& f, const box<D>& whole, double width, double floor = 0) {
    struct candidate {
        box<D> b;
        double upper;
        std::size_t widest;
        bool operator<(const candidate& other) const { return upper < other.upper; }
    };
    maximum<D> best{{floor, floor}, {}};
    std::priority_queue<candidate> open;
    const auto add = [&](const box<D>& b) {
        const estimate e = enclose_over(f, b);
        if (e.centre.mignitude() > best.value.lo) {
            best.value.lo = e.centre.mignitude();
            for (std::size_t i = 0; i < D; ++i)
                best.at[i] = b[i].middle();
        }
        if (e.value.magnitude() > best.value.lo) open.push({b, e.value.magnitude(), e.widest});
    };
    add(whole);
    for (int steps = 0; !open.empty() && open.top().upper > best.value.lo + width; ++steps) {
        if (steps > 4'000'000) break;
        const candidate c = open.top();
        open.pop();
        box<D> half = c.b;
        const interval side = c.b[c.widest];
        half[c.widest] = interval::between(side.lo, side.middle());
        add(half);
        half[c.widest] = interval::between(side.middle(), side.hi);
        add(half);
    }
    best.value.hi = open.empty() ? best.value.lo : std::max(open.top().upper, best.value.lo);
    return best;
}

/// How narrow an enclosure is to be, of the absolute and of the relative error.
struct narrowness {
    double absolute, relative;
};
constexpr narrowness one_domain{5e-6, 1e-4}, every_metal{5e-5, 1e-3};

// ---- the domains ------------------------------------------------------------------------------------------

/// f0 of an index, and what is left of a model with f0 as its one free parameter.
template <class T, class Row>
T of_f0(const Row& row, T f0, T cos_i) {
    std::array<T, std::tuple_size_v<decltype(row.parameters)>> values;
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = i == 0 ? f0 : T(static_cast<int>(row.parameters[i].default_value));
    return reflectance(evaluate(row, values, cos_i));
}

template <class T>
T exact_dielectric(T eta, T c) {
    return dielectric_fast(T(1), eta, c).reflectance();
}

template <std::size_t D, class Model, class Exact>
certificate certify(const Model& model, const Exact& exact, const box<D>& where,
                    const std::array<const char*, D>& names) {
    const auto error = [&](const auto& x) { return model(x) - exact(x); };
    const auto relative = [&](const auto& x) { return model(x) / exact(x) - 1; };
    const maximum<D> absolute = largest_over(error, where, one_domain.absolute);
    certificate result{};
    result.absolute = absolute.value, result.proved = true;
    result.relative = largest_over(relative, where, one_domain.relative).value;
    for (std::size_t i = 0; i < D; ++i)
        result.at.emplace_back(names[i], absolute.at[i]);
    return result;
}

const interval any_cosine = interval::between(0, 1);

/// At eta = 1 nothing is reflected. A model that stays above some number at 60 degrees as eta comes near 1 is therefore
/// wrong by more than any factor.
template <class Row>
bool unbounded_near_match(const Row& row) {
    const interval near = interval::between(1, 1 + 0x1p-20);
    return of_f0(row, normal_reflectance(interval(1), near, interval(0)), ratio<interval, 1, 2>()).lo > 0;
}

template <class Row>
certificate over_gems(const Row& row) {
    certificate result = certify<2>(
        [&](const auto& x) {
            return of_f0(row, normal_reflectance(decltype(x[0] + x[0])(1), x[0], decltype(x[0] + x[0])(0)),
                         x[1]);
        },
        [](const auto& x) { return exact_dielectric(x[0], x[1]); }, {interval::between(1.3, 2.5), any_cosine},
        {"eta", "cos_i"});
    result.unbounded_near_match = unbounded_near_match(row);
    return result;
}

template <class T>
T constant_of(double value) {
    if constexpr (std::is_same_v<T, interval>)
        return interval(value);
    else
        return T::constant(interval(value));
}

template <class Row>
certificate over_indices(const Row& row) {
    return certify<3>([&](const auto& x) { return reflectance(evaluate(row, std::array{x[0], x[1]}, x[2])); },
                      [](const auto& x) { return conductor_over(x[0], x[1], x[2]); },
                      {interval::between(0.1, 4), interval::between(1, 8), any_cosine}, {"n", "k", "cos_i"});
}

/// Schlick from inside by the cosine outside. R(theta_i, eta) = R(theta_t, 1 / eta), f0 is the same from either side,
/// and beyond the critical angle model and exact are both 1: the error is that of `schlick` at cos_t.
certificate over_internal_gems() {
    certificate result = prove("schlick");
    result.at[0].first = "1/eta", result.at[1].first = "cos_t";
    return result;
}

/// Every metal by itself, with the parameters fitted to it; only the worst is enclosed narrowly.
template <class Row>
certificate over_metals(const Row& row) {
    certificate result{};
    double relative_lo = 0, relative_hi = 0;
    for (const metal_sample& metal : metal_samples()) {
        const parameters fitted = fit(row.name, channel_of(metal.index));
        const auto model = [&](const auto& x) {
            using T = std::remove_cvref_t<decltype(x[0])>;
            std::array<T, std::tuple_size_v<decltype(row.parameters)>> values;
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = constant_of<T>(fitted[i]);
            return reflectance(evaluate(row, values, x[0]));
        };
        const auto exact = [&](const auto& x) {
            using T = std::remove_cvref_t<decltype(x[0])>;
            return conductor_over(constant_of<T>(metal.index.n), constant_of<T>(metal.index.k), x[0]);
        };
        const auto error = [&](const auto& x) { return model(x) - exact(x); };
        const auto relative = [&](const auto& x) { return model(x) / exact(x) - 1; };
        const maximum<1> here =
            largest_over<1>(error, {any_cosine}, every_metal.absolute, result.absolute.lo);
        result.absolute.hi = std::max(result.absolute.hi, here.value.hi);
        if (here.value.lo > result.absolute.lo) {
            result.absolute.lo = here.value.lo;
            result.at = {{"cos_i", here.at[0]}};
            result.material = fmt::format("{} at {:.0f} nm", metal.name, metal.wavelength_nm);
        }
        const certified r = largest_over<1>(relative, {any_cosine}, every_metal.relative, relative_lo).value;
        relative_lo = std::max(relative_lo, r.lo), relative_hi = std::max(relative_hi, r.hi);
    }
    result.relative = certified{relative_lo, relative_hi}, result.proved = true;
    return result;
}

// ---- rounding ---------------------------------------------------------------------------------------------

/// Arguments of moderate size, beside the default.
interval moderate(const parameter& p) {
    return interval::between(std::max(p.min, p.max > 10 ? 0.1 : p.min), std::min(p.max, 10.0));
}

double draw(const parameter& p, std::mt19937_64& generator) {
    std::uniform_real_distribution<double> unit(0, 1);
    const auto [lo, hi] = moderate(p);
    if (unit(generator) < 0.1) return p.default_value;
    return p.max > 10 ? lo * std::exp(unit(generator) * std::log(hi / lo)) : lo + (hi - lo) * unit(generator);
}

/// Largest |float32 - real| of a model at random and edge inputs of moderate size; the real one at 60 digits.
template <class Row>
double rounding_of(const Row& row) {
    constexpr std::size_t N = std::tuple_size_v<decltype(row.parameters)>;
    std::mt19937_64 generator(32);
    std::uniform_real_distribution<double> unit(0, 1);
    double worst = 0;
    for (int i = 0; i < 4000; ++i) {
        std::array<float, N> narrow{};
        std::array<real50, N> wide;
        for (std::size_t p = 0; p < N; ++p)
            narrow[p] = static_cast<float>(draw(row.parameters[p], generator)), wide[p] = narrow[p];
        const float c = i % 50 == 0 ? 0.0f : i % 50 == 1 ? 1.0f : static_cast<float>(unit(generator));
        const real50 truth = reflectance(evaluate(row, wide, real50(c)));
        const double miss =
            std::abs(static_cast<double>(real50(reflectance(evaluate(row, narrow, c)) - truth)));
        worst = std::max(worst, miss);
    }
    return worst;
}

/// The largest `bound` over a box, after so many halvings of the box where it is largest, each where it helps most.
template <std::size_t D, class F>
double bound_over(const F& bound, const box<D>& whole, int halvings) {
    struct part {
        box<D> b;
        double upper;
        bool operator<(const part& other) const { return upper < other.upper; }
    };
    std::priority_queue<part> open;
    open.push({whole, bound(whole)});
    for (int h = 0; h < halvings; ++h) {
        const part worst = open.top();
        open.pop();
        std::array<part, 2> best{worst, worst};
        std::pair<double, double> best_score{std::numeric_limits<double>::infinity(), 0};
        for (std::size_t i = 0; i < D; ++i) {
            std::array<part, 2> halves{worst, worst};
            halves[0].b[i].hi = halves[1].b[i].lo = worst.b[i].middle();
            for (part& half : halves)
                half.upper = bound(half.b);
            const std::pair score{std::max(halves[0].upper, halves[1].upper),
                                  -worst.b[i].width() / whole[i].width()};
            if (score < best_score) best_score = score, best = halves;
        }
        for (const part& half : best)
            open.push(half);
    }
    return open.top().upper;
}

/// What |float32 - real| never exceeds for the arguments of `rounding_of`; none for models with comparisons.
template <class Row>
std::optional<double> rounding_bound_of(const Row& row) {
    constexpr std::size_t N = std::tuple_size_v<decltype(row.parameters)>;
    box<N + 1> whole;
    for (std::size_t p = 0; p < N; ++p)
        whole[p] = hull(moderate(row.parameters[p]), interval(row.parameters[p].default_value));
    whole[N] = any_cosine;
    const auto bound = [&](const box<N + 1>& b) {
        std::array<rounding, N> values;
        for (std::size_t p = 0; p < N; ++p)
            values[p] = rounding(b[p].lo, b[p].hi);
        return reflectance(evaluate(row, values, rounding(b[N].lo, b[N].hi))).error;
    };
    try {
        return bound_over(bound, whole, 3000);
    } catch (const rounding::undecided&) {
        return std::nullopt;
    }
}

template <std::size_t i>
certificate certify_row() {
    static constexpr const auto& row = std::get<i>(registry);
    certificate result{};
    if constexpr (row.error.over == row::inside_gems)
        result = over_internal_gems();
    else if constexpr (row.error.over == row::gems)
        result = over_gems(row);
    else if constexpr (row.error.over == row::box)
        result = over_indices(row);
    else if constexpr (row.error.over == row::metals)
        result = over_metals(row);
    else
        result.absolute = {row.error.max, row.error.max}; // as the registry's test measures it
    result.model = row.name, result.domain = row.error.over;
    result.rounding_float32 = rounding_of(row), result.rounding_bound = rounding_bound_of(row);
    return result;
}

/// The certificate of the model in each row of the registry.
template <std::size_t... i>
constexpr auto certifiers(std::index_sequence<i...>) {
    return std::array{&certify_row<i>...};
}

} // namespace

bool can_prove(std::string_view over) {
    return over == row::gems || over == row::inside_gems || over == row::box || over == row::metals;
}

certificate prove(std::string_view model) {
    static constexpr auto by_row =
        certifiers(std::make_index_sequence<std::tuple_size_v<decltype(registry)>>{});
    const std::span<const model_row<double>> rows = model_table<double>();
    return by_row[static_cast<std::size_t>(&find_model<double>(model) - rows.data())]();
}

std::vector<certificate> prove_all() {
    std::vector<std::string_view> names;
    for (const model_row<double>& row : model_table<double>())
        names.push_back(row.name);
    std::vector<certificate> results(names.size());
    std::atomic<std::size_t> next = 0;
    const auto work = [&] {
        for (std::size_t i = next++; i < names.size(); i = next++)
            results[i] = prove(names[i]);
    };
    const std::size_t count = std::max(1u, std::thread::hardware_concurrency());
    std::vector<std::future<void>> workers;
    for (std::size_t i = 0; i < count; ++i)
        workers.push_back(std::async(std::launch::async, work));
    for (std::future<void>& w : workers)
        w.get();
    return results;
}

} // namespace fresnel
