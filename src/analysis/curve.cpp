#include "analysis/curve.hpp"

#include "analysis/angles.hpp"
#include "analysis/fit.hpp"
#include "error.hpp"
#include "materials/observer.hpp"
#include "materials/table.hpp"

#include <fresnel/exact.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fresnel {

optical_index used_index(const material& substance, double wavelength_nm) {
    const optical_index index = index_at(substance, wavelength_nm);
    if (!std::isfinite(index.n) || !std::isfinite(index.k))
        throw bad_input(fmt::format("material '{}': has no index at {} nm, where its formula has a pole",
                                    substance.name, wavelength_nm));
    if (index.n < 0 || index.n > largest_index)
        throw bad_input(fmt::format("material '{}': n = {} at {} nm: must be in [0, {}]", substance.name,
                                    index.n, wavelength_nm, largest_index));
    if (index.n == 0 && index.k == 0)
        throw bad_input(fmt::format("material '{}': n and k are both 0 at {} nm; one must be above 0",
                                    substance.name, wavelength_nm));
    return index;
}

namespace {

// The indices of a material at every wavelength of the recipe: looked up once, used at every angle.
struct index_spectrum {
    std::vector<optical_index> at;

    index_spectrum(const material& substance, const std::vector<double>& wavelength_nm) {
        for (const double nm : wavelength_nm)
            at.push_back(used_index(substance, nm));
    }
    std::vector<double> reflectance(double ambient, double cos_i,
                                    polarization which = polarization::mean) const {
        std::vector<double> R;
        R.reserve(at.size());
        for (const optical_index& index : at)
            R.push_back(reflectance_of(conductor(ambient, index.n, index.k, cos_i), which));
        return R;
    }
};

} // namespace

double radians(double degrees) { return degrees * std::numbers::pi / 180; }

double degrees(double radians) { return radians * 180 / std::numbers::pi; }

double cosine_of_degrees(double theta_deg) {
    return theta_deg == 90 ? 0 : theta_deg == 60 ? 0.5 : std::cos(radians(theta_deg));
}

double degrees_of_cosine(double cos_i) { return degrees(std::acos(cos_i)); }

spectral_surface exact_surface(const material& substance, double ambient, std::vector<double> wavelength_nm,
                               std::vector<double> theta_deg, polarization which) {
    const index_spectrum indices(substance, wavelength_nm);
    spectral_surface surface{std::move(wavelength_nm), std::move(theta_deg), {}, {}};
    for (const double theta : surface.theta_deg) {
        surface.cos_i.push_back(cosine_of_degrees(theta));
        surface.R.push_back(indices.reflectance(ambient, surface.cos_i.back(), which));
    }
    return surface;
}

std::vector<rgb> exact_colours(const material& substance, color_space space, double ambient,
                               const std::vector<double>& cos_i, polarization which) {
    const recipe& how = default_recipe(space);
    const index_spectrum indices(substance, how.wavelength_nm);
    std::vector<rgb> colours;
    for (const double c : cos_i)
        colours.push_back(integrate(how, indices.reflectance(ambient, c, which)));
    return colours;
}

rgb_curve exact_curve(const material& substance, color_space space, double ambient, double step_deg,
                      polarization which) {
    rgb_curve curve{space, {}, {}, {}};
    const int steps = static_cast<int>(std::lround(90 / step_deg));
    for (int i = 0; i <= steps; ++i) {
        curve.theta_deg.push_back(90.0 * i / steps);
        curve.cos_i.push_back(cosine_of_degrees(curve.theta_deg.back()));
    }
    curve.value = exact_colours(substance, space, ambient, curve.cos_i, which);
    return curve;
}

rgb colour_at(const material& substance, color_space space, double ambient, double cos_i) {
    return exact_colours(substance, space, ambient, {cos_i}).front();
}

namespace {

/// What a gamut policy makes of the colours of a surface with that f0, as parts of white.
class gamut_limit {
public:
    gamut_limit(gamut policy, const rgb& f0, const rgb& white) : policy_(policy), white_(white) {
        if (policy != gamut::divide) return;
        for (std::size_t i = 0; i < 3; ++i)
            factor_ = std::max(factor_, f0[i] / white[i]);
    }
    rgb operator()(rgb color) const {
        if (policy_ == gamut::none) return color;
        for (std::size_t i = 0; i < 3; ++i)
            color[i] = std::clamp(color[i] / (white_[i] * factor_), 0.0, 1.0) * white_[i];
        return color;
    }

private:
    gamut policy_;
    rgb white_;
    double factor_ = 1;
};

} // namespace

normal_colour colour_at_normal(const material& substance, color_space space, double ambient, gamut policy) {
    const recipe& how = default_recipe(space);
    const index_spectrum indices(substance, how.wavelength_nm);
    normal_colour result{
        substance.name, substance.page, space, ambient, {}, {}, {}, {}, {}, {}, how.text, true};
    const rgb white = white_of(space), f0 = colour_at(substance, space, ambient, 1);
    const gamut_limit limited(policy, f0, white);
    result.in_gamut = in_gamut({f0[0] / white[0], f0[1] / white[1], f0[2] / white[2]});
    result.f0 = limited(f0);
    result.f82 = limited(colour_at(substance, space, ambient, ratio<double, 1, 7>()));
    std::vector<double> average;
    for (const optical_index& index : indices.at)
        average.push_back(hemispherical_average(ambient, index.n, index.k));
    result.average = limited(integrate(how, average));

    rgb_curve exact = exact_curve(substance, space, ambient, 1);
    for (rgb& color : exact.value)
        color = limited(color);
    for (std::size_t i = 0; i < 3; ++i) {
        const channel one = channel_of(exact, result.f0, result.f82, ambient, i, white);
        result.f82_tint[i] = tint_of_f82(one.f0, one.f82);
        const edge_tint tint = fit_gulbrandsen(one);
        result.gulbrandsen_r[i] = tint.r, result.gulbrandsen_g[i] = tint.g;
    }
    return result;
}

} // namespace fresnel
