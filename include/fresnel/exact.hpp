#pragma once

// Fresnel's equations for one plane boundary, exact for every angle, on both sides of a transparent surface
// and on the outside of an absorbing one.
//
// Conventions. Light arrives in a transparent medium of index n_i and meets a medium of index n_t + i k_t,
// k_t >= 0. cos_i in [0, 1] is the cosine of the angle of incidence. Everything is relative to the ambient
// medium: eta = n_t / n_i. Transmittances are ratios of power through the surface, so that R + T = 1.
//
// Three arrangements of the same equations, chosen by measurement (docs/accuracy.md):
//   dielectric, conductor            accurate in float but at the critical angle; use these
//   dielectric_fast, conductor_fast  the fewest operations; lose digits near n_t = n_i and where n << k
//   conductor_precise                compensated arithmetic; accurate at the critical angle as well

#include <fresnel/complex.hpp>
#include <fresnel/number.hpp>
#include <fresnel/twofold.hpp>

#include <limits>

namespace fresnel {

/// Power reflected and transmitted at one boundary, for light polarised across (s) and along (p) the plane of
/// incidence. Each in [0, 1].
template <class T>
struct boundary {
    T R_s, R_p, T_s, T_p;

    /// Reflectance of unpolarised light.
    constexpr T reflectance() const { return (R_s + R_p) / 2; }
    /// Transmittance of unpolarised light.
    constexpr T transmittance() const { return (T_s + T_p) / 2; }
};

/// A denominator below this is taken for 0: 2^-126 in float32, the smallest normal number, 2^-504 in wider types.
template <class T>
T negligible() {
    const T x = square(ratio<T, 1, 1 << 21>()); // 2^-42
    return std::numeric_limits<T>::digits > 24 ? square(square(x * x * x)) : x * x * x;
}

/// A squared length below this is taken for it, so that a scale is never 0: 2^-50 in float32, 2^-500 in wider types.
/// In units of 1 / n_i the smallest difference of two float32 squares is 2^-47.
template <class T>
T least_square() {
    const T x = square(ratio<T, 1, 1 << 20>()) * ratio<T, 1, 1 << 10>(); // 2^-50
    return std::numeric_limits<T>::digits > 24 ? square(x * square(square(x))) : x;
}

/// Exact reflectance and transmittance between two transparent media.
///
///   g^2 = eta^2 - 1 + c^2                      R_s = E^2 / (E^2 + W), E = eta^2 - 1, W = 4 c g (g + c)^2
///   R_p = R_s ((c g - s^2) / (c g + s^2))^2    T_s = W / (E^2 + W)
///   T_p = T_s + R_s 4 c g s^2 / (c g + s^2)^2
///
/// n_i     index of the ambient medium            [0.01, 100]
/// n_t     index of the medium behind             [0.001, 1000]
/// cos_i   cosine of incidence                    [0, 1]
/// returns R and T per polarisation, each in [0, 1]; 1 and 0 beyond the critical angle; R is exactly 0 for
///         equal media at every angle, and exactly 1 at cos_i = 0 for any others
/// error   relative 8 epsilon in R and 4 in T, times 1 + |eta^2 - 1| / g^2: in float32 2e-6 for eta > 1,
///         and up to 1e-1 at the critical angle of eta >= 0.1, 2e-1 in R_p (conductor_precise: 1e-6 there too)
/// source  Fresnel 1823. From g^2 - c^2 = E follows (g + c)^4 = E^2 + W, so that nothing cancels, and what is
///         reflected at grazing incidence and beyond the critical angle is exactly 1. Lengths are in units of
///         1 / n_i, which saves the division by it
template <class T>
boundary<T> dielectric(T n_i, T n_t, T cos_i) {
    const T c = let("c", n_i * cos_i);
    const T s2 = let("s2", n_i * (1 - cos_i * cos_i));
    const T E = let("E", (n_t - n_i) * (n_t + n_i), "n_t^2 - n_i^2");

    const T g2 = let("g2", E + c * c, "Snell\nbelow 0 beyond the critical angle");
    const T g = let("g", sqrt(max(g2, negligible<T>())), "n_t cos_t; beyond it so small that R is 1");

    const T E2 = let("E2", E * E, "s-polarised, across the plane of incidence\n");
    const T cg = let("cg", c * g);
    const T a = let("a", 2 * (g + c));
    const T a2 = let("a2", a * a);
    const T D_s = let("D_s", max(E2 + cg * a2, negligible<T>()), "0 only for equal media at cos_i = 0");
    const T R_s = let("R_s", E2 / D_s);

    const T x = let("x", cos_i * g, "p-polarised, along it\n");
    const T b = let("b", x + s2);
    const T q = let("q", (x - s2) / b);
    const T R_p = let("R_p", R_s * (q * q));

    const T through_s = let("through_s", select(g2 <= 0, T(0), cg * (a2 / D_s)), "transmitted\n");
    const T through_p = let("through_p", select(g2 <= 0, T(0), 4 * (x * s2) / (b * b)));
    const T T_s = let("T_s", select(E2 <= 0, 1 - R_s, through_s));
    const T T_p = let("T_p", T_s + R_s * through_p);
    return {R_s, R_p, min(T_s, T(1)), min(T_p, T(1))};
}

/// The same equations in the fewest operations, the arrangement of Cook and Torrance.
///
///   R_s = ((g - c) / (g + c))^2        R_p = R_s ((c g - s^2) / (c g + s^2))^2
///
/// n_i, n_t, cos_i, returns   as `dielectric`
/// error   float32: relative 8e-6 in R for eta > 1.05, growing like 2e-7 / |eta - 1|: no digit left at
///         1 +- 1e-6, in slopes (`dual`) as in values. Equal media at cos_i = 0 transmit nothing
/// source  Cook and Torrance 1982, "A Reflectance Model for Computer Graphics"; lengths as in `dielectric`.
///         Beyond the critical angle the results alone are selected, so that nothing before them has to be
template <class T>
boundary<T> dielectric_fast(T n_i, T n_t, T cos_i) {
    const T c = let("c", n_i * cos_i);
    const T sin2 = let("sin2", 1 - cos_i * cos_i);
    const T s2 = let("s2", n_i * sin2);
    const T g2 = let("g2", n_t * n_t - n_i * s2, "below 0 under total internal reflection");
    const T g = let("g", sqrt(abs(g2)));
    const T x = let("x", cos_i * g);
    const T a = let("a", g + c);
    const T b = let("b", x + s2);

    const T r_s = let("r_s", (g - c) / a);
    const T q = let("q", (x - s2) / b);
    const T r2 = let("r2", r_s * r_s);
    const T R_s = let("R_s", select(g2 <= 0, T(1), r2));
    const T R_p = let("R_p", select(g2 <= 0, T(1), r2 * (q * q)));

    const T w = let("w", 4 * (c * g));
    const T through_s = let("through_s", w / (a * a));
    const T through_p = let("through_p", w * sin2 / (b * b));
    const T T_s = let("T_s", select(g2 <= 0, T(0), through_s));
    const T T_p = let("T_p", select(g2 <= 0, T(0), T_s + r2 * through_p));
    return {R_s, R_p, min(T_s, T(1)), min(T_p, T(1))};
}

/// The part of the transmitted wave's vector along the normal, m cos_t = a + i b with m the relative complex
/// index, and d = a - cos_i without the cancellation of that subtraction.
template <class T>
struct normal_wave {
    T a, b, d;
};

/// Snell's law for a complex index: (a + i b)^2 = m^2 - sin_i^2.
///
/// Written with the larger of a and b from a sum and the smaller from n k / larger, so that neither cancels;
/// E = n^2 - k^2 - 1 is formed from the differences of the indices. Near an index match a - c is taken from
/// a^2 - c^2 = E + b^2 instead.
///
/// n_i, n_t, k_t, cos_i   as `conductor`
/// source  Born and Wolf 1999, "Principles of Optics", 7th ed., sec. 14.2
template <class T>
normal_wave<T> refract_complex(T n_i, T n_t, T k_t, T cos_i) {
    const T c = cos_i;
    const T n_i2 = n_i * n_i;
    const T E = let("E", ((n_t - n_i) * (n_t + n_i) - k_t * k_t) / n_i2); // n^2 - k^2 - 1
    const T nk = let("nk", n_t * k_t / n_i2);
    const T t0 = let("t0", E + c * c);
    const T A = let("A", max(sqrt(t0 * t0 + 4 * (nk * nk)), abs(t0)));
    const T m = let("m", sqrt((A + abs(t0)) / 2));
    const T q = let("q", nk / select(m > 0, m, T(1)));

    const T a = let("a", select(t0 <= 0, q, m));
    const T b = let("b", select(t0 <= 0, m, q));
    const auto near = max(2 * abs(a - c), b) < c;
    const T d = let("d", select(near, (E + b * b) / select(near, a + c, T(1)), a - c));
    return {a, b, d};
}

/// Exact reflectance and transmittance from a transparent medium into an absorbing one.
///
///   (a + i b)^2 = m^2 - s^2     A = a^2 + b^2     m = n + i k
///   R_s = F / (F + W)           F = |m^2 - 1|^2             W = 4 a c (A + c^2 + 2 a c)
///   R_p = R_s B / (B + V)       B = |m^2 c^2 - s^2|^2       V = 4 a c s^2 (c^2 A + s^4 + 2 a c s^2)
///   T_s = W / (F + W)           T_p = T_s + R_s V / (B + V)
///
/// n_i     index of the ambient medium                        [0.01, 100]
/// n_t     real part of the index behind                      [0.001, 1000]
/// k_t     imaginary part of the index behind                 [0, 10000]; 0 is a dielectric
/// cos_i   cosine of incidence                                [0, 1]
/// returns R and T per polarisation, each in [0, 1]; T is the power that enters, to be absorbed. R is exactly
///         0 for equal media at every angle, and exactly 1 at cos_i = 0 for any others, but for an absorption so
///         faint that its cube is lost (k_t / n_i < 1e-7 in float32) where n_t = n_i
/// error   relative 8 epsilon in R and 4 in T, times 1 + |m^2 - 1| / |m^2 - s^2|, for eta >= 0.1: in float32 2e-6 for metals
///         and for eta > 1, and up to 1e-1 at the critical angle of eta >= 0.1, 2e-1 in R_p (small k_t; 3e-4 at 1e-3)
/// source  Born and Wolf 1999, "Principles of Optics", 7th ed., sec. 14.2. With q = a + i b, |q + c|^4 = F + W
///         and |q c + s^2|^4 = B + V, so that nothing cancels; Re(m^2 c^2 - s^2) is Re q^2 c^2 - s^4. Of a and b
///         the larger is u, the other n k / u; lengths are in units of 1 / n_i, and F, W, B, V are multiplied by
///         S = 2 u^2, which saves those divisions
template <class T>
boundary<T> conductor(T n_i, T n_t, T k_t, T cos_i) {
    const T c = let("c", n_i * cos_i);
    const T c2 = let("c2", c * c);
    const T cos2 = let("cos2", cos_i * cos_i);
    const T sin2 = let("sin2", 1 - cos2);
    const T s2 = let("s2", n_i * sin2);
    const T s4 = let("s4", s2 * s2);

    const T E = let("E", (n_t - n_i) * (n_t + n_i) - k_t * k_t, "Snell\nRe m^2 - n_i^2, m the complex index");
    const T Z = let("Z", 2 * (n_t * k_t), "Im m^2");
    const T Z2 = let("Z2", Z * Z);
    const T t0 = let("t0", E + c2, "q^2 = t0 + i Z");
    const T A = let("A", sqrt(t0 * t0 + Z2), "|q|^2");
    const T S = let("S", max(A + abs(t0), least_square<T>()), "0 only at the critical angle");
    const T u = let("u", sqrt(2 * S), "twice the larger of Re q and Im q");
    const T a = let("a", select(t0 <= 0, Z, S), "u Re q");

    const T h = let("h", 2 * (a * c), "s-polarised, across the plane of incidence\n");
    const T F = let("F", (E * E + Z2) * S, "S |c - q|^2 |c + q|^2");
    const T G_s = let("G_s", (A + c2) * u + h);
    const T D_s =
        let("D_s", max(F + h * G_s, negligible<T>()), "S |c + q|^4; 0 only for equal media at cos_i = 0");
    const T R_s = let("R_s", F / D_s);

    const T h_p = let("h_p", h * sin2, "p-polarised, along it\n");
    const T N = let("N", t0 * cos2 - s4);
    const T M = let("M", Z * cos2);
    const T M2 = let("M2", M * M + least_square<T>() * ratio<T, 1, 1 << 20>(), "above 0, so that D_p is");
    const T B = let("B", (N * N + M2) * S, "S |q c - s^2|^2 |q c + s^2|^2");
    const T G_p = let("G_p", (A * cos2 + s4) * u + h_p);
    const T D_p = let("D_p", B + h_p * G_p, "S |q c + s^2|^4");
    const T R_p = let("R_p", R_s * (B / D_p));

    const T T_s = let("T_s", select(F <= 0, 1 - R_s, 2 * (a * (G_s / D_s)) * c), "transmitted\n");
    const T T_p = let("T_p", T_s + R_s * (2 * (a * (G_p / D_p)) * (c * sin2)));
    return {R_s, R_p, min(T_s, T(1)), min(T_p, T(1))};
}

/// The same equations in the fewest operations.
///
///   R_s = (t1 - t2) / (t1 + t2)        R_p = R_s (t3 - t4) / (t3 + t4)
///
/// n_i, n_t, k_t, cos_i, returns   as `conductor`
/// error   float32: relative 6e-6 in R for metals, 2e-4 for dielectrics; R and T have no digit left near an
///         index match (k_t < 1e-3 and n_t near n_i), T none where n_t << k_t. Equal media at cos_i = 0 transmit
///         nothing. Slopes (`dual`) are as the values: none near an index match, and 0 by a k_t below 1e-8 beyond the
///         critical angle, where |q|^2 - |t0| rounds to 0
/// source  Lagarde 2013, "Memo on Fresnel equations", after Shirley; lengths as in `dielectric`
template <class T>
boundary<T> conductor_fast(T n_i, T n_t, T k_t, T cos_i) {
    const T c = let("c", n_i * cos_i);
    const T c2 = let("c2", c * c);
    const T cos2 = let("cos2", cos_i * cos_i);
    const T sin2 = let("sin2", 1 - cos2);
    const T s2 = let("s2", n_i * sin2);
    const T t0 = let("t0", n_t * n_t - n_i * n_i - k_t * k_t + c2);
    const T nk2 = let("nk2", 2 * (n_t * k_t));
    const T A = let("A", sqrt(t0 * t0 + nk2 * nk2), "a^2 + b^2");
    const T a2 = let("a2", 2 * (A + t0), "(2 a)^2");
    const T a = let("a", sqrt(max(a2, negligible<T>())));

    const T t1 = let("t1", A + c2);
    const T t2 = let("t2", a * c);
    const T t3 = let("t3", cos2 * A + (s2 * s2 + negligible<T>()), "above 0 where n_t << n_i, at cos_i = 1");
    const T t4 = let("t4", t2 * sin2);
    const T D_s = let("D_s", max(t1 + t2, negligible<T>()), "0 only for equal media at cos_i = 0");
    const T D_p = let("D_p", t3 + t4);

    const T R_s = let("R_s", abs((t1 - t2) / D_s), "rounding may bring it below 0");
    const T R_p = let("R_p", R_s * abs((t3 - t4) / D_p));
    const T w = let("w", select(a2 <= 0, T(0), 2 * t2), "0 beyond the critical angle");
    const T T_s = let("T_s", w / D_s);
    const T T_p = let("T_p", T_s + R_s * (w * sin2 / D_p));
    return {R_s, R_p, min(T_s, T(1)), min(T_p, T(1))};
}

/// The exact equations with the two sums that cancel carried in twice the digits.
///
/// t0 = n_t^2 - k_t^2 - n_i^2 s^2 vanishes at the critical angle and N = c^2 (n_t^2 + n_i^2) - n_i^2 at
/// Brewster's; everything is scaled by n_i instead of divided by it, so that no quotient is rounded first.
///
/// n_i, n_t, k_t, cos_i, returns   as `conductor`; k_t = 0 gives the dielectric
/// error   float32, eta >= 0.1: relative 1e-6 in R and absolute 1e-6 in T, the critical angle included; from 1000 times
///         denser media, whose critical angle is at 0.06 degrees, 5e-5 in R. Not for n_t = n_i and k_t below 1e-17, whose
///         square is lost beside that of cos_i
/// source  as `conductor`; the sums after Knuth, Veltkamp and Dekker. Needs an arithmetic that does not
///         re-associate (no -ffast-math)
template <class T>
boundary<T> conductor_precise(T n_i, T n_t, T k_t, T cos_i) {
    const T s2 = let("s2", (1 - cos_i) * (1 + cos_i));
    const twofold<T> n2 = let("n2", two_product(n_t, n_t), "what cancels, in twice the digits\n");
    const twofold<T> k2 = let("k2", two_product(k_t, k_t)), i2 = let("i2", two_product(n_i, n_i));
    const twofold<T> c2 = let("c2", two_product(cos_i, cos_i));
    const twofold<T> m2 = let("m2", n2 - k2, "Re m^2, m = n_t + i k_t");
    const twofold<T> E = let("E", m2 - i2);
    const twofold<T> p2 = let("p2", i2 * c2, "(n_i cos_i)^2");
    const twofold<T> q2 = let("q2", E + p2, "Re q^2, q^2 = m^2 - (n_i sin_i)^2");
    const twofold<T> sum2 = let("sum2", n2 + i2);
    const twofold<T> product = let("product", c2 * sum2);
    const twofold<T> N = let("N", product - i2, "0 at Brewster's angle where k_t = 0");

    const T c = let("c", n_i * cos_i, "q = a + i b, which is m cos_t; lengths in units of 1 / n_i\n");
    const T nk = let("nk", n_t * k_t, "Im q^2 / 2");
    const T t0 = q2.hi;
    const T size = let("size", abs(t0));
    const T A = let("A", max(sqrt(t0 * t0 + 4 * (nk * nk)), size), "|q|^2");
    const T larger = let("larger", sqrt((A + size) / 2), "of |Re q| and |Im q|");
    const T smaller = let("smaller", nk / select(larger > 0, larger, T(1)));
    const T a = let("a", select(t0 <= 0, smaller, larger), "Re q");
    const T b = let("b", select(t0 <= 0, larger, smaller), "Im q");
    const T b2 = let("b2", b * b);

    const T a_minus_c =
        let("a_minus_c", a - c, "s-polarised; d is a - c, exact near an index match as well\n");
    const T a_plus_c = let("a_plus_c", a + c);
    const auto near_match = max(2 * abs(a_minus_c), b) < c;
    const T d = let("d", select(near_match, (E.hi + b2) / select(near_match, a_plus_c, T(1)), a_minus_c));
    const T D_s = let("D_s", square(a_plus_c) + b2);
    const T D = let("D", select(D_s <= 0, T(1), D_s), "0 only for equal media at cos_i = 0");
    const T N_s = let("N_s", d * d + b2);
    const T R_s = let("R_s", N_s / D);
    const T T_s = let("T_s", select(N_s <= 0, T(1), 4 * (a * c) / D));

    // nu = a cos_i - n_i s^2 from nu (a cos_i + n_i s^2) = N + cos_i^2 (b^2 - k^2)
    const T is2 = let("is2", n_i * s2,
                      "p-polarised; nu is a cos_i - n_i sin_i^2, exact near Brewster's angle as well\n");
    const T ac = let("ac", a * cos_i);
    const T bc = let("bc", b * cos_i);
    const T bc2 = let("bc2", bc * bc);
    const T difference = let("difference", ac - is2);
    const auto near_brewster = max(2 * abs(difference) - is2, 2 * b - n_i) < 0;
    const T total = let("total", ac + is2);
    const T sum = let("sum", select(total <= 0, T(1), total));
    const T exact = let("exact", (N.hi + c2.hi * (b2 - k2.hi)) / sum);
    const T nu = let("nu", select(near_brewster, exact, difference));
    const T P = let("P", square(sum) + bc2);
    const T R_p = let("R_p", R_s * ((nu * nu + bc2) / P));
    const T T_p = let("T_p", T_s + R_s * (4 * (ac * is2) / P));
    return {min(R_s, T(1)), min(R_p, T(1)), min(T_s, T(1)), min(T_p, T(1))};
}

/// Complex amplitudes of the reflected and transmitted electric field. A wave is exp(-i omega t), so that an
/// absorbing medium is n + i k; the sign of r_p is Verdet's (r_s and r_p differ in sign at normal incidence).
template <class T>
struct amplitudes {
    complex<T> r_s, r_p, t_s, t_p;
};

/// Fresnel's amplitudes for any boundary; k_t = 0 gives the dielectric, complex beyond the critical angle.
///
///   q^2 = m^2 - s^2     r_s = (c - q) / (c + q)     r_p = r_s (s^2 - q c) / (s^2 + q c)
///   t_s = 2 c / (c + q)     t_p = 2 m c / (m^2 c + q)
///
/// n_i, n_t, k_t, cos_i   as `conductor`
/// returns |r_s|^2 = R_s and |r_p|^2 = R_p of `conductor`; R + T n-weighted = 1, see `conductor` for T
/// source  Born and Wolf 1999, "Principles of Optics", 7th ed., sec. 1.5.2; Verdet's convention as in
///         Clarke 2009, "Stellar Polarimetry", appendix A
template <class T>
amplitudes<T> boundary_amplitudes(T n_i, T n_t, T k_t, T cos_i) {
    const T c = cos_i;
    const T s2 = let("s2", (1 - c) * (1 + c));
    const normal_wave<T> t = refract_complex(n_i, n_t, k_t, c);
    const complex<T> m = {n_t / n_i, k_t / n_i};

    const complex<T> sum = {t.a + c, t.b};
    const auto none = norm(sum) <= 0; // equal media at grazing incidence
    const complex<T> safe_sum = {select(none, T(1), sum.re), sum.im};
    const complex<T> qc = {t.a * c, t.b * c};
    const complex<T> r_s = complex<T>{-t.d, -t.b} / safe_sum;
    const complex<T> r_p = r_s * (complex<T>{s2 - qc.re, -qc.im} / complex<T>{s2 + qc.re, qc.im});
    const complex<T> one_s = {select(none, T(1), 2 * c), T(0)};

    // m^2 c + q = (c + q) (s^2 + q c), and the transmitted ray of equal media is the incident one
    const complex<T> t_s = one_s / safe_sum;
    const complex<T> t_p = m * (t_s / complex<T>{s2 + qc.re, qc.im});
    return {r_s, r_p, t_s, t_p};
}

/// The other common sign of r_p, Fresnel's: r_s and r_p are equal at normal incidence. Its own inverse.
template <class T>
amplitudes<T> opposite_p(amplitudes<T> x) {
    return {x.r_s, -x.r_p, x.t_s, x.t_p};
}

} // namespace fresnel
