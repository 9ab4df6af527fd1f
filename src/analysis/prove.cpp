#include "analysis/prove.hpp"

#include "analysis/conductor_enclosure.hpp"
#include "analysis/fit.hpp"
#include "analysis/measure.hpp"
#include "analysis/multi.hpp"
#include "error.hpp"

#include <fresnel/geometry.hpp>
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

/// Natural intervals intersected with the mean value form f(m) + f'(box) (box - m), where the slope is bounded and no
/// comparison is undecided, at which f may jump.
template <std::size_t D, class F>
estimate enclose_over(const F& f, const box<D>& b) {
    using number = dual<interval, static_cast<int>(D)>;
    std::array<number, D> x;
    for (std::size_t i = 0; i < D; ++i)
        x[i] = number::variable(b[i], static_cast<int>(i));
    int branches = 0;
    number over;
    for_each_branch([&] { return f(x); },
                    [&](const number& one) {
                        if (branches == 0) over = one;
                        over.value = hull(over.value, one.value);
                        for (std::size_t i = 0; i < D; ++i)
                            over.d[i] = hull(over.d[i], one.d[i]);
                        ++branches;
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
    const bool bounded = branches == 1 && std::isfinite(centred.lo) && std::isfinite(centred.hi);
    return {bounded ? intersection(over.value, centred) : over.value, centre, widest};
}

template <std::size_t D>
struct maximum {
    certified value;
    std::array<double, D> at;
};

/// The largest |f| over a box, enclosed to within `width`.
template <std::size_t D, class F>
maximum<D> largest_over(const F& f, const box<D>& whole, double width) {
    struct candidate {
        box<D> b;
        double upper;
        std::size_t widest;
        bool operator<(const candidate& other) const { return upper < other.upper; }
    };
    maximum<D> best{};
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
constexpr narrowness one_domain{5e-6, 1e-4}, every_material{5e-5, 1e-3};

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
T constant_of(const interval& value) {
    if constexpr (std::is_same_v<T, interval>)
        return value;
    else
        return T::constant(value);
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

/// What is certain of one material.
struct material_error {
    maximum<1> absolute;
    certified relative;
};

/// A curve over the cosine against the exact one of an index.
template <class Model>
material_error enclose_curve(const Model& model, const optical_index& index) {
    const auto exact = [&](const auto& x) {
        using T = std::remove_cvref_t<decltype(x[0])>;
        return conductor_over(constant_of<T>(interval(index.n)), constant_of<T>(interval(index.k)), x[0]);
    };
    const auto error = [&](const auto& x) { return model(x) - exact(x); };
    const auto relative = [&](const auto& x) { return model(x) / exact(x) - 1; };
    return {largest_over<1>(error, {any_cosine}, every_material.absolute),
            largest_over<1>(relative, {any_cosine}, every_material.relative).value};
}

/// The exact equations of an index so near that the difference of both curves is lost in their enclosures: the distance
/// times the slopes between the two.
material_error enclose_nearby(const complex<interval>& found, const optical_index& index, double off_n,
                              double off_k) {
    using number = dual<interval, 2>;
    material_error result{};
    constexpr int parts = 64;
    for (int i = 0; i < parts; ++i) {
        const interval c = interval::between(double(i) / parts, double(i + 1) / parts);
        const number R =
            conductor_over(number::variable(hull(found.re, interval(index.n)), 0),
                           number::variable(hull(found.im, interval(index.k)), 1), number::constant(c));
        const interval moved =
            interval(R.d[0].magnitude()) * interval(off_n) + interval(R.d[1].magnitude()) * interval(off_k);
        if (moved.hi > result.absolute.value.hi) result.absolute.value.hi = moved.hi;
        result.relative.hi = std::max(result.relative.hi, (moved / R.value).hi);
    }
    return result;
}

/// `gulbrandsen` is the exact equations of an index that its two parameters stand for; of most materials their own.
material_error enclose_gulbrandsen(const parameters& fitted, const optical_index& index) {
    const complex<interval> found = gulbrandsen_index(interval(fitted[0]), interval(fitted[1]));
    const double off_n = (found.re - interval(index.n)).magnitude(),
                 off_k = (found.im - interval(index.k)).magnitude();
    if (off_n + off_k < 1e-9) return enclose_nearby(found, index, off_n, off_k);
    return enclose_curve(
        [&](const auto& x) {
            using T = std::remove_cvref_t<decltype(x[0])>;
            return conductor_over(constant_of<T>(found.re), constant_of<T>(found.im), x[0]);
        },
        index);
}

/// A model with the parameters fitted to a material against the exact curve.
template <class Row>
material_error enclose_material(const Row& row, const parameters& fitted, const optical_index& index) {
    if (row.name == "gulbrandsen") return enclose_gulbrandsen(fitted, index);
    return enclose_curve(
        [&](const auto& x) {
            using T = std::remove_cvref_t<decltype(x[0])>;
            std::array<T, std::tuple_size_v<decltype(row.parameters)>> values;
            for (std::size_t i = 0; i < values.size(); ++i)
                values[i] = constant_of<T>(interval(fitted[i]));
            return reflectance(evaluate(row, values, x[0]));
        },
        index);
}

/// Every material by itself, with the parameters fitted to it.
template <class Row>
certificate over_materials(const Row& row, const std::vector<material_sample>& samples) {
    certificate result{};
    certified relative{};
    for (const material_sample& sample : samples) {
        const parameters fitted = fit(row.name, channel_of(sample.index));
        const material_error here = enclose_material(row, fitted, sample.index);
        certified_material one{sample.name, sample.wavelength_nm, here.absolute.value, {}};
        for (std::size_t i = 0; i < fitted.size(); ++i)
            one.at.emplace_back(row.parameters[i].name, fitted[i]);
        if (one.absolute.lo > 0) one.at.emplace_back("cos_i", here.absolute.at[0]);
        if (one.absolute.lo > result.absolute.lo) {
            result.at = one.at;
            result.material = fmt::format("{} at {:.0f} nm", sample.name, sample.wavelength_nm);
        }
        const auto enlarge = [](certified& all, const certified& with) {
            all = {std::max(all.lo, with.lo), std::max(all.hi, with.hi)};
        };
        enlarge(result.absolute, one.absolute), enlarge(relative, here.relative);
        result.materials.push_back(std::move(one));
    }
    result.relative = relative, result.proved = true;
    return result;
}

// ---- rounding ---------------------------------------------------------------------------------------------

/// The values of a parameter over which rounding is looked at: moderate ones and the default. An eta below 1 is that of
/// `inside_gems`, and r of `gulbrandsen` keeps away from 0 and 1, where its index has no digits left.
interval moderate(const parameter& p) {
    if (p.name == "eta") return interval::between(0.4, 1 / 1.3);
    if (p.name == "r") return interval::between(0.02, 0.99);
    const interval most = interval::between(std::max(p.min, p.max > 10 ? 0.1 : p.min), std::min(p.max, 10.0));
    return hull(most, interval(p.default_value));
}

/// Inputs of a model, the angle last, and |float32 - real| there.
template <std::size_t N>
struct rounding_error {
    std::array<float, N> x;
    double size;
};

/// A search for the inputs where float32 is furthest from the real value, for parameters of moderate size: random ones,
/// most of them near the ends of their ranges or of each other, at all angles and at the critical one, then climbs from
/// the worst of them.
template <class Row>
class rounding_search {
public:
    static constexpr std::size_t N = std::tuple_size_v<decltype(Row::parameters)> + 1;
    using inputs = std::array<float, N>;

    explicit rounding_search(const Row& row) : row_(row) {}

    rounding_error<N> worst() {
        constexpr std::size_t climbs = 24;
        std::vector<rounding_error<N>> found;
        for (int i = 0; i < 40'000; ++i) {
            const inputs x = drawn();
            found.push_back({x, miss<double>(x)});
        }
        const auto larger = [](const auto& a, const auto& b) { return a.size > b.size; };
        std::partial_sort(found.begin(), found.begin() + climbs, found.end(), larger);
        found.resize(climbs);
        rounding_error<N> best{found[0].x, 0};
        for (rounding_error<N>& one : found) {
            climb(one);
            one.size = miss<real50>(one.x);
            if (one.size > best.size) best = one;
        }
        return best;
    }

private:
    template <class T>
    T value(const inputs& x) const {
        return reflectance(evaluate(row_, x, T(x[N - 1])));
    }

    /// |float32 - real|, the real value in T; 0 where the row promises nothing.
    template <class T>
    double miss(const inputs& x) const {
        if (!promised(x)) return 0;
        return std::abs(static_cast<double>(T(value<float>(x)) - value<T>(x)));
    }

    /// Exact models have n_t / n_i in [0.1, 10], and most keep 0.001 away from what their rows name.
    bool promised(const inputs& x) const {
        if constexpr (N > 2)
            if (exact_) {
                const double eta = double(x[1]) / double(x[0]), k = N > 3 ? double(x[2]) / double(x[0]) : 0;
                const bool critical = eta < 1 && std::abs(double(x[N - 1]) - critical_cosine(eta)) < 0.001;
                return eta >= 0.1 && eta <= 10 &&
                       (row_.error.over == row::everywhere || k >= 0.1 || !critical) &&
                       (row_.error.over != row::apart || k >= 0.001 || std::abs(eta - 1) >= 0.001);
            }
        return true;
    }

    double unit() { return std::uniform_real_distribution<double>(0, 1)(generator_); }

    /// A small number, of every size alike.
    double small() { return std::exp2(-30 * unit()); }

    double drawn_in(double lo, double hi) {
        const double place = unit();
        if (place < 0.4) return lo + (hi - lo) * unit();
        return place < 0.7 ? lo + (hi - lo) * small() : hi - (hi - lo) * small();
    }

    inputs drawn() {
        inputs x{};
        for (std::size_t i = 0; i + 1 < N; ++i) {
            const parameter& p = row_.parameters[i];
            const double how = unit();
            const double drawn = how < 0.1             ? p.default_value
                                 : i == 1 && how < 0.3 ? double(x[0]) * (1 + (how < 0.2 ? 1 : -1) * small())
                                                       : drawn_in(range(i).lo, range(i).hi);
            x[i] = limited(i, drawn);
        }
        x[N - 1] = unit() < 0.3 ? critical(x) : limited(N - 1, drawn_in(0, 1));
        return x;
    }

    /// Near the critical angle where there is one, otherwise anywhere.
    float critical(const inputs& x) {
        double eta = 2;
        if constexpr (N > 2)
            if (exact_) eta = double(x[1]) / double(x[0]);
        if constexpr (N == 2)
            if (row_.parameters[0].name == "eta") eta = double(x[0]);
        return limited(N - 1, (eta < 1 ? critical_cosine(eta) : unit()) * (1 + (unit() - 0.5) * small()));
    }

    interval range(std::size_t i) const {
        return i + 1 < N ? moderate(row_.parameters[i]) : interval::between(0, 1);
    }

    float limited(std::size_t i, double value) const {
        const interval within = range(i);
        return static_cast<float>(std::clamp(value, within.lo, within.hi));
    }

    void climb(rounding_error<N>& at) {
        for (int step = 0; step < 3000; ++step) {
            inputs x = at.x;
            const std::size_t i = generator_() % N;
            x[i] = limited(i, double(x[i]) * (1 + (unit() < 0.5 ? 1 : -1) * small()));
            if (unit() < 0.3) x[N - 1] = critical(x);
            if (const double size = miss<double>(x); size > at.size) at = {x, size};
        }
    }

    const Row& row_;
    const bool exact_ = row_.kind == model_kind::exact; ///< then the first two parameters are n_i and n_t
    std::mt19937_64 generator_{32};
};

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

/// What |float32 - real| never exceeds for parameters of moderate size; none for models with comparisons.
template <class Row>
std::optional<double> rounding_bound_of(const Row& row) {
    constexpr std::size_t N = std::tuple_size_v<decltype(row.parameters)>;
    box<N + 1> whole;
    for (std::size_t p = 0; p < N; ++p)
        whole[p] = moderate(row.parameters[p]);
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

/// What holds over the domain of the registry.
template <std::size_t i>
certificate over_domain() {
    static constexpr const auto& row = std::get<i>(registry);
    certificate result{};
    if constexpr (row.error.over == row::inside_gems)
        result = over_internal_gems();
    else if constexpr (row.error.over == row::gems)
        result = over_gems(row);
    else if constexpr (row.error.over == row::box)
        result = over_indices(row);
    else if constexpr (row.error.over == row::metals)
        result = over_materials(row, metal_samples());
    else
        result.absolute = {0, row.error.max}; // as the registry's test measures it
    result.domain =
        result.proved ? std::string(row.error.over) : fmt::format("{}; {}", row.domain, row.error.over);
    return result;
}

/// The samples of materials, each with a boundary to air that reflects and has no critical angle.
std::vector<material_sample> samples_of_all(const std::vector<material>& materials) {
    std::vector<material_sample> all;
    for (const material& m : materials)
        for (material_sample& sample : samples_of(m)) {
            const auto [n, k] = sample.index;
            if (n <= 0 || (n <= 1 && k < 0.001) || normal_reflectance(1.0, n, k) < 1e-4)
                throw bad_input(
                    fmt::format("material '{}': n = {}, k = {} at {} nm: n must be above 1, or above 0 with "
                                "k >= 0.001, and the reflectance at normal incidence at least 1e-4",
                                m.name, n, k, sample.wavelength_nm));
            all.push_back(std::move(sample));
        }
    return all;
}

/// Whether it approximates what is seen from outside; of a row of the registry or of its table.
template <class Row>
constexpr bool is_fitted_from_outside(const Row& row) {
    return row.kind != model_kind::exact && row.error.over != row::inside_gems;
}

/// What holds over these materials.
template <std::size_t i>
certificate over_these([[maybe_unused]] const std::vector<material>& materials) {
    static constexpr const auto& row = std::get<i>(registry);
    if constexpr (!is_fitted_from_outside(row)) {
        throw bad_input(fmt::format(
            "model '{}': must approximate what is seen from outside, to be fitted to a material", row.name));
    } else {
        certificate result = over_materials(row, samples_of_all(materials));
        for (const material& m : materials)
            result.domain += m.name + ", ";
        result.domain += "at 450, 550 and 650 nm, parameters fitted";
        return result;
    }
}

/// f.template operator()<i>(), a certificate, where the model is row i of the registry; with its name, and its rounding.
template <class F>
certificate certify_row(std::string_view model, const F& f) {
    const std::span<const model_row<double>> rows = model_table<double>();
    const auto wanted = static_cast<std::size_t>(&find_model<double>(model) - rows.data());
    certificate result{};
    const auto certify_this = [&]<std::size_t i>() {
        static constexpr const auto& row = std::get<i>(registry);
        result = f.template operator()<i>();
        result.model = row.name;
        rounding_search search(row);
        const auto worst = search.worst();
        result.rounding_found = worst.size, result.rounding_bound = rounding_bound_of(row);
        result.rounding_at.clear();
        for (std::size_t p = 0; p < row.parameters.size(); ++p)
            result.rounding_at.emplace_back(row.parameters[p].name, worst.x[p]);
        result.rounding_at.emplace_back("cos_i", worst.x[row.parameters.size()]);
    };
    [&]<std::size_t... i>(std::index_sequence<i...>) {
        ((i == wanted ? certify_this.template operator()<i>() : void()), ...);
    }(std::make_index_sequence<std::tuple_size_v<decltype(registry)>>{});
    return result;
}

} // namespace

bool can_prove(std::string_view over) {
    return over == row::gems || over == row::inside_gems || over == row::box || over == row::metals;
}

certificate prove(std::string_view model) {
    return certify_row(model, []<std::size_t i>() { return over_domain<i>(); });
}

bool can_fit(std::string_view model) { return is_fitted_from_outside(find_model<double>(model)); }

certificate prove(std::string_view model, const std::vector<material>& materials) {
    return certify_row(model, [&]<std::size_t i>() { return over_these<i>(materials); });
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
        mpfr_free_cache(); // each thread has one of its own
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
