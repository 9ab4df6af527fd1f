#pragma once

// The laws of batch<float, N>, for every width that a plain translation unit can hold. Included by one program
// for GNU vectors and by one for the array that replaces them.

#include "inputs.hpp"
#include "tolerances.hpp"

#include "analysis/multi.hpp"

#include <fresnel/models.hpp>
#include <fresnel/types/simd.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

namespace fresnel::test {
namespace {

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float nan = std::numeric_limits<float>::quiet_NaN();
constexpr float tiny = std::numeric_limits<float>::denorm_min();

template <class Batch>
struct simd : testing::Test {};

using widths = testing::Types<batch<float, 1>, batch<float, 4>>;
TYPED_TEST_SUITE(simd, widths);

/// Equal bit for bit, or both not a number.
testing::AssertionResult identical(float actual, float expected, const std::string& input) {
    if (std::isnan(actual) && std::isnan(expected)) return testing::AssertionSuccess();
    return exactly(actual, expected, input);
}

/// Values at which operations have limits, and ordinary ones.
std::vector<float> values_with_limits() {
    return {0.0F,  -0.0F, 1.0F,  -1.0F, 0.5F,      3.0F, -7.25F,   1e-20F,
            1e20F, tiny,  -tiny, 1e38F, 0x1p-126F, nan,  infinity, -infinity};
}

/// f of a batch whose last lane is x and y, the others 1: the last lane of the result.
template <class Batch, class F>
float in_last_lane(float x, float y, F f) {
    std::array<float, Batch::size> a, b;
    a.fill(1), b.fill(1);
    a.back() = x, b.back() = y;
    return f(Batch::load(a.data()), Batch::load(b.data()))[Batch::size - 1];
}

template <class Batch, class Packed, class Scalar>
void expect_lanewise(std::string_view name, Packed packed, Scalar scalar) {
    for (const float x : values_with_limits())
        for (const float y : values_with_limits())
            EXPECT_TRUE(identical(in_last_lane<Batch>(x, y, packed), scalar(x, y),
                                  std::string(name) + " of " + digits(x) + " and " + digits(y)));
}

TYPED_TEST(simd, operations_are_those_of_float_in_every_lane) {
    using V = TypeParam;
    const auto sum = [](auto x, auto y) { return x + y; };
    const auto difference = [](auto x, auto y) { return x - y; };
    const auto product = [](auto x, auto y) { return x * y; };
    const auto quotient = [](auto x, auto y) { return x / y; };
    const auto smaller = [](auto x, auto y) { return min(x, y); };
    const auto larger = [](auto x, auto y) { return max(x, y); };
    const auto with_integers = [](auto x, auto y) { return (2 * x - 1) / (y + 3) + 4; };
    const auto one = [](auto x, auto) { return sqrt(abs(-x)); };
    expect_lanewise<V>("sum", sum, sum);
    expect_lanewise<V>("difference", difference, difference);
    expect_lanewise<V>("product", product, product);
    expect_lanewise<V>("quotient", quotient, quotient);
    expect_lanewise<V>("min", smaller, smaller);
    expect_lanewise<V>("max", larger, larger);
    expect_lanewise<V>("integers", with_integers, with_integers);
    expect_lanewise<V>("root", one, one);
}

TYPED_TEST(simd, comparisons_select_lane_by_lane) {
    using V = TypeParam;
    const auto chosen = [](auto less, auto at_most, auto more, auto at_least) {
        using T = decltype(less);
        return less + 2 * at_most + 4 * more + 8 * at_least + T(0);
    };
    const auto law = [&](auto x, auto y) {
        using T = decltype(x);
        return chosen(select(x < y, T(1), T(0)), select(x <= y, T(1), T(0)), select(x > y, T(1), T(0)),
                      select(x >= y, T(1), T(0)));
    };
    expect_lanewise<V>("comparisons", law, law);
}

TYPED_TEST(simd, min_and_max_keep_a_nan_that_comes_first) {
    using V = TypeParam;
    EXPECT_TRUE(std::isnan(min(V::broadcast(nan), V(1))[0]));
    EXPECT_TRUE(std::isnan(max(V::broadcast(nan), V(1))[0]));
    EXPECT_EQ(min(V(1), V::broadcast(nan))[0], 1);
    EXPECT_EQ(max(V(1), V::broadcast(nan))[0], 1);
}

/// The distance from the truth in units of the last place of the truth, a denormal's being the smallest float.
double ulps(float actual, const real50& truth) {
    const int exponent = truth == 0 ? -200 : static_cast<int>(ilogb(truth));
    const double unit = std::ldexp(1.0, std::max(exponent - 23, -149));
    return std::abs(static_cast<double>(real50((real50(actual) - truth) / unit)));
}

constexpr int function_points = 20000 / thinning;

TYPED_TEST(simd, exact_product_is_exact) {
    random_numbers random(14);
    for (int i = 0; i < function_points; ++i) {
        const float x = static_cast<float>(random.log_uniform(1e-12, 1e12));
        const float y = static_cast<float>(-random.log_uniform(1e-12, 1e12));
        const auto [high, low] = exact_product(TypeParam::broadcast(x), TypeParam::broadcast(y));
        const double product = static_cast<double>(x) * static_cast<double>(y);
        EXPECT_EQ(static_cast<double>(high[0]) + static_cast<double>(low[0]), product)
            << digits(x) << " * " << digits(y);
        EXPECT_EQ(high[0], static_cast<float>(product));
    }
}

TYPED_TEST(simd, exp2_is_within_its_error) {
    random_numbers random(11);
    for (int i = 0; i < function_points; ++i) {
        const float x = static_cast<float>(i % 2 ? random.uniform(-151, 128) : random.uniform(-13, 1));
        EXPECT_LE(ulps(exp2(TypeParam::broadcast(x))[0], exp2(real50(x))), 1.25) << digits(x);
    }
}

TYPED_TEST(simd, log2_and_log_are_within_their_errors) {
    random_numbers random(12);
    for (int i = 0; i < function_points; ++i) {
        const float x =
            static_cast<float>(i % 2 ? std::exp2(random.uniform(-149, 128)) : random.uniform(0.7, 1.42));
        const TypeParam v = TypeParam::broadcast(x);
        EXPECT_LE(ulps(log2(v)[0], log2(real50(x))), 0.6) << digits(x);
        EXPECT_LE(ulps(log(v)[0], log(real50(x))), 0.6) << digits(x);
    }
}

TYPED_TEST(simd, pow_is_within_its_error) {
    random_numbers random(13);
    for (int i = 0; i < function_points; ++i) {
        const float x = static_cast<float>(i % 2 ? random.uniform(0, 1) : random.log_uniform(1e-30, 1e30));
        const double logarithm = std::log2(static_cast<double>(x));
        const float y =
            static_cast<float>(i % 3 ? random.uniform(-125, 127) / logarithm
                                     : std::fmin(random.log_uniform(0.1, 1000), -125 / logarithm));
        if (std::abs(static_cast<double>(y) * logarithm) > 125) continue;
        const float power = pow(TypeParam::broadcast(x), TypeParam::broadcast(y))[0];
        EXPECT_LE(ulps(power, pow(real50(x), real50(y))), 1.5) << digits(x) << " to the " << digits(y);
    }
}

TYPED_TEST(simd, functions_have_the_limits_of_the_c_library) {
    for (const float x : {0.0F, -0.0F, 1.0F, -1.0F, -infinity, infinity, nan}) {
        const TypeParam v = TypeParam::broadcast(x);
        EXPECT_TRUE(identical(log2(v)[0], std::log2(x), "log2 of " + digits(x)));
        EXPECT_TRUE(identical(log(v)[0], std::log(x), "log of " + digits(x)));
    }
    EXPECT_EQ(exp2(TypeParam::broadcast(-infinity))[0], 0);
    EXPECT_EQ(exp2(TypeParam::broadcast(infinity))[0], infinity);
    EXPECT_EQ(exp2(TypeParam::broadcast(128))[0], infinity);
    EXPECT_EQ(exp2(TypeParam::broadcast(-149))[0], tiny);
    EXPECT_EQ(exp2(TypeParam::broadcast(-151))[0], 0);
    EXPECT_TRUE(std::isnan(exp2(TypeParam::broadcast(nan))[0]));
}

TYPED_TEST(simd, pow_has_the_limits_of_the_c_library) {
    for (const float x : {0.0F, 1.0F, 0.5F, 2.0F, tiny, infinity, nan})
        for (const float y : {0.0F, 1.0F, 1000.0F, -1000.0F, infinity, -infinity, nan}) {
            const float expected = std::pow(x, y);
            const float actual = pow(TypeParam::broadcast(x), TypeParam::broadcast(y))[0];
            EXPECT_TRUE(identical(actual, expected, digits(x) + " to the " + digits(y)));
        }
}

TYPED_TEST(simd, runs_every_model_as_float_does) {
    for_each_model([](const auto& row) {
        random_numbers random(14);
        for (int i = 0; i < 200; ++i) {
            std::vector<float> values;
            for (const parameter& p : row.parameters)
                values.push_back(static_cast<float>(random.uniform(
                    std::max(p.min, p.default_value / 3), std::min(p.max, 2 * p.default_value + 0.1))));
            const float c = static_cast<float>(random.uniform(0, 1));
            std::vector<TypeParam> packed;
            for (const float v : values)
                packed.push_back(TypeParam::broadcast(v));
            const auto actual = evaluate(row, packed, TypeParam::broadcast(c));
            const auto expected = evaluate(row, values, c);
            const std::string input = std::string(row.name) + " at " + digits(c);
            if constexpr (requires { actual.R_s; })
                EXPECT_TRUE(identical(actual.R_p[0], expected.R_p, input));
            else // exp2 and pow are another's here
                EXPECT_TRUE(same(actual[0], expected, input, 1));
        }
    });
}

} // namespace
} // namespace fresnel::test
