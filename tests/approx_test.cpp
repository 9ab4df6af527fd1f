#include "inputs.hpp"
#include "oracles.hpp"
#include "tolerances.hpp"

#include <fresnel/models.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <tuple>
#include <type_traits>

namespace fresnel::test {
namespace {

// ---- every approximation, everywhere ----------------------------------------------------------------------

/// The parameters of a row of the registry as numbers.
template <class T, class Row>
using values_of = std::array<T, std::tuple_size_v<decltype(Row::parameters)>>;

/// Calls law(row) for every model that is not exact.
template <class Law>
void for_each_approximation(Law law) {
    for_each_model([&]<class Row>(const Row& row) {
        using result = decltype(evaluate(row, values_of<double, Row>{}, 1.0));
        if constexpr (std::is_same_v<result, double>)
            law(row);
        else
            EXPECT_EQ(row.kind, model_kind::exact) << row.name;
    });
}

/// A parameter in its range: an end, the default, or anywhere, by its logarithm where it spans decades.
template <class T>
T draw(const parameter& p, random_numbers& random) {
    const double pick = random.uniform(0, 8);
    if (pick < 1) return static_cast<T>(p.min);
    if (pick < 2) return static_cast<T>(p.max);
    if (pick < 3) return static_cast<T>(p.default_value);
    if (pick < 5 && p.max > 10 && p.min >= 0)
        return static_cast<T>(random.log_uniform(std::max(p.min, 1e-6), p.max));
    return static_cast<T>(random.uniform(p.min, p.max));
}

template <class T>
T draw_cosine(random_numbers& random) {
    using limits = std::numeric_limits<T>;
    const std::array<T, 8> edges = {
        0,        1,       limits::denorm_min(), limits::min(), limits::epsilon(), 1 - limits::epsilon() / 2,
        T(1) / 7, T(1) / 2};
    const double pick = random.uniform(0, 32);
    return pick < 8 ? edges[static_cast<std::size_t>(pick)] : static_cast<T>(random.uniform(0, 1));
}

template <class T>
struct approximations_of : testing::Test {};
using machine_types = testing::Types<float, double>;
TYPED_TEST_SUITE(approximations_of, machine_types);

template <class Values, class T>
std::string text(std::string_view name, const Values& values, T cos_i) {
    std::string result = std::string(name) + " at cos_i " + digits(cos_i);
    for (const auto& x : values)
        result += ", " + digits(x);
    return result;
}

TYPED_TEST(approximations_of, stay_in_0_to_1_over_the_whole_range_of_their_parameters) {
    for_each_approximation([]<class Row>(const Row& row) {
        random_numbers random(1994);
        values_of<TypeParam, Row> values{};
        for (int i = 0; i < 1000000 / thinning; ++i) {
            for (std::size_t p = 0; p < values.size(); ++p)
                values[p] = draw<TypeParam>(row.parameters[p], random);
            const TypeParam c = draw_cosine<TypeParam>(random);
            const TypeParam F = evaluate(row, values, c);
            ASSERT_TRUE(F >= 0 && F <= 1) << text(row.name, values, c) << "\nF " << digits(F);
        }
    });
}

TYPED_TEST(approximations_of, pass_a_nan_on_from_any_argument_they_read) {
    constexpr TypeParam nan = std::numeric_limits<TypeParam>::quiet_NaN();
    for_each_approximation([=]<class Row>(const Row& row) {
        random_numbers random(7);
        values_of<TypeParam, Row> values{};
        for (int i = 0; i < 1000; ++i) {
            const TypeParam c = static_cast<TypeParam>(random.uniform(0.01, 0.99));
            for (std::size_t p = 0; p <= values.size(); ++p) {
                for (std::size_t q = 0; q < values.size(); ++q)
                    values[q] = q == p ? nan : static_cast<TypeParam>(row.parameters[q].default_value);
                if (p == values.size() && row.name == "constant") continue; // reads no cosine
                const TypeParam F = evaluate(row, values, p == values.size() ? nan : c);
                ASSERT_TRUE(std::isnan(F)) << text(row.name, values, c) << "\nF " << digits(F);
            }
        }
    });
}

// ---- the ends of each curve -------------------------------------------------------------------------------

constexpr std::array f0s = {0.0, 0.02, 0.04, 0.17, 0.46, 0.56, 0.92, 1.0};

TEST(approximations, are_f0_at_normal_incidence) {
    for (const double f0 : f0s) {
        const std::string input = "f0 " + digits(f0);
        EXPECT_TRUE(exactly(schlick(f0, 1.0), f0, input));
        EXPECT_TRUE(exactly(schlick_f90(f0, 0.7, 1.0), f0, input));
        EXPECT_TRUE(exactly(schlick_power(f0, 0.7, 3.5, 1.0), f0, input));
        EXPECT_TRUE(exactly(photometric(f0, 1.0), f0, input));
        EXPECT_TRUE(exactly(powers_4_8(f0, 1.0), f0, input));
        EXPECT_TRUE(exactly(powers_3_9(f0, 1.0), f0, input));
        EXPECT_TRUE(exactly(powers_3_6_9(f0, 1.0), f0, input));
        EXPECT_TRUE(exactly(constant(f0, 1.0), f0, input));
        EXPECT_TRUE(exactly(f82(f0, 0.3, 1.0), f0, input));
        EXPECT_TRUE(exactly(f82_tint(f0, 0.3, 1.0), f0, input));
        EXPECT_TRUE(exactly(hoffman(f0, 0.3, 0.9, 4.0, 1.0), f0, input));
        EXPECT_TRUE(exactly(powers_4_12(f0, 0.3, 1.0), f0, input));
        EXPECT_TRUE(exactly(powers_2_8_16(f0, 0.3, 1.0), f0, input));
    }
    EXPECT_EQ(one_minus_cos(1.0), 0);
}

TEST(approximations, are_1_at_grazing_incidence) {
    for (const double f0 : f0s) {
        const std::string input = "f0 " + digits(f0);
        EXPECT_TRUE(exactly(schlick(f0, 0.0), 1.0, input));
        EXPECT_TRUE(same(schlick_f90(f0, 0.7, 0.0), 0.7, input));
        EXPECT_TRUE(same(schlick_power(f0, 0.7, 3.5, 0.0), 0.7, input));
        EXPECT_TRUE(exactly(spherical_gaussian(f0, 0.0), 1.0, input));
        EXPECT_TRUE(exactly(photometric(f0, 0.0), 1.0, input));
        EXPECT_TRUE(same(powers_4_8(f0, 0.0), 1.0, input));
        EXPECT_TRUE(same(powers_3_9(f0, 0.0), 1.0, input));
        EXPECT_TRUE(same(powers_3_6_9(f0, 0.0), 1.0, input));
        EXPECT_TRUE(exactly(f82(f0, 0.3, 0.0), 1.0, input));
        EXPECT_TRUE(exactly(f82_tint(f0, 0.3, 0.0), 1.0, input));
        EXPECT_TRUE(same(hoffman(f0, 0.3, 0.9, 4.0, 0.0), 0.9, input));
        EXPECT_TRUE(same(powers_4_12(f0, 0.3, 0.0), 1.0, input));
        EXPECT_TRUE(same(powers_2_8_16(f0, 0.3, 0.0), 1.0, input));
    }
    EXPECT_EQ(one_minus_cos(0.0), 1);
    EXPECT_TRUE(same(schlick_nk(1.5, 5.0, 0.0), 1.0, "n 1.5, k 5"));
    EXPECT_EQ(air_conductor(1.5, 5.0, 0.0), 1);
    EXPECT_TRUE(same(lazanyi(1.5, 5.0, 3.0, 7.0, 0.0), 1.0, "n 1.5, k 5"));
    EXPECT_EQ(gulbrandsen(0.6, 0.3, 0.0), 1);
    EXPECT_EQ(schlick_internal(1 / 1.5, 0.0), 1);
}

TEST(approximations, of_conductors_meet_the_exact_value_at_normal_incidence) {
    for (const double n : {0.1, 0.5, 1.0, 1.5, 4.0})
        for (const double k : {0.5, 2.0, 5.0, 9.0}) {
            const double f0 = normal_reflectance(1.0, n, k);
            const std::string input = "n " + digits(n) + ", k " + digits(k);
            EXPECT_TRUE(same(schlick_nk(n, k, 1.0), f0, input));
            EXPECT_TRUE(same(air_conductor(n, k, 1.0), f0, input));
            EXPECT_TRUE(same(lazanyi(n, k, 2 * n, 7.0, 1.0), f0, input));
        }
}

TEST(spherical_gaussian, ends_1_7e_4_of_the_way_above_f0) {
    for (const double f0 : f0s)
        EXPECT_NEAR(spherical_gaussian(f0, 1.0), f0 + 1.7e-4 * (1 - f0), 5e-6) << f0;
    double largest = 0;
    for (double c = 0; c <= 1; c += 1e-4)
        largest = std::fmax(largest, std::abs(spherical_gaussian(0.0, c) - schlick(0.0, c)));
    EXPECT_NEAR(largest, 0.0038, 5e-5);
}

TEST(schlick, rises_from_f0_to_1_without_a_dip) {
    for (const double f0 : f0s)
        for (double c = 1; c >= 0.001; c -= 0.001)
            EXPECT_LE(schlick(f0, c), schlick(f0, c - 0.001)) << f0 << ' ' << c;
}

TEST(powers_3_9, never_dips_below_f0_and_powers_4_8_does_only_above_0_55) {
    for (double f0 = 0; f0 <= 1; f0 += 0.01) {
        double lowest_39 = 1, lowest_48 = 1;
        for (double c = 0; c <= 1; c += 0.001) {
            lowest_39 = std::fmin(lowest_39, powers_3_9(f0, c) - f0);
            lowest_48 = std::fmin(lowest_48, powers_4_8(f0, c) - f0);
        }
        EXPECT_GE(lowest_39, -1e-15) << f0;
        EXPECT_EQ(lowest_48 < -1e-15, f0 > 0.55 + 1e-9) << f0 << ' ' << lowest_48;
    }
}

TEST(powers_3_6_9, is_monotone_over_the_gems) {
    for (double eta = 1.3; eta <= 2.7; eta += 0.01) {
        const double f0 = normal_reflectance(1.0, eta, 0.0);
        for (double c = 1; c >= 0.001; c -= 0.001)
            ASSERT_LE(powers_3_6_9(f0, c), powers_3_6_9(f0, c - 0.001)) << eta << ' ' << c;
    }
}

TEST(schlick_internal, is_1_beyond_the_critical_angle_and_schlick_outside_it) {
    const double eta = 1 / 1.5, critical = std::sqrt((1 - eta) * (1 + eta));
    for (double c = 0; c < critical; c += 0.01)
        EXPECT_EQ(schlick_internal(eta, c), 1) << c;
    for (double c = critical; c <= 1; c += 0.01)
        EXPECT_TRUE(same(schlick_internal(eta, c),
                         schlick(normal_reflectance(1.0, 1.5, 0.0), refracted_cosine(eta, c)), digits(c)));
}

// ---- the f82 family ---------------------------------------------------------------------------------------

TEST(f82_family, meets_f82_at_a_cosine_of_one_seventh) {
    for (const double f0 : {0.04, 0.3, 0.56, 0.92})
        for (const double h : {0.4, 0.7, 0.95}) {
            const std::string input = "f0 " + digits(f0) + ", f82 " + digits(h);
            EXPECT_TRUE(same(f82(f0, h, 1.0 / 7), h, input, 4));
            EXPECT_TRUE(same(hoffman(f0, h, 1.0, 5.0, 1.0 / 7), h, input, 4));
            EXPECT_TRUE(same(hoffman(f0, h, 0.9, 3.0, 1.0 / 7), h, input, 4));
            EXPECT_TRUE(same(powers_4_12(f0, h, 1.0 / 7), h, input, 4));
            EXPECT_TRUE(within(powers_2_8_16(f0, h, 1.0 / 7), h, 3e-6, input));
            EXPECT_TRUE(same(f82_tint(f0, h, 1.0 / 7), h * schlick(f0, 1.0 / 7), input, 4));
        }
}

TEST(f82_family, is_schlick_where_f82_is_schlicks) {
    for (const double f0 : f0s)
        for (double c = 0; c <= 1; c += 0.05) {
            EXPECT_TRUE(exactly(f82_tint(f0, 1.0, c), schlick(f0, c), digits(f0)));
            EXPECT_TRUE(same(f82(f0, schlick(f0, 1.0 / 7), c), schlick(f0, c), digits(f0), 1));
            EXPECT_TRUE(same(hoffman(f0, f0 + (0.8 - f0) * std::pow(6.0 / 7, 3), 0.8, 3.0, c),
                             schlick_power(f0, 0.8, 3.0, c), digits(f0), 1));
        }
}

TEST(f82_family, saturates_at_0_for_a_hostile_tint) {
    // unclamped, tint 0 reaches -0.127 at f0 = 0 and -0.021 at f0 = 0.5
    const auto unclamped = [](double f0, double tint, double c) {
        const double x = 1 - c, b = schlick(f0, 1.0 / 7) * (1 - tint) * 7 / std::pow(6.0 / 7, 6);
        return schlick(f0, c) - b * c * std::pow(x, 6);
    };
    for (const auto [f0, lowest] : {std::array{0.0, -0.127}, std::array{0.5, -0.021}}) {
        double deepest = 1, clamped = 1;
        for (double c = 0; c <= 1; c += 1e-3) {
            deepest = std::fmin(deepest, unclamped(f0, 0, c));
            clamped = std::fmin(clamped, f82_tint(f0, 0.0, c));
            EXPECT_NEAR(f82_tint(f0, 0.0, c), std::fmax(unclamped(f0, 0, c), 0), 1e-14) << f0 << ' ' << c;
        }
        EXPECT_NEAR(deepest, lowest, 6e-4) << f0;
        EXPECT_EQ(clamped, 0) << f0;
    }
}

// ---- gulbrandsen ------------------------------------------------------------------------------------------

TEST(gulbrandsen, is_a_number_in_float_for_every_corner_of_its_parameters) {
    for (const float r : {0.0f, 1e-6f, 0.5f, 0.9999f, 1.0f})
        for (const float g : {0.0f, 0.5f, 1.0f})
            for (const float cos_i : {0.0f, 1e-6f, 0.5f, 1.0f}) {
                const float R = gulbrandsen(r, g, cos_i);
                EXPECT_TRUE(R >= 0 && R <= 1) << r << " " << g << " " << cos_i << ": " << R;
            }
}

TEST(gulbrandsen, gives_back_r_at_normal_incidence_in_float_too) {
    random_numbers random(2014);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const double r = random.uniform(0, 0.9999), g = random.uniform(0, 1);
        EXPECT_TRUE(within(gulbrandsen(r, g, 1.0), r, 1e-12, digits(r) + ", " + digits(g)));
        const float narrow = static_cast<float>(r);
        EXPECT_TRUE(within(gulbrandsen(narrow, static_cast<float>(g), 1.0f), narrow, 2e-6f,
                           digits(r) + ", " + digits(g)));
    }
}

TEST(gulbrandsen, is_the_conductor_of_its_indices) {
    for (const double r : {0.2, 0.6, 0.95})
        for (const double g : {0.1, 0.5, 0.9}) {
            const double s = std::sqrt(r), n = g * (1 - r) / (1 + r) + (1 - g) * (1 + s) / (1 - s);
            const double k2 = ((n + 1) * (n + 1) * r - (n - 1) * (n - 1)) / (1 - r);
            for (const double c : {0.05, 0.3, 0.8})
                EXPECT_NEAR(gulbrandsen(r, g, c), conductor(1.0, n, std::sqrt(k2), c).reflectance(), 1e-12);
        }
}

// ---- published errors -------------------------------------------------------------------------------------

/// Largest |approximation - exact| over 20,001 cosines.
template <class F, class G>
double largest_difference(F approximation, G exact) {
    double largest = 0;
    for (int i = 0; i <= 20000; ++i) {
        const double c = i / 20000.0;
        largest = std::fmax(largest, std::abs(approximation(c) - exact(c)));
    }
    return largest;
}

auto exact_dielectric(double eta) {
    return [=](double c) { return dielectric(1.0, eta, c).reflectance(); };
}

auto exact_conductor(double n, double k) {
    return [=](double c) { return conductor(1.0, n, k, c).reflectance(); };
}

TEST(published_errors, of_schlick_by_index) {
    for (const auto [eta, published] : {std::array{1.01, 0.550},
                                        {1.05, 0.318},
                                        {1.1, 0.211},
                                        {1.2, 0.113},
                                        {1.333, 0.0594},
                                        {1.5, 0.0361},
                                        {1.65, 0.032},
                                        {2.0, 0.044},
                                        {2.42, 0.0757},
                                        {3.0, 0.125},
                                        {4.0, 0.201}}) {
        const double f0 = normal_reflectance(1.0, eta, 0.0);
        EXPECT_NEAR(largest_difference([=](double c) { return schlick(f0, c); }, exact_dielectric(eta)),
                    published, 6e-4)
            << eta;
    }
}

TEST(published_errors, of_schlick_between_1_337_and_2_2005_are_at_most_0_0582) {
    for (double eta = 1.337; eta <= 2.2005; eta += 0.005) {
        const double f0 = normal_reflectance(1.0, eta, 0.0);
        EXPECT_LE(largest_difference([=](double c) { return schlick(f0, c); }, exact_dielectric(eta)), 0.0583)
            << eta;
    }
}

TEST(published_errors, of_schlick_internal) {
    for (const auto [eta, published] : {std::array{1.333, 0.059}, {1.5, 0.036}, {2.42, 0.076}})
        EXPECT_NEAR(largest_difference([=](double c) { return schlick_internal(1 / eta, c); },
                                       exact_dielectric(1 / eta)),
                    published, 1e-3)
            << eta;
}

TEST(published_errors, of_schlick_without_the_transmitted_cosine_inside_are_useless) {
    for (const double eta : {1.333, 1.5, 2.42}) {
        const double f0 = normal_reflectance(1.0, eta, 0.0);
        EXPECT_GT(largest_difference([=](double c) { return schlick(f0, c); }, exact_dielectric(1 / eta)),
                  0.8)
            << eta;
    }
}

TEST(published_errors, of_the_power_forms_over_gems) {
    double schlick_error = 0, photometric_error = 0, q48 = 0, q39 = 0, h369 = 0;
    for (double eta = 1.33; eta <= 2.42; eta += 0.01) {
        const double f0 = normal_reflectance(1.0, eta, 0.0);
        const auto error = [&](auto form) {
            return largest_difference([&](double c) { return form(f0, c); }, exact_dielectric(eta));
        };
        schlick_error = std::fmax(schlick_error, error([](double f, double c) { return schlick(f, c); }));
        photometric_error =
            std::fmax(photometric_error, error([](double f, double c) { return photometric(f, c); }));
        q48 = std::fmax(q48, error([](double f, double c) { return powers_4_8(f, c); }));
        q39 = std::fmax(q39, error([](double f, double c) { return powers_3_9(f, c); }));
        h369 = std::fmax(h369, error([](double f, double c) { return powers_3_6_9(f, c); }));
    }
    EXPECT_NEAR(schlick_error, 0.0757, 5e-4);
    EXPECT_NEAR(q48, 0.0307, 5e-4);
    EXPECT_NEAR(q39, 0.0270, 5e-4);
    EXPECT_NEAR(h369, 0.0040, 2e-4);
    EXPECT_LT(photometric_error, schlick_error);
}

TEST(published_errors, of_the_memos_metal_n_1_5_k_5) {
    const auto exact = exact_conductor(1.5, 5);
    const double f0 = normal_reflectance(1.0, 1.5, 5.0), h = exact(1.0 / 7);
    EXPECT_NEAR(largest_difference([](double c) { return schlick_nk(1.5, 5.0, c); }, exact), 0.132, 1e-3);
    EXPECT_NEAR(largest_difference([](double c) { return lazanyi(1.5, 5.0, 3.0, 7.7, c); }, exact), 0.028,
                1e-3);
    EXPECT_NEAR(largest_difference([](double c) { return lazanyi(1.5, 5.0, 3.0, 7.0, c); }, exact), 0.019,
                1e-3);
    EXPECT_NEAR(largest_difference([=](double c) { return f82(f0, h, c); }, exact), 0.011, 1e-3);
    EXPECT_NEAR(largest_difference([=](double c) { return schlick(f0, c); }, exact), 0.132, 1e-3);
}

TEST(published_errors, of_the_air_conductor_shrink_with_absorption) {
    for (const auto [k, published] : {std::array{0.0, 0.099}, {0.5, 0.052}, {1.0, 0.0168}, {2.0, 0.0065}})
        EXPECT_NEAR(
            largest_difference([=](double c) { return air_conductor(1.5, k, c); }, exact_conductor(1.5, k)),
            published, 6e-4)
            << k;
}

TEST(published_errors, of_the_rim_of_game_shaders_fitted_to_water_and_glass) {
    constexpr double rounding = 1e-3; // bias and scale are given to three places
    EXPECT_NEAR(largest_difference([](double c) { return bias_scale_power(0.034, 0.952, 5.76, c); },
                                   exact_dielectric(1.333)),
                0.0139, rounding);
    EXPECT_NEAR(largest_difference([](double c) { return bias_scale_power(0.055, 0.929, 5.30, c); },
                                   exact_dielectric(1.5)),
                0.0154, rounding);
}

// ---- number types -----------------------------------------------------------------------------------------

TYPED_TEST(approximations_of, round_to_a_few_places_of_50_digits) {
    // The parameter range of dielectrics and metals; the sharp powers and deep dips of the artistic extremes
    // multiply rounding by themselves and are left to the range test above.
    const auto close = [](TypeParam got, const real50& exact, const std::string& input) {
        const TypeParam allowed = 40 * std::numeric_limits<TypeParam>::epsilon();
        return within<TypeParam>(got, static_cast<TypeParam>(exact), allowed, input);
    };
    random_numbers random(82);
    for (int i = 0; i < 3000 / thinning; ++i) {
        const TypeParam f0 = static_cast<TypeParam>(random.uniform(0, 1)),
                        h = static_cast<TypeParam>(random.uniform(0, 1));
        const TypeParam n = static_cast<TypeParam>(random.uniform(0.1, 4)),
                        k = static_cast<TypeParam>(random.uniform(0, 8));
        const TypeParam c = draw_cosine<TypeParam>(random);
        const real50 F0 = f0, H = h, N = n, K = k, C = c;
        const std::string input = text("f0, f82, n, k", std::array{f0, h, n, k}, c);
        EXPECT_TRUE(close(schlick(f0, c), schlick(F0, C), input));
        EXPECT_TRUE(close(schlick_f90(f0, h, c), schlick_f90(F0, H, C), input));
        EXPECT_TRUE(close(schlick_power(f0, h, TypeParam(7), c), schlick_power(F0, H, real50(7), C), input));
        EXPECT_TRUE(close(schlick_nk(n, k, c), schlick_nk(N, K, C), input));
        EXPECT_TRUE(close(spherical_gaussian(f0, c), spherical_gaussian(F0, C), input));
        EXPECT_TRUE(close(photometric(f0, c), photometric(F0, C), input));
        EXPECT_TRUE(close(powers_4_8(f0, c), powers_4_8(F0, C), input));
        EXPECT_TRUE(close(powers_3_9(f0, c), powers_3_9(F0, C), input));
        EXPECT_TRUE(close(powers_3_6_9(f0, c), powers_3_6_9(F0, C), input));
        EXPECT_TRUE(close(air_conductor(n, k, c), air_conductor(N, K, C), input));
        EXPECT_TRUE(close(f82(f0, h, c), f82(F0, H, C), input));
        EXPECT_TRUE(close(f82_tint(f0, h, c), f82_tint(F0, H, C), input));
        EXPECT_TRUE(close(hoffman(f0, h, TypeParam(1), TypeParam(5), c),
                          hoffman(F0, H, real50(1), real50(5), C), input));
        EXPECT_TRUE(close(powers_4_12(f0, h, c), powers_4_12(F0, H, C), input));
        EXPECT_TRUE(close(powers_2_8_16(f0, h, c), powers_2_8_16(F0, H, C), input));
    }
}

} // namespace
} // namespace fresnel::test
