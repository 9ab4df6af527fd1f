#include "inputs.hpp"
#include "tolerances.hpp"

#include "analysis/multi.hpp"

#include <fresnel/geometry.hpp>
#include <fresnel/types/strict.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace fresnel::test {
namespace {

using vector = vector3<double>;

double length(vector v) { return std::sqrt(dot(v, v)); }

vector unit(random_numbers& random) {
    for (;;) {
        const vector v{random.uniform(-1, 1), random.uniform(-1, 1), random.uniform(-1, 1)};
        if (length(v) > 0.1 && length(v) < 1) return (1 / length(v)) * v;
    }
}

/// A normal and a direction on its side.
struct pair {
    vector n, v;
};

pair facing(random_numbers& random) {
    const vector n = unit(random), v = unit(random);
    return dot(n, v) < 0 ? pair{n, -1.0 * v} : pair{n, v};
}

TEST(geometry, reflect_keeps_the_angle_the_plane_and_the_length) {
    random_numbers random(1);
    for (int i = 0; i < 1000; ++i) {
        const auto [n, v] = facing(random);
        const vector r = reflect(v, n);
        EXPECT_NEAR(dot(n, r), dot(n, v), 4e-15);
        EXPECT_NEAR(length(r), 1, 4e-15);
        EXPECT_NEAR(length(r + v - (2 * dot(n, v)) * n), 0, 4e-15);
        EXPECT_NEAR(length(reflect(r, n) - v), 0, 4e-15);
    }
}

TEST(geometry, refract_obeys_snells_law_on_the_other_side) {
    random_numbers random(2);
    for (int i = 0; i < 2000; ++i) {
        const auto [n, v] = facing(random);
        const double eta = random.log_uniform(0.3, 4), sin_t2 = (1 - dot(n, v) * dot(n, v)) / (eta * eta);
        const vector t = refract(v, n, eta);
        if (sin_t2 > 1) {
            EXPECT_EQ(length(t), 0) << "beyond the critical angle there is no direction";
            continue;
        }
        EXPECT_NEAR(length(t), 1, 1e-14);
        EXPECT_NEAR(dot(n, t), -std::sqrt(1 - sin_t2), 1e-7) << eta; // a root near the critical angle
        const vector across = t - dot(n, t) * n, before = v - dot(n, v) * n;
        EXPECT_NEAR(length(eta * across + before), 0, 1e-14) << "same plane, opposite sides";
    }
}

TEST(geometry, refract_goes_straight_on_between_equal_media) {
    random_numbers random(3);
    for (int i = 0; i < 100; ++i) {
        const auto [n, v] = facing(random);
        EXPECT_NEAR(length(refract(v, n, 1.0) + v), 0, 1e-15);
    }
}

TEST(geometry, refract_at_the_critical_angle_is_along_the_surface) {
    const vector n{0, 1, 0}, v{0.8, 0.6, 0};
    const vector t = refract(v, n, 0.8);
    EXPECT_NEAR(t.x, -1, 1e-15);
    EXPECT_NEAR(t.y, 0, 1e-7);
}

TEST(geometry, complex_refracted_cosine_obeys_snells_law_in_complex_numbers) {
    random_numbers random(4);
    for (int i = 0; i < 2000; ++i) {
        const double n_i = random.uniform(1, 2), n_t = random.log_uniform(0.05, 10),
                     k_t = random.log_uniform(1e-3, 10), c = random.uniform(0, 1);
        const complex<double> cos_t = complex_refracted_cosine(n_i, n_t, k_t, c), m{n_t / n_i, k_t / n_i};
        const complex<double> sin_t2 = complex<double>{1, 0} - cos_t * cos_t, s2 = m * m * sin_t2;
        EXPECT_NEAR(s2.re, 1 - c * c, 1e-12 * norm(m));
        EXPECT_NEAR(s2.im, 0, 1e-12 * norm(m));
        EXPECT_GE((m * cos_t).im, 0) << "the wave decays";
    }
}

TEST(geometry, complex_refracted_cosine_without_absorption_is_real_or_imaginary) {
    EXPECT_NEAR(complex_refracted_cosine(1.0, 1.5, 0.0, 0.5).re, refracted_cosine(1.5, 0.5), 1e-15);
    EXPECT_EQ(complex_refracted_cosine(1.0, 1.5, 0.0, 0.5).im, 0);
    EXPECT_EQ(complex_refracted_cosine(1.5, 1.0, 0.0, 0.5).re, 0);
    EXPECT_GT(complex_refracted_cosine(1.5, 1.0, 0.0, 0.5).im, 0);
    EXPECT_NEAR(phase_cosine(1.0, 1.5, 0.0, 0.5), refracted_cosine(1.5, 0.5), 1e-15);
}

TEST(geometry, brewster_is_the_zero_of_r_p) {
    for (const double eta : {0.4, 0.9, 1.1, 1.5, 2.417, 7.0}) {
        const double c = brewster_cosine(eta);
        EXPECT_NEAR(std::sqrt(1 - c * c) / c, eta, 1e-14 * eta);
        EXPECT_LT(dielectric(1.0, eta, c).R_p, 1e-28);
    }
}

/// Humphreys-Owen's cubic in u = sin^2 and its slope.
struct cubic {
    real50 value, slope;
};

cubic humphreys_owen(const real50& n, const real50& k, const real50& u) {
    const real50 re = n * n - k * k, im = 2 * n * k, m2 = re * re + im * im;
    return {2 * (m2 + re) * u * u * u + (m2 * m2 - 3 * m2) * u * u - 2 * m2 * m2 * u + m2 * m2,
            6 * (m2 + re) * u * u + 2 * (m2 * m2 - 3 * m2) * u - 2 * m2 * m2};
}

TEST(geometry, pseudo_brewster_solves_the_cubic_of_humphreys_owen) {
    random_numbers random(5);
    for (int i = 0; i < 2000; ++i) {
        const double n = random.log_uniform(0.02, 50), k = random.log_uniform(1e-4, 50);
        const real50 c = pseudo_brewster_cosine(real50(1), real50(n), real50(k));
        const cubic p = humphreys_owen(n, k, 1 - c * c);
        EXPECT_LT(static_cast<double>(abs(p.value / p.slope)), 1e-50) << n << " " << k;
    }
}

TEST(geometry, pseudo_brewster_is_the_least_r_p) {
    random_numbers random(6);
    for (int i = 0; i < 500; ++i) {
        const double n_i = random.uniform(1, 1.6), n = random.log_uniform(0.1, 10),
                     k = random.log_uniform(0.02, 20);
        const double c = pseudo_brewster_cosine(n_i, n, k), least = conductor(n_i, n, k, c).R_p;
        for (int j = 0; j <= 500; ++j)
            EXPECT_GE(conductor(n_i, n, k, j / 500.0).R_p, least * (1 - 1e-13)) << n << " " << k;
    }
}

TEST(geometry, pseudo_brewster_keeps_its_digits) {
    random_numbers random(7);
    double worst = 0, worst_float = 0;
    for (int i = 0; i < 20000; ++i) {
        const double n = random.log_uniform(0.02, 50),
                     k = random.one_in(5) ? 0 : random.log_uniform(1e-6, 100);
        const real50 truth = pseudo_brewster_cosine(real50(1), real50(n), real50(k));
        const float nf = static_cast<float>(n), kf = static_cast<float>(k);
        const real50 truth_float = pseudo_brewster_cosine(real50(1), real50(nf), real50(kf));
        worst =
            std::fmax(worst, std::abs(static_cast<double>(pseudo_brewster_cosine(1.0, n, k) / truth - 1)));
        worst_float =
            std::fmax(worst_float,
                      std::abs(static_cast<double>(pseudo_brewster_cosine(1.0f, nf, kf) / truth_float - 1)));
    }
    std::printf("pseudo_brewster_cosine: relative %.1e in float64, %.1e in float32\n", worst, worst_float);
    EXPECT_LT(worst, 1e-15);
    EXPECT_LT(worst_float, 1e-6);
}

TEST(geometry, pseudo_brewster_without_absorption_is_brewster) {
    for (const double eta : {0.2, 0.8, 1.0, 1.5, 4.0})
        EXPECT_TRUE(same(pseudo_brewster_cosine(1.0, eta, 0.0), brewster_cosine(eta), digits(eta)));
}

TEST(geometry, critical_cosine_is_where_everything_is_reflected) {
    for (const double eta : {0.3, 0.75, 0.99}) {
        const double c = critical_cosine(eta);
        EXPECT_NEAR(c * c + eta * eta, 1, 1e-15);
        EXPECT_EQ(dielectric(1.0, eta, c * 0.999).reflectance(), 1);
        EXPECT_LT(dielectric(1.0, eta, c * 1.001).reflectance(), 1);
    }
    EXPECT_EQ(critical_cosine(1.0), 0);
    EXPECT_EQ(critical_cosine(1.5), 0);
}

TEST(geometry, both_indices_of_an_f0_give_it_back) {
    for (const double f0 : {0.0, 1e-6, 0.02, 0.04, 0.17, 0.5, 0.99}) {
        EXPECT_NEAR(normal_reflectance(1.0, eta_from_f0(f0), 0.0), f0, 1e-15);
        EXPECT_NEAR(normal_reflectance(1.0, inner_eta_from_f0(f0), 0.0), f0, 1e-15);
        EXPECT_NEAR(eta_from_f0(f0) * inner_eta_from_f0(f0), 1, 1e-14);
        EXPECT_EQ(sin_critical(f0), inner_eta_from_f0(f0));
    }
}

TEST(geometry, the_k_of_an_f0_gives_it_back) {
    for (const double n : {0.05, 0.5, 1.0, 2.0, 3.0})
        for (const double k : {0.1, 1.0, 5.0, 20.0})
            EXPECT_NEAR(k_from_f0(normal_reflectance(1.0, n, k), n), k, 1e-11 * k) << n << " " << k;
}

TEST(geometry, internal_reflection_needs_f0_alone) {
    for (const double n : {1.1, 1.333, 1.5, 2.417})
        for (double c = 0; c <= 1; c += 0.05) {
            const double critical = critical_cosine(1 / n);
            if (std::abs(c - critical) < 1e-3) continue;
            const double from_f0 = internal_reflection(normal_reflectance(1.0, n, 0.0), c).reflectance();
            EXPECT_NEAR(from_f0, dielectric(n, 1.0, c).reflectance(), 1e-12) << n << " " << c;
        }
}

TEST(geometry, is_of_models_too_and_instantiates_with_strict) {
    const strict one(1), half = ratio<strict, 1, 2>(), eta = ratio<strict, 3, 2>(), k(5), zero(0);
    EXPECT_EQ(brewster_cosine(eta).value(), brewster_cosine(1.5));
    EXPECT_EQ(pseudo_brewster_cosine(one, eta, k).value(), pseudo_brewster_cosine(1.0, 1.5, 5.0));
    EXPECT_EQ(critical_cosine(half).value(), critical_cosine(0.5));
    EXPECT_EQ(inner_eta_from_f0(half).value(), inner_eta_from_f0(0.5));
    EXPECT_EQ(k_from_f0(half, eta).value(), k_from_f0(0.5, 1.5));
    EXPECT_EQ(internal_reflection(half, half).R_p.value(), internal_reflection(0.5, 0.5).R_p);
    EXPECT_EQ(complex_refracted_cosine(one, eta, k, half).im.value(),
              complex_refracted_cosine(1.0, 1.5, 5.0, 0.5).im);
    EXPECT_EQ(phase_cosine(one, eta, k, half).value(), phase_cosine(1.0, 1.5, 5.0, 0.5));
    const vector3<strict> n{zero, one, zero};
    EXPECT_EQ(refract(n, n, eta).y.value(), -1);
    EXPECT_EQ(reflect(n, n).y.value(), 1);
}

} // namespace
} // namespace fresnel::test
