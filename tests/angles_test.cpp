#include "command.hpp"
#include "tolerances.hpp"

#include "analysis/angles.hpp"
#include "analysis/curve.hpp"
#include "analysis/fit.hpp"

#include <fresnel/exact.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace fresnel;

class angles : public test::command_test {};

TEST_F(angles, of_glass_are_the_textbooks) {
    const auto a = json("angles --n-i 1 --n-t 1.5 --json");
    EXPECT_NEAR(a["f0"], 0.04, 1e-15);
    EXPECT_NEAR(a["brewster"], 56.309932474020215, 1e-10);
    EXPECT_NEAR(a["pseudo_brewster"], 56.309932474020215, 1e-10);
    EXPECT_TRUE(a["critical"].is_null());
    EXPECT_TRUE(a["least"].is_null());
    EXPECT_NEAR(a["average"], 0.0918, 5e-5);
    EXPECT_NEAR(a["average_inside"], 0.5963, 5e-5);
}

TEST_F(angles, from_inside_have_a_critical_one) {
    const auto a = json("angles --n-i 1.5 --n-t 1 --json");
    EXPECT_NEAR(a["critical"], 41.810314895778596, 1e-10);
    EXPECT_NEAR(a["brewster"], 33.690067525979785, 1e-10);
    EXPECT_NEAR(a["average"], 0.5963, 5e-5);
    EXPECT_EQ(a["f82"], 1.0);
}

TEST_F(angles, of_a_metal_have_a_pseudo_brewster_and_a_least_one_elsewhere) {
    const auto a = json("angles --n-t 1.5 --k-t 5 --json");
    EXPECT_TRUE(a["brewster"].is_null());
    EXPECT_TRUE(a["critical"].is_null());
    EXPECT_TRUE(a["average_inside"].is_null());
    EXPECT_NEAR(a["f0"], 0.808, 1e-12);
    EXPECT_NEAR(a["f82"], 0.76467, 1e-5);
    const auto chromium = json("angles --material chromium --wavelength 550 --json");
    EXPECT_NEAR(chromium["least"], 72.8, 0.05); // measured apart, by brute force in another program
    EXPECT_NEAR(chromium["pseudo_brewster"], 77.5, 0.05);
}

TEST_F(angles, of_equal_media_are_none) {
    const auto a = json("angles --n-i 1.2 --n-t 1.2 --json");
    for (const char* key : {"brewster", "pseudo_brewster", "critical", "least"})
        EXPECT_TRUE(a[key].is_null()) << key;
    EXPECT_EQ(a["average"], 0.0);
    EXPECT_EQ(a["f0"], 0.0);
}

TEST_F(angles, refract_rays_and_say_where_there_is_none) {
    const auto a = json("angles --n-i 1.5 --n-t 1 --theta 30,60 --json");
    EXPECT_NEAR(a["rays"][0]["theta_t"], 48.59037789072914, 1e-10);
    EXPECT_TRUE(a["rays"][1]["theta_t"].is_null());
    EXPECT_EQ(a["rays"][1]["R"], 1.0);
    EXPECT_NE(run("angles --n-i 1.5 --n-t 1 --theta 60").out.find("totally reflected"), std::string::npos);
}

TEST_F(angles, refuse_bad_use) {
    expect_refused("angles", {"--n-t", "--material"});
    expect_refused("angles --n-t 1.5 --material gold", {"--n-t", "--material"});
    expect_refused("angles --n-t 0", {"n_t", "0", "[0.001, 1000]"});
    expect_refused("angles --n-t 1.5 --k-t -1", {"k_t", "-1", "[0, 10000]"});
    expect_refused("angles --n-t glass", {"n_t", "glass", "number"});
    expect_refused("angles --n-t 1.5 --theta 91", {"theta", "91", "[0, 90]"});
    expect_refused("angles --n-t 1.5 --theta 30,,60", {"theta", "''"});
    expect_refused("angles --n-t 1.5 --wavelength abc", {"--wavelength abc", "--material"});
    expect_refused("angles --material gold --k-t 3", {"--k-t 3", "gold"});
    expect_refused("angles --material goldd", {"goldd", "gold"});
    expect_refused("angles --material gold --wavelength -5", {"--wavelength", "-5"});
}

TEST(least_reflectance, is_below_every_other_angle) {
    for (const auto& [n, k] : {std::pair{1.5, 5.0}, {3.18, 3.33}, {0.96, 6.69}, {2.0, 0.5}}) {
        const double c = least_reflectance_cosine(1, n, k), least = conductor(1.0, n, k, c).reflectance();
        for (int i = 0; i <= 9000; ++i)
            EXPECT_GE(conductor(1.0, n, k, cosine_of_degrees(0.01 * i)).reflectance(), least - 1e-12) << n;
    }
    EXPECT_EQ(least_reflectance_cosine(1, 1.5, 0), 1);
    EXPECT_EQ(least_reflectance_cosine(1.5, 1, 0), 1);
}

TEST(metal_dip, is_the_solver_of_the_memo) {
    const metal_dip dip = find_metal_dip(1.5, 5);
    EXPECT_NEAR(dip.alpha, 7.7054, 5e-5); // independent: 40 digits
    EXPECT_NEAR(dip.cos_i, 0.1355, 5e-5);
    EXPECT_NEAR(dip.error, -0.1324, 5e-5);
    EXPECT_NEAR(2 * 1.5 * dip.cos_i * std::pow(1 - dip.cos_i, dip.alpha), -dip.error, 1e-12);
}

} // namespace
