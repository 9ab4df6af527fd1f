#pragma once

// A plate between two parallel boundaries, as a windowpane: the light that bounces between them is added up as
// power, so that there is no interference. That holds for every plate much thicker than the light is coherent,
// a tenth of a millimetre for daylight.
//
// A boundary reflects the same share of the light from either side along one ray (Stokes 1849), so that one
// `boundary` describes both directions through it.

#include <fresnel/exact.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/number.hpp>

namespace fresnel {

// ---- absorption on the way through ------------------------------------------------------------------------

/// 1 - e^-x, without the cancellation of that difference.
///
///   1 - e^-x = x / (x / 2 + h coth h),   h coth h = 1 + h^2 / (3 + h^2 / (5 + ...)),   h = x / 2
///
/// x       >= 0
/// returns [0, 1]
/// error   relative 1e-16 of truncation below x = 1/2, whatever the number type
/// source  Lambert 1768, "Memoire sur quelques proprietes remarquables des quantites transcendentes"
template <class T>
T one_minus_exp(T x) {
    const auto small = 2 * x < 1;
    const T s = let("s", select(small, x, T(0)));
    const T h2 = let("h2", s * s / 4);
    const T rest = let("rest", 5 + h2 / (7 + h2 / (9 + h2 / 11)));
    const T h_coth_h = let("h_coth_h", 1 + h2 / (3 + h2 / rest));
    return select(small, s / (s / 2 + h_coth_h), 1 - exp2(-x / log(T(2))));
}

/// What one passage through an absorbing layer does to power; passed + absorbed = 1.
template <class T>
struct passage {
    T passed, absorbed;
};

/// The law of Bouguer, Lambert and Beer along a slanted path.
///
///   passed = e^(-tau / cos_t)
///
/// tau      optical depth along the normal: absorption coefficient x thickness, natural logarithm   [0, inf)
/// cos_t    cosine inside the layer                                                                  [0, 1]
/// returns  passed and absorbed, each in [0, 1] and each of full relative precision; nothing passes along
///          the layer (cos_t = 0) unless tau = 0
/// source   Bouguer 1729; Beer 1852
template <class T>
passage<T> pass(T tau, T cos_t) {
    const auto along = cos_t <= 0;
    const auto absorbs = tau > 0;
    const T path = let("path", tau / select(along, T(1), cos_t));
    return {select(along, select(absorbs, T(0), 1 - tau), exp2(-path / log(T(2)))),
            select(along, select(absorbs, T(1), tau), one_minus_exp(path))};
}

// ---- two boundaries ---------------------------------------------------------------------------------------

/// Power reflected and transmitted by a plate, as by one boundary, and what it absorbs: R + T + A = 1.
template <class T>
struct slab : boundary<T> {
    T A_s, A_p;

    /// Absorptance for unpolarised light.
    constexpr T absorptance() const { return (A_s + A_p) / 2; }
};

/// The boundary with its R + T brought to 1, from which `dielectric` strays at the critical angle by its rounding.
template <class T>
boundary<T> balanced(boundary<T> b) {
    const T sum_s = let("sum_s", b.R_s + b.T_s);
    const T sum_p = let("sum_p", b.R_p + b.T_p);
    return {b.R_s / sum_s, b.R_p / sum_p, b.T_s / sum_s, b.T_p / sum_p};
}

/// Share of power that a plate reflects, transmits and absorbs, in one polarisation.
template <class T>
struct power_split {
    T reflected, transmitted, absorbed;
};

/// One polarisation of `plate`: the geometric series of the bounces, summed.
///
///   D = 1 - R1 R2 a^2 = (1 - a) (1 + a) + a^2 (T1 + R1 T2)
///
/// The second form cancels nowhere, and so gives grazing incidence its digits.
template <class T>
power_split<T> add_bounces(T R1, T T1, T R2, T T2, passage<T> through) {
    const T a = through.passed;
    const T D = let("D", through.absorbed * (1 + a) + a * a * (T1 + R1 * T2));
    const auto shut = D <= 0; // nothing enters, and nothing would be absorbed: the limit for equal faces
    const T inside = let("inside", select(shut, ratio<T, 1, 2>(), T1 / select(shut, T(1), D)));
    return {min(R1 + T1 * inside * (a * a * R2), T(1)), min(inside * (a * T2), T(1)),
            min(inside * (through.absorbed * (1 + a * R2)), T(1))};
}

/// `plate` with the passage given in both parts: the absorbed one of a thin plate is lost in the rounding of
/// 1 - a. Both boundaries are balanced.
template <class T>
slab<T> plate_of(boundary<T> front, boundary<T> back, passage<T> through) {
    const power_split<T> s = add_bounces(front.R_s, front.T_s, back.R_s, back.T_s, through);
    const power_split<T> p = add_bounces(front.R_p, front.T_p, back.R_p, back.T_p, through);
    return {{s.reflected, p.reflected, s.transmitted, p.transmitted}, s.absorbed, p.absorbed};
}

/// A plate between any two boundaries, its bounces added as power.
///
///   R = R1 + T1^2 a^2 R2 / (1 - R1 R2 a^2)        T = T1 T2 a / (1 - R1 R2 a^2)
///   A = T1 (1 - a) (1 + a R2) / (1 - R1 R2 a^2)
///
/// front           boundary that the light meets first, as seen from outside         R + T = 1
/// back            boundary behind it, as seen from inside, at the refracted angle   R + T = 1
/// transmittance   a: power left of 1 after one passage through the inside           [0, 1]
/// returns         R, T and A per polarisation, each in [0, 1]; R = 1 where both boundaries reflect all
/// source          Stokes 1862, "On the intensity of the light reflected from or transmitted through a pile of
///                 plates"
template <class T>
slab<T> plate(boundary<T> front, boundary<T> back, T transmittance) {
    return plate_of(balanced(front), balanced(back), {transmittance, 1 - transmittance});
}

/// A clear plate with the same medium on both sides: a windowpane.
///
///   R = 2 R1 / (1 + R1)        T = T1 / (1 + R1)
///
/// The sums are written with 1 + R1 = T1 + 2 R1, so that R + T is 1 however R1 and T1 are rounded.
///
/// n_i, n_t, cos_i   as `dielectric`, n_t being the index of the plate
/// returns R and T per polarisation, each in [0, 1]; 1 and 0 at grazing incidence and, for a gap between
///         denser media, beyond the critical angle; R is exactly 0 for equal media at every angle
/// error   as `dielectric`; R + T = 1 within 4 epsilon
/// source  Stokes 1862, "On the intensity of the light reflected from or transmitted through a pile of plates"
template <class T>
boundary<T> window(T n_i, T n_t, T cos_i) {
    const boundary<T> face = dielectric(n_i, n_t, cos_i);
    const T D_s = let("D_s", face.T_s + 2 * face.R_s);
    const T D_p = let("D_p", face.T_p + 2 * face.R_p);
    return {2 * face.R_s / D_s, 2 * face.R_p / D_p, face.T_s / D_s, face.T_p / D_p};
}

/// A tinted plate with the same medium on both sides.
///
///   R = R1 + T1^2 a^2 R1 / (1 - R1^2 a^2)   T = T1^2 a / (1 - R1^2 a^2)   A = T1 (1 - a) / (1 - R1 a)
///   a = e^(-tau / cos_t)
///
/// n_i, n_t, cos_i   as `dielectric`, n_t being the index of the plate, whose k is too small to reflect
/// tau     optical depth along the normal: absorption coefficient x thickness, natural logarithm   [0, inf)
/// returns R, T and A per polarisation, each in [0, 1], R + T + A = 1 within 8 epsilon; `window` for tau = 0
/// error   float64: relative 1e-12 for tau / cos_t < 100 and an n_t / n_i that is not rounded, else times
///         1 + 1 / |eta^2 - sin_i^2|, the condition of the refracted angle
/// source  Stokes 1862, as `plate`
template <class T>
slab<T> window_absorbing(T n_i, T n_t, T tau, T cos_i) {
    const boundary<T> face = balanced(dielectric(n_i, n_t, cos_i));
    const T cos_t = refracted_cosine(let("eta", n_t / n_i), cos_i);
    return plate_of(face, face, pass(tau, cos_t));
}

} // namespace fresnel
