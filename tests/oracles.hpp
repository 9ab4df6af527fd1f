#pragma once

// Fresnel's equations as others print them, at any number type that has sqrt, sin, tan, asin: independent of
// include/fresnel, whose arrangements they judge. Each formula stands as in its source, whatever its faults;
// where it is undefined is said beside it. Indices and angles carry the names used there, theta is the angle
// of incidence, and light arrives in n_i.

#include "../src/analysis/multi.hpp"

#include <fresnel/complex.hpp>
#include <fresnel/exact.hpp>

#include <cmath>

namespace fresnel::oracle {

using std::asin;
using std::cos;
using std::pow;
using std::sin;
using std::sqrt;
using std::tan;

template <class T>
struct polarised {
    T R_s, R_p;
    T mean() const { return (R_s + R_p) / 2; }
};

// ---- Wloka 2002, "Fresnel Reflection", NVIDIA -------------------------------------------------------------

/// Eq. 2: undefined beyond the critical angle, which the paper leaves out (n_i < n_t there).
template <class T>
T wloka_theta_t(T n_i, T n_t, T theta) {
    return asin(n_i / n_t * sin(theta));
}

/// Eq. 3 and 4: 0/0 at theta = 0, and wherever n_i = n_t meets theta = pi/2.
template <class T>
polarised<T> wloka_3_4(T n_i, T n_t, T theta) {
    const T theta_t = wloka_theta_t(n_i, n_t, theta);
    const T s = sin(theta - theta_t) / sin(theta + theta_t);
    const T p = tan(theta - theta_t) / tan(theta + theta_t);
    return {s * s, p * p};
}

/// Eq. 5: the limit at theta = 0.
template <class T>
T wloka_5(T n_i, T n_t) {
    return (n_i - n_t) * (n_i - n_t) / ((n_i + n_t) * (n_i + n_t));
}

/// Eq. 6: as eq. 3 and 4, and so undefined at theta = 0.
template <class T>
T wloka_6(T n_i, T n_t, T theta) {
    const T theta_t = wloka_theta_t(n_i, n_t, theta);
    const T s = sin(theta - theta_t) / sin(theta + theta_t);
    const T q = cos(theta + theta_t) / cos(theta - theta_t);
    return s * s / 2 * (1 + q * q);
}

/// Eq. 7 to 9: undefined beyond the critical angle, and 0/0 where n_i = n_t meets theta = pi/2.
template <class T>
T wloka_9(T n_i, T n_t, T cos_theta) {
    const T r = n_i / n_t;
    const T c = cos_theta * r;
    const T g = sqrt(1 + c * c - r * r);
    const T s = (g - c) / (g + c);
    const T q = (c * (g + c) - r * r) / (c * (g - c) + r * r);
    return s * s / 2 * (1 + q * q);
}

/// Figure 5: R(0) from the ratio of indices, whichever way round.
template <class T>
T wloka_figure_5_R0(T ratio_of_indices) {
    return pow(1 - ratio_of_indices, T(2)) / pow(1 + ratio_of_indices, T(2));
}

/// Figure 5: eq. 10, with the power function.
template <class T>
T wloka_figure_5(T R0, T cos_theta) {
    return R0 + (1 - R0) * pow(1 - cos_theta, T(5));
}

// ---- Lagarde 2013, "Memo on Fresnel equations" ------------------------------------------------------------

/// First dielectric listing: no test for total internal reflection, where the root is of a negative number;
/// 0/0 at eta = 1, cos = 0.
template <class T>
polarised<T> memo_dielectric_1(T eta, T cos_theta) {
    const T sin2 = 1 - cos_theta * cos_theta;
    const T t0 = sqrt(1 - sin2 / (eta * eta));
    const T t1 = eta * t0;
    const T t2 = eta * cos_theta;
    const T rs = (cos_theta - t1) / (cos_theta + t1);
    const T rp = (t0 - t2) / (t0 + t2);
    return {rs * rs, rp * rp};
}

/// Second dielectric listing, which returns 1 for an imaginary g; 0/0 at eta = 1, cos = 0.
template <class T>
T memo_dielectric_2(T eta, T cos_theta) {
    const T c = cos_theta;
    const T temp = eta * eta + c * c - 1;
    if (temp < 0) return 1;
    const T g = sqrt(temp);
    const T s = (g - c) / (g + c);
    const T q = ((g + c) * c - 1) / ((g - c) * c + 1);
    return s * s / 2 * (1 + q * q);
}

/// a^2 and b^2 with n_i: R_p has a tangent, so theta = pi/2 is infinity over infinity.
template <class T>
polarised<T> memo_conductor_a2_b2(T n_i, T n_t, T k_t, T theta) {
    const T sin_theta = sin(theta), cos_theta = cos(theta);
    const T d = n_t * n_t - k_t * k_t - n_i * n_i * sin_theta * sin_theta;
    const T root = sqrt(d * d + 4 * n_t * n_t * k_t * k_t);
    const T a2 = (root + d) / (2 * n_i * n_i);
    const T b2 = (root - d) / (2 * n_i * n_i);
    const T a = sqrt(a2);
    const T st = sin_theta * tan(theta);
    const T R_s = (a2 + b2 - 2 * a * cos_theta + cos_theta * cos_theta) /
                  (a2 + b2 + 2 * a * cos_theta + cos_theta * cos_theta);
    return {R_s, R_s * (a2 + b2 - 2 * a * st + st * st) / (a2 + b2 + 2 * a * st + st * st)};
}

/// The listing with eta and eta_k; 0/0 at eta = 1, eta_k = 0, cos = 0.
template <class T>
polarised<T> memo_conductor_listing(T eta, T eta_k, T cos_theta) {
    const T cos2 = cos_theta * cos_theta;
    const T sin2 = 1 - cos2;
    const T eta2 = eta * eta, eta_k2 = eta_k * eta_k;
    const T t0 = eta2 - eta_k2 - sin2;
    const T a2_plus_b2 = sqrt(t0 * t0 + 4 * eta2 * eta_k2);
    const T t1 = a2_plus_b2 + cos2;
    const T a = sqrt((a2_plus_b2 + t0) / 2);
    const T t2 = 2 * a * cos_theta;
    const T R_s = (t1 - t2) / (t1 + t2);
    const T t3 = cos2 * a2_plus_b2 + sin2 * sin2;
    const T t4 = t2 * sin2;
    return {R_s, R_s * (t3 - t4) / (t3 + t4)};
}

/// The approximation for conductors in air, after Pharr and Humphreys.
template <class T>
polarised<T> memo_air_conductor(T eta, T eta_k, T cos_theta) {
    const T cos2 = cos_theta * cos_theta;
    const T two_eta_cos = 2 * eta * cos_theta;
    const T t0 = eta * eta + eta_k * eta_k;
    const T t1 = t0 * cos2;
    return {(t0 - two_eta_cos + cos2) / (t0 + two_eta_cos + cos2),
            (t1 - two_eta_cos + 1) / (t1 + two_eta_cos + 1)};
}

/// Schlick from R(0).
template <class T>
T memo_schlick(T R0, T cos_theta) {
    return R0 + (1 - R0) * pow(1 - cos_theta, T(5));
}

/// Schlick without R(0), dielectric.
template <class T>
T memo_schlick_n(T n_i, T n_t, T cos_theta) {
    return ((n_t - n_i) * (n_t - n_i) + 4 * n_t * n_i * pow(1 - cos_theta, T(5))) /
           ((n_t + n_i) * (n_t + n_i));
}

/// Schlick without R(0), conductor.
template <class T>
T memo_schlick_nk(T n_i, T n_t, T k_t, T cos_theta) {
    return ((n_t - n_i) * (n_t - n_i) + 4 * n_t * n_i * pow(1 - cos_theta, T(5)) + k_t * k_t) /
           ((n_t + n_i) * (n_t + n_i) + k_t * k_t);
}

/// Schlick with cos_t on the inside of a denser medium.
template <class T>
T memo_schlick_internal(T n_t, T n_i, T cos_x) {
    const T r = (n_t - n_i) / (n_t + n_i);
    const T R0 = r * r;
    if (n_i > n_t) {
        const T inv_eta = n_i / n_t;
        const T sin2_t = inv_eta * inv_eta * (1 - cos_x * cos_x);
        if (sin2_t > 1) return 1;
        cos_x = sqrt(1 - sin2_t);
    }
    return R0 + (1 - R0) * pow(1 - cos_x, T(5));
}

/// R(0) of a conductor, first form.
template <class T>
T memo_R0(T n_i, T n_t, T k_t) {
    return ((n_t - n_i) * (n_t - n_i) + k_t * k_t) / ((n_t + n_i) * (n_t + n_i) + k_t * k_t);
}

/// R(0) of a conductor, third form: the real part of a quotient of complex products.
template <class T>
T memo_R0_complex(T n_i, T n_t, T k_t) {
    const complex<T> above = complex<T>{n_t - n_i, k_t} * complex<T>{n_t - n_i, -k_t};
    const complex<T> below = complex<T>{n_t + n_i, k_t} * complex<T>{n_t + n_i, -k_t};
    return (above / below).re;
}

// ---- complex amplitudes -----------------------------------------------------------------------------------

/// The square root with a positive real part.
template <class T>
complex<T> principal_sqrt(complex<T> z) {
    const T size = sqrt(norm(z));
    const T a = sqrt((size + z.re) / 2), b = sqrt((size - z.re) / 2);
    return z.im < 0 ? complex<T>{a, -b} : complex<T>{a, b};
}

template <class T>
struct plain_amplitudes {
    complex<T> r_s, r_p, t_s, t_p;
};

/// Fresnel's amplitudes by Snell's complex cosine, with n + i k and Verdet's sign of r_p:
/// r_s = (n_i cos_i - m cos_t) / (n_i cos_i + m cos_t), r_p = (m cos_i - n_i cos_t) / (m cos_i + n_i cos_t).
/// 0/0 for equal media at grazing incidence. (Born and Wolf 1999, sec. 1.5.2; Lagarde 2013.)
template <class T>
plain_amplitudes<T> amplitudes(T n_i, T n_t, T k_t, T cos_i) {
    const complex<T> m = {n_t, k_t};
    const complex<T> sin_t = complex<T>{n_i * sqrt((1 - cos_i) * (1 + cos_i)), T(0)} / m;
    const complex<T> cos_t = principal_sqrt(complex<T>{T(1), T(0)} - sin_t * sin_t);
    const complex<T> i_i = {n_i * cos_i, T(0)}, i_t = m * cos_t;
    const complex<T> p_i = {m.re * cos_i, m.im * cos_i}, p_t = {n_i * cos_t.re, n_i * cos_t.im};
    return {(i_i - i_t) / (i_i + i_t), (p_i - p_t) / (p_i + p_t), (i_i + i_i) / (i_i + i_t),
            (i_i + i_i) / (p_i + p_t)};
}

/// The truth at 60 digits, at exactly the given binary inputs. The amplitudes above lose digits, even 60, for
/// inputs as small as 1e-300; with M = m^2 - 1 formed from differences,
///   c - q = -M / (c + q)   and   m^2 c - q = M (c (c + q) - 1) / (c + q)
/// lose none. T_p is not from T_s but from the Poynting vector, 4 c Re(m^2 conj q) / |m^2 c + q|^2.
inline boundary<real50> truth(const real50& n_i, const real50& n_t, const real50& k_t, const real50& c) {
    if (n_i == n_t && k_t == 0) return {0, 0, 1, 1};
    const real50 n = n_t / n_i, k = k_t / n_i;
    const complex<real50> M = {(n_t - n_i) * (n_t + n_i) / (n_i * n_i) - k * k, 2 * n * k};
    const complex<real50> q2 = {M.re + c * c, M.im};
    // the smaller part of the root from the product, which is exact where the difference is not
    const real50 size = sqrt(norm(q2));
    const real50 large = sqrt((size + abs(q2.re)) / 2);
    const real50 small = large == 0 ? real50(0) : M.im / 2 / large;
    const complex<real50> q = q2.re < 0 ? complex<real50>{small, large} : complex<real50>{large, small};

    const complex<real50> sum = {c + q.re, q.im};
    const complex<real50> m2 = {M.re + 1, M.im};
    const complex<real50> p = {m2.re * c + q.re, m2.im * c + q.im};
    const complex<real50> nu = {c * sum.re - 1, c * sum.im};
    return {norm(M) / square(norm(sum)), norm(M) * norm(nu) / (norm(sum) * norm(p)), 4 * c * q.re / norm(sum),
            4 * c * (m2.re * q.re + m2.im * q.im) / norm(p)};
}

} // namespace fresnel::oracle
