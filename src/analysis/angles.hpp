#pragma once

#include <optional>

namespace fresnel {

/// The numbers of one boundary, seen from the medium of index n_i. Angles are in degrees; nothing where there is
/// no such angle.
struct boundary_angles {
    double f0, f82;
    std::optional<double> brewster;        ///< R_p = 0: transparent media only
    std::optional<double> pseudo_brewster; ///< R_p least
    std::optional<double> critical;        ///< from the denser of two transparent media
    std::optional<double> least;           ///< unpolarised R least, if that is not at normal incidence
    std::optional<double> least_reflectance;
    double average;                       ///< hemispherical
    std::optional<double> average_inside; ///< of the same boundary from behind: transparent media only
};

/// All of them; equal media (n_i = n_t, k_t = 0) have none of the angles.
///
/// n_i, n_t, k_t   as `conductor`
boundary_angles angles_of(double n_i, double n_t, double k_t);

/// Average of one boundary: the closed form for k_t = 0, else by quadrature.
double hemispherical_average(double n_i, double n_t, double k_t);

/// Cosine at which the unpolarised reflectance is least; 1 where it only rises. It has no closed form.
double least_reflectance_cosine(double n_i, double n_t, double k_t);

} // namespace fresnel
