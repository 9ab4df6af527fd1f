#include "inputs.hpp"
#include "tolerances.hpp"

#include "analysis/multi.hpp"

#include <fresnel/models.hpp>
#include <fresnel/types/dual.hpp>
#include <fresnel/types/interval.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fresnel::test {
namespace {

template <class X>
auto reflectance(const X& result) {
    if constexpr (requires { result.R_s; })
        return result.reflectance();
    else
        return result;
}

bool holds(const interval& x, const real50& truth) { return real50(x.lo) <= truth && truth <= real50(x.hi); }

/// A random interval of any size and sign.
interval draw(random_numbers& random) {
    const double a = random.signed_log_uniform(1e-3, 1e3);
    return interval::between(a, a + random.log_uniform(1e-9, 10));
}

double inside(const interval& x, random_numbers& random) {
    const double t = random.uniform(0, 1);
    return std::clamp(x.lo + t * (x.hi - x.lo), x.lo, x.hi);
}

TEST(interval, holds_every_result_of_its_operations) {
    random_numbers random(1);
    for (int i = 0; i < 20000; ++i) {
        const interval x = draw(random), y = draw(random), z = abs(x) + interval(1e-6);
        const real50 a = inside(x, random), b = inside(y, random), c = real50(inside(z, random));
        EXPECT_TRUE(holds(x + y, a + b));
        EXPECT_TRUE(holds(x - y, a - b));
        EXPECT_TRUE(holds(x * y, a * b));
        EXPECT_TRUE(holds(x / y, a / b));
        EXPECT_TRUE(holds(sqrt(z), sqrt(c)));
        EXPECT_TRUE(holds(log2(z), real50(log(c) / log(real50(2)))));
        EXPECT_TRUE(holds(pow(z, interval(2.5)), real50(pow(c, real50(2.5)))));
        EXPECT_TRUE(holds(exp2(interval::between(-3, 3) * interval(0.5)), real50(sqrt(real50(2)))));
        EXPECT_TRUE(holds(min(x, y), a < b ? a : b));
        EXPECT_TRUE(holds(abs(x), real50(abs(a))));
    }
}

TEST(interval, of_single_numbers_is_a_few_roundings_wide) {
    const interval third = interval(1) / interval(3);
    EXPECT_LT(third.width(), 2e-16);
    EXPECT_TRUE(holds(third, real50(1) / 3));
}

TEST(interval, divided_by_one_that_holds_0_is_everything) {
    const interval all = interval(1) / interval::between(-1, 1);
    EXPECT_EQ(all.lo, -interval_rounding::infinity);
    EXPECT_EQ(all.hi, interval_rounding::infinity);
}

TEST(interval, without_enclose_refuses_an_undecided_comparison) {
    const interval x = interval::between(0, 2), y = interval::between(1, 3);
    EXPECT_THROW((void)(x < y), std::logic_error);
    EXPECT_TRUE(interval(0.5) < interval(1));
}

TEST(enclose, runs_both_sides_of_an_undecided_comparison_and_keeps_them_together) {
    const interval x = interval::between(-0.5, 0.25);
    const auto guarded_root = [&] { // as the models write it
        return select(x < interval(0), interval(0), sqrt(select(x < interval(0), interval(1), x)));
    };
    const interval root = enclose(guarded_root);
    EXPECT_EQ(root.lo, 0);
    EXPECT_NEAR(root.hi, 0.5, 1e-15) << "not the 1 of the guard";
}

TEST(enclose, leaves_nothing_behind_when_the_function_throws) {
    EXPECT_THROW(enclose([]() -> interval { throw std::runtime_error("x"); }), std::runtime_error);
    EXPECT_EQ(interval_rounding::explorer::current(), nullptr);
}

/// Every model over boxes of several sizes holds the real value at points of the box.
template <std::size_t N, class F>
void scan(const model<N, F>& row) {
    random_numbers random(3);
    for (int i = 0; i < 300 / thinning; ++i) {
        const double size = random.log_uniform(1e-6, 0.2);
        std::array<interval, N> box;
        std::array<real50, N> point;
        for (std::size_t p = 0; p < N; ++p) {
            const parameter& q = row.parameters[p];
            const double lo = std::max(q.min, q.max > 10 ? 0.2 : 0.0), hi = std::min(q.max, 4.0);
            const double at = lo + (hi - lo) * random.uniform(0, 1) * 0.8;
            box[p] = interval::between(at, std::min(at + size * (hi - lo), hi));
            point[p] = inside(box[p], random);
        }
        const double at = random.one_in(10) ? 0 : random.uniform(0, 1);
        const interval c = interval::between(at, std::min(at + size, 1.0));
        const real50 truth = reflectance(evaluate(row, point, real50(inside(c, random))));
        const interval R = enclose([&] { return reflectance(evaluate(row, box, c)); });
        EXPECT_TRUE(holds(R, truth)) << row.name << " [" << R.lo << ", " << R.hi << "] " << digits(truth);
    }
}

TEST(enclose, holds_every_model_over_boxes) {
    for_each_model([](const auto& row) {
        if (row.name != "conductor_precise")
            scan(row); // its error terms are of roundings, which intervals have not
    });
}

TEST(enclose, shrinks_with_its_box) {
    const auto width = [](double size) {
        const interval eta = interval::between(1.5, 1.5 + size), c = interval::between(0.3, 0.3 + size);
        return enclose([&] { return dielectric(interval(1), eta, c).reflectance(); }).width();
    };
    EXPECT_LT(width(1e-3), 0.05);
    EXPECT_NEAR(width(1e-6) / width(1e-4), 0.01, 0.005);
}

TEST(enclose, of_a_dual_gives_slopes_that_hold) {
    using number = dual<interval, 1>;
    const interval c = interval::between(0.4, 0.41);
    interval slope;
    for_each_branch([&] { return schlick(number::constant(interval(0.04)), number::variable(c, 0)); },
                    [&](const number& one) { slope = one.d[0]; });
    for (const double at : {0.4, 0.405, 0.41})
        EXPECT_TRUE(slope.contains(-5 * 0.96 * std::pow(1 - at, 4))) << at;
}

} // namespace
} // namespace fresnel::test
