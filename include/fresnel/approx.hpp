#pragma once

// Approximations of Fresnel reflectance, each under the name its users know. All take cos_i in [0, 1], return
// a reflectance in [0, 1], and are evaluated per colour channel. x below is 1 - cos_i.
//
// The largest error of each against the exact equations, and over what, is in its registry row (models.hpp),
// where a test measures the same number.

#include <fresnel/exact.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/number.hpp>

namespace fresnel {

// ---- the Schlick family -----------------------------------------------------------------------------------

/// Schlick's approximation with any reflectance at grazing incidence.
///
///   F = f0 + (f90 - f0) x^5
///
/// f0, f90   reflectance at normal and grazing incidence   [0, 1]
/// source    Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering"; f90 as in
///           "Real-Time Rendering", 4th ed., eq. 9.18
template <class T>
T schlick_f90(T f0, T f90, T cos_i) {
    const T x = let("x", 1 - cos_i);
    return f0 + (f90 - f0) * pow5(x);
}

/// Schlick's approximation of dielectric or conductor reflectance.
///
///   F = f0 + (1 - f0) x^5
///
/// f0      reflectance at normal incidence   [0, 1]
/// returns [f0, 1]; exact at cos_i = 0 and 1; monotone
/// source  Schlick 1994, "An Inexpensive BRDF Model for Physically-based Rendering"
template <class T>
T schlick(T f0, T cos_i) {
    const T x = let("x", 1 - cos_i);
    return f0 + (1 - f0) * pow5(x);
}

/// Schlick's approximation with the power left free, which follows metals far better.
///
///   F = f0 + (f90 - f0) x^power
///
/// f0, f90   reflectance at normal and grazing incidence   [0, 1]
/// power     sharpness of the rise, 5 is Schlick's         [0.1, 1000]
/// source    "Real-Time Rendering", 4th ed., eq. 9.18, where the power is written 1 / p
template <class T>
T schlick_power(T f0, T f90, T power, T cos_i) {
    const T rise = let("rise", f90 - f0);
    return f0 + rise * pow(1 - cos_i, power);
}

/// Schlick's approximation written in n and k, without f0.
///
///   F = ((n - 1)^2 + 4 n x^5 + k^2) / ((n + 1)^2 + k^2)
///
/// n, k    index relative to the ambient medium   [0.001, 1000], [0, 10000]
/// source  Lazanyi and Szirmay-Kalos 2005, "Fresnel Term Approximations for Metals"
template <class T>
T schlick_nk(T n, T k, T cos_i) {
    const T x = let("x", 1 - cos_i);
    return min((square(n - 1) + k * k + 4 * n * pow5(x)) / (square(n + 1) + k * k), T(1));
}

/// Schlick's approximation from inside a denser medium: the transmitted cosine takes the place of cos_i.
///
///   F = f0 + (1 - f0) (1 - cos_t)^5,   1 beyond the critical angle
///
/// eta     n_t / n_i   [0.01, 1]
/// source  Lagarde 2013, "Memo on Fresnel equations"; "Real-Time Rendering", 4th ed., sec. 9.5.3
template <class T>
T schlick_internal(T eta, T cos_i) {
    const T f0 = let("f0", f0_from_eta(eta));
    return schlick(f0, refracted_cosine(eta, cos_i));
}

// ---- one parameter ----------------------------------------------------------------------------------------

/// Schlick's curve with its fifth power replaced by a spherical Gaussian.
///
///   F = f0 + (1 - f0) 2^((-5.55473 c - 6.98316) c)
///
/// f0      reflectance at normal incidence   [0, 1]
/// returns [f0, 1]; at cos_i = 1 it is f0 + 1.7e-4 (1 - f0)
/// source  Lagarde 2012, "Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel"; Karis 2013
template <class T>
T spherical_gaussian(T f0, T cos_i) {
    const T p = let("p", -(ratio<T, 555473, 100000>() * cos_i + ratio<T, 698316, 100000>()) * cos_i);
    return f0 + (1 - f0) * exp2(p);
}

/// A curve found by symbolic regression.
///
///   F = f0 + (x - f0) x^4
///
/// f0      reflectance at normal incidence   [0, 1]
/// source  photometric.io, "Improving Schlick's Approximation"
template <class T>
T photometric(T f0, T cos_i) {
    const T x = let("x", 1 - cos_i);
    return f0 + (x - f0) * square(x * x);
}

/// The a of `powers_4_8`.
template <class T>
T powers_4_8_weight() {
    return ratio<T, 55, 100>();
}

/// Two powers for one operation more than Schlick; better than Schlick on dielectrics in every norm.
///
///   F = f0 + x^4 ((a - f0) + (1 - a) x^4),   a = 0.55
///
/// f0      reflectance at normal incidence   [0, 1]; made for f0 in [0.02, 0.18]
/// returns [0, 1]; below f0 somewhere for f0 > 0.55
/// source  this library: minimax fit over eta in [1.333, 2.42]
template <class T>
T powers_4_8(T f0, T cos_i) {
    const T a = powers_4_8_weight<T>();
    const T x = let("x", 1 - cos_i);
    const T x4 = let("x4", square(square(x)));
    return f0 + x4 * ((a - f0) + (1 - a) * x4);
}

/// How far the rise of `powers_3_9` is below 1 - f0 at normal incidence.
template <class T>
T powers_3_9_depth() {
    return ratio<T, 54, 100>();
}

/// Two powers, two fifths of Schlick's error on dielectrics.
///
///   F = f0 + x^3 max((1 - f0) - 0.54 (1 - x^6), 0)
///
/// f0      reflectance at normal incidence   [0, 1]; made for f0 in [0.02, 0.18]
/// returns [f0, 1]: the maximum, which acts for f0 > 0.46 alone, keeps a bright f0 from dipping below itself
/// source  this library: minimax fit over eta in [1.333, 2.42]
template <class T>
T powers_3_9(T f0, T cos_i) {
    const T x = let("x", 1 - cos_i);
    const T x3 = let("x3", x * x * x);
    const T rise =
        let("rise", saturate((1 - f0) - powers_3_9_depth<T>() * (1 - x3 * x3)), "saturate is free on GPUs");
    return f0 + x3 * rise;
}

/// Coefficients of three powers of 1 - cos_i, the lowest first.
template <class T>
struct three_terms {
    T first, second, third;
};

/// p, q and r of `powers_3_6_9`.
template <class T>
three_terms<T> powers_3_6_9_terms(T f0) {
    const T s = let("s", sqrt(f0 + tiny<T>()), "2^-80 keeps the slope at f0 = 0 finite");
    const T p =
        let("p", ratio<T, 290623, 100000>() * s - ratio<T, 2379, 100000>() - ratio<T, 478491, 100000>() * f0);
    const T q =
        let("q", ratio<T, 43137, 100000>() - ratio<T, 58931, 100000>() * s - ratio<T, 231299, 100000>() * f0);
    const T r = let("r", 1 - f0 - p - q);
    return {p, q, r};
}

/// Three powers with coefficients in sqrt(f0), a tenth of Schlick's error on dielectrics.
///
///   F = f0 + y (p + y (q + y r)),   y = x^3,   r = 1 - f0 - p - q
///   p = -0.02379 + 2.90623 s - 4.78491 f0,   q = 0.43137 - 0.58931 s - 2.31299 f0,   s = sqrt(f0)
///
/// f0      reflectance at normal incidence   [0, 1]; made for f0 in [0.02, 0.18]
/// returns clamped to [0, 1], which acts only for f0 far above that range
/// source  this library: minimax fit over eta in [1.333, 2.42]
template <class T>
T powers_3_6_9(T f0, T cos_i) {
    const three_terms<T> t = powers_3_6_9_terms(f0);
    const T x = let("x", 1 - cos_i);
    const T y = let("y", x * x * x);
    return saturate(f0 + y * (t.first + y * (t.second + y * t.third)));
}

/// The rim factor 1 - cos_i, as a stand-in for reflectance.
///
///   F = x
///
/// source  Wloka 2002, "Fresnel Reflection", fig. 4 and 15
template <class T>
T one_minus_cos(T cos_i) {
    return 1 - cos_i;
}

/// No Fresnel effect at all.
///
///   F = f0
///
/// f0      reflectance at every angle   [0, 1]
template <class T>
T constant(T f0, [[maybe_unused]] T cos_i) {
    return f0;
}

// ---- conductors; n and k are relative to the ambient medium ----------------------------------------------

/// The classic approximation for metals: exact for a large index, without a square root.
///
///   R_s = ((n - c)^2 + k^2) / ((n + c)^2 + k^2)
///   R_p = ((n c - 1)^2 + k^2 c^2) / ((n c + 1)^2 + k^2 c^2)
///
/// n, k    index relative to the ambient medium   [0.001, 1000], [0, 10000]; made for k >= 1
/// returns (R_s + R_p) / 2
/// source  Pharr and Humphreys, "Physically Based Rendering"; Lagarde 2013, "Memo on Fresnel equations"
template <class T>
T air_conductor(T n, T k, T cos_i) {
    const T c = cos_i;
    const T k2 = let("k2", k * k);
    const T n_minus_c = let("n_minus_c", n - c);
    const T n_plus_c = let("n_plus_c", n + c);
    const T R_s = let("R_s", (square(n_minus_c) + k2) / (square(n_plus_c) + k2));
    const T nc = let("nc", n * c);
    const T kc2 = let("kc2", k2 * (c * c));
    const T R_p = let("R_p", (square(nc - 1) + kc2) / (square(nc + 1) + kc2));
    return (R_s + R_p) / 2;
}

/// Schlick's approximation less a term for the dip that metals have before grazing incidence.
///
///   F = schlick_nk(n, k) - a c x^alpha
///
/// n, k    index relative to the ambient medium   [0.001, 1000], [0, 10000]
/// a       depth of the dip                       [0, 2000]; the paper suggests 2 n
/// alpha   sharpness of the dip                   [0.1, 1000]; fitted per material and channel
/// returns clamped to [0, 1]: a too large a would leave it
/// source  Lazanyi and Szirmay-Kalos 2005, "Fresnel Term Approximations for Metals"
template <class T>
T lazanyi(T n, T k, T a, T alpha, T cos_i) {
    const T F = let("F", schlick_nk(n, k, cos_i));
    return saturate(F - a * cos_i * pow(1 - cos_i, alpha));
}

/// The largest r of `gulbrandsen`: n is infinite at 1.
template <class T>
T gulbrandsen_limit() {
    return ratio<T, 9999, 10000>();
}

/// The indices of `gulbrandsen`, of the ambient medium and behind, all times 1 - r^2, which spares divisions.
template <class T>
struct artist_indices {
    T n_i, n, k;
};

template <class T>
artist_indices<T> gulbrandsen_indices(T r, T g) {
    const T f0 = let("f0", min(r, gulbrandsen_limit<T>()) + tiny<T>(), "2^-80 keeps its root's slope finite");
    const T root = let("root", sqrt(f0));
    const T one_minus_f0 = let("one_minus_f0", 1 - f0);
    const T one_plus_f0 = let("one_plus_f0", 1 + f0);
    const T one_plus_root = let("one_plus_root", 1 + root);
    const T one_minus_root = let("one_minus_root", 1 - root);

    const T n_i = let("n_i", one_minus_f0 * one_plus_f0, "indices, all times 1 - f0^2\n");
    const T n_max = let("n_max", one_plus_root * one_plus_root * one_plus_f0);
    const T n_min = let("n_min", one_minus_f0 * one_minus_f0);
    const T n_0 = let("n_0", one_minus_root * one_minus_root * one_plus_f0, "1 / n_max; k is 0 at both");
    const T n =
        let("n", n_max * (1 - g) + n_min * g); // the other form of a mix is 0 at g = 1 where n_max is large
    const T k = let("k", sqrt(max((n_max - n) * (n - n_0), T(0)) + tiny<T>()));
    return {n_i, n, k};
}

/// The index n + i k, relative to the ambient medium, that `gulbrandsen` stands for.
template <class T>
complex<T> gulbrandsen_index(T r, T g) {
    const auto [n_i, n, k] = gulbrandsen_indices(r, g);
    return {n / n_i, k / n_i};
}

/// An index from two artist's colours, then the exact equations.
///
///   n = mix((1 + sqrt r) / (1 - sqrt r), (1 - r) / (1 + r), g),   k^2 = (n_max - n) (n - 1 / n_max)
///
/// r       reflectance at normal incidence   [0, 1]; clamped to 0.9999, where n reaches 40 000
/// g       edge tint                         [0, 1]
/// returns [0, 1]; r at normal incidence for every g, to rounding
/// source  Gulbrandsen 2014, "Artist Friendly Metallic Fresnel"; k^2 = ((n + 1)^2 r - (n - 1)^2) / (1 - r)
///         factored by its roots in n
template <class T>
T gulbrandsen(T r, T g, T cos_i) {
    const auto [n_i, n, k] = gulbrandsen_indices(r, g);
    return conductor(n_i, n, k, cos_i).reflectance();
}

/// Schlick's approximation at cos_i = 1/7, where f82 is.
template <class T>
T schlick_at_82(T f0) {
    return let("at_82", f0 + (1 - f0) * ratio<T, 7776, 16807>(),
               "Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5");
}

/// The b for which b c x^6 is `depth` at c = 1/7.
template <class T>
T dip_of_depth(T depth) {
    return let("b", depth * ratio<T, 823543, 46656>(), "divided by c x^6 at cos_i = 1/7");
}

/// Schlick's approximation with the dip of Lazanyi, through given reflectances at 0, 81.8 and 90 degrees.
///
///   F = S(c) - (S(1/7) - f82) c x^6 / ((1/7) (6/7)^6),   S(c) = f0 + (f90 - f0) x^power
///
/// f0, f90   reflectance at normal and grazing incidence   [0, 1]
/// f82       reflectance at cos_i = 1/7                    [0, 1]
/// power     sharpness of the rise, 5 is Schlick's         [0.1, 1000]
/// returns   clamped to [0, 1]
/// source    Hoffman 2019, "Fresnel Equations Considered Harmful"; the general form as `hoffman_schlick` of
///           MaterialX
template <class T>
T hoffman(T f0, T f82, T f90, T power, T cos_i) {
    const T at_82 = let("at_82", schlick_power(f0, f90, power, ratio<T, 1, 7>()), "at cos_i = 1/7: x is 6/7");
    const T b = dip_of_depth(at_82 - f82);
    const T x = let("x", 1 - cos_i);
    const T x2 = let("x2", x * x);
    return saturate(schlick_power(f0, f90, power, cos_i) - b * cos_i * (x2 * x2 * x2));
}

/// Schlick's approximation less the dip of Lazanyi with alpha = 6, its depth b given.
///
///   F = f0 + (1 - f0) x^5 - b c x^6
///
/// The shared body of `f82` and `f82_tint`.
template <class T>
T schlick_with_dip(T f0, T b, T cos_i) {
    const T x = let("x", 1 - cos_i);
    const T x5 = let("x5", pow5(x));
    return saturate(f0 + (1 - f0) * x5 - b * cos_i * (x5 * x));
}

/// Schlick's approximation with a dip, through given reflectances at 0 and 81.8 degrees.
///
///   F = f0 + (1 - f0) x^5 - b c x^6,   b = (schlick(f0, 1/7) - f82) / ((1/7) (6/7)^6)
///
/// f0      reflectance at normal incidence   [0, 1]
/// f82     reflectance at cos_i = 1/7        [0, 1]
/// returns clamped to [0, 1]; f82 at cos_i = 1/7
/// source  Hoffman 2019, "Fresnel Equations Considered Harmful"
template <class T>
T f82(T f0, T f82, T cos_i) {
    return schlick_with_dip(f0, dip_of_depth(schlick_at_82(f0) - f82), cos_i);
}

/// The same curve with f82 given as a fraction of Schlick's value there.
///
///   F = f0 + (1 - f0) x^5 - b c x^6,   b = schlick(f0, 1/7) (1 - tint) / ((1/7) (6/7)^6)
///
/// f0      reflectance at normal incidence   [0, 1]
/// tint    f82 / schlick(f0, 1/7)            [0, 1]; 1 is Schlick's approximation
/// returns clamped to [0, 1]: a strong tint would go below 0
/// source  Kutz, Hasan and Edmondson 2021, "Novel aspects of the Adobe Standard Material"; OpenPBR
template <class T>
T f82_tint(T f0, T tint, T cos_i) {
    return schlick_with_dip(f0, dip_of_depth(schlick_at_82(f0) * (1 - tint)), cos_i);
}

/// The q of `powers_4_12`.
template <class T>
T powers_4_12_term(T f0, T f82) {
    // q ((6/7)^8 - 1) = (f82 - f0) (7/6)^4 - (1 - f0)
    const T rise =
        let("rise", (1 - f0) - (f82 - f0) * ratio<T, 2401, 1296>(), "1 / x^4 at cos_i = 1/7: (7/6)^4");
    return let("q", rise * ratio<T, 5764801, 4085185>(), "1 / (1 - x^8) there");
}

/// Two powers through f0 and f82: the best single form for blends of metals and dielectrics.
///
///   F = f0 + x^4 (p + q x^8),   p + q = 1 - f0,   F(1/7) = f82
///
/// f0      reflectance at normal incidence   [0, 1]
/// f82     reflectance at cos_i = 1/7        [0, 1]
/// returns clamped to [0, 1]
/// source  this library
template <class T>
T powers_4_12(T f0, T f82, T cos_i) {
    const T q = powers_4_12_term(f0, f82);
    const T x = let("x", 1 - cos_i);
    const T x4 = let("x4", square(square(x)));
    return saturate(f0 + x4 * ((1 - f0 - q) + q * (x4 * x4)));
}

/// c2, c8 and c16 of `powers_2_8_16`.
template <class T>
three_terms<T> powers_2_8_16_terms(T f0, T f82) {
    const T rise = let("rise", 1 - f0);
    const T dip = let("dip", f82 - f0);
    const T c2 = let("c2", ratio<T, 104343, 100000>() * dip - ratio<T, 27520, 100000>() * rise);
    const T c8 = let("c8", ratio<T, 155944, 100000>() * dip + ratio<T, 45498, 100000>() * rise);
    const T c16 = let("c16", ratio<T, 82022, 100000>() * rise - ratio<T, 260287, 100000>() * dip);
    return {c2, c8, c16};
}

/// Three powers through f0 and f82: nine tenths of the worst error of `f82` on metals.
///
///   F = f0 + c2 x^2 + c8 x^8 + c16 x^16,   c_e = A_e (1 - f0) + B_e (f82 - f0)
///
/// f0      reflectance at normal incidence   [0, 1]
/// f82     reflectance at cos_i = 1/7        [0, 1]; met to 3e-6
/// returns clamped to [0, 1]: a very low f82 would go below 0
/// source  this library: least-squares fit over 28 metals, three channels each
template <class T>
T powers_2_8_16(T f0, T f82, T cos_i) {
    const three_terms<T> t = powers_2_8_16_terms(f0, f82);
    const T x = let("x", 1 - cos_i);
    const T x2 = let("x2", square(x));
    const T x8 = let("x8", square(x2 * x2));
    return saturate(f0 + t.first * x2 + x8 * (t.second + t.third * x8));
}

// ---- artistic ---------------------------------------------------------------------------------------------

/// The rim of game shaders.
///
///   F = saturate(bias + scale x^power)
///
/// bias    value at normal incidence   [-10, 10]
/// scale   strength of the rim         [-10, 10]
/// power   sharpness of the rim        [0.1, 1000]
/// returns clamped to [0, 1]
/// source  Fernando and Kilgard 2003, "The Cg Tutorial", ch. 7; Halladay 2014, "Fresnel Shading"
template <class T>
T bias_scale_power(T bias, T scale, T power, T cos_i) {
    return saturate(bias + scale * pow(1 - cos_i, power));
}

} // namespace fresnel
