#include "inputs.hpp"
#include "oracles.hpp"
#include "tolerances.hpp"

#include <fresnel/slab.hpp>
#include <fresnel/types/strict.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <string>

namespace fresnel::test {
namespace {

constexpr double whole = 1e-15; // how far R + T may stray from 1
constexpr int points = 100000 / thinning;

/// A plate in its surroundings.
struct pane {
    double n_i, n_t, tau, cos_i;

    std::string text() const {
        return "n_i " + digits(n_i) + ", n_t " + digits(n_t) + ", tau " + digits(tau) + ", cos_i " +
               digits(cos_i);
    }
};

/// Anywhere in the domain: near an index match, thin and thick, grazing and not.
pane draw_pane(random_numbers& random) {
    const double n_i = random.log_uniform(0.01, 100);
    const double n_t =
        random.one_in(4) ? n_i * (1 + random.signed_log_uniform(1e-9, 0.1)) : random.log_uniform(0.001, 1000);
    return {n_i, n_t, random.log_uniform(1e-12, 1e3), any_cosine(random)};
}

/// A plate of ordinary index in a medium of index 1, so that n_t / n_i is not rounded; not total reflection.
pane draw_ordinary_pane(random_numbers& random) {
    const double cos_i = any_cosine(random);
    const double least = std::sqrt(1.01 - cos_i * cos_i); // where eta^2 - sin_i^2 is 0.01
    const bool inside = least < 0.98 && random.one_in(3);
    const double n_t = inside ? random.uniform(least, 0.99) : random.uniform(1.01, 4);
    return {1, n_t, random.log_uniform(1e-12, 20), cos_i};
}

// ---- the truth --------------------------------------------------------------------------------------------

/// The textbook sums at 60 digits, from boundaries that are themselves at 60 digits.
slab<real50> true_plate(const boundary<real50>& b, const real50& a) {
    const auto one = [&](const real50& R, const real50& T) {
        const real50 D = 1 - square(R * a);
        return power_split<real50>{R + T * T * a * a * R / D, T * T * a / D, T * (1 - a) / (1 - R * a)};
    };
    const power_split<real50> s = one(b.R_s, b.T_s), p = one(b.R_p, b.T_p);
    return {{s.reflected, p.reflected, s.transmitted, p.transmitted}, s.absorbed, p.absorbed};
}

slab<real50> true_window(const pane& x) {
    const real50 eta = real50(x.n_t) / x.n_i, c = x.cos_i;
    const real50 cos_t = sqrt(1 - (1 - c * c) / (eta * eta));
    return true_plate(oracle::truth(x.n_i, x.n_t, 0, c), exp(-x.tau / cos_t));
}

/// R_p within the reference tolerance of the truth, or of what Brewster's angle leaves of R_s: the last digits of
/// cos_i decide there.
testing::AssertionResult right_p(double R_p, const boundary<real50>& truth, const std::string& input) {
    const real50 scale = std::max(truth.R_p, real50(1e-6 * truth.R_s));
    return within(real50(R_p), truth.R_p, tolerance::reference * scale, input);
}

/// Every bounce by itself, until 400 crossings are done.
power_split<double> bounce(double R1, double T1, double R2, double T2, double a) {
    double reflected = R1, transmitted = 0, absorbed = 0, power = T1;
    for (int i = 0; i < 200; ++i) {
        absorbed += power * (1 - a), power *= a;
        transmitted += power * T2, power *= R2;
        absorbed += power * (1 - a), power *= a;
        reflected += power * T1, power *= R1;
    }
    return {reflected, transmitted, absorbed};
}

// ---- 1 - e^-x ---------------------------------------------------------------------------------------------

TEST(one_minus_exp, is_expm1_at_every_size) {
    random_numbers random(1768);
    for (int i = 0; i < points; ++i) {
        const double x = i < 10 ? 0.5 + (i - 5) * 1e-16 : random.log_uniform(1e-300, 1e3);
        ASSERT_TRUE(within_relative(one_minus_exp(x), -std::expm1(-x), 2e-15, digits(x)));
        const float f = static_cast<float>(random.log_uniform(1e-30, 80));
        ASSERT_TRUE(within_relative(one_minus_exp(f), -std::expm1(-f), 1e-6, digits(f)));
    }
}

TEST(one_minus_exp, is_0_at_0_and_1_at_infinity) {
    EXPECT_TRUE(exactly(one_minus_exp(0.0), 0.0, "0"));
    EXPECT_TRUE(exactly(one_minus_exp(std::numeric_limits<double>::infinity()), 1.0, "inf"));
    EXPECT_TRUE(std::isnan(one_minus_exp(std::nan(""))));
}

TEST(pass, lets_nothing_through_along_the_layer_unless_it_is_clear) {
    EXPECT_TRUE(exactly(pass(0.1, 0.0).passed, 0.0, "tau 0.1"));
    EXPECT_TRUE(exactly(pass(0.1, 0.0).absorbed, 1.0, "tau 0.1"));
    EXPECT_TRUE(exactly(pass(0.0, 0.0).passed, 1.0, "tau 0"));
    EXPECT_TRUE(exactly(pass(0.0, 0.0).absorbed, 0.0, "tau 0"));
    EXPECT_TRUE(std::isnan(pass(std::nan(""), 0.0).passed));
    EXPECT_TRUE(std::isnan(pass(std::nan(""), 0.0).absorbed));
}

// ---- clear ------------------------------------------------------------------------------------------------

TEST(window, reflects_twice_the_single_boundary_over_one_plus_it) {
    EXPECT_TRUE(same(window(1.0, 1.5, 1.0).reflectance(), 2 * 0.04 / 1.04, "glass at normal incidence"));
    EXPECT_TRUE(same(window(1.0, 1.5, 1.0).transmittance(), 0.96 / 1.04, "glass at normal incidence"));
    const boundary<double> face = dielectric(1.0, 1.5, 0.3), pane = window(1.0, 1.5, 0.3);
    EXPECT_TRUE(same(pane.R_s, 2 * face.R_s / (1 + face.R_s), "s"));
    EXPECT_TRUE(same(pane.R_p, 2 * face.R_p / (1 + face.R_p), "p"));
}

TEST(window, reflects_and_transmits_all_there_is) {
    random_numbers random(1862);
    for (int i = 0; i < points; ++i) {
        const pane x = draw_pane(random);
        const boundary<double> b = window(x.n_i, x.n_t, x.cos_i);
        ASSERT_TRUE(within(b.R_s + b.T_s, 1.0, whole, x.text()));
        ASSERT_TRUE(within(b.R_p + b.T_p, 1.0, whole, x.text()));
        ASSERT_TRUE(b.R_s >= 0 && b.R_s <= 1 && b.R_p >= 0 && b.R_p <= 1) << x.text();
        ASSERT_TRUE(b.T_s >= 0 && b.T_s <= 1 && b.T_p >= 0 && b.T_p <= 1) << x.text();
    }
}

TEST(window, is_right_against_50_digits) {
    random_numbers random(50);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const pane x = draw_ordinary_pane(random);
        const boundary<double> got = window(x.n_i, x.n_t, x.cos_i);
        const slab<real50> truth = true_plate(oracle::truth(x.n_i, x.n_t, 0, x.cos_i), 1);
        ASSERT_TRUE(within_relative(real50(got.R_s), truth.R_s, tolerance::reference, x.text()));
        ASSERT_TRUE(right_p(got.R_p, truth, x.text()));
        ASSERT_TRUE(within_relative(real50(got.T_s), truth.T_s, tolerance::reference, x.text()));
        ASSERT_TRUE(within_relative(real50(got.T_p), truth.T_p, tolerance::reference, x.text()));
    }
}

TEST(window, reflects_all_at_grazing_incidence_and_nothing_without_a_boundary) {
    for (const double n_t : {0.7, 1.0001, 1.5, 4.0}) {
        EXPECT_TRUE(exactly(window(1.0, n_t, 0.0).reflectance(), 1.0, digits(n_t)));
        EXPECT_TRUE(exactly(window(1.0, n_t, 0.0).transmittance(), 0.0, digits(n_t)));
    }
    for (const double c : {0.0, 1e-9, 0.5, 1.0}) {
        EXPECT_TRUE(exactly(window(1.3, 1.3, c).reflectance(), 0.0, digits(c)));
        EXPECT_TRUE(exactly(window(1.3, 1.3, c).transmittance(), 1.0, digits(c)));
    }
}

TEST(window, is_shut_beyond_the_critical_angle) {
    for (const double c : {0.1, 0.5, 0.7}) { // an air gap in glass: critical at cos_i = 0.745
        EXPECT_TRUE(exactly(window(1.5, 1.0, c).reflectance(), 1.0, digits(c)));
        EXPECT_TRUE(exactly(window(1.5, 1.0, c).transmittance(), 0.0, digits(c)));
        const slab<double> tinted = window_absorbing(1.5, 1.0, 0.3, c);
        EXPECT_TRUE(exactly(tinted.reflectance(), 1.0, digits(c)));
        EXPECT_TRUE(exactly(tinted.absorptance(), 0.0, digits(c)));
        EXPECT_TRUE(exactly(window_absorbing(1.5, 1.0, 0.0, c).reflectance(), 1.0, digits(c)));
    }
}

TEST(window, shows_no_p_reflection_at_brewsters_angle) {
    const double brewster = 1 / std::sqrt(1 + 1.5 * 1.5);
    EXPECT_LT(window(1.0, 1.5, brewster).R_p, 1e-30);
    EXPECT_TRUE(same(window(1.0, 1.5, brewster).T_p, 1.0, "Brewster"));
}

// ---- absorbing --------------------------------------------------------------------------------------------

TEST(window_absorbing, reflects_transmits_and_absorbs_all_there_is) {
    random_numbers random(1852);
    for (int i = 0; i < points; ++i) {
        const pane x = draw_pane(random);
        const slab<double> b = window_absorbing(x.n_i, x.n_t, x.tau, x.cos_i);
        ASSERT_TRUE(within(b.R_s + b.T_s + b.A_s, 1.0, whole, x.text()));
        ASSERT_TRUE(within(b.R_p + b.T_p + b.A_p, 1.0, whole, x.text()));
        ASSERT_TRUE(b.A_s >= 0 && b.A_s <= 1 && b.A_p >= 0 && b.A_p <= 1) << x.text();
        ASSERT_TRUE(b.T_s >= 0 && b.T_s <= 1 && b.R_s >= 0 && b.R_s <= 1) << x.text();
    }
}

TEST(window_absorbing, is_right_against_50_digits) {
    random_numbers random(51);
    double worst = 0;
    for (int i = 0; i < 20000 / thinning; ++i) {
        const pane x = draw_ordinary_pane(random);
        const slab<double> got = window_absorbing(x.n_i, x.n_t, x.tau, x.cos_i);
        const slab<real50> truth = true_window(x);
        const auto check = [&](double value, const real50& expected) {
            EXPECT_TRUE(within_relative(real50(value), expected, tolerance::reference, x.text()));
            worst = std::fmax(worst, static_cast<double>(abs(value / expected - 1)));
        };
        check(got.R_s, truth.R_s);
        EXPECT_TRUE(right_p(got.R_p, truth, x.text()));
        check(got.A_s, truth.A_s), check(got.A_p, truth.A_p);
        if (truth.T_s > 1e-40) check(got.T_s, truth.T_s), check(got.T_p, truth.T_p);
        if (HasFailure()) return;
    }
    std::printf("window_absorbing: relative error in float64 %.1e\n", worst);
}

TEST(window_absorbing, is_the_sum_of_its_bounces) {
    random_numbers random(200);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const pane x = {random.uniform(1, 1.5), random.uniform(1.55, 3), random.log_uniform(1e-6, 10),
                        random.uniform(0.15, 1)};
        const boundary<double> face = dielectric(x.n_i, x.n_t, x.cos_i);
        const double a = std::exp(-x.tau / refracted_cosine(x.n_t / x.n_i, x.cos_i));
        const slab<double> got = window_absorbing(x.n_i, x.n_t, x.tau, x.cos_i);
        const power_split<double> s = bounce(face.R_s, face.T_s, face.R_s, face.T_s, a);
        const power_split<double> p = bounce(face.R_p, face.T_p, face.R_p, face.T_p, a);
        ASSERT_TRUE(within(got.R_s, s.reflected, 1e-14, x.text()));
        ASSERT_TRUE(within(got.T_s, s.transmitted, 1e-14, x.text()));
        ASSERT_TRUE(within(got.A_s, s.absorbed, 1e-14, x.text()));
        ASSERT_TRUE(within(got.R_p, p.reflected, 1e-14, x.text()));
        ASSERT_TRUE(within(got.T_p, p.transmitted, 1e-14, x.text()));
        ASSERT_TRUE(within(got.A_p, p.absorbed, 1e-14, x.text()));
    }
}

TEST(window_absorbing, is_the_clear_window_at_zero_depth_and_the_single_boundary_at_infinite_depth) {
    for (const double c : {0.0, 0.05, 0.5, 1.0}) {
        const boundary<double> clear = window(1.0, 1.5, c), face = dielectric(1.0, 1.5, c);
        const slab<double> thin = window_absorbing(1.0, 1.5, 0.0, c);
        const slab<double> thick = window_absorbing(1.0, 1.5, std::numeric_limits<double>::infinity(), c);
        EXPECT_TRUE(same(thin.R_s, clear.R_s, digits(c)));
        EXPECT_TRUE(same(thin.T_p, clear.T_p, digits(c)));
        EXPECT_TRUE(exactly(thin.absorptance(), 0.0, digits(c)));
        EXPECT_TRUE(same(thick.R_s, face.R_s, digits(c)));
        EXPECT_TRUE(exactly(thick.transmittance(), 0.0, digits(c)));
        EXPECT_TRUE(same(thick.A_p, face.T_p, digits(c)));
    }
}

TEST(window_absorbing, is_beers_law_without_a_boundary) {
    EXPECT_TRUE(same(window_absorbing(1.0, 1.0, 0.7, 0.5).transmittance(), std::exp(-1.4), "0.7 at 60"));
    EXPECT_TRUE(exactly(window_absorbing(1.0, 1.0, 0.7, 0.0).transmittance(), 0.0, "0.7 at 90"));
    EXPECT_TRUE(exactly(window_absorbing(1.0, 1.0, 0.7, 0.0).absorptance(), 1.0, "0.7 at 90"));
    EXPECT_TRUE(exactly(window_absorbing(1.0, 1.0, 0.0, 0.0).transmittance(), 1.0, "clear at 90"));
}

// ---- any two boundaries -----------------------------------------------------------------------------------

TEST(plate, is_the_sum_of_its_bounces_between_unequal_boundaries) {
    random_numbers random(1849);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const double c = random.uniform(0.15, 1), a = random.uniform(0, 1);
        const boundary<double> front = dielectric(1.0, 1.5, c);
        const boundary<double> back = conductor(1.5, 0.2, 3.9, refracted_cosine(1.5, c)); // a mirror
        const slab<double> got = plate(front, back, a);
        const power_split<double> s = bounce(front.R_s, front.T_s, back.R_s, back.T_s, a);
        ASSERT_TRUE(within(got.R_s, s.reflected, 1e-14, digits(c)));
        ASSERT_TRUE(within(got.T_s, s.transmitted, 1e-14, digits(c)));
        ASSERT_TRUE(within(got.A_s, s.absorbed, 1e-14, digits(c)));
    }
}

TEST(plate, of_clear_equal_faces_is_the_window) {
    for (const double c : {0.0, 1e-6, 0.2, 0.9, 1.0}) {
        const boundary<double> face = dielectric(1.0, 1.7, c), clear = window(1.0, 1.7, c);
        const slab<double> got = plate(face, face, 1.0);
        EXPECT_TRUE(same(got.R_s, clear.R_s, digits(c)));
        EXPECT_TRUE(same(got.R_p, clear.R_p, digits(c)));
        EXPECT_TRUE(same(got.T_s, clear.T_s, digits(c)));
        EXPECT_TRUE(exactly(got.absorptance(), 0.0, digits(c)));
    }
}

TEST(plate, transmits_the_same_from_either_side) {
    for (const double c : {0.1, 0.4, 1.0}) {
        const boundary<double> air = dielectric(1.0, 1.5, c);
        const boundary<double> water = dielectric(1.5, 1.33, refracted_cosine(1.5, c));
        const slab<double> down = plate(air, water, 0.6), up = plate(water, air, 0.6);
        EXPECT_TRUE(same(down.T_s, up.T_s, digits(c)));
        EXPECT_TRUE(same(down.T_p, up.T_p, digits(c)));
    }
}

TEST(plate, between_two_mirrors_reflects_all_and_an_opaque_one_absorbs_what_enters) {
    const boundary<double> shut = {1, 1, 0, 0}, face = {0.1, 0.2, 0.9, 0.8};
    EXPECT_TRUE(exactly(plate(shut, shut, 1.0).reflectance(), 1.0, "mirrors"));
    EXPECT_TRUE(exactly(plate(shut, shut, 1.0).transmittance(), 0.0, "mirrors"));
    EXPECT_TRUE(exactly(plate(face, shut, 0.0).R_s, 0.1, "opaque"));
    EXPECT_TRUE(exactly(plate(face, shut, 0.0).A_p, 0.8, "opaque"));
    EXPECT_TRUE(exactly(plate(face, shut, 1.0).R_s, 1.0, "clear before a mirror"));
}

// ---- every number type ------------------------------------------------------------------------------------

TEST(slab, passes_a_nan_on_from_any_argument) {
    const double nan = std::nan("");
    for (const slab<double>& b : {window_absorbing(nan, 1.5, 0.1, 0.5), window_absorbing(1.0, nan, 0.1, 0.5),
                                  window_absorbing(1.0, 1.5, nan, 0.5), window_absorbing(1.0, 1.5, 0.1, nan)})
        EXPECT_TRUE(std::isnan(b.reflectance()) && std::isnan(b.transmittance()) &&
                    std::isnan(b.absorptance()));
    for (const boundary<double>& b : {window(nan, 1.5, 0.5), window(1.0, nan, 0.5), window(1.0, 1.5, nan)})
        EXPECT_TRUE(std::isnan(b.reflectance()) && std::isnan(b.transmittance()));
    const boundary<double> face = dielectric(1.0, 1.5, 0.5), lost = {nan, nan, nan, nan};
    EXPECT_TRUE(std::isnan(plate(face, lost, 0.5).reflectance()));
    EXPECT_TRUE(std::isnan(plate(lost, face, 0.5).reflectance()));
    EXPECT_TRUE(std::isnan(plate(face, face, nan).transmittance()));
}

TEST(slab, holds_in_float) {
    random_numbers random(24);
    for (int i = 0; i < points; ++i) {
        const pane x = draw_ordinary_pane(random);
        const float n_t = static_cast<float>(x.n_t), tau = static_cast<float>(x.tau),
                    c = static_cast<float>(x.cos_i);
        const slab<float> b = window_absorbing(1.0f, n_t, tau, c);
        ASSERT_TRUE(within(b.R_s + b.T_s + b.A_s, 1.0f, 1e-6f, x.text()));
        ASSERT_TRUE(within(b.R_p + b.T_p + b.A_p, 1.0f, 1e-6f, x.text()));
    }
}

TEST(slab, is_made_of_models_and_instantiates_with_strict) {
    const strict one = 1, n = ratio<strict, 3, 2>(), tau = ratio<strict, 1, 10>(), c = ratio<strict, 1, 2>();
    EXPECT_TRUE(exactly(window(one, n, c).R_s.value(), window(1.0, 1.5, 0.5).R_s, "window"));
    EXPECT_TRUE(exactly(window_absorbing(one, n, tau, c).A_p.value(),
                        window_absorbing(1.0, 1.5, 0.1, 0.5).A_p, "window_absorbing"));
    const boundary<strict> face = dielectric(one, n, c);
    const boundary<double> same_face = dielectric(1.0, 1.5, 0.5);
    EXPECT_TRUE(exactly(plate(face, face, tau).T_s.value(), plate(same_face, same_face, 0.1).T_s, "plate"));
}

} // namespace
} // namespace fresnel::test
