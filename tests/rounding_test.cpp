#include "inputs.hpp"
#include "tolerances.hpp"

#include "analysis/multi.hpp"

#include <fresnel/models.hpp>
#include <fresnel/types/rounding.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace fresnel::test {
namespace {

constexpr double half_unit_of_1 = 0x1p-24; // of [1, 2)

/// Real and float results lie where they should, and as near to each other as stated.
testing::AssertionResult bounds(const rounding& x, float machine, const real50& real) {
    const double m = static_cast<double>(machine);
    const double miss = static_cast<double>(real50(abs(real50(m) - real)));
    if (real50(x.real.lo) <= real && real <= real50(x.real.hi) && x.machine.contains(m) && miss <= x.error)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << "float " << digits(machine) << " in [" << x.machine.lo << ", "
                                       << x.machine.hi << "], real " << digits(real) << " in [" << x.real.lo
                                       << ", " << x.real.hi << "], miss " << miss << " of " << x.error;
}

/// Floats in a random interval, and one of them.
struct drawn {
    rounding all;
    float one;
    real50 real() const { return real50(static_cast<double>(one)); }
};

drawn draw(random_numbers& random, double low, double high, double size) {
    const auto a = static_cast<float>(random.uniform(low, high));
    const auto b = static_cast<float>(std::min(static_cast<double>(a) + size, high));
    const auto inner = static_cast<float>(random.uniform(static_cast<double>(a), static_cast<double>(b)));
    return {rounding(static_cast<double>(a), static_cast<double>(b)), std::clamp(inner, a, b)};
}

TEST(rounding, bounds_its_operations) {
    random_numbers random(11);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const double size = random.one_in(3) ? 0 : random.log_uniform(1e-8, 1);
        const drawn x = draw(random, 0.1, 3, size), y = draw(random, 0.1, 3, size);
        const float a = x.one, b = y.one;
        const real50 p = x.real(), q = y.real();
        EXPECT_TRUE(bounds(x.all + y.all, a + b, p + q));
        EXPECT_TRUE(bounds(x.all - y.all, a - b, p - q));
        EXPECT_TRUE(bounds(x.all * y.all, a * b, p * q));
        EXPECT_TRUE(bounds(x.all / y.all, a / b, p / q));
        EXPECT_TRUE(bounds(sqrt(x.all), std::sqrt(a), sqrt(p)));
        EXPECT_TRUE(bounds(log(x.all), std::log(a), log(p)));
        EXPECT_TRUE(bounds(log2(x.all), std::log2(a), real50(log(p) / log(real50(2)))));
        EXPECT_TRUE(bounds(exp2(x.all), std::exp2(a), real50(pow(real50(2), p))));
        EXPECT_TRUE(bounds(pow(x.all, y.all), std::pow(a, b), real50(pow(p, q))));
        EXPECT_TRUE(bounds(max(x.all, y.all), std::max(a, b), std::max(p, q)));
        EXPECT_TRUE(bounds(abs(x.all - y.all), std::abs(a - b), real50(abs(p - q))));
        // what the operands bring
        EXPECT_TRUE(
            bounds((x.all * y.all - y.all) / (x.all + y.all), (a * b - b) / (a + b), (p * q - q) / (p + q)));
        EXPECT_TRUE(bounds(sqrt(x.all * y.all), std::sqrt(a * b), sqrt(p * q)));
        EXPECT_TRUE(bounds(pow(x.all * y.all, x.all), std::pow(a * b, a), real50(pow(p * q, p))));
        EXPECT_TRUE(bounds(exp2(x.all * y.all), std::exp2(a * b), real50(pow(real50(2), real50(p * q)))));
        EXPECT_TRUE(bounds(log2(x.all * y.all), std::log2(a * b), real50(log(p * q) / log(real50(2)))));
    }
}

TEST(rounding, of_one_operation_is_half_a_unit_of_the_last_place) {
    EXPECT_NEAR((rounding(0, 1) + rounding(0, 0.9)).error / half_unit_of_1, 1, 1e-9);
    EXPECT_NEAR((rounding(0, 1) * rounding(0, 1)).error / half_unit_of_1, 0.5, 1e-9);
    EXPECT_NEAR((rounding(1, 1) / rounding(3, 3)).error / half_unit_of_1, 1.0 / 6, 1e-6);
}

TEST(rounding, of_what_is_exact_is_none_but_of_subnormals) {
    const rounding x(0.7, 0.9);
    EXPECT_EQ((x + 0).error, 0);
    EXPECT_EQ((1 - x).error, 0) << "Sterbenz";
    EXPECT_LE((2 * x).error, 0x1p-149);
    EXPECT_LE((x / 4).error, 0x1p-149);
    EXPECT_GT((1 - rounding(0.1, 0.2)).error, 0x1p-27);
}

TEST(rounding, keeps_float_results_on_floats) {
    const rounding x = rounding(0, 0.7) * rounding(0, 0.3);
    const auto nearest = static_cast<float>(x.machine.hi);
    EXPECT_EQ(static_cast<double>(nearest), x.machine.hi);
    EXPECT_EQ((1 - rounding(0, 0.5)).machine.hi, 1) << "rounded outwards, then to float";
}

TEST(rounding, refuses_a_comparison_that_only_one_of_the_two_might_pass) {
    EXPECT_TRUE(rounding(0, 0.5) < rounding(0.6, 1));
    EXPECT_THROW((void)(rounding(0, 0.5) < rounding(0.4, 1)), rounding::undecided);
}

TEST(rounding, refuses_a_root_of_what_float_may_have_below_0) {
    const rounding x(1.10013485, 1.10013486), y(1.33148956, 1.33148957); // x^3 - y is 9e-10, in float below 0
    EXPECT_THROW((void)sqrt(x * x * x - y), rounding::undecided);
    EXPECT_THROW((void)log2(x * x * x - y), rounding::undecided);
    EXPECT_NO_THROW((void)sqrt(rounding(0, 1) * rounding(0, 1)));
}

TEST(rounding, charges_an_integer_that_float_does_not_have) {
    const rounding x = rounding(16777217) - 16777216;
    EXPECT_EQ(x.machine.hi, 0);
    EXPECT_GE(x.error, 1);
    EXPECT_EQ(rounding(16777216).error, 0);
}

/// Every model over boxes of any size, where it makes no such comparison.
template <std::size_t N, class F>
int scan(const model<N, F>& row) {
    random_numbers random(12);
    int held = 0;
    for (int i = 0; i < 1000 / thinning; ++i) {
        const double size = random.one_in(4) ? 0 : random.log_uniform(1e-7, 1);
        std::array<rounding, N> box;
        std::array<float, N> narrow{};
        std::array<real50, N> wide;
        for (std::size_t p = 0; p < N; ++p) {
            const parameter& q = row.parameters[p];
            const drawn x =
                draw(random, std::max(q.min, q.max > 10 ? 0.1 : q.min), std::min(q.max, 10.0), size);
            box[p] = x.all, narrow[p] = x.one, wide[p] = x.real();
        }
        const drawn c = draw(random, 0, 1, size);
        try {
            const rounding R = reflectance(evaluate(row, box, c.all));
            EXPECT_TRUE(bounds(R, reflectance(evaluate(row, narrow, c.one)),
                               reflectance(evaluate(row, wide, c.real()))))
                << row.name;
            ++held;
        } catch (const rounding::undecided&) {
        }
    }
    return held;
}

TEST(rounding, bounds_every_model) {
    for_each_model([](const auto& row) {
        const int held = scan(row);
        const bool compares =
            row.kind == model_kind::exact || row.name == "gulbrandsen" || row.name == "schlick_internal";
        if (!compares) {
            EXPECT_EQ(held, 1000 / thinning) << row.name;
        }
    });
}

} // namespace
} // namespace fresnel::test
