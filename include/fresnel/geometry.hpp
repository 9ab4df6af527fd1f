#pragma once

// Angles and indices at a boundary: Snell's law and the relation of f0 to the index.

#include <fresnel/number.hpp>

namespace fresnel {

/// Snell's law: cosine of the transmitted ray, 0 beyond the critical angle.
///
///   cos_t = sqrt(1 - sin_i^2 / eta^2) = sqrt(eta^2 - 1 + cos_i^2) / eta
///
/// The second form keeps its digits at grazing incidence and near an index match.
///
/// eta     n_t / n_i                 > 0
/// cos_i   cosine of incidence       [0, 1]
/// returns [0, 1]; exactly cos_i for eta = 1
template <class T>
T refracted_cosine(T eta, T cos_i) {
    const T g2 = let("g2", (eta - 1) * (eta + 1) + cos_i * cos_i);
    return let("cos_t", select(g2 <= 0, T(0), min(sqrt(select(g2 <= 0, T(1), g2)) / eta, T(1))));
}

/// Reflectance at normal incidence.
///
///   f0 = ((n_t - n_i)^2 + k_t^2) / ((n_t + n_i)^2 + k_t^2)
///
/// n_i, n_t, k_t   as `conductor`
template <class T>
T normal_reflectance(T n_i, T n_t, T k_t) {
    return (square(n_t - n_i) + k_t * k_t) / (square(n_t + n_i) + k_t * k_t);
}

/// The relative index above 1 that gives f0; its inverse 1 / eta gives the same f0 from inside.
///
///   eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)
///
/// f0   reflectance at normal incidence   [0, 1); infinite at 1
template <class T>
T eta_from_f0(T f0) {
    return square(1 + sqrt(f0)) / (1 - f0);
}

/// Sine of the critical angle, beyond which the inner side of a surface reflects everything.
///
///   sin_c = (1 - sqrt f0) / (1 + sqrt f0)
///
/// f0      reflectance at normal incidence   [0, 1]
/// source  Akenine-Moeller et al. 2018, "Real-Time Rendering", 4th ed., sec. 9.5.3
template <class T>
T sin_critical(T f0) {
    return (1 - f0) / square(1 + sqrt(f0));
}

} // namespace fresnel
