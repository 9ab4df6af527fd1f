#pragma once

// Angles and indices at a boundary: directions, Snell's law, the angles that have names, and the relation of f0
// to the index. An angle is given by its cosine; eta is n_t / n_i.

#include <fresnel/exact.hpp>
#include <fresnel/number.hpp>

namespace fresnel {

// ---- directions -------------------------------------------------------------------------------------------

/// A direction or a point in space. Directions are unit vectors that point away from the surface.
template <class T>
struct vector3 {
    T x, y, z;
};

template <class T>
constexpr vector3<T> operator+(vector3<T> a, vector3<T> b) {
    return {a.x + b.x, a.y + b.y, a.z + b.z};
}

template <class T>
constexpr vector3<T> operator-(vector3<T> a, vector3<T> b) {
    return {a.x - b.x, a.y - b.y, a.z - b.z};
}

template <class T>
constexpr vector3<T> operator*(T factor, vector3<T> a) {
    return {factor * a.x, factor * a.y, factor * a.z};
}

template <class T>
constexpr T dot(vector3<T> a, vector3<T> b) {
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/// Cosine of incidence: the positive part of the cosine between two directions, capped at 1.
///
/// normal, direction   unit; the view, the light, or the half vector with either
/// returns             [0, 1], 0 where the direction is behind the surface
template <class V>
auto incidence_cosine(V normal, V direction) {
    return saturate(dot(normal, direction));
}

/// The mirror direction.
///
///   r = 2 (n . v) n - v
///
/// v        where the light comes from, or the eye is   unit, on the side of n
/// n        normal                                      unit
/// returns  unit, on the side of n
template <class V>
V reflect(V v, V n) {
    const auto d = let("d", 2 * dot(n, v));
    return d * n - v;
}

/// Snell's law: cosine of the transmitted ray, 0 beyond the critical angle.
///
///   cos_t = sqrt(1 - sin_i^2 / eta^2) = sqrt(eta^2 - 1 + cos_i^2) / eta
///
/// The second form keeps its digits at grazing incidence and near an index match.
///
/// eta     n_t / n_i                 > 0
/// cos_i   cosine of incidence       [0, 1]
/// returns [0, 1]; exactly cos_i for eta = 1 where its square is a normal number
template <class T>
T refracted_cosine(T eta, T cos_i) {
    const T g2 = let("g2", (eta - 1) * (eta + 1) + cos_i * cos_i);
    return let("cos_t", select(g2 <= 0, T(0), min(sqrt(select(g2 <= 0, T(1), g2)) / eta, T(1))));
}

/// The refracted direction; the zero vector beyond the critical angle, where there is none.
///
///   t = -(v - cos_i n) / eta - cos_t n
///
/// v        where the light comes from   unit, on the side of n
/// n        normal                       unit
/// eta      n_t / n_i                    > 0
/// returns  unit, on the other side of n
/// source   Snell's law; the vector form as in Greve 2006, "Reflections and Refractions in Ray Tracing"
template <class V, class T>
V refract(V v, V n, T eta) {
    const T cos_i = let("cos_i", dot(n, v));
    const T cos_t = refracted_cosine(eta, cos_i);
    const auto reflected = (eta - 1) * (eta + 1) + cos_i * cos_i < 0;
    const T scale = let("scale", select(reflected, T(0), 1 / eta));
    const T down = let("down", select(reflected, T(0), cos_t));
    return -scale * (v - cos_i * n) - down * n;
}

/// Snell's law into an absorbing medium: the complex cosine of the transmitted wave.
///
///   m cos_t = sqrt(m^2 - sin_i^2),   m = (n_t + i k_t) / n_i
///
/// n_i, n_t, k_t, cos_i   as `conductor`
/// returns real and imaginary part; for k_t = 0 the real `refracted_cosine`, or an imaginary number beyond the
///         critical angle
template <class T>
complex<T> complex_refracted_cosine(T n_i, T n_t, T k_t, T cos_i) {
    const normal_wave<T> t = refract_complex(n_i, n_t, k_t, cos_i);
    return complex<T>{t.a, t.b} / complex<T>{n_t / n_i, k_t / n_i};
}

/// Cosine of the direction in which the phase of the transmitted wave moves, a real angle in any medium.
///
///   tan = sin_i / Re(m cos_t)
///
/// n_i, n_t, k_t, cos_i   as `conductor`
/// source  Born and Wolf 1999, "Principles of Optics", 7th ed., sec. 14.2
template <class T>
T phase_cosine(T n_i, T n_t, T k_t, T cos_i) {
    const normal_wave<T> t = refract_complex(n_i, n_t, k_t, cos_i);
    const T length = let("length", sqrt(t.a * t.a + (1 - cos_i) * (1 + cos_i)));
    return t.a / select(length > 0, length, T(1));
}

// ---- angles that have names -------------------------------------------------------------------------------

/// Brewster's angle, at which light polarised along the plane of incidence is not reflected.
///
///   tan_B = eta,   cos_B = 1 / sqrt(1 + eta^2)
///
/// eta      n_t / n_i   > 0
/// returns  (0, 1)
template <class T>
T brewster_cosine(T eta) {
    return 1 / sqrt(1 + eta * eta);
}

/// The pseudo-Brewster angle of any medium, at which R_p is least; Brewster's for k_t = 0.
///
///   cot^2 = (1 + x) / m,   x^3 + (3 + m) x^2 + 2 m x = 4 k^2 / m,   m = n^2 + k^2 = |epsilon|
///
/// The left side rises and is convex, and leaving out all but one of its terms gives three bounds above the
/// root, so that Newton's steps from the least of them come down to it.
///
/// n_i, n_t, k_t   as `conductor`
/// returns cosine, (0, 1)
/// error   relative 1e-15 in float64, 1e-6 in float32
/// source  Humphreys-Owen 1961, "Comparison of Reflection Methods for Measuring Optical Constants"; his cubic in
///         sin^2, written in |epsilon| cot^2 - 1
template <class T>
T pseudo_brewster_cosine(T n_i, T n_t, T k_t) {
    const T n = let("n", n_t / n_i);
    const T k = let("k", k_t / n_i);
    const T m = let("m", n * n + k * k);
    const T rhs = let("rhs", 4 * (k * k / m));
    T x = min(min(rhs / (2 * m), sqrt(rhs / (3 + m))), T(1));
    for (int step = 0; step < 7; ++step) {
        const T value = x * (x * (x + 3 + m) + 2 * m) - rhs;
        x = max(x - value / (x * (3 * x + 6 + 2 * m) + 2 * m), T(0));
    }
    return sqrt((1 + x) / (1 + x + m));
}

/// The critical angle, beyond which the denser side of a surface reflects everything.
///
///   sin_c = eta,   cos_c = sqrt(1 - eta^2)
///
/// eta      n_t / n_i   > 0
/// returns  [0, 1); 0, grazing incidence, from the thinner side, where there is none
template <class T>
T critical_cosine(T eta) {
    return select(eta < 1, sqrt(select(eta < 1, (1 - eta) * (1 + eta), T(1))), T(0));
}

// ---- f0 and the index -------------------------------------------------------------------------------------

/// Reflectance at normal incidence.
///
///   f0 = ((n_t - n_i)^2 + k_t^2) / ((n_t + n_i)^2 + k_t^2)
///
/// n_i, n_t, k_t   as `conductor`
template <class T>
T normal_reflectance(T n_i, T n_t, T k_t) {
    return (square(n_t - n_i) + k_t * k_t) / (square(n_t + n_i) + k_t * k_t);
}

/// The k of a metal in air whose reflectance at normal incidence and n are known.
///
///   k = sqrt(((n + 1)^2 f0 - (n - 1)^2) / (1 - f0))
///
/// f0       reflectance at normal incidence   [0, 1), at least that of k = 0, ((n - 1) / (n + 1))^2
/// n        index                             > 0
/// source   the f0 above, solved for k
template <class T>
T k_from_f0(T f0, T n) {
    return sqrt((square(n + 1) * f0 - square(n - 1)) / (1 - f0));
}

/// Reflectance at normal incidence between two transparent media.
///
///   f0 = ((eta - 1) / (eta + 1))^2
///
/// eta      n_t / n_i   > 0
/// returns  [0, 1); the same for 1 / eta
template <class T>
T f0_from_eta(T eta) {
    const T r = let("r", (eta - 1) / (eta + 1), "amplitude");
    return square(r);
}

/// The relative index above 1 that gives f0, the outside of a surface.
///
///   eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)
///
/// f0   reflectance at normal incidence   [0, 1); infinite at 1
template <class T>
T eta_from_f0(T f0) {
    const T p = let("p", 1 + sqrt(f0));
    return square(p) / (1 - f0);
}

/// The relative index below 1 that gives the same f0, the inside of that surface.
///
///   eta = (1 - sqrt f0) / (1 + sqrt f0) = (1 - f0) / (1 + sqrt f0)^2
///
/// f0   reflectance at normal incidence   [0, 1]
template <class T>
T inner_eta_from_f0(T f0) {
    const T p = let("p", 1 + sqrt(f0));
    return (1 - f0) / square(p);
}

/// Sine of the critical angle of a surface known by its f0: the inner relative index itself.
///
/// f0      reflectance at normal incidence   [0, 1]
/// source  Akenine-Moeller et al. 2018, "Real-Time Rendering", 4th ed., sec. 9.5.3
template <class T>
T sin_critical(T f0) {
    return inner_eta_from_f0(f0);
}

/// Exact reflection from the inside of a surface known by its f0 alone.
///
/// f0      reflectance at normal incidence   [0, 1)
/// cos_i   cosine of incidence inside        [0, 1]
/// returns as `dielectric`
template <class T>
boundary<T> internal_reflection(T f0, T cos_i) {
    return dielectric(T(1), inner_eta_from_f0(f0), cos_i);
}

} // namespace fresnel
