#include "analysis/fit.hpp"

#include "analysis/least_squares.hpp"
#include "analysis/minimize.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <numbers>

namespace fresnel {

namespace {

double unit(double value) { return std::clamp(value, 0.0, 1.0); }

const parameter& parameter_of(std::string_view model, std::string_view name) {
    const std::span<const parameter> all = find_model<double>(model).parameters;
    return *std::ranges::find(all, name, &parameter::name);
}

/// The box of a model's parameters of those names, in the order given; "power" and "alpha" by their log2.
template <std::size_t N>
bounds<N> box_of(std::string_view model, const std::array<std::string_view, N>& names) {
    bounds<N> box{};
    for (std::size_t i = 0; i < N; ++i) {
        const parameter& p = parameter_of(model, names[i]);
        const bool exponent = p.name == "power" || p.name == "alpha";
        box.lo[i] = exponent ? std::log2(p.min) : p.min;
        box.hi[i] = exponent ? std::log2(p.max) : p.max;
    }
    return box;
}

/// A double that remembers log2 of itself and of 1 - itself, where they are known: a power of 1 - cos_i, on which most
/// models spend their time, is then one exp2.
struct logged {
    double value = 0;
    double log2_of_it = unknown, log2_of_rest = unknown;

    static constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

    logged() = default;
    constexpr logged(int integer) : value(integer) {}
    explicit constexpr logged(double v) : value(v) {}

    friend logged operator-(logged x) { return logged(-x.value); }
    friend logged operator+(logged x, logged y) { return logged(x.value + y.value); }
    friend logged operator-(logged x, logged y) {
        logged difference(x.value - y.value);
        if (x.value == 1) difference.log2_of_it = y.log2_of_rest;
        return difference;
    }
    friend logged operator*(logged x, logged y) { return logged(x.value * y.value); }
    friend logged operator/(logged x, logged y) { return logged(x.value / y.value); }
    friend bool operator==(logged x, logged y) { return x.value == y.value; }
    friend auto operator<=>(logged x, logged y) { return x.value <=> y.value; }
    friend logged exp2(logged x) { return logged(std::exp2(x.value)); }
    friend logged log(logged x) {
        return logged(std::isnan(x.log2_of_it) ? std::log(x.value) : x.log2_of_it * std::numbers::ln2);
    }
    friend logged pow(logged x, logged y) {
        return logged(std::isnan(x.log2_of_it) ? std::pow(x.value, y.value)
                                               : std::exp2(y.value * x.log2_of_it));
    }
};

double plain(double x) { return x; }
double plain(logged x) { return x.value; }

/// The number a curve of N parameters runs on.
template <class Scalar, std::size_t N>
using number = dual<Scalar, static_cast<int>(N)>;

using dual1 = number<double, 1>;
using power1 = number<logged, 1>; // for the models of a power
using power2 = number<logged, 2>;
using power3 = number<logged, 3>;

template <class Scalar>
std::vector<Scalar> scalars_of(const std::vector<double>& cos_i) {
    std::vector<Scalar> scalars;
    for (const double c : cos_i) {
        scalars.emplace_back(c);
        if constexpr (std::is_same_v<Scalar, logged>) scalars.back().log2_of_rest = std::log2(1 - c);
    }
    return scalars;
}

/// Fits to a channel: family(x) is the curve, a callable of cos_i, of parameters x, on number<Scalar, N>.
template <class Scalar, std::size_t N, class Family>
point<N> fit_curve(const channel& exact, const Family& family, const bounds<N>& box,
                   const std::vector<point<N>>& starts) {
    using dual_in = number<Scalar, N>;
    using dual_out = number<double, N>;
    const std::vector<Scalar> cosines = scalars_of<Scalar>(exact.cos_i);
    const auto problem = [&](const std::array<dual_out, N>& x) {
        std::array<dual_in, N> variables;
        for (std::size_t i = 0; i < N; ++i)
            variables[i] = dual_in::variable(Scalar(x[i].value), static_cast<int>(i));
        return [&, curve = family(variables)](std::size_t sample) {
            const dual_in R = curve(dual_in::constant(cosines[sample]));
            dual_out residual = dual_out::constant(plain(R.value) - exact.R[sample]);
            for (std::size_t i = 0; i < N; ++i)
                residual.d[i] = plain(R.d[i]);
            return residual;
        };
    };
    return least_squares<N>(problem, exact.R.size(), box, starts);
}

/// Coefficient a of least squares for target = a basis.
double project(const std::vector<double>& target, const std::vector<double>& basis) {
    double dot = 0, norm = 0;
    for (std::size_t i = 0; i < target.size(); ++i)
        dot += target[i] * basis[i], norm += basis[i] * basis[i];
    return norm > 0 ? dot / norm : 0;
}

/// Intercept and slope of least squares for y = intercept + slope x.
std::array<double, 2> line_through(const std::vector<double>& x, const std::vector<double>& y) {
    const double count = static_cast<double>(x.size());
    double sum_x = 0, sum_y = 0, xx = 0, xy = 0;
    for (std::size_t i = 0; i < x.size(); ++i)
        sum_x += x[i], sum_y += y[i], xx += x[i] * x[i], xy += x[i] * y[i];
    const double spread = xx - sum_x * sum_x / count;
    const double slope = spread > 0 ? (xy - sum_x * sum_y / count) / spread : 0;
    return {(sum_y - slope * sum_x) / count, slope};
}

/// A few samples of a channel, to choose where a fit starts.
channel thinned(const channel& exact) {
    channel few{{}, {}, {}, exact.f0, exact.f82, exact.ambient};
    for (std::size_t i = 0; i < exact.R.size(); i += 12)
        few.cos_i.push_back(exact.cos_i[i]), few.R.push_back(exact.R[i]);
    return few;
}

parameters fit_power(const channel& exact) {
    const double f0 = unit(exact.f0);
    const auto family = [&](const std::array<power1, 1>& x) {
        return [f0 = power1::constant(logged(f0)), power = exp2(x[0])](const power1& c) {
            return schlick_power(f0, power1(1), power, c);
        };
    };
    const bounds<1> box = box_of<1>("schlick_power", {"power"});
    return {f0, 1, std::exp2(fit_curve<logged>(exact, family, box, {{0.5}, {2}, {3.5}, {6}})[0])};
}

parameters fit_f90(const channel& exact) {
    const double f0 = unit(exact.f0);
    std::vector<double> target, basis;
    for (std::size_t i = 0; i < exact.R.size(); ++i) {
        target.push_back(exact.R[i] - f0);
        basis.push_back(pow5(1 - exact.cos_i[i]));
    }
    return {f0, unit(f0 + project(target, basis))};
}

parameters fit_lazanyi(const channel& exact, const edge_tint& index) {
    const auto family = [&](const std::array<power2, 2>& x) {
        return [n = power2::constant(logged(index.n)), k = power2::constant(logged(index.k)), a = x[0],
                alpha = exp2(x[1])](const power2& c) { return lazanyi(n, k, a, alpha, c); };
    };
    const bounds<2> box = box_of<2>("lazanyi", {"a", "alpha"});
    const channel few = thinned(exact);
    std::vector<double> miss, basis(few.R.size());
    for (std::size_t i = 0; i < few.R.size(); ++i)
        miss.push_back(schlick_nk(index.n, index.k, few.cos_i[i]) - few.R[i]);
    std::vector<point<2>> starts;
    for (const double log2_alpha : {0.5, 2.0, 3.5, 4.5, 5.5, 6.5}) {
        for (std::size_t i = 0; i < few.R.size(); ++i)
            basis[i] = few.cos_i[i] * std::pow(1 - few.cos_i[i], std::exp2(log2_alpha));
        starts.push_back({project(miss, basis), log2_alpha});
    }
    const point<2> found = fit_curve<logged>(exact, family, box, starts);
    return {index.n, index.k, found[0], std::exp2(found[1])};
}

parameters fit_hoffman(const channel& exact) {
    const double f0 = unit(exact.f0), f82 = unit(exact.f82);
    const auto family = [&](const std::array<power1, 1>& x) {
        return [f0 = power1::constant(logged(f0)), f82 = power1::constant(logged(f82)),
                power = exp2(x[0])](const power1& c) { return hoffman(f0, f82, power1(1), power, c); };
    };
    const bounds<1> box = box_of<1>("hoffman", {"power"});
    return {f0, f82, 1, std::exp2(fit_curve<logged>(exact, family, box, {{0.5}, {2}, {3.5}, {6}})[0])};
}

/// Gulbrandsen's g at the exact f0, for a model of the index it stands for; searched by log2 of n, since most n of a
/// bright metal have a g close to 1.
template <class Model>
double fit_g(const channel& exact, const Model& model) {
    const double r = unit(exact.f0);
    const double n_max = gulbrandsen_index(r, 0.0).re, n_min = gulbrandsen_index(r, 1.0).re;
    const auto g_of = [&](const dual1& n) {
        return (dual1::constant(n_max) - n) / dual1::constant(std::max(n_max - n_min, 1e-300));
    };
    const auto family = [&](const std::array<dual1, 1>& x) {
        return [&model, m = gulbrandsen_index(dual1::constant(r), g_of(exp2(x[0])))](const dual1& c) {
            return model(m.re, m.im, c);
        };
    };
    const double lo = std::log2(n_min), hi = std::log2(n_max);
    const std::vector<point<1>> starts = {{mix(lo, hi, 0.001)}, {mix(lo, hi, 0.5)}, {mix(lo, hi, 0.999)}};
    const double x = fit_curve<double>(exact, family, bounds<1>{{lo}, {hi}}, starts)[0];
    return unit(g_of(dual1::constant(std::exp2(x))).value);
}

parameters fit_air_conductor(const channel& exact) {
    const double g =
        fit_g(exact, [](const dual1& n, const dual1& k, const dual1& c) { return air_conductor(n, k, c); });
    const edge_tint index = index_of(exact.f0, g);
    return {index.n, index.k};
}

parameters fit_bias_scale_power(const channel& exact) {
    const auto family = [](const std::array<power3, 3>& x) {
        return [bias = x[0], scale = x[1], power = exp2(x[2])](const power3& c) {
            return bias_scale_power(bias, scale, power, c);
        };
    };
    const bounds<3> box = box_of<3>("bias_scale_power", {"bias", "scale", "power"});
    const channel few = thinned(exact);
    std::vector<double> basis(few.R.size());
    std::vector<point<3>> starts;
    for (const double log2_power : {0.0, 1.5, 2.5, 3.5, 5.0, 6.5}) {
        for (std::size_t i = 0; i < few.R.size(); ++i)
            basis[i] = std::pow(1 - few.cos_i[i], std::exp2(log2_power));
        const auto [bias, scale] = line_through(basis, few.R);
        starts.push_back({bias, scale, log2_power});
    }
    const point<3> found = fit_curve<logged>(exact, family, box, starts);
    return {found[0], found[1], std::exp2(found[2])};
}

/// The second parameter of a model of f0 and f82, by least squares.
template <class Model>
parameters fit_second(const channel& exact, const Model& model) {
    const double f0 = unit(exact.f0);
    const auto family = [&](const std::array<dual1, 1>& x) {
        return [&model, f0 = dual1::constant(f0), f82 = x[0]](const dual1& c) { return model(f0, f82, c); };
    };
    return {f0, fit_curve<double>(exact, family, box_of<1>("f82", {"f82"}), {{unit(exact.f82)}})[0]};
}

double index_from_f0(const channel& exact, bool internal) {
    const double eta = eta_from_f0(std::min(unit(exact.f0), gulbrandsen_limit<double>()));
    return internal ? 1 / eta : eta;
}

// Beyond a critical angle the curve stays at 1, but for the trace of k that even water has; only a surface with one
// does.
bool has_critical_angle(const channel& exact) {
    return exact.R.size() > 2 && exact.R[exact.R.size() - 2] > 1 - 1e-6 && exact.f0 < 0.9;
}

/// `fit`, where tint() gives Gulbrandsen's fit; it is called only for the models that need it.
template <class Tint>
parameters fit_with(std::string_view model, const channel& exact, const Tint& tint) {
    const double f0 = unit(exact.f0), f82 = unit(exact.f82);
    if (model == "dielectric")
        return {exact.ambient, exact.ambient * index_from_f0(exact, has_critical_angle(exact))};
    if (model == "schlick_internal") return {index_from_f0(exact, true)};
    if (model == "one_minus_cos") return {};
    if (model == "schlick_power") return fit_power(exact);
    if (model == "schlick_f90") return fit_f90(exact);
    if (model == "lazanyi") return fit_lazanyi(exact, tint());
    if (model == "hoffman") return fit_hoffman(exact);
    if (model == "air_conductor") return fit_air_conductor(exact);
    if (model == "bias_scale_power") return fit_bias_scale_power(exact);
    if (model == "f82_tint") return {f0, unit(tint_of_f82(f0, f82))};
    if (model == "f82" || model == "powers_4_12" || model == "powers_2_8_16") return {f0, f82};

    const std::span<const parameter> wanted = find_model<double>(model).parameters;
    if (wanted.size() == 1 && wanted[0].name == "f0") return {f0};

    const edge_tint known = tint();
    if (model == "gulbrandsen") return {f0, known.g};
    if (model == "schlick_nk") return {known.n, known.k};
    return {exact.ambient, exact.ambient * known.n,
            exact.ambient * known.k}; // conductor and its arrangements
}

} // namespace

double tint_of_f82(double f0, double f82) { return f82 / schlick(f0, ratio<double, 1, 7>()); }

channel channel_of(const rgb_curve& exact, const rgb& f0, const rgb& f82, double ambient, std::size_t i,
                   const rgb& white) {
    channel result{exact.theta_deg, exact.cos_i, {}, f0[i] / white[i], f82[i] / white[i], ambient};
    for (const rgb& value : exact.value)
        result.R.push_back(value[i] / white[i]);
    return result;
}

channel channel_of(const optical_index& index) {
    const auto exact = [&](double c) { return conductor(1.0, index.n, index.k, c).reflectance(); };
    channel result{{}, {}, {}, exact(1), exact(ratio<double, 1, 7>()), 1};
    for (int i = 0; i <= 360; ++i) {
        result.theta_deg.push_back(0.25 * i);
        result.cos_i.push_back(cosine_of_degrees(result.theta_deg.back()));
        result.R.push_back(exact(result.cos_i.back()));
    }
    return result;
}

std::vector<std::string_view> models_for(surface_class surface) {
    const auto suits = [surface](std::string_view name) {
        const auto is = [name](auto... names) { return ((name == names) || ...); };
        if (surface == surface_class::matched) return is("dielectric", "constant");
        if (surface == surface_class::internal)
            return is("dielectric", "schlick_internal", "schlick", "one_minus_cos", "constant");
        if (is("schlick_internal", "dielectric_fast", "conductor_fast", "conductor_precise")) return false;
        return surface == surface_class::metal ? !is("dielectric") : !is("conductor");
    };
    std::vector<std::string_view> names;
    for (const model_row<double>& row : model_table<double>())
        if (suits(row.name)) names.push_back(row.name);
    return names;
}

edge_tint index_of(double r, double g) {
    const complex<double> m = gulbrandsen_index(std::max(r, 0.0), g);
    return {std::clamp(r, 0.0, gulbrandsen_limit<double>()), g, m.re, m.im};
}

edge_tint fit_gulbrandsen(const channel& exact) {
    const double g = fit_g(exact, [](const dual1& n, const dual1& k, const dual1& c) {
        return conductor(dual1(1), n, k, c).reflectance();
    });
    return index_of(unit(exact.f0), g);
}

metal_dip find_metal_dip(double n, double k) {
    const auto error = [&](double c) { return conductor(1.0, n, k, c).reflectance() - schlick_nk(n, k, c); };
    const double c = minimize(0, 1, error);
    return {c, error(c), std::log(-error(c) / (2 * n * c)) / std::log(1 - c)};
}

parameters fit(std::string_view model, const channel& exact) {
    return fit_with(model, exact, [&] { return fit_gulbrandsen(exact); });
}

parameters fit(std::string_view model, const channel& exact, const edge_tint& tint) {
    return fit_with(model, exact, [&] { return tint; });
}

parameters fit_f82(std::string_view model, const channel& exact) {
    const auto with = [&](const auto& body) { return fit_second(exact, body); };
    using arg = const dual1&;
    if (model == "f82") return with([](arg f0, arg h, arg c) { return f82(f0, h, c); });
    if (model == "powers_4_12") return with([](arg f0, arg h, arg c) { return powers_4_12(f0, h, c); });
    if (model == "powers_2_8_16") return with([](arg f0, arg h, arg c) { return powers_2_8_16(f0, h, c); });
    throw bad_input(
        fmt::format("model '{}' has no f82 to fit: use f82, powers_4_12 or powers_2_8_16", model));
}

std::vector<double> evaluate(std::string_view model, const parameters& values,
                             const std::vector<double>& cos_i) {
    const auto evaluate_one = find_model<double>(model).evaluate;
    std::vector<double> R;
    R.reserve(cos_i.size());
    for (const double c : cos_i)
        R.push_back(evaluate_one(values.data(), c).reflectance());
    return R;
}

} // namespace fresnel
