#pragma once

// Hemispherical averages: the reflectance of a surface lit evenly from every direction.
//
//   average = integral over cos_i from 0 to 1 of 2 F(cos_i) cos_i
//
// A polynomial model averages term by term: x^p gives 2 / ((p + 1) (p + 2)) and cos_i x^p gives
// 4 / ((p + 1) (p + 2) (p + 3)), with x = 1 - cos_i. Each such average below is exact where its model does
// not clamp; where a model clamps, the average of the unclamped polynomial is returned.

#include <fresnel/approx.hpp>
#include <fresnel/number.hpp>

namespace fresnel {

/// (artanh(u) - u) / u^3, given log_m = 2 artanh(u): a series below 1/4, where the difference cancels.
///
/// u       [0, 1)
/// error   relative 1e-16 of truncation below u = 1/4, whatever the number type
template <class T>
T artanh_rest(T u, T log_m) {
    const T v = let("v", u * u);
    const T low =
        let("low", ratio<T, 1, 15>() +
                       v * (ratio<T, 1, 17>() +
                            v * (ratio<T, 1, 19>() +
                                 v * (ratio<T, 1, 21>() + v * (ratio<T, 1, 23>() + v * ratio<T, 1, 25>())))));
    const T series = let(
        "series",
        ratio<T, 1, 3>() +
            v * (ratio<T, 1, 5>() +
                 v * (ratio<T, 1, 7>() +
                      v * (ratio<T, 1, 9>() + v * (ratio<T, 1, 11>() + v * (ratio<T, 1, 13>() + v * low))))));
    const auto small = 4 * u < 1;
    const T u3 = let("u3", select(small, T(1), v * u));
    return select(small, series, (log_m / 2 - u) / u3);
}

/// Average reflectance of a boundary between transparent media.
///
///   (1 + u^2)^3 A = 2 u^2 (1 + u)^2 ln u + u P(u) / 12 + u (1 - u)^2 (1 + u)^4 (1 + 6 u^2 + u^4) h(u) / 4
///   u = |eta - 1| / (eta + 1),   h = (artanh(u) - u) / u^3
///   P = 7 + 44 u - 24 u^3 + 6 u^4 + 36 u^5 + 16 u^6 + 8 u^7 + 3 u^8
///   average = A for eta > 1 and 1 - eta^2 (1 - A) for eta < 1
///
/// eta     n_t / n_i   [0.01, 100]
/// returns [0, 1); exactly 0 at eta = 1
/// error   relative 1e-14 in float64 and 2e-6 in float32 on [0.1, 10], through eta = 1
/// source  Walsh 1926, "The Reflection Factor of a Polished Glass Surface for Diffused Light"; written in u,
///         in which the poles of the textbook form at eta = 1 cancel by hand
template <class T>
T dielectric_average(T eta) {
    const T u = let("u", abs(eta - 1) / (eta + 1));
    const T v = let("v", u * u);
    const T log_u = let("log_u", log(select(u <= 0, T(1), u)));
    const T h = let("h", artanh_rest(u, abs(log(eta))));

    const T high = let("high", 6 + u * (36 + u * (16 + u * (8 + 3 * u))));
    const T P = let("P", 7 + u * (44 + v * (u * high - 24)));
    const T up = let("up", square(1 + u));
    const T down = let("down", square(1 - u) * up * up);
    const T bracket = let("bracket", 2 * (u * up * log_u) + P / 12 + down * (1 + v * (6 + v)) * h / 4);
    const T v1 = let("v1", 1 + v);
    const T A = let("A", u * bracket / (v1 * v1 * v1));
    return select(eta <= 1, (1 - eta) * (1 + eta) + eta * eta * A, A);
}

/// One segment of `conductor_average`: the integral of 2 R c dc from lo to hi.
///
/// Five-point Gauss-Legendre on 32 panels of t, c = lo + (hi - lo) t^3 (10 - 15 t + 6 t^2), fine at both ends.
template <class T>
T average_between(T n_i, T n_t, T k_t, T lo, T hi) {
    const T root70 = sqrt(T(70)), root = 2 * sqrt(ratio<T, 10, 7>());
    const T node[3] = {T(0), sqrt(5 - root) / 3, sqrt(5 + root) / 3};
    const T weight[3] = {ratio<T, 128, 225>() / 2, (322 + 13 * root70) / 900, (322 - 13 * root70) / 900};
    T sum = T(0);
    for (int panel = 0; panel < 32; ++panel)
        for (int i = 0; i < 3; ++i)
            for (int side = -1; side <= 1; side += 2) {
                const T t = (2 * panel + 1 + side * node[i]) / 64;
                const T c = min(lo + (hi - lo) * (t * t * t * (10 - t * (15 - 6 * t))), T(1));
                const T slope = (hi - lo) * (30 * square(t * (1 - t)));
                sum = sum + weight[i] * (conductor(n_i, n_t, k_t, c).reflectance() * (2 * c) * slope);
            }
    return sum / 64;
}

/// Average reflectance of any boundary, by quadrature; `dielectric_average` has the closed form for k_t = 0.
///
/// Split at the cosine where n^2 - k^2 = sin_i^2, at which a weakly absorbing medium has a critical angle.
///
/// n_i, n_t, k_t   as `conductor`
/// returns [0, 1]
/// error   absolute 1e-7 for n_t / n_i >= 0.3 or k_t / n_i >= 0.1, up to 100; otherwise 1e-6
template <class T>
T conductor_average(T n_i, T n_t, T k_t) {
    const T E = let("E", ((n_t - n_i) * (n_t + n_i) - k_t * k_t) / (n_i * n_i));
    const auto split = abs(2 * E + 1) < 1; // -1 < E < 0
    const T c_c = let("c_c", select(split, sqrt(select(split, -E, T(1))), T(0)));
    return average_between(n_i, n_t, k_t, T(0), c_c) + average_between(n_i, n_t, k_t, c_c, T(1));
}

/// Average of `constant`: f0 itself.
template <class T>
T constant_average(T f0) {
    return f0;
}

/// Average of `one_minus_cos`: 1/3.
template <class T>
T one_minus_cos_average() {
    return ratio<T, 1, 3>();
}

/// Average of `schlick`.
///
///   f0 + (1 - f0) / 21
template <class T>
T schlick_average(T f0) {
    return f0 + (1 - f0) / 21;
}

/// Average of `schlick_f90`.
///
///   f0 + (f90 - f0) / 21
template <class T>
T schlick_f90_average(T f0, T f90) {
    return f0 + (f90 - f0) / 21;
}

/// Average of `schlick_power`.
///
///   f0 + 2 (f90 - f0) / ((power + 1) (power + 2))
template <class T>
T schlick_power_average(T f0, T f90, T power) {
    return f0 + 2 * (f90 - f0) / ((power + 1) * (power + 2));
}

/// Average of `schlick_nk`: that of `schlick` at the f0 of n and k.
template <class T>
T schlick_nk_average(T n, T k) {
    return schlick_average(normal_reflectance(T(1), n, k));
}

/// Average of `lazanyi`, where it does not clamp.
///
///   schlick_nk_average(n, k) - 4 a / ((alpha + 1) (alpha + 2) (alpha + 3))
template <class T>
T lazanyi_average(T n, T k, T a, T alpha) {
    return schlick_nk_average(n, k) - 4 * a / ((alpha + 1) * (alpha + 2) * (alpha + 3));
}

/// Average of `bias_scale_power`, where it does not clamp.
///
///   bias + 2 scale / ((power + 1) (power + 2))
template <class T>
T bias_scale_power_average(T bias, T scale, T power) {
    return bias + 2 * scale / ((power + 1) * (power + 2));
}

/// Average of `photometric`.
///
///   f0 + 1/21 - f0 / 15
template <class T>
T photometric_average(T f0) {
    return f0 + (ratio<T, 1, 21>() - f0 / 15);
}

/// Average of `powers_4_8`.
///
///   f0 + (a - f0) / 15 + (1 - a) / 45,   a = 0.55
template <class T>
T powers_4_8_average(T f0) {
    const T a = powers_4_8_weight<T>();
    return f0 + (a - f0) / 15 + (1 - a) / 45;
}

/// Average of `powers_3_9`, with b = 0.54.
///
///   f0 + (1 - f0 - b) / 10 + b / 55 + d x^4 (3 / 10 - 12 x / 55),   d = max(b - (1 - f0), 0),   x^6 = d / b
///
/// A bright f0 rises from x = 1 - cos_i on.
template <class T>
T powers_3_9_average(T f0) {
    const T b = powers_3_9_depth<T>();
    const T least = let("least", (1 - f0) - b);
    const T d = let("d", max(-least, T(0)));
    const T x = let("x", pow(d / b + tiny<T>(), ratio<T, 1, 6>()));
    const T late = let("late", d * square(x * x) * (ratio<T, 3, 10>() - ratio<T, 12, 55>() * x));
    return f0 + least / 10 + b / 55 + late;
}

/// Average of `powers_3_6_9`, whose p, q and r these are.
///
///   f0 + p / 10 + q / 28 + r / 55
template <class T>
T powers_3_6_9_average(T f0) {
    const three_terms<T> t = powers_3_6_9_terms(f0);
    return f0 + t.first / 10 + t.second / 28 + t.third / 55;
}

/// Average of `schlick_with_dip`, the shared body of `f82` and `f82_tint`.
///
///   f0 + (1 - f0) / 21 - b / 126
template <class T>
T schlick_with_dip_average(T f0, T b) {
    return schlick_average(f0) - b / 126;
}

/// Average of `f82`.
///
///   f0 + (1 - f0) / 21 - b / 126,   b = (schlick(f0, 1/7) - f82) / ((1/7) (6/7)^6)
template <class T>
T f82_average(T f0, T f82) {
    return schlick_with_dip_average(f0, dip_of_depth(schlick_at_82(f0) - f82));
}

/// Average of `f82_tint`.
///
///   f0 + (1 - f0) / 21 - b / 126,   b = schlick(f0, 1/7) (1 - tint) / ((1/7) (6/7)^6)
template <class T>
T f82_tint_average(T f0, T tint) {
    return schlick_with_dip_average(f0, dip_of_depth(schlick_at_82(f0) * (1 - tint)));
}

/// Average of `hoffman`.
///
///   f0 + 2 (f90 - f0) / ((power + 1) (power + 2)) - b / 126
template <class T>
T hoffman_average(T f0, T f82, T f90, T power) {
    const T at_82 = schlick_power(f0, f90, power, ratio<T, 1, 7>());
    return schlick_power_average(f0, f90, power) - dip_of_depth(at_82 - f82) / 126;
}

/// Average of `powers_4_12`.
///
///   f0 + p / 15 + q / 91,   p + q = 1 - f0
template <class T>
T powers_4_12_average(T f0, T f82) {
    const T q = powers_4_12_term(f0, f82);
    return f0 + (1 - f0 - q) / 15 + q / 91;
}

/// Average of `powers_2_8_16`, whose c2, c8 and c16 these are.
///
///   f0 + c2 / 6 + c8 / 45 + c16 / 153
template <class T>
T powers_2_8_16_average(T f0, T f82) {
    const three_terms<T> t = powers_2_8_16_terms(f0, f82);
    return f0 + t.first / 6 + t.second / 45 + t.third / 153;
}

} // namespace fresnel
