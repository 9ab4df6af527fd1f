#include "analysis/fit.hpp"

#include "analysis/minimize.hpp"

#include <algorithm>
#include <cmath>

namespace fresnel {

namespace {

double inside(double value, std::string_view model, std::string_view name) {
    for (const parameter& p : find_model<double>(model).parameters)
        if (p.name == name) return std::clamp(value, p.min, p.max);
    return value;
}

double squared_error(std::string_view model, const parameters& values, const channel& exact) {
    const auto evaluate_one = find_model<double>(model).evaluate;
    double sum = 0;
    for (std::size_t i = 0; i < exact.R.size(); ++i)
        sum += square(evaluate_one(values.data(), exact.cos_i[i]).reflectance() - exact.R[i]);
    return sum;
}

/// The exponent of least squared error; searched on a logarithmic scale.
double fit_exponent(double lo, double hi, const std::function<double(double)>& error_of) {
    return std::exp2(
        minimize(std::log2(lo), std::log2(hi), [&](double e) { return error_of(std::exp2(e)); }));
}

/// Coefficient a of least squares for target = a basis.
double project(const std::vector<double>& target, const std::vector<double>& basis) {
    double dot = 0, norm = 0;
    for (std::size_t i = 0; i < target.size(); ++i)
        dot += target[i] * basis[i], norm += basis[i] * basis[i];
    return norm > 0 ? dot / norm : 0;
}

double unit(double value) { return std::clamp(value, 0.0, 1.0); }

parameters fit_power(const channel& exact) {
    const double f0 = unit(exact.f0);
    const auto error = [&](double power) { return squared_error("schlick_power", {f0, 1, power}, exact); };
    return {f0, 1, fit_exponent(0.5, 500, error)};
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

parameters fit_lazanyi(const channel& exact) {
    const edge_tint index = fit_gulbrandsen(exact);
    std::vector<double> target, basis(exact.R.size());
    for (std::size_t i = 0; i < exact.R.size(); ++i)
        target.push_back(schlick_nk(index.n, index.k, exact.cos_i[i]) - exact.R[i]);
    const auto with_alpha = [&](double alpha) {
        for (std::size_t i = 0; i < basis.size(); ++i)
            basis[i] = exact.cos_i[i] * std::pow(1 - exact.cos_i[i], alpha);
        return parameters{index.n, index.k, inside(project(target, basis), "lazanyi", "a"), alpha};
    };
    const auto error = [&](double alpha) { return squared_error("lazanyi", with_alpha(alpha), exact); };
    return with_alpha(fit_exponent(1, 200, error));
}

parameters fit_hoffman(const channel& exact) {
    const double f0 = unit(exact.f0), f82 = unit(exact.f82);
    const auto error = [&](double power) { return squared_error("hoffman", {f0, f82, 1, power}, exact); };
    return {f0, f82, 1, fit_exponent(0.5, 100, error)};
}

parameters fit_air_conductor(const channel& exact) {
    const auto index = [&](double g) { return index_of(exact.f0, g); };
    const double g = minimize(
        0, 1, [&](double t) { return squared_error("air_conductor", {index(t).n, index(t).k}, exact); });
    return {index(g).n, index(g).k};
}

// Bias and scale are linear for a given power: the two normal equations, solved.
parameters fit_bias_scale_power(const channel& exact) {
    const double count = static_cast<double>(exact.R.size());
    const auto with_power = [&](double power) {
        double x = 0, xx = 0, y = 0, xy = 0;
        for (std::size_t i = 0; i < exact.R.size(); ++i) {
            const double rim = std::pow(1 - exact.cos_i[i], power);
            x += rim, xx += rim * rim, y += exact.R[i], xy += rim * exact.R[i];
        }
        const double scale = (count * xy - x * y) / (count * xx - x * x);
        return parameters{(y - scale * x) / count, scale, power};
    };
    const auto error = [&](double power) {
        return squared_error("bias_scale_power", with_power(power), exact);
    };
    return with_power(fit_exponent(0.5, 500, error));
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

} // namespace

channel channel_of(const rgb_curve& exact, const rgb& f0, const rgb& f82, double ambient, std::size_t i) {
    channel result{exact.theta_deg, exact.cos_i, {}, f0[i], f82[i], ambient};
    for (const rgb& value : exact.value)
        result.R.push_back(value[i]);
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
    const double r = unit(exact.f0);
    return index_of(r, minimize(0, 1, [&](double g) { return squared_error("gulbrandsen", {r, g}, exact); }));
}

metal_dip find_metal_dip(double n, double k) {
    const auto error = [&](double c) { return conductor(1.0, n, k, c).reflectance() - schlick_nk(n, k, c); };
    const double c = minimize(0, 1, error);
    return {c, error(c), std::log(-error(c) / (2 * n * c)) / std::log(1 - c)};
}

parameters fit(std::string_view model, const channel& exact) {
    const double f0 = unit(exact.f0), f82 = unit(exact.f82);
    if (model == "dielectric")
        return {exact.ambient, exact.ambient * index_from_f0(exact, has_critical_angle(exact))};
    if (model == "schlick_internal") return {index_from_f0(exact, true)};
    if (model == "one_minus_cos") return {};
    if (model == "schlick_power") return fit_power(exact);
    if (model == "schlick_f90") return fit_f90(exact);
    if (model == "lazanyi") return fit_lazanyi(exact);
    if (model == "hoffman") return fit_hoffman(exact);
    if (model == "air_conductor") return fit_air_conductor(exact);
    if (model == "bias_scale_power") return fit_bias_scale_power(exact);
    if (model == "f82_tint") return {f0, unit(f82 / schlick(f0, ratio<double, 1, 7>()))};
    if (model == "f82" || model == "powers_4_12" || model == "powers_2_8_16") return {f0, f82};

    const std::span<const parameter> wanted = find_model<double>(model).parameters;
    if (wanted.size() == 1 && wanted[0].name == "f0") return {f0};

    const edge_tint tint = fit_gulbrandsen(exact);
    if (model == "gulbrandsen") return {f0, tint.g};
    if (model == "schlick_nk") return {tint.n, tint.k};
    return {exact.ambient, exact.ambient * tint.n, exact.ambient * tint.k}; // conductor and its arrangements
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
