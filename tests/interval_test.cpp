#include "inputs.hpp"
#include "tolerances.hpp"

#include "analysis/conductor_enclosure.hpp"
#include "analysis/multi.hpp"

#include <fresnel/models.hpp>
#include <fresnel/types/dual.hpp>
#include <fresnel/types/interval.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fresnel::test {
namespace {

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

TEST(interval, knows_no_number_below_0_beside_0_itself) {
    for (const interval& x :
         {interval::between(-0.0, 4), -interval::between(-4, 0), max(-interval(0), interval(0))})
        EXPECT_EQ(pow(x, interval(-1)).hi, interval_rounding::infinity) << x.lo << " " << x.hi;
}

TEST(interval, of_infinities_that_cancel_is_everything) {
    const interval endless(interval_rounding::infinity), all = endless - endless;
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

TEST(enclose, tells_quantities_of_equal_bounds_apart) {
    const auto step = [](const interval& x) { return select(x < 0, interval(0), interval(1)); };
    const interval x = interval::between(-1, 1), y = interval::between(-1, 1);
    const interval between_two = enclose([&] { return step(x) - step(y); });
    EXPECT_LE(between_two.lo, -1);
    EXPECT_GE(between_two.hi, 1);
    const interval opposite = enclose([&] { return step(x) - step(-x); });
    EXPECT_LE(opposite.lo, -1);
    EXPECT_GE(opposite.hi, 1);
    const interval copy = x;
    EXPECT_LT(enclose([&] { return step(x) - step(copy); }).magnitude(), 1e-300);
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

// ---- the conductor over boxes -----------------------------------------------------------------------------

/// A random box of n, k and cos_i, of any size, as in `fresnel prove`; one in four touches cos_i = 0.
std::array<interval, 3> draw_box(random_numbers& random) {
    const double n = random.uniform(0.1, 4), k = random.uniform(1, 8), size = random.log_uniform(1e-6, 1);
    const double c = random.one_in(4) ? 0 : random.uniform(0, 1);
    return {interval::between(n, n + size), interval::between(k, k + size),
            interval::between(c, std::min(c + size, 1.0))};
}

TEST(conductor_over, holds_the_values_and_the_slopes_of_conductor) {
    using number = dual<interval, 3>;
    using real = dual<real50, 3>;
    random_numbers random(5);
    for (int i = 0; i < 3000 / thinning; ++i) {
        std::array<number, 3> x;
        std::array<real, 3> at;
        const std::array<interval, 3> box = draw_box(random);
        for (int p = 0; p < 3; ++p) {
            const auto j = static_cast<std::size_t>(p);
            x[j] = number::variable(box[j], p);
            at[j] = real::variable(real50(inside(box[j], random)), p);
        }
        const real truth = conductor(real(1), at[0], at[1], at[2]).reflectance();
        const number over = conductor_over(x[0], x[1], x[2]);
        EXPECT_TRUE(holds(over.value, truth.value)) << digits(truth.value);
        EXPECT_TRUE(holds(conductor_over(box[0], box[1], box[2]), truth.value)) << digits(truth.value);
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_TRUE(holds(over.d[j], truth.d[j])) << "slope " << j << " " << digits(truth.d[j]);
    }
}

TEST(conductor_over, of_single_numbers_is_as_narrow_as_conductor_and_overlaps_it) {
    random_numbers random(6);
    for (int i = 0; i < 3000 / thinning; ++i) {
        const interval n(random.uniform(0.1, 4)), k(random.uniform(1, 8)), c(random.uniform(0, 1));
        const interval R = conductor_over(n, k, c);
        const interval same = enclose([&] { return conductor(interval(1), n, k, c).reflectance(); });
        EXPECT_LT(R.width(), 1e-13);
        EXPECT_TRUE(overlap(R, same));
    }
}

TEST(root_over, has_exact_ranges) {
    random_numbers random(7);
    for (int i = 0; i < 3000 / thinning; ++i) {
        const auto [n, k, c] = draw_box(random);
        const complex_root<interval> q = root_over(n, k, c);
        const auto least = refract_complex(1.0, n.lo, k.lo, c.lo),
                   most = refract_complex(1.0, n.hi, k.hi, c.hi);
        EXPECT_NEAR(q.a.lo, least.a, 1e-13);
        EXPECT_NEAR(q.a.hi, most.a, 1e-13);
        for (int j = 0; j < 10; ++j) {
            const auto inner = refract_complex(real50(1), real50(inside(n, random)),
                                               real50(inside(k, random)), real50(inside(c, random)));
            EXPECT_TRUE(holds(q.a, inner.a));
            EXPECT_TRUE(holds(q.b, inner.b));
        }
    }
}

} // namespace
} // namespace fresnel::test
