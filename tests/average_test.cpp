#include "inputs.hpp"
#include "oracles.hpp"
#include "tolerances.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/average.hpp>
#include <fresnel/exact.hpp>
#include <fresnel/types/strict.hpp>

#include <boost/math/quadrature/gauss.hpp>
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <string>

namespace fresnel::test {
namespace {

/// The integral of 2 F(c) c over [low, high] by Gauss's rule, which is exact for polynomials of degree < 60.
template <class T, class F>
T integral(F reflectance, T low, T high) {
    using boost::math::quadrature::gauss;
    return gauss<T, 30>::integrate([&](T c) { return T(2 * c * reflectance(c)); }, low, high);
}

template <class F>
double average(F reflectance) {
    return integral<double>(reflectance, 0, 1);
}

/// Average of the exact dielectric by quadrature at 60 digits, over the logarithm of w = g + c, of which
/// c = (w - E / w) / 2: equal ratios of w resolve the integrand, whose width is sqrt E, at every E.
real50 quadrature_average(const real50& eta) {
    const real50 E = (eta - 1) * (eta + 1);
    const auto integrand = [&](const real50& log_w) {
        const real50 w = exp(log_w);
        const real50 c = (w - E / w) / 2;
        const real50 dc = (w + E / w) / 2; // dc / dlog w
        return real50(2 * c * dc * oracle::truth(1, eta, 0, c).reflectance());
    };
    const real50 low = log(E) / 2, high = log(real50(eta + 1));
    constexpr int pieces = 24;
    real50 sum = 0;
    for (int i = 0; i < pieces; ++i) {
        const real50 from = low + (high - low) * i / pieces, to = low + (high - low) * (i + 1) / pieces;
        sum += boost::math::quadrature::gauss<real50, 30>::integrate(integrand, from, to);
    }
    return sum;
}

// ---- exact dielectric -------------------------------------------------------------------------------------

TEST(dielectric_average, is_the_quadrature_of_the_dielectric_at_both_sides) {
    double worst = 0, worst_float = 0;
    for (const double gap :
         {1e-9, 1e-8, 1e-6, 1e-4, 1e-3, 0.01, 0.1, 0.25, 0.333, 0.5, 0.6, 0.666, 0.67, 1.42, 3.0, 9.0}) {
        const double eta = 1 + gap;
        const real50 outside = quadrature_average(eta);
        const real50 inside = 1 - (1 - outside) / (real50(eta) * real50(eta));
        const double got = dielectric_average(eta);
        const double got_float = static_cast<double>(dielectric_average(static_cast<float>(eta)));
        const double expected = static_cast<double>(outside);
        EXPECT_TRUE(within_relative(got, expected, 1e-14, digits(eta)));
        worst = std::fmax(worst, std::abs(got / expected - 1));
        // 1 / eta in 60 digits, rounded once to double: its own truth
        const double below = static_cast<double>(real50(1 / real50(eta)));
        const real50 there = quadrature_average(1 / real50(below));
        const double expected_below = static_cast<double>(1 - (1 - there) * real50(below) * real50(below));
        EXPECT_TRUE(within_relative(dielectric_average(below), expected_below, 1e-14, digits(below)));
        EXPECT_TRUE(within_relative(static_cast<double>(inside), expected_below, 1e-6, digits(below)));
        if (gap > 1e-3) {
            const real50 rounded = static_cast<float>(eta);
            const double truth_float = static_cast<double>(quadrature_average(rounded));
            EXPECT_TRUE(within_relative(got_float, truth_float, 2e-6, digits(eta)));
            worst_float = std::fmax(worst_float, std::abs(got_float / truth_float - 1));
        }
    }
    std::printf("dielectric_average: relative error float64 %.1e, float32 %.1e\n", worst, worst_float);
}

TEST(dielectric_average, is_the_integral_over_the_inside_too) {
    // directly, not by reciprocity: total reflection up to the critical cosine, then the rest by quadrature
    for (const double eta : {0.4, 1 / 1.5, 0.75, 0.95}) {
        const double critical = std::sqrt((1 - eta) * (1 + eta));
        // c^2 = critical^2 + u^2 removes the root at the critical angle; c dc = u du
        const double rest = boost::math::quadrature::gauss<double, 30>::integrate(
            [&](double u) { return 2 * u * dielectric(1.0, eta, std::hypot(critical, u)).reflectance(); },
            0.0, eta);
        EXPECT_NEAR(dielectric_average(eta), critical * critical + rest, 1e-9) << eta;
    }
}

/// Walsh's closed form as it is printed: its poles at n = 1 cancel in the sum.
real50 walsh(const real50& n) {
    const real50 n2 = n * n, n4 = n2 * n2, p = n + 1, m = n - 1;
    return real50(1) / 2 + m * (3 * n + 1) / (6 * p * p) +
           n2 * (n2 - 1) * (n2 - 1) / ((n2 + 1) * (n2 + 1) * (n2 + 1)) * log(m / p) -
           2 * n2 * n * (n2 + 2 * n - 1) / ((n2 + 1) * (n4 - 1)) +
           8 * n4 * (n4 + 1) / ((n2 + 1) * (n4 - 1) * (n4 - 1)) * log(n);
}

TEST(dielectric_average, is_walshs_closed_form) {
    random_numbers random(1926);
    for (int i = 0; i < 500; ++i) {
        const double eta = 1 + random.log_uniform(1e-9, 99);
        const double expected = static_cast<double>(walsh(eta));
        EXPECT_TRUE(within_relative(dielectric_average(eta), expected, 1e-14, digits(eta)));
    }
    // beyond the series, in 60 digits, the two are one function
    for (const double eta : {1.7, 2.42, 10.0, 90.0})
        EXPECT_TRUE(within_relative(dielectric_average(real50(eta)), walsh(eta), tolerance::printed_form,
                                    digits(eta)));
}

TEST(dielectric_average, is_0_without_a_boundary_and_rises_away_from_it) {
    EXPECT_EQ(dielectric_average(1.0), 0);
    EXPECT_EQ(dielectric_average(1.0f), 0);
    double last = 0;
    for (double eta = 1.001; eta < 90; eta *= 1.01) {
        EXPECT_GT(dielectric_average(eta), last) << eta;
        last = dielectric_average(eta);
        EXPECT_LT(last, 1) << eta;
    }
}

TEST(dielectric_average, passes_nan_on) { EXPECT_TRUE(std::isnan(dielectric_average(std::nan("")))); }

// ---- conductors -------------------------------------------------------------------------------------------

/// The same integral with 40 times the points, split at the same cosine.
double fine_average(double n, double k) {
    const double E = n * n - 1 - k * k, split = E < 0 && E > -1 ? std::sqrt(-E) : 0;
    double sum = 0;
    for (const auto& [lo, hi] : {std::pair{0.0, split}, {split, 1.0}})
        for (int i = 0; i < 400; ++i) {
            const auto place = [&](double t) { // dense at both ends
                const double y = t * t * t * (10 - t * (15 - 6 * t));
                return lo + (hi - lo) * y * y * y * (10 - y * (15 - 6 * y));
            };
            sum += integral<double>([&](double c) { return conductor(1.0, n, k, c).reflectance(); },
                                    place(i / 400.0), place((i + 1) / 400.0));
        }
    return sum;
}

TEST(conductor_average, is_the_quadrature_to_1e_7) {
    random_numbers random(9);
    double worst = 0;
    for (int i = 0; i < 300; ++i) {
        const double n = i % 2 == 0 ? random.log_uniform(0.3, 100) : random.log_uniform(0.02, 5),
                     k = i % 2 == 0 ? random.log_uniform(1e-5, 100) : random.log_uniform(0.1, 100);
        const double miss = std::abs(conductor_average(1.0, n, k) - fine_average(n, k));
        worst = std::fmax(worst, miss);
        EXPECT_LE(miss, 1e-7) << n << " " << k;
    }
    std::printf("conductor_average: %.1e\n", worst);
}

TEST(conductor_average, without_absorption_is_the_closed_form) {
    for (const double eta : {0.1, 0.4, 0.75, 0.999, 1.001, 1.333, 2.417, 20.0})
        EXPECT_NEAR(conductor_average(1.0, eta, 0.0), dielectric_average(eta), eta < 0.3 ? 1e-6 : 1e-7)
            << eta;
    EXPECT_EQ(conductor_average(1.3, 1.3, 0.0), 0);
}

TEST(conductor_average, depends_on_the_ratio_of_indices_alone) {
    EXPECT_NEAR(conductor_average(1.333, 0.2, 3.4), conductor_average(1.0, 0.2 / 1.333, 3.4 / 1.333), 1e-14);
}

// ---- polynomial models ------------------------------------------------------------------------------------

/// f0 and a second reflectance for which no model clamps.
constexpr std::array f0s = {0.02, 0.04, 0.17, 0.42, 0.56, 0.92};
constexpr std::array seconds = {0.7, 0.85, 1.0};

testing::AssertionResult averages(double closed, double quadrature, double f0, double second = 0) {
    return within(closed, quadrature, 1e-14, "f0 " + digits(f0) + ", " + digits(second));
}

TEST(polynomial_averages, with_one_parameter_are_the_quadrature_of_their_models) {
    for (const double f0 : f0s) {
        EXPECT_TRUE(averages(schlick_average(f0), average([=](double c) { return schlick(f0, c); }), f0));
        EXPECT_TRUE(
            averages(photometric_average(f0), average([=](double c) { return photometric(f0, c); }), f0));
        EXPECT_TRUE(
            averages(powers_4_8_average(f0), average([=](double c) { return powers_4_8(f0, c); }), f0));
        const auto form = [=](double c) { return powers_3_9(f0, c); };
        const double rise = 1 - std::pow(std::fmax(f0 - 0.46, 0) / 0.54, 1.0 / 6); // flat for larger cosines
        EXPECT_TRUE(averages(powers_3_9_average(f0),
                             integral<double>(form, 0, rise) + integral<double>(form, rise, 1), f0));
        EXPECT_TRUE(averages(constant_average(f0), average([=](double c) { return constant(f0, c); }), f0));
        if (f0 > 0.2) continue; // there powers_3_6_9 clamps
        EXPECT_TRUE(
            averages(powers_3_6_9_average(f0), average([=](double c) { return powers_3_6_9(f0, c); }), f0));
    }
    EXPECT_NEAR(one_minus_cos_average<double>(), average([](double c) { return one_minus_cos(c); }), 1e-15);
}

TEST(polynomial_averages, with_two_parameters_are_the_quadrature_of_their_models) {
    for (const double f0 : f0s)
        for (const double s : seconds) {
            const double f82_value = s * schlick(f0, 1.0 / 7);
            EXPECT_TRUE(averages(schlick_f90_average(f0, s),
                                 average([=](double c) { return schlick_f90(f0, s, c); }), f0, s));
            EXPECT_TRUE(averages(f82_average(f0, f82_value),
                                 average([=](double c) { return f82(f0, f82_value, c); }), f0, s));
            EXPECT_TRUE(averages(f82_tint_average(f0, s),
                                 average([=](double c) { return f82_tint(f0, s, c); }), f0, s));
            EXPECT_TRUE(averages(powers_4_12_average(f0, f82_value),
                                 average([=](double c) { return powers_4_12(f0, f82_value, c); }), f0, s));
            EXPECT_TRUE(averages(powers_2_8_16_average(f0, f82_value),
                                 average([=](double c) { return powers_2_8_16(f0, f82_value, c); }), f0, s));
        }
}

TEST(polynomial_averages, with_a_free_power_are_the_quadrature_of_their_models) {
    for (const double f0 : f0s)
        for (const double power : {1.0, 2.0, 5.0, 12.0}) {
            EXPECT_TRUE(averages(schlick_power_average(f0, 0.95, power),
                                 average([=](double c) { return schlick_power(f0, 0.95, power, c); }), f0,
                                 power));
            const double f82_value = 0.9 * schlick_power(f0, 0.95, power, 1.0 / 7);
            EXPECT_TRUE(averages(hoffman_average(f0, f82_value, 0.95, power),
                                 average([=](double c) { return hoffman(f0, f82_value, 0.95, power, c); }),
                                 f0, power));
        }
    // a broken power is no polynomial: the rule converges slowly
    const double half = average([](double c) { return schlick_power(0.1, 1.0, 2.5, c); });
    EXPECT_NEAR(schlick_power_average(0.1, 1.0, 2.5), half, 1e-8);
}

TEST(polynomial_averages, of_the_f82_family_are_equal_where_the_models_are) {
    const double f0 = 0.56, tint = 0.8, f82_value = tint * schlick(f0, 1.0 / 7);
    EXPECT_TRUE(same(f82_tint_average(f0, tint), f82_average(f0, f82_value), "f82_tint"));
    EXPECT_TRUE(same(hoffman_average(f0, f82_value, 1.0, 5.0), f82_average(f0, f82_value), "hoffman"));
    EXPECT_TRUE(same(f82_tint_average(f0, 1.0), schlick_average(f0), "tint 1"));
}

TEST(polynomial_averages, of_index_forms_are_the_quadrature_of_their_models) {
    for (const double n : {0.2, 1.5, 3.0})
        for (const double k : {1.0, 5.0}) {
            EXPECT_TRUE(averages(schlick_nk_average(n, k),
                                 average([=](double c) { return schlick_nk(n, k, c); }), n, k));
            EXPECT_TRUE(averages(lazanyi_average(n, k, 0.3, 7.0),
                                 average([=](double c) { return lazanyi(n, k, 0.3, 7.0, c); }), n, k));
        }
    EXPECT_TRUE(averages(bias_scale_power_average(0.1, 0.8, 4.0),
                         average([](double c) { return bias_scale_power(0.1, 0.8, 4.0, c); }), 0.1));
}

TEST(averages, are_models_too_and_instantiate_with_strict) {
    const strict f0 = ratio<strict, 1, 25>(), high = ratio<strict, 9, 10>(), eta = ratio<strict, 3, 2>();
    EXPECT_TRUE(exactly(dielectric_average(eta).value(), dielectric_average(1.5), "eta 1.5"));
    EXPECT_TRUE(exactly(schlick_average(f0).value(), schlick_average(0.04), "schlick"));
    EXPECT_TRUE(
        exactly(schlick_f90_average(f0, high).value(), schlick_f90_average(0.04, 0.9), "schlick_f90"));
    EXPECT_TRUE(exactly(schlick_power_average(f0, high, strict(5)).value(),
                        schlick_power_average(0.04, 0.9, 5.0), "power"));
    EXPECT_TRUE(exactly(photometric_average(f0).value(), photometric_average(0.04), "photometric"));
    EXPECT_TRUE(exactly(powers_4_8_average(f0).value(), powers_4_8_average(0.04), "powers_4_8"));
    EXPECT_TRUE(exactly(powers_3_9_average(f0).value(), powers_3_9_average(0.04), "powers_3_9"));
    EXPECT_TRUE(exactly(powers_3_6_9_average(f0).value(), powers_3_6_9_average(0.04), "powers_3_6_9"));
    EXPECT_TRUE(exactly(f82_average(f0, high).value(), f82_average(0.04, 0.9), "f82"));
    EXPECT_TRUE(exactly(f82_tint_average(f0, high).value(), f82_tint_average(0.04, 0.9), "f82_tint"));
    EXPECT_TRUE(exactly(hoffman_average(f0, high, high, strict(5)).value(),
                        hoffman_average(0.04, 0.9, 0.9, 5.0), "hoffman"));
    EXPECT_TRUE(
        exactly(powers_4_12_average(f0, high).value(), powers_4_12_average(0.04, 0.9), "powers_4_12"));
    EXPECT_TRUE(
        exactly(powers_2_8_16_average(f0, high).value(), powers_2_8_16_average(0.04, 0.9), "powers_2_8_16"));
    EXPECT_TRUE(exactly(conductor_average(strict(1), eta, strict(5)).value(),
                        conductor_average(1.0, 1.5, 5.0), "metal"));
    EXPECT_TRUE(
        exactly(schlick_nk_average(eta, strict(5)).value(), schlick_nk_average(1.5, 5.0), "schlick_nk"));
    EXPECT_TRUE(exactly(lazanyi_average(eta, strict(5), strict(3), strict(7)).value(),
                        lazanyi_average(1.5, 5.0, 3.0, 7.0), "lazanyi"));
    EXPECT_TRUE(exactly(bias_scale_power_average(f0, high, strict(5)).value(),
                        bias_scale_power_average(0.04, 0.9, 5.0), "rim"));
    EXPECT_TRUE(exactly(constant_average(f0).value(), 0.04, "constant"));
    EXPECT_TRUE(exactly(one_minus_cos_average<strict>().value(), 1.0 / 3, "one_minus_cos"));
}

} // namespace
} // namespace fresnel::test
