// Every model of the registry, differentiated by itself, against central differences at 60 digits.

#include "inputs.hpp"
#include "tolerances.hpp"

#include "analysis/multi.hpp"

#include <fresnel/types/interval.hpp> // before dual.hpp, which asks whether its numbers overlap

#include <fresnel/average.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/models.hpp>
#include <fresnel/slab.hpp>
#include <fresnel/types/dual.hpp>
#include <fresnel/types/rounding.hpp>
#include <fresnel/types/simd.hpp>
#include <fresnel/types/sym.hpp>
#include <fresnel/types/wide.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <type_traits>

namespace fresnel::test {
namespace {

/// An int makes one by itself; a double, which would be cut to an int, does not.
template <class T>
constexpr bool integers_only =
    std::is_convertible_v<int, T> && !std::is_convertible_v<double, T> && !std::is_convertible_v<float, T>;
static_assert(integers_only<dual<double, 1>> && integers_only<dual<interval, 2>>);
static_assert(integers_only<interval> && integers_only<rounding> && integers_only<sym>);
static_assert(integers_only<batch<float, 4>> && integers_only<wide<batch<float, 4>, 2>>);

/// A value of a parameter where renderers have it, away from the kinks that clamps make where a reflectance is 1 everywhere.
double draw(const parameter& p, random_numbers& random) {
    const std::string_view name = p.name;
    if (name == "n_i") return random.one_in(2) ? 1 : random.log_uniform(0.7, 2);
    if (name == "n_t" || name == "n") return random.log_uniform(0.1, 5);
    if (name == "k_t" || name == "k") return random.one_in(5) ? 0 : random.log_uniform(1e-3, 10);
    if (name == "eta") return random.uniform(0.1, 1);
    if (name == "power" || name == "alpha") return random.log_uniform(2, 30);
    if (name == "a") return random.uniform(0, 5);
    if (name == "g") return random.one_in(10) ? (random.one_in(2) ? 0.0 : 1.0) : random.uniform(0, 1);
    return random.uniform(0.001, 0.99);
}

/// A value anywhere in a parameter's range, and at its ends.
double draw_anywhere(const parameter& p, random_numbers& random) {
    if (random.one_in(20)) return random.one_in(2) ? p.min : p.max;
    return random.one_in(2) ? draw(p, random) : random.log_uniform(std::max(p.min, 1e-6 * p.max), p.max);
}

/// (f(x + h) - f(x - h)) / 2h at 60 digits; one-sided and of second order at the ends of the range.
template <class F>
double difference(F f, const real50& x, double lo, double hi) {
    const real50 h("1e-18");
    if (x <= lo) return static_cast<double>(real50((4 * f(x + h) - 3 * f(x) - f(x + 2 * h)) / (2 * h)));
    if (x >= hi) return static_cast<double>(real50((3 * f(x) - 4 * f(x - h) + f(x - 2 * h)) / (2 * h)));
    return static_cast<double>(real50((f(x + h) - f(x - h)) / (2 * h)));
}

/// R, then R_s, R_p, T_s and T_p of exact models.
template <class T>
T part_of(const boundary<T>& result, std::size_t part) {
    return part == 0   ? result.reflectance()
           : part == 1 ? result.R_s
           : part == 2 ? result.R_p
           : part == 3 ? result.T_s
                       : result.T_p;
}
template <class T>
T part_of(const T& result, std::size_t) {
    return result;
}

/// Where dual.hpp says that derivatives are infinite, lost or a kink's.
template <std::size_t N, class F>
bool is_excepted(const model<N, F>& row, const std::array<double, N>& p, std::size_t by, double c) {
    if (row.name == "powers_3_6_9") return by == 0 && p[0] < 1e-5;  // sqrt f0
    if (row.name == "gulbrandsen") return p[0] < 1e-5;              // r = 0
    if (row.name == "schlick_internal") return c == 0 && p[0] == 1; // an index match
    for (std::size_t i = 0; i < N; ++i)                             // x^power at x = 0
        if (row.parameters[i].name == "power" || row.parameters[i].name == "alpha")
            return c == 1 && by == N && p[i] < 1.5;
    return false;
}

/// Compares every derivative of a model, of each of its results, at random inputs with differences at 60 digits: off by
/// `allowed` at most, times 1 + |derivative|.
template <std::size_t N, class F, class Draw>
void scan(const model<N, F>& row, double allowed, Draw draw_one) {
    using number = dual<double, static_cast<int>(N) + 1>;
    random_numbers random(2024);
    const bool exact = row.kind == model_kind::exact;
    for (int trial = 0; trial < 3000 / thinning; ++trial) {
        std::array<double, N> p{};
        for (std::size_t i = 0; i < N; ++i)
            p[i] = draw_one(row.parameters[i], random);
        if constexpr (N >= 2)
            if (exact && random.one_in(7) && row.name != "dielectric_fast") p[1] = p[0]; // an index match
        bool grazing = random.one_in(13);
        if constexpr (N >= 2)
            grazing = grazing && !(exact && p[0] == p[1]); // equal media have no slope there
        const double c = grazing ? 0 : random.one_in(17) ? 1 : random.uniform(1e-3, 1);
        if (row.name == "conductor_fast" && p[N - 1] == 0)
            continue; // loses k at k = 0 beyond the critical angle

        std::array<number, N> x;
        for (std::size_t i = 0; i < N; ++i)
            x[i] = number::variable(p[i], static_cast<int>(i));
        const auto result = evaluate(row, x, number::variable(c, static_cast<int>(N)));
        const auto plain = evaluate(row, p, c);
        for (std::size_t part = 0; part < (exact ? 5 : 1); ++part)
            for (std::size_t v = 0; v <= N; ++v) {
                if (is_excepted(row, p, v, c)) continue;
                const auto f = [&](const real50& at) {
                    std::array<real50, N> y;
                    for (std::size_t i = 0; i < N; ++i)
                        y[i] = i == v ? at : real50(p[i]);
                    return real50(part_of(evaluate(row, y, v == N ? at : real50(c)), part));
                };
                if (const real50 near = v == N && c == 0 ? f(real50("1e-18")) : real50(2);
                    near == 0 || near == 1)
                    continue; // a clamp ends here, a kink
                const double truth = v == N
                                         ? difference(f, c, 0, 1)
                                         : difference(f, p[v], row.parameters[v].min, row.parameters[v].max);
                std::string input = fmt::format("{} part {} by {}, cos_i {}", row.name, part, v, digits(c));
                for (const double value : p)
                    input += ", " + digits(value);
                const number R = part_of(result, part);
                EXPECT_EQ(R.value, part_of(plain, part)) << input << ": the value is the model's";
                ASSERT_TRUE(within(R.d[v], truth, allowed * (1 + std::abs(truth)), input));
            }
    }
}

TEST(dual, differentiates_every_model_as_60_digits_do) {
    for_each_model([](const auto& row) { scan(row, 1e-9, draw); });
}

TEST(dual, differentiates_over_the_whole_domain) {
    for_each_model([](const auto& row) {
        if (!row.name.ends_with("_fast"))
            scan(row, 1e-6, draw_anywhere); // those lose their digits at its ends
    });
}

TEST(dual, keeps_the_slope_at_grazing_incidence_and_at_an_index_match) {
    using number = dual<double, 2>;
    const auto slope = [](double eta, double c) {
        return dielectric(number(1), number::variable(eta, 0), number::variable(c, 1)).reflectance();
    };
    // -2 (1 + eta^2) / sqrt(eta^2 - 1)
    EXPECT_NEAR(slope(1.5, 0).d[1], -2 * 3.25 / std::sqrt(1.25), 1e-13);
    EXPECT_NEAR(slope(4.0 / 3, 0).d[1], -2 * (1 + 16.0 / 9) / std::sqrt(7.0 / 9), 1e-12);
    EXPECT_EQ(slope(1.0, 0.5).d[0], 0);
    EXPECT_EQ(slope(1.0, 0.0).value, 0);
    EXPECT_NEAR(slope(0.5, 0.3).d[1], 0, 1e-60) << "total internal reflection";
}

TEST(dual, is_right_where_re_q2_is_exactly_0) {
    // n = k straight on, and n_t = n_i with k = cos_i: |Re q^2| and the choice between Re q and Im q both turn here
    for (const std::array<double, 3>& at :
         {std::array{3.0, 3.0, 1.0}, {0.5, 0.5, 1.0}, {0.25, 0.25, 1.0}, {1.0, 0.125, 0.125}}) {
        const double n = at[0], k = at[1], c = at[2];
        const auto check = [&](const auto& model, const std::string& name) {
            using d = dual<double, 2>;
            const d found = model(d::variable(n, 0), d::variable(k, 1), d::constant(c));
            const auto by_n = [&](const real50& x) { return model(x, real50(k), real50(c)); };
            const auto by_k = [&](const real50& x) { return model(real50(n), x, real50(c)); };
            EXPECT_NEAR(found.d[0], difference(by_n, real50(n), 0, 1000), 1e-12) << name << " " << n;
            EXPECT_NEAR(found.d[1], difference(by_k, real50(k), 0, 1000), 1e-12) << name << " " << n;
        };
        check([](auto x, auto y, auto z) { return conductor(decltype(x)(1), x, y, z).reflectance(); },
              "conductor");
        check([](auto x, auto y, auto z) { return conductor(decltype(x)(1), x, y, z).T_p; }, "T_p");
        check([](auto x, auto y, auto z) { return conductor_fast(decltype(x)(1), x, y, z).reflectance(); },
              "fast");
        check([](auto x, auto y, auto z) { return conductor_precise(decltype(x)(1), x, y, z).reflectance(); },
              "precise");
        check([](auto x, auto y, auto z) { return norm(boundary_amplitudes(decltype(x)(1), x, y, z).r_p); },
              "r_p");
    }
}

TEST(dual, of_an_average_at_an_index_match_is_that_of_one_side) {
    const auto slope = [](double eta) { return dielectric_average(dual<double, 1>::variable(eta, 0)).d[0]; };
    EXPECT_NEAR(slope(1), slope(1 - 1e-9), 1e-6);
}

TEST(dual, of_a_clear_plate_at_grazing_incidence_is_that_of_the_window) {
    using d = dual<double, 1>;
    const d c = d::variable(0, 0);
    const boundary<d> clear = window(d(1), d(3) / 2, c);
    const slab<d> absorbing = window_absorbing(d(1), d(3) / 2, d(0), c);
    EXPECT_NEAR(absorbing.R_s.d[0], clear.R_s.d[0], 1e-14);
    EXPECT_NEAR(absorbing.R_p.d[0], clear.R_p.d[0], 1e-14);
    EXPECT_NEAR(absorbing.T_s.d[0], clear.T_s.d[0], 1e-14);
    EXPECT_NEAR(absorbing.T_p.d[0], clear.T_p.d[0], 1e-14);
    EXPECT_NEAR(clear.R_s.d[0], -1.788854, 1e-6);
}

TEST(dual, of_total_internal_reflection_is_0_on_its_side_and_finite_on_the_other) {
    using number = dual<double, 1>;
    const double critical = critical_cosine(1 / 1.5);
    for (const double step : {1e-12, 1e-6, 1e-3}) {
        const number inside =
            dielectric(number(1), number::constant(1 / 1.5), number::variable(critical - step, 0)).R_s;
        const number outside =
            dielectric(number(1), number::constant(1 / 1.5), number::variable(critical + step, 0)).R_s;
        EXPECT_NEAR(inside.d[0], 0, 1e-60);
        EXPECT_LT(outside.d[0], -1);
        EXPECT_TRUE(std::isfinite(outside.d[0]));
    }
}

TEST(dual, obeys_the_rules_of_differentiation) {
    using number = dual<double, 2>;
    const number x = number::variable(1.7, 0), y = number::variable(0.6, 1);
    EXPECT_NEAR((x * y).d[0], 0.6, 1e-16);
    EXPECT_NEAR((x / y).d[1], -1.7 / 0.36, 1e-14);
    EXPECT_NEAR(sqrt(x).d[0], 0.5 / std::sqrt(1.7), 1e-15);
    EXPECT_NEAR(exp2(x).d[0], std::exp2(1.7) * std::log(2.0), 1e-14);
    EXPECT_NEAR(log2(x).d[0], 1 / (1.7 * std::log(2.0)), 1e-15);
    EXPECT_NEAR(log(y).d[1], 1 / 0.6, 1e-15);
    EXPECT_NEAR(pow(x, y).d[0], 0.6 * std::pow(1.7, -0.4), 1e-15);
    EXPECT_NEAR(pow(x, y).d[1], std::pow(1.7, 0.6) * std::log(1.7), 1e-15);
    EXPECT_EQ(max(x, y).d, x.d);
    EXPECT_EQ(min(x, y).d, y.d);
    EXPECT_EQ(abs(-x).d, x.d);
    EXPECT_EQ(sqrt(number(0)).d[0], 0) << "the root of a constant";
    EXPECT_EQ(pow(number(0), y).d[1], 0);
}

TEST(dual, of_nothing_times_an_infinite_slope_is_0) {
    using number = dual<double, 1>;
    const number c = number::variable(1, 0);
    const auto fixed = [](double x) { return number::constant(x); };
    EXPECT_EQ(schlick_power(fixed(0.5), fixed(0.5), fixed(0.5), c).d[0], 0);
    EXPECT_TRUE(std::isfinite(lazanyi(fixed(2), fixed(3), fixed(0), fixed(0.5), c).d[0]));
    EXPECT_EQ(bias_scale_power(fixed(0.5), fixed(0), fixed(0.5), c).d[0], 0);
    EXPECT_TRUE(std::isinf(schlick_power(fixed(0.2), fixed(0.5), fixed(0.5), c).d[0])) << "a true one";
    EXPECT_EQ((fixed(0) / (1 + sqrt(c))).d[0], 0);
    EXPECT_EQ(pow(c, fixed(0)).d[0], 0);
}

TEST(dual, works_in_float_and_in_60_digits) {
    using narrow = dual<float, 1>;
    using wide = dual<real50, 1>;
    const float in_float =
        conductor(narrow(1), narrow::constant(0.2f), narrow::constant(3.5f), narrow::variable(0.3f, 0))
            .reflectance()
            .d[0];
    const real50 in_60 =
        conductor(wide(1), wide::constant(0.2f), wide::constant(3.5f), wide::variable(real50(0.3f), 0))
            .reflectance()
            .d[0];
    EXPECT_NEAR(static_cast<double>(in_float), static_cast<double>(in_60), 2e-6);
}

} // namespace
} // namespace fresnel::test
