#include "analysis/angles.hpp"

#include "analysis/curve.hpp"
#include "analysis/minimize.hpp"

#include <fresnel/average.hpp>
#include <fresnel/geometry.hpp>

#include <numbers>

namespace fresnel {

double hemispherical_average(double n_i, double n_t, double k_t) {
    return k_t == 0 ? dielectric_average(n_t / n_i) : conductor_average(n_i, n_t, k_t);
}

double least_reflectance_cosine(double n_i, double n_t, double k_t) {
    const auto R = [&](double theta) { return conductor(n_i, n_t, k_t, std::cos(theta)).reflectance(); };
    const double theta = minimize(0, std::numbers::pi / 2, R);
    // a surface that is flat at normal incidence would report rounding errors as a minimum
    return R(theta) < R(0) * (1 - 1e-9) ? std::cos(theta) : 1;
}

boundary_angles angles_of(double n_i, double n_t, double k_t) {
    const auto at = [&](double c) { return conductor(n_i, n_t, k_t, c).reflectance(); };
    boundary_angles result{normal_reflectance(n_i, n_t, k_t),
                           at(ratio<double, 1, 7>()),
                           {},
                           {},
                           {},
                           {},
                           {},
                           hemispherical_average(n_i, n_t, k_t),
                           {}};
    const bool transparent = k_t == 0;
    if (transparent) result.average_inside = hemispherical_average(n_t, n_i, 0);
    if (transparent && n_i == n_t) return result;
    if (transparent) result.brewster = degrees_of_cosine(brewster_cosine(n_t / n_i));
    result.pseudo_brewster = degrees_of_cosine(pseudo_brewster_cosine(n_i, n_t, k_t));
    if (transparent && n_t < n_i) result.critical = degrees_of_cosine(critical_cosine(n_t / n_i));
    const double least = least_reflectance_cosine(n_i, n_t, k_t);
    if (least < 1) result.least = degrees_of_cosine(least), result.least_reflectance = at(least);
    return result;
}

} // namespace fresnel
