#pragma once

// The registry: every model's name, parameters, equation, citation, domain and error. The command line, the
// error tables, the documentation and the tests read this table and nothing else, so that a model is complete
// once it has a docstring, a body and a row here.

#include <fresnel/approx.hpp>
#include <fresnel/exact.hpp>

#include <array>
#include <cstddef>
#include <string_view>
#include <tuple>
#include <utility>

namespace fresnel {

enum class model_kind { exact, approximation, artistic };

/// One argument of a model beside cos_i. `neutral` marks a default that changes nothing (n_i = 1, k_t = 0),
/// so that leaving the argument out is never a mistake.
struct parameter {
    std::string_view name;
    std::string_view unit;
    double min, max;
    double default_value;
    bool neutral = false;
    std::string_view meaning = {};
};

/// What |model - exact| never exceeds, rounded up to three digits, and what it was taken over. `fresnel prove` certifies
/// it, and a test measures it on a grid; of exact models, whose error is rounding, it is measured only, and what float32
/// leaves of it is said in words (docs/accuracy.md has the table).
struct model_error {
    double max;
    std::string_view over;
    std::string_view in_float32 = {};
};

/// A row of the registry. `evaluate` takes the parameters in order, then cos_i, all of one number type, and
/// returns a `boundary` (exact models) or the reflectance.
template <std::size_t N, class F>
struct model {
    std::string_view name;
    model_kind kind;
    std::string_view summary;
    std::string_view equation;
    std::array<parameter, N> parameters;
    std::string_view citation;
    std::string_view domain;
    model_error error;
    F evaluate;
};

/// Evaluates a row on an indexable list of parameters.
template <class T, std::size_t N, class F, class Values>
constexpr auto evaluate(const model<N, F>& row, const Values& values, T cos_i) {
    return [&]<std::size_t... i>(std::index_sequence<i...>) {
        return row.evaluate(T(values[i])..., cos_i);
    }(std::make_index_sequence<N>{});
}

/// Reflectance of unpolarised light from what a row's `evaluate` returns, a `boundary` or the reflectance itself.
template <class X>
constexpr auto reflectance(const X& result) {
    if constexpr (requires { result.R_s; })
        return result.reflectance();
    else
        return result;
}

namespace row {

inline constexpr parameter cos_i{"cos_i", "1", 0, 1, 1}; ///< of every model, beside its parameters
inline constexpr parameter n_i{"n_i", "1", 0.01, 100, 1, true, "index in front of the surface"};
inline constexpr parameter n_t{"n_t", "1", 0.001, 1000, 1.5, false, "index behind it"};
inline constexpr parameter k_t{"k_t", "1", 0, 10000, 0, true, "its imaginary part"};
inline constexpr parameter n{"n", "1", 0.001, 1000, 1.5, false, "index relative to the medium in front"};
inline constexpr parameter k{"k", "1", 0, 10000, 0, true, "its imaginary part"};
inline constexpr parameter f0{"f0", "1", 0, 1, 0.04, false, "reflectance at normal incidence"};
inline constexpr parameter f82{"f82", "1", 0, 1, 0.5, false, "reflectance at cos_i = 1/7, 81.8 degrees"};
inline constexpr parameter f90{"f90", "1", 0, 1, 1, true, "reflectance at grazing incidence"};
inline constexpr parameter power{"power", "1", 0.1, 1000, 5, true, "sharpness of the rise"};

inline constexpr std::string_view any_angle = "cos_i in [0, 1]";
inline constexpr std::string_view two_media = "n_t / n_i in [0.1, 10], cos_i in [0, 1]";
inline constexpr std::string_view any_index =
    "n_t / n_i in [0.1, 10], k_t / n_i in [0, 100], cos_i in [0, 1]";

// what an error is taken over
inline constexpr std::string_view gems = "eta in [1.3, 2.5], from outside, f0 exact";
inline constexpr std::string_view inside_gems = "1 / eta in [1.3, 2.5], from inside";
inline constexpr std::string_view box = "n in [0.1, 4], k in [1, 8]";
inline constexpr std::string_view metals =
    "measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted";
inline constexpr std::string_view away = "float64 rounding, 0.001 and more from a critical angle";
inline constexpr std::string_view apart =
    "float64 rounding, 0.001 and more from a critical angle and from an index match";
inline constexpr std::string_view everywhere = "float64 rounding";

} // namespace row

/// Every model there is.
inline constexpr auto registry = std::tuple{
    // exact
    model{"dielectric",
          model_kind::exact,
          "Exact reflectance between two transparent media, accurate in float but at the critical angle.",
          "R_s = E^2 / (E^2 + 4 c g (g + c)^2), R_p = R_s ((c g - s^2) / (c g + s^2))^2, E = eta^2 - 1, g^2 "
          "= E + c^2",
          std::array{row::n_i, row::n_t},
          "Fresnel 1823",
          row::two_media,
          {1e-13, row::away, "relative 2e-6, up to 1e-1 at a critical angle"},
          [](auto... x) { return dielectric(x...); }},
    model{"conductor",
          model_kind::exact,
          "Exact reflectance of an absorbing medium seen from a transparent one, accurate in float but at "
          "the critical angle.",
          "R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2",
          std::array{row::n_i, row::n_t, row::k_t},
          "Born and Wolf 1999, Principles of Optics, sec. 14.2",
          row::any_index,
          {1e-13, row::away, "relative 2e-6, up to 1e-1 at a critical angle of small k_t"},
          [](auto... x) { return conductor(x...); }},
    model{"dielectric_fast",
          model_kind::exact,
          "Exact reflectance between two transparent media in the fewest operations.",
          "R_s = ((g - c) / (g + c))^2, R_p = R_s ((c g - s^2) / (c g + s^2))^2, g^2 = eta^2 - 1 + c^2",
          std::array{row::n_i, row::n_t},
          "Cook and Torrance 1982",
          row::two_media,
          {1e-12, row::apart, "relative 8e-6 for eta > 1.05, no digit left at 1 +- 1e-6"},
          [](auto... x) { return dielectric_fast(x...); }},
    model{"conductor_fast",
          model_kind::exact,
          "Exact reflectance of an absorbing medium in the fewest operations.",
          "R_s = (t1 - t2) / (t1 + t2), R_p = R_s (t3 - t4) / (t3 + t4), t1 = A + c^2, t2 = 2 a c, "
          "t3 = A c^2 + s^4, t4 = t2 s^2, A = a^2 + b^2, (a + i b)^2 = (n + i k)^2 - s^2",
          std::array{row::n_i, row::n_t, row::k_t},
          "Lagarde 2013, Memo on Fresnel equations, after Shirley",
          row::any_index,
          {1e-07, row::apart,
           "relative 6e-6 for metals, 2e-4 for dielectrics, no digit left near an index match"},
          [](auto... x) { return conductor_fast(x...); }},
    model{"conductor_precise",
          model_kind::exact,
          "Exact reflectance of any medium, with the two sums that cancel in twice the digits.",
          "R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2",
          std::array{row::n_i, row::n_t, row::k_t},
          "Born and Wolf 1999; Knuth 1969; Dekker 1971",
          row::any_index,
          {2e-15, row::everywhere, "relative 1e-6 in R, absolute 1e-6 in T"},
          [](auto... x) { return conductor_precise(x...); }},

    // the Schlick family
    model{"schlick",
          model_kind::approximation,
          "Schlick's approximation.",
          "f0 + (1 - f0) x^5, x = 1 - cos_i",
          std::array{row::f0},
          "Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering",
          row::any_angle,
          {0.0824, row::gems},
          [](auto... x) { return schlick(x...); }},
    model{"schlick_f90",
          model_kind::approximation,
          "Schlick's approximation with any reflectance at grazing incidence.",
          "f0 + (f90 - f0) x^5, x = 1 - cos_i",
          std::array{row::f0, row::f90},
          "Schlick 1994; Real-Time Rendering, 4th ed., eq. 9.18",
          row::any_angle,
          {0.0824, row::gems},
          [](auto... x) { return schlick_f90(x...); }},
    model{"schlick_power",
          model_kind::approximation,
          "Schlick's approximation with the power left free.",
          "f0 + (f90 - f0) x^power, x = 1 - cos_i",
          std::array{row::f0, row::f90, row::power},
          "Real-Time Rendering, 4th ed., eq. 9.18",
          row::any_angle,
          {0.0968, row::metals},
          [](auto... x) { return schlick_power(x...); }},
    model{"schlick_nk",
          model_kind::approximation,
          "Schlick's approximation written in n and k.",
          "((n - 1)^2 + 4 n x^5 + k^2) / ((n + 1)^2 + k^2), x = 1 - cos_i",
          std::array{row::n, row::k},
          "Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals",
          row::any_angle,
          {0.256, row::box},
          [](auto... x) { return schlick_nk(x...); }},
    model{"schlick_internal",
          model_kind::approximation,
          "Schlick's approximation from inside a denser medium.",
          "schlick(f0, cos_t), f0 = ((1 - eta) / (1 + eta))^2; 1 beyond the critical angle",
          std::array{parameter{"eta", "1", 0.01, 1, ratio<double, 2, 3>(), false, "n_t / n_i"}},
          "Lagarde 2013, Memo on Fresnel equations",
          row::any_angle,
          {0.0824, row::inside_gems},
          [](auto... x) { return schlick_internal(x...); }},

    // one parameter
    model{"spherical_gaussian",
          model_kind::approximation,
          "Schlick's curve by a spherical Gaussian.",
          "f0 + (1 - f0) 2^((-5.55473 cos_i - 6.98316) cos_i)",
          std::array{row::f0},
          "Lagarde 2012, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel",
          row::any_angle,
          {0.0847, row::gems},
          [](auto... x) { return spherical_gaussian(x...); }},
    model{"photometric",
          model_kind::approximation,
          "A curve found by symbolic regression.",
          "f0 + (x - f0) x^4, x = 1 - cos_i",
          std::array{row::f0},
          "photometric.io, Improving Schlick's Approximation",
          row::any_angle,
          {0.0708, row::gems},
          [](auto... x) { return photometric(x...); }},
    model{"powers_4_8",
          model_kind::approximation,
          "Two powers for one operation more than Schlick, better on dielectrics.",
          "f0 + x^4 ((a - f0) + (1 - a) x^4), a = 0.55, x = 1 - cos_i",
          std::array{row::f0},
          "this library",
          row::any_angle,
          {0.0363, row::gems},
          [](auto... x) { return powers_4_8(x...); }},
    model{"powers_3_9",
          model_kind::approximation,
          "Two powers, less than half of Schlick's error on dielectrics.",
          "f0 + x^3 max((1 - f0) - 0.54 (1 - x^6), 0), x = 1 - cos_i",
          std::array{row::f0},
          "this library",
          row::any_angle,
          {0.0328, row::gems},
          [](auto... x) { return powers_3_9(x...); }},
    model{
        "powers_3_6_9",
        model_kind::approximation,
        "Three powers with coefficients in sqrt(f0), a tenth of Schlick's error on dielectrics.",
        "f0 + y (p + y (q + y r)), y = (1 - cos_i)^3, p and q linear in sqrt(f0) and f0, p + q + r = 1 - f0",
        std::array{row::f0},
        "this library",
        row::any_angle,
        {0.00713, row::gems},
        [](auto... x) { return powers_3_6_9(x...); }},
    model{"one_minus_cos",
          model_kind::approximation,
          "The rim factor, as a stand-in for reflectance.",
          "1 - cos_i",
          std::array<parameter, 0>{},
          "Wloka 2002, Fresnel Reflection, fig. 4",
          row::any_angle,
          {0.543, row::gems},
          [](auto... x) { return one_minus_cos(x...); }},
    model{"constant",
          model_kind::approximation,
          "No Fresnel effect.",
          "f0",
          std::array{row::f0},
          "no Fresnel effect",
          row::any_angle,
          {0.983, row::gems},
          [](auto... x) { return constant(x...); }},

    // conductors
    model{"air_conductor",
          model_kind::approximation,
          "The classic approximation for metals, without a square root.",
          "R_s = ((n - c)^2 + k^2) / ((n + c)^2 + k^2), R_p = ((n c - 1)^2 + k^2 c^2) / ((n c + 1)^2 + k^2 "
          "c^2)",
          std::array{row::n, row::k},
          "Pharr and Humphreys, Physically Based Rendering; Lagarde 2013",
          row::any_angle,
          {0.0639, row::box},
          [](auto... x) { return air_conductor(x...); }},
    model{"lazanyi",
          model_kind::approximation,
          "Schlick's approximation less a term for the dip of metals before grazing incidence.",
          "schlick_nk(n, k) - a c x^alpha, x = 1 - c, c = cos_i",
          std::array{row::n, row::k, parameter{"a", "1", 0, 2000, 0, false, "depth of the dip, about 2 n"},
                     parameter{"alpha", "1", 0.1, 1000, 7, false, "sharpness of the dip"}},
          "Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals",
          row::any_angle,
          {0.0451, row::metals},
          [](auto... x) { return lazanyi(x...); }},
    model{"gulbrandsen",
          model_kind::approximation,
          "An index from two artist's colours, then the exact equations.",
          "conductor(n, k), n = mix(n_max(r), n_min(r), g), k^2 = ((n + 1)^2 r - (n - 1)^2) / (1 - r)",
          std::array{parameter{"r", "1", 0, 1, 0.9, false, "reflectance at normal incidence"},
                     parameter{"g", "1", 0, 1, 0.5, false, "edge tint"}},
          "Gulbrandsen 2014, Artist Friendly Metallic Fresnel",
          row::any_angle,
          {1e-13, row::metals, "3e-7 for r in [0.02, 0.99]"},
          [](auto... x) { return gulbrandsen(x...); }},
    model{"f82",
          model_kind::approximation,
          "Schlick's approximation with a dip, through the reflectance at cos_i = 1/7.",
          "f0 + (1 - f0) x^5 - b c x^6, through f82 at c = 1/7, x = 1 - c, c = cos_i",
          std::array{row::f0, row::f82},
          "Hoffman 2019, Fresnel Equations Considered Harmful",
          row::any_angle,
          {0.0406, row::metals},
          [](auto... x) { return f82(x...); }},
    model{"f82_tint",
          model_kind::approximation,
          "Schlick's approximation with a dip, given as a fraction of its value at cos_i = 1/7.",
          "f82(f0, tint schlick(f0, 1/7))",
          std::array{row::f0, parameter{"tint", "1", 0, 1, 1, true, "f82 over that of Schlick"}},
          "Kutz, Hasan and Edmondson 2021, Novel aspects of the Adobe Standard Material",
          row::any_angle,
          {0.0451, row::metals},
          [](auto... x) { return f82_tint(x...); }},
    model{"hoffman",
          model_kind::approximation,
          "Schlick's approximation with a dip, any power and any reflectance at grazing incidence.",
          "f0 + (f90 - f0) x^power - b c x^6, through f82 at c = 1/7, x = 1 - c, c = cos_i",
          std::array{row::f0, row::f82, row::f90, row::power},
          "Hoffman 2019, Fresnel Equations Considered Harmful; MaterialX",
          row::any_angle,
          {0.0185, row::metals},
          [](auto... x) { return hoffman(x...); }},
    model{"powers_4_12",
          model_kind::approximation,
          "Two powers through f0 and f82.",
          "f0 + x^4 (p + q x^8), through f82 at cos_i = 1/7, x = 1 - cos_i",
          std::array{row::f0, row::f82},
          "this library",
          row::any_angle,
          {0.0216, row::metals},
          [](auto... x) { return powers_4_12(x...); }},
    model{"powers_2_8_16",
          model_kind::approximation,
          "Three powers through f0 and f82.",
          "f0 + c2 x^2 + c8 x^8 + c16 x^16, through f82 at cos_i = 1/7, x = 1 - cos_i",
          std::array{row::f0, row::f82},
          "this library",
          row::any_angle,
          {0.0358, row::metals},
          [](auto... x) { return powers_2_8_16(x...); }},

    // artistic
    model{"bias_scale_power",
          model_kind::artistic,
          "The rim of game shaders.",
          "saturate(bias + scale x^power), x = 1 - cos_i",
          std::array{parameter{"bias", "1", -10, 10, 0, true, "value at normal incidence"},
                     parameter{"scale", "1", -10, 10, 1, true, "strength of the rim"}, row::power},
          "Fernando and Kilgard 2003, The Cg Tutorial, ch. 7; Halladay 2014, Fresnel Shading",
          row::any_angle,
          {0.147, row::metals},
          [](auto... x) { return bias_scale_power(x...); }},
};

/// Calls f(row) for every row, in order.
template <class F>
constexpr void for_each_model(F&& f) {
    std::apply([&](const auto&... rows) { (f(rows), ...); }, registry);
}

} // namespace fresnel
