#pragma once

// A plate of a transparent or weakly absorbing material: two parallel boundaries and everything that bounces
// between them, without interference. That is a windowpane; a film thinner than the coherence of light is not.
//
// Reciprocity makes one boundary enough: seen from inside along the same ray it reflects and transmits as much as
// from outside.

#include <fresnel/exact.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/number.hpp>

namespace fresnel {

/// What one polarisation of a plate reflects and lets through.
template <class T>
struct passage {
    T R, T_through;
};

/// One polarisation of a plate with two different faces: the geometric series of all bounces.
///
///   R = R_1 + T_1^2 a^2 R_2 / (1 - R_1 R_2 a^2)      T = T_1 T_2 a / (1 - R_1 R_2 a^2)
///
/// R_1, T_1, R_2, T_2   of the front and the back face   [0, 1]
/// a                    transmittance of one passage     [0, 1]
/// returns              R and T of the plate; nothing passes where either face or the passage bars it
/// source               Stokes 1862, "On the Intensity of the Light Reflected from or Transmitted through a Pile
///                      of Plates"
template <class T>
passage<T> through_plate(T R_1, T T_1, T R_2, T T_2, T a) {
    const T a2 = a * a;
    const T open = let("open", 1 - R_1 * R_2 * a2);
    const T D = let("D", select(open <= 0, T(1), open));
    return {min(R_1 + T_1 * T_1 * a2 * R_2 / D, T(1)), min(T_1 * T_2 * a / D, T(1))};
}

/// A plate whose faces are different boundaries, per polarisation.
///
/// front, back   the two boundaries along one ray, each seen from either side
/// a             transmittance of one passage of the slanted ray   [0, 1]
/// returns       what the plate reflects and lets through; 1 - R - T is absorbed
template <class T>
boundary<T> plate(boundary<T> front, boundary<T> back, T a) {
    const passage<T> s = through_plate(front.R_s, front.T_s, back.R_s, back.T_s, a);
    const passage<T> p = through_plate(front.R_p, front.T_p, back.R_p, back.T_p, a);
    return {s.R, p.R, s.T_through, p.T_through};
}

/// A clear windowpane: the same medium on both sides, no absorption.
///
///   R = 2 R_1 / (1 + R_1)      T = T_1 / (1 + R_1)
///
/// n_i, n_t, cos_i   as `dielectric`
/// returns           R and T per polarisation, R + T = 1
template <class T>
boundary<T> window(T n_i, T n_t, T cos_i) {
    const boundary<T> face = dielectric(n_i, n_t, cos_i);
    return {2 * face.R_s / (1 + face.R_s), 2 * face.R_p / (1 + face.R_p), face.T_s / (1 + face.R_s),
            face.T_p / (1 + face.R_p)};
}

/// Transmittance of one passage through a layer, Beer and Lambert's law along the refracted ray.
///
///   a = exp(-tau / cos_t)
///
/// tau     absorption coefficient times thickness, its optical depth at normal incidence   [0, infinity)
/// cos_t   cosine inside the layer   [0, 1]; 0 lets nothing through unless tau is 0
template <class T>
T passage_transmittance(T tau, T cos_t) {
    const T path = let("path", tau / select(cos_t > 0, cos_t, T(1)));
    return select(tau <= 0, T(1), select(cos_t > 0, exp2(-path / log(T(2))), T(0)));
}

/// A windowpane of tinted glass. The index is taken as real: for k below about 0.01 its effect on the boundaries
/// is not seen.
///
/// n_i, n_t, cos_i   as `dielectric`
/// tau               optical depth at normal incidence, 4 pi k thickness / wavelength   [0, infinity)
/// returns           R and T per polarisation; 1 - R - T is absorbed, see `window_absorptance`
template <class T>
boundary<T> window_absorbing(T n_i, T n_t, T tau, T cos_i) {
    const boundary<T> face = dielectric(n_i, n_t, cos_i);
    const T cos_t = refracted_cosine(n_t / n_i, cos_i);
    return plate(face, face, passage_transmittance(tau, cos_t));
}

/// What `window_absorbing` absorbs, without the cancellation of 1 - R - T.
///
///   A = T_1 (1 - a) / (1 - R_1 a)
///
/// n_i, n_t, tau, cos_i   as `window_absorbing`
/// returns                s and p, in R_s and R_p; what is left over, in T_s and T_p
template <class T>
boundary<T> window_absorptance(T n_i, T n_t, T tau, T cos_i) {
    const boundary<T> face = dielectric(n_i, n_t, cos_i);
    const T a = passage_transmittance(tau, refracted_cosine(n_t / n_i, cos_i));
    const T D_s = let("D_s", 1 - face.R_s * a);
    const T D_p = let("D_p", 1 - face.R_p * a);
    const T A_s = face.T_s * (1 - a) / select(D_s <= 0, T(1), D_s);
    const T A_p = face.T_p * (1 - a) / select(D_p <= 0, T(1), D_p);
    return {A_s, A_p, 1 - A_s, 1 - A_p};
}

} // namespace fresnel
