#pragma once

// The exact reflectance of a conductor over boxes of n, k and cos_i: the real function of `conductor`, arranged for
// intervals, which cannot know that the terms of t0^2 + 4 n^2 k^2 belong together.
//
// q = a + i b is the root of z = m^2 - s^2, m = n + i k, in the first quadrant. From q^2 = n^2 - k^2 + 2 i n k - 1 + c^2,
//
//     dq/dn = m / q     da/dn =  (n a + k b) / |q|^2     db/dn = -(n b - k a) / |q|^2
//     dq/dk = i m / q   da/dk =  (n b - k a) / |q|^2     db/dk =  (n a + k b) / |q|^2
//     dq/dc = c / q     da/dc =  c a / |q|^2             db/dc = -c b / |q|^2
//
// Taking s^2 >= 0 from m^2 turns it towards -1, so arg q >= arg m and n b - k a >= 0. Hence a grows with n, k and c, and
// b grows with k and falls with n and c: their exact ranges over a box are had from two of its corners each.

#include <fresnel/exact.hpp>
#include <fresnel/types/dual.hpp>
#include <fresnel/types/interval.hpp>

#include <algorithm>

namespace fresnel {

/// The wave behind the surface, a + i b; see the top of this file.
template <class T>
struct complex_root {
    T a, b;
};

/// Its exact range, to rounding. n and k above 0, c in [0, 1].
inline complex_root<interval> root_over(const interval& n, const interval& k, const interval& c) {
    const auto at = [](double n_t, double k_t, double cos_i) {
        return [=] { return refract_complex(interval(1), interval(n_t), interval(k_t), interval(cos_i)); };
    };
    const auto a = [](const auto& wave) { return enclose([&] { return wave().a; }); };
    const auto b = [](const auto& wave) { return enclose([&] { return wave().b; }); };
    return {interval::between(a(at(n.lo, k.lo, c.lo)).lo, a(at(n.hi, k.hi, c.hi)).hi),
            interval::between(b(at(n.hi, k.lo, c.hi)).lo, b(at(n.lo, k.hi, c.lo)).hi)};
}

/// The same with slopes, whose signs are known.
template <int N>
complex_root<dual<interval, N>> root_over(const dual<interval, N>& n, const dual<interval, N>& k,
                                          const dual<interval, N>& c) {
    const auto [a, b] = root_over(n.value, k.value, c.value);
    const interval norm = a * a + b * b;
    const interval along = (n.value * a + k.value * b) / norm;
    const interval twist = max((n.value * b - k.value * a) / norm, interval(0));
    auto slopes_of_a = dual<interval, N>::constant(a), slopes_of_b = dual<interval, N>::constant(b);
    for (std::size_t i = 0; i < N; ++i) {
        slopes_of_a.d[i] = along * n.d[i] + twist * k.d[i] + c.value * a / norm * c.d[i];
        slopes_of_b.d[i] = along * k.d[i] - twist * n.d[i] - c.value * b / norm * c.d[i];
    }
    return {slopes_of_a, slopes_of_b};
}

/// conductor(1, n, k, c).reflectance() for T = interval or dual<interval, N>: holds every value over the box.
///
///   R_s = 1 - 4 a c / ((a + c)^2 + b^2)     R_p = R_s (1 - 4 a c s^2 / ((a c + s^2)^2 + b^2 c^2))
///
/// n, k   relative index, above 0; c in [0, 1]
template <class T>
T conductor_over(const T& n, const T& k, const T& c) {
    const auto [a, b] = root_over(n, k, c);
    const T s2 = (1 - c) * (1 + c), ac = a * c;
    const T T_s = 4 * ac / (square(a + c) + b * b);
    const T P = 4 * (ac * s2) / (square(ac + s2) + square(b * c));
    return (1 - T_s) * (1 - P / 2);
}

} // namespace fresnel
