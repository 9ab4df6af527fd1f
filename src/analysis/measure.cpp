#include "analysis/measure.hpp"

#include "analysis/curve.hpp"
#include "analysis/minimize.hpp"
#include "materials/catalog.hpp"

#include <fresnel/approx.hpp>

#include <cmath>
#include <numbers>

namespace fresnel {

namespace {

double exact(double eta, double c) { return dielectric(1.0, eta, c).reflectance(); }

double f0_of(double eta) { return normal_reflectance(1.0, eta, 0.0); }

} // namespace

double extremum::theta_deg() const { return degrees_of_cosine(cos_i); }

double extremum::size() const { return std::abs(value); }

extremum largest(const curve_function& difference) {
    const auto at = [&](double theta) {
        const double c = cosine_of_degrees(theta);
        return extremum{c, difference(c)};
    };
    constexpr int steps = 720;
    int best = 0;
    for (int i = 1; i <= steps; ++i)
        if (at(90.0 * i / steps).size() > at(90.0 * best / steps).size()) best = i;
    const double lo = 90.0 * std::max(best - 1, 0) / steps, hi = 90.0 * std::min(best + 1, steps) / steps;
    const extremum refined = at(minimize(lo, hi, [&](double theta) { return -at(theta).size(); }));
    const extremum scanned = at(90.0 * best / steps);
    return refined.size() > scanned.size() ? refined : scanned;
}

double root_of(double lo, double hi, const std::function<double(double)>& f) {
    const bool rising = f(lo) < f(hi);
    for (int i = 0; i < 60; ++i) {
        const double middle = (lo + hi) / 2;
        ((f(middle) < 0) == rising ? lo : hi) = middle;
    }
    return (lo + hi) / 2;
}

extremum schlick_error(double eta) {
    return largest([=](double c) { return schlick(f0_of(eta), c) - exact(eta, c); });
}

extremum schlick_relative_error(double eta) {
    return largest([=](double c) { return schlick(f0_of(eta), c) / exact(eta, c) - 1; });
}

extremum schlick_internal_error(double eta) {
    return largest([=](double c) { return schlick_internal(eta, c) - exact(eta, c); });
}

extremum one_minus_cos_error(double eta) {
    return largest([=](double c) { return one_minus_cos(c) - exact(eta, c); });
}

extremum polarisation_gap(double eta) {
    return largest([=](double c) {
        const boundary<double> b = dielectric(1.0, eta, c);
        return b.R_s - b.reflectance();
    });
}

extremum air_conductor_error(double n, double k) {
    return largest([=](double c) { return air_conductor(n, k, c) - conductor(1.0, n, k, c).reflectance(); });
}

extremum schlick_nk_error(double n, double k) {
    return largest([=](double c) { return schlick_nk(n, k, c) - conductor(1.0, n, k, c).reflectance(); });
}

extremum lazanyi_error(double n, double k, double a, double alpha) {
    return largest(
        [=](double c) { return lazanyi(n, k, a, alpha, c) - conductor(1.0, n, k, c).reflectance(); });
}

extremum table_error(const curve_function& f, int size, int bits) {
    const double levels = std::exp2(bits) - 1;
    std::vector<double> texels;
    for (int i = 0; i < size; ++i) {
        const double value = f(static_cast<double>(i) / (size - 1));
        texels.push_back(bits == 0 ? value : std::round(value * levels) / levels);
    }
    return largest([&](double c) {
        const double x = c * (size - 1);
        const auto i = static_cast<std::size_t>(std::min(std::floor(x), size - 2.0));
        return mix(texels[i], texels[i + 1], x - static_cast<double>(i)) - f(c);
    });
}

double vertex_interpolation_error(const curve_function& f, int sides) {
    const double step = 2 * std::numbers::pi / sides;
    double worst = 0;
    for (int shift = 0; shift < 8; ++shift)
        for (double a = step * shift / 8; a + step <= std::numbers::pi / 2 + 1e-12; a += step)
            for (int i = 1; i < 16; ++i) {
                const double t = i / 16.0, x = mix(std::cos(a), std::cos(a + step), t),
                             y = mix(std::sin(a), std::sin(a + step), t);
                const double per_vertex = mix(f(std::cos(a)), f(std::max(std::cos(a + step), 0.0)), t);
                worst = std::max(worst, std::abs(per_vertex - f(x / std::hypot(x, y))));
            }
    return worst;
}

double channel_spread(const material& substance) {
    double worst = 0;
    for (const rgb& v : exact_curve(substance, color_space::srgb, 1, 1).value)
        worst = std::max(worst, std::max({v[0], v[1], v[2]}) - std::min({v[0], v[1], v[2]}));
    return worst;
}

bool is_sample_metal(const material& m) {
    return m.category == "metal" && m.kind == material_kind::spectral && m.name != "caesium" &&
           !m.quality.starts_with("Calculated");
}

std::vector<material_sample> samples_of(const material& m) {
    std::vector<material_sample> samples;
    for (const double nm : {450.0, 550.0, 650.0})
        samples.push_back({m.name, nm, used_index(m, nm)});
    return samples;
}

const std::vector<material_sample>& metal_samples() {
    static const std::vector<material_sample> all = [] {
        std::vector<material_sample> samples;
        for (const material& m : builtin_materials())
            if (is_sample_metal(m))
                for (material_sample& sample : samples_of(m))
                    samples.push_back(std::move(sample));
        return samples;
    }();
    return all;
}

} // namespace fresnel
