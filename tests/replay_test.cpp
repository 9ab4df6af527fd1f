// Numbers that others publish for their own Fresnel code, replayed. T1 to T31 are the cases of the project's
// survey of renderers; those of polarised films, dispersion and Mueller matrices are tested with those parts.
//
// A negative cosine in a source means the other side of the surface: the indices swapped. Amplitudes here are
// for waves exp(-i omega t), media n + i k and Verdet's sign of r_p; a source's other choice is said beside
// it.

#include "oracles.hpp"
#include "tolerances.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/average.hpp>
#include <fresnel/exact.hpp>
#include <fresnel/geometry.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

namespace fresnel::test {
namespace {

using std::numbers::pi;

constexpr double default_tolerance = 1e-6; // of single precision comparisons in the sources

double degrees(double angle) { return angle * 180 / pi; }

double phase(complex<double> z) { return std::atan2(z.im, z.re); }

double glass(double cos_i) { return dielectric(1.0, 1.5, cos_i).reflectance(); }

// ---- Mitsuba 3, test_fresnel.py ---------------------------------------------------------------------------

TEST(replay, T1_glass_reflects_4_percent_straight_on) {
    EXPECT_NEAR(glass(1), 0.04, 1e-15);
    EXPECT_NEAR(refracted_cosine(1.5, 1.0), 1, 1e-15);
}

TEST(replay, T2_and_the_same_from_inside) {
    EXPECT_NEAR(dielectric(1.5, 1.0, 1.0).reflectance(), 0.04, 1e-15);
    EXPECT_NEAR(refracted_cosine(1 / 1.5, 1.0), 1, 1e-15);
}

TEST(replay, T3_glass_reflects_everything_at_grazing_incidence) {
    EXPECT_EQ(glass(0), 1);
    EXPECT_NEAR(refracted_cosine(1.5, 0.0), 0.745355992499930, 1e-14);
}

TEST(replay, T4_glass_at_45_degrees) {
    const double c = std::sqrt(0.5);
    const boundary<double> y = dielectric(1.0, 1.5, c);
    EXPECT_NEAR(std::sqrt(y.R_s), 0.3033370452904235, 1e-15);
    EXPECT_NEAR(std::sqrt(y.R_p), 0.09201336304552442, 1e-15);
    EXPECT_NEAR(degrees(std::acos(refracted_cosine(1.5, c))), 28.1255057020557, 1e-12);
    EXPECT_NEAR(y.reflectance(), 0.0502399110122359, 1e-15);
}

TEST(replay, T5_glass_from_inside_at_10_degrees) {
    const double c = std::cos(10 * pi / 180);
    const boundary<double> y = dielectric(1.5, 1.0, c);
    EXPECT_NEAR(std::sqrt(y.R_s), 0.20949431963852014, 1e-8);
    EXPECT_NEAR(std::sqrt(y.R_p), 0.19046797197779405, 1e-8);
    EXPECT_NEAR(degrees(std::acos(refracted_cosine(1 / 1.5, c))), 15.098086605159006, 1e-12);
    EXPECT_NEAR(y.reflectance(), 0.0400829591550701, 1e-14);
}

TEST(replay, T6_glass_from_inside_at_45_degrees_reflects_everything) {
    const double c = std::sqrt(0.5);
    EXPECT_EQ(dielectric(1.5, 1.0, c).reflectance(), 1);
    EXPECT_EQ(refracted_cosine(1 / 1.5, c), 0);
}

TEST(replay, T7_brewsters_angle_of_glass) {
    const boundary<double> printed = dielectric(1.0, 1.5, std::cos(56.3099 * pi / 180));
    EXPECT_NEAR(printed.R_s, std::pow(0.3846150939598947, 2), default_tolerance);
    EXPECT_NEAR(printed.R_p, 0, default_tolerance);
    const amplitudes<double> exact = boundary_amplitudes(1.0, 1.5, 0.0, 1 / std::sqrt(3.25));
    EXPECT_NEAR(exact.r_s.re, -5.0 / 13, 1e-15);
    EXPECT_NEAR(exact.r_p.re, 0, 1e-15);
}

TEST(replay, T8_glass_at_80_degrees) {
    EXPECT_NEAR(glass(std::cos(80 * pi / 180)), 0.387704354691473, 1e-15);
}

TEST(replay, T9_equal_media_reflect_nothing_and_bend_nothing) {
    for (int i = 0; i < 20; ++i) {
        const double c = std::abs(-1 + 2 * i / 19.0);
        EXPECT_EQ(dielectric(1.0, 1.0, c).reflectance(), 0) << c;
        EXPECT_NEAR(refracted_cosine(1.0, c), c, 1e-15) << c;
    }
}

TEST(replay, T10_a_conductor_without_absorption_is_a_dielectric) {
    for (const double eta : {1.5, 1 / 1.5})
        for (int i = 0; i < 20; ++i) {
            const double c = std::cos(i * pi / 38);
            EXPECT_NEAR(conductor(1.0, eta, 0.0, c).reflectance(), dielectric(1.0, eta, c).reflectance(),
                        1e-14)
                << c;
        }
}

TEST(replay, T11_snells_law) {
    for (int i = 0; i < 20; ++i) {
        const double angle = i * pi / 38, cos_t = refracted_cosine(1.5, std::cos(angle));
        EXPECT_NEAR(std::sin(angle) - 1.5 * std::sqrt(1 - cos_t * cos_t), 0, 1e-14) << angle;
    }
}

/// Signs of the real amplitudes r_s and r_p.
std::array<int, 2> signs(double n_i, double n_t, double cos_i) {
    const amplitudes<double> r = boundary_amplitudes(n_i, n_t, 0.0, cos_i);
    const auto sign = [](double x) { return x > 0 ? 1 : x < 0 ? -1 : 0; };
    return {sign(r.r_s.re), sign(r.r_p.re)};
}

TEST(replay, T12_signs_outside_glass_change_at_brewsters_angle) { // the source: Verdet's sign, as here
    const double brewster = std::atan(1.5);
    EXPECT_EQ(signs(1, 1.5, 1), (std::array{-1, 1}));
    EXPECT_EQ(signs(1, 1.5, std::cos(brewster - 0.01)), (std::array{-1, 1}));
    EXPECT_EQ(signs(1, 1.5, std::cos(brewster + 0.01)), (std::array{-1, -1}));
    const amplitudes<double> grazing = boundary_amplitudes(1.0, 1.5, 0.0, 0.0);
    EXPECT_EQ(grazing.r_s.re, -1);
    EXPECT_EQ(grazing.r_p.re, -1);
}

TEST(replay, T13_signs_inside_glass_change_at_brewsters_angle) {
    const double brewster = std::atan(1 / 1.5), critical = std::asin(1 / 1.5);
    EXPECT_EQ(signs(1.5, 1, 1), (std::array{1, -1}));
    EXPECT_EQ(signs(1.5, 1, std::cos(brewster - 0.01)), (std::array{1, -1}));
    EXPECT_EQ(signs(1.5, 1, std::cos(brewster + 0.01)), (std::array{1, 1}));
    const amplitudes<double> at_critical = boundary_amplitudes(1.5, 1.0, 0.0, std::cos(critical));
    EXPECT_NEAR(at_critical.r_s.re, 1, 1e-6);
    EXPECT_NEAR(at_critical.r_p.re, 1, 1e-6);
}

TEST(replay,
     T14_largest_phase_difference_of_total_reflection) { // the source: exp(+i omega t), phases negative
    const double eta = 1 / 1.5, c = std::sqrt((1 - eta * eta) / (1 + eta * eta));
    EXPECT_NEAR(c, 0.620173672946, 1e-12);
    const amplitudes<double> r = boundary_amplitudes(1.5, 1.0, 0.0, c);
    const double difference = phase(r.r_s) - phase(r.r_p);
    EXPECT_NEAR(difference, 2 * std::atan((1 - eta * eta) / (2 * eta)), 1e-14);
    EXPECT_NEAR(difference, 0.789582239399523, 1e-14);
    EXPECT_NEAR(degrees(difference), 45.2397298960809, 1e-12);
}

TEST(replay, T15_phases_of_total_reflection_run_from_0_at_the_critical_angle_to_pi_at_grazing_incidence) {
    const double critical = std::sqrt(1 - 1 / 2.25);
    const amplitudes<double> at_critical = boundary_amplitudes(1.5, 1.0, 0.0, critical * (1 - 1e-14));
    EXPECT_NEAR(phase(at_critical.r_s), 0, 1e-5);
    EXPECT_NEAR(phase(at_critical.r_p), 0, 1e-5);
    const amplitudes<double> grazing = boundary_amplitudes(1.5, 1.0, 0.0, 0.0);
    EXPECT_NEAR(std::abs(phase(grazing.r_s)), pi, 1e-5);
    EXPECT_NEAR(std::abs(phase(grazing.r_p)), pi, 1e-5);
}

// ---- other renderers --------------------------------------------------------------------------------------

TEST(replay, T20_silver_at_45_degrees) {
    const boundary<double> y = conductor(1.0, 0.136125, 4.010625, std::sqrt(0.5));
    EXPECT_NEAR(y.R_s, 0.978072208255417, 1e-14);
    EXPECT_NEAR(y.R_p, 0.956625244561627, 1e-14);
    EXPECT_NEAR(y.reflectance(), 0.967348726408522, 1e-14);
}

TEST(replay, T21_a_conductor_without_absorption_reflects_totally_and_is_not_nan) {
    EXPECT_EQ(conductor(1.0f, 0.4000000059604645f, 0.0f, 0.8029893636703491f).reflectance(), 1);
    EXPECT_EQ(conductor_fast(1.0f, 0.4000000059604645f, 0.0f, 0.8029893636703491f).reflectance(), 1);
    EXPECT_EQ(conductor_precise(1.0f, 0.4000000059604645f, 0.0f, 0.8029893636703491f).reflectance(), 1);
}

TEST(replay, T22_a_conductor_equal_to_the_ambient_medium_is_not_negative) {
    const float c = 0.670869052f;
    EXPECT_NEAR(oracle::memo_conductor_listing(1.0f, 0.0f, c).mean(), -1.67196e-08f,
                1e-13f); // the defect itself
    EXPECT_EQ(conductor(1.0f, 1.0f, 0.0f, c).reflectance(), 0);
    EXPECT_EQ(conductor_fast(1.0f, 1.0f, 0.0f, c).reflectance(), 0);
    EXPECT_EQ(conductor_precise(1.0f, 1.0f, 0.0f, c).reflectance(), 0);
}

TEST(replay, T23_materialx_default_conductor) {
    constexpr std::array n = {0.271, 0.677, 1.316}, k = {3.609, 2.625, 2.292};
    constexpr std::array f0 = {0.925957912674325, 0.720909735323902, 0.50419699504197};
    constexpr std::array f82 = {0.934606984078347, 0.826446702506804, 0.69583517007251};
    for (std::size_t i = 0; i < 3; ++i) {
        EXPECT_NEAR(conductor(1.0, n[i], k[i], 1.0).reflectance(), f0[i], 1e-14) << n[i];
        EXPECT_NEAR(conductor(1.0, n[i], k[i], 1.0 / 7).reflectance(), f82[i], 1e-14) << n[i];
    }
}

TEST(replay, T24_gltf_table_of_f0_by_index) {
    constexpr std::array index = {1.0, 1.33, 1.38, 1.52, 1.76, 2.42};
    constexpr std::array f0 = {0.0,
                               0.0200593121995248,
                               0.0254925499611609,
                               0.0425799949609473,
                               0.0758244066372611,
                               0.172394924934168};
    for (std::size_t i = 0; i < index.size(); ++i)
        EXPECT_NEAR(normal_reflectance(1.0, index[i], 0.0), f0[i], 1e-15) << index[i];
}

TEST(replay, T24_gltf_index_0_makes_every_angle_reflect_everything) {
    const double f0 = normal_reflectance(1.0, 0.0, 0.0);
    EXPECT_EQ(f0, 1);
    for (const double c : {0.0, 0.3, 1.0})
        EXPECT_EQ(schlick(f0, c), 1) << c;
}

TEST(replay, T25_gltf_default_is_4_percent) {
    EXPECT_TRUE(same(normal_reflectance(1.0, 1.5, 0.0), 0.04, "ior 1.5"));
    EXPECT_TRUE(same(normal_reflectance(1.0f, 1.5f, 0.0f), 0.04f, "ior 1.5"));
}

// ---- averages and the F82 family --------------------------------------------------------------------------

TEST(replay, T27_average_of_f82_tint) {
    for (const double f0 : {0.2, 0.56, 0.9})
        for (const double tint : {0.6, 0.85, 1.0}) {
            const double b = schlick(f0, 1.0 / 7) * (1 - tint) * 17.6513846021948;
            EXPECT_NEAR(f82_tint_average(f0, tint), f0 + (1 - f0) / 21 - b / 126, 1e-14) << f0 << ' ' << tint;
        }
}

TEST(replay, T28_constants_of_f82_tint) {
    EXPECT_NEAR(std::pow(6.0 / 7, 5), 0.46266436603796, 1e-14);
    EXPECT_NEAR(7 / std::pow(6.0 / 7, 6), 17.6513846021948, 1e-12);
    for (const double f0 : {0.0, 0.5, 1.0}) { // K (7776 + 9031 f0), K = 49/46656, is b of a tint 0
        const double b = schlick(f0, 1.0 / 7) * 17.6513846021948;
        EXPECT_NEAR(49.0 / 46656 * (7776 + 9031 * f0), b, 1e-12) << f0;
        for (const double tint : {0.7, 0.9, 1.0})
            EXPECT_NEAR(f82_tint(f0, tint, 1.0 / 7), tint * schlick(f0, 1.0 / 7), 1e-15) << f0 << ' ' << tint;
    }
}

TEST(replay, T29_average_from_inside_follows_from_the_average_outside) {
    for (const double eta : {1.01, 1.33, 1.5, 2.42, 8.0}) {
        const double inside = dielectric_average(1 / eta), outside = dielectric_average(eta);
        EXPECT_NEAR(inside, 1 - (1 - outside) / (eta * eta), 1e-15) << eta;
    }
}

TEST(replay, T30_averages_of_water_and_glass) {
    EXPECT_NEAR(dielectric_average(1.33), 0.0659308492994054, 1e-15);
    EXPECT_NEAR(dielectric_average(1.5), 0.0917779593423512, 1e-15);
    EXPECT_NEAR(dielectric_average(1 / 1.5), 0.596345759707712, 1e-15);
}

TEST(replay, T31_gulbrandsen_returns_r_straight_on_for_every_edge_tint) {
    for (const double r : {0.0, 0.02, 0.5, 0.9, 0.99})
        for (const double g : {0.0, 0.25, 0.5, 1.0})
            EXPECT_NEAR(gulbrandsen(r, g, 1.0), r, default_tolerance) << r << ' ' << g;
}

} // namespace
} // namespace fresnel::test
