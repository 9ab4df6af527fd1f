#include "inputs.hpp"
#include "tolerances.hpp"

#include <fresnel/exact.hpp>
#include <fresnel/shading.hpp>
#include <fresnel/types/strict.hpp>

#include "analysis/multi.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace fresnel::test {
namespace {

const double nan = std::nan("");

// ---- opacity ----------------------------------------------------------------------------------------------

TEST(opacity_fresnel, rises_from_the_users_value_to_1) {
    EXPECT_TRUE(exactly(opacity_fresnel(0.2, 1.0), 0.2, "along the normal"));
    EXPECT_TRUE(exactly(opacity_fresnel(0.2, 0.0), 1.0, "silhouette"));
    EXPECT_TRUE(same(opacity_fresnel(0.2, 0.5), 0.2 + 0.8 / 32, "60 degrees"));
}

TEST(opacity_silhouette, grows_with_the_path_until_nothing_passes) {
    EXPECT_TRUE(exactly(opacity_silhouette(0.25, 1.0), 0.25, "along the normal"));
    EXPECT_TRUE(exactly(opacity_silhouette(0.25, 0.5), 0.5, "60 degrees"));
    EXPECT_TRUE(exactly(opacity_silhouette(0.25, 0.25), 1.0, "just opaque"));
    EXPECT_TRUE(exactly(opacity_silhouette(0.25, 0.1), 1.0, "beyond"));
}

TEST(opacity_silhouette, is_1_at_the_edge_but_for_a_layer_that_is_not_there) {
    EXPECT_TRUE(exactly(opacity_silhouette(1e-300, 0.0), 1.0, "edge"));
    EXPECT_TRUE(exactly(opacity_silhouette(0.0, 0.0), 0.0, "no layer"));
    EXPECT_TRUE(std::isnan(opacity_silhouette(nan, 0.0)));
    EXPECT_TRUE(std::isnan(opacity_silhouette(0.3, nan)));
}

TEST(opacity_slab, keeps_its_digits_for_thin_layers) {
    random_numbers random(12);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const double tau = random.log_uniform(1e-12, 30), c = random.uniform(0.05, 1);
        const real50 truth = -boost::multiprecision::expm1(-real50(tau) / c);
        ASSERT_TRUE(within_relative(real50(opacity_slab(tau, c)), truth, 1e-14, digits(tau)));
    }
}

TEST(opacity_slab, is_the_silhouette_law_for_thin_layers_and_below_it_for_all) {
    random_numbers random(13);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const double tau = random.log_uniform(1e-12, 1), c = random.uniform(0, 1);
        const double slab = opacity_slab(tau, c), thin = opacity_silhouette(tau, c);
        ASSERT_LE(slab, thin * (1 + 1e-15)) << tau << " " << c;
        ASSERT_GE(slab, thin * (1 - tau / c)) << tau << " " << c;
    }
}

TEST(opacity_total, multiplies_the_transparencies) {
    EXPECT_TRUE(same(opacity_total(0.5, 0.2), 1 - 0.5 * 0.8, "half"));
    EXPECT_TRUE(exactly(opacity_total(0.3, 0.0), 0.3, "no reflection"));
    EXPECT_TRUE(exactly(opacity_total(0.0, 0.3), 0.3, "no attenuation"));
    EXPECT_TRUE(exactly(opacity_total(1.0, 0.3), 1.0, "opaque"));
}

TEST(opacity_attenuation, is_the_inverse_of_the_total) {
    random_numbers random(23);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const double attenuation = random.uniform(0, 1), fresnel = random.uniform(0, 0.99);
        const double back = opacity_attenuation(opacity_total(attenuation, fresnel), fresnel);
        ASSERT_TRUE(within(back, attenuation, 1e-13, digits(attenuation) + " " + digits(fresnel)));
    }
}

TEST(opacity_attenuation, is_negative_where_the_reflection_alone_is_more_than_the_total) {
    EXPECT_TRUE(same(opacity_attenuation(0.1, 0.2), -0.125, "total 0.1, fresnel 0.2"));
}

// ---- highlights -------------------------------------------------------------------------------------------

TEST(phong_lobe, is_0_behind_the_mirrored_light) {
    EXPECT_TRUE(exactly(phong_lobe(-0.3, 10.0), 0.0, "behind"));
    EXPECT_TRUE(exactly(phong_lobe(1.0, 10.0), 1.0, "in the middle"));
    EXPECT_TRUE(same(phong_lobe(0.5, 10.0), 1 / 1024.0, "60 degrees"));
    EXPECT_TRUE(std::isnan(phong_lobe(nan, 10.0)));
}

TEST(fresnel_highlight, is_the_listing_of_the_chapter) {
    random_numbers random(29);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const double f0 = random.uniform(0, 1), h = random.uniform(0, 1), r = random.uniform(-1, 1),
                     s = random.uniform(1, 100), l = random.uniform(-1, 1);
        const double w = std::pow(1 - std::fmax(0, h), 5);
        const double listing = l < 0 ? 0 : (f0 * (1 - w) + w) * std::pow(std::fmax(0, r), s);
        ASSERT_TRUE(same(fresnel_highlight(f0, h, r, s, l), listing, digits(h), 1e-300)) << r << " " << s;
    }
}

TEST(fresnel_highlight, is_0_for_a_light_below_the_surface) {
    EXPECT_TRUE(exactly(fresnel_highlight(0.04, 0.5, 1.0, 10.0, -0.1), 0.0, "below"));
    EXPECT_TRUE(exactly(fresnel_highlight(0.04, 1.0, 1.0, 10.0, 0.0), 0.04, "on the horizon"));
    EXPECT_TRUE(std::isnan(fresnel_highlight(0.04, 1.0, 1.0, 10.0, nan)));
    EXPECT_TRUE(std::isnan(fresnel_highlight(0.04, nan, 1.0, 10.0, 0.5)));
}

// ---- F0 as an artist's value ------------------------------------------------------------------------------

TEST(cavity_f90, is_1_from_two_percent_on) {
    EXPECT_TRUE(exactly(cavity_f90(0.0), 0.0, "0"));
    EXPECT_TRUE(exactly(cavity_f90(0.01), 0.5, "0.01"));
    EXPECT_TRUE(exactly(cavity_f90(0.02), 1.0, "0.02"));
    EXPECT_TRUE(exactly(cavity_f90(0.9), 1.0, "0.9"));
}

TEST(immersed, leaves_f0_in_air_and_vanishes_at_the_index_of_the_medium) {
    for (const double f0 : {0.0, 0.02, 0.04, 0.17, 0.9, 1.0})
        EXPECT_TRUE(same(immersed(f0, 1.0), f0, digits(f0)));
    EXPECT_LT(immersed(0.04, 1.5), 1e-30);
    EXPECT_TRUE(exactly(immersed(1.0, 1.33), 1.0, "a perfect mirror"));
}

TEST(immersed, is_the_reflectance_of_the_index_that_f0_has_in_air) {
    for (const double n : {1.0001, 1.4, 1.5, 2.42, 4.0})
        for (const double ambient : {1.0, 1.33, 1.6})
            EXPECT_TRUE(within(immersed(normal_reflectance(1.0, n, 0.0), ambient),
                               normal_reflectance(ambient, n, 0.0), 1e-14, digits(n)));
}

TEST(immersed, skin_in_water_keeps_the_f90_it_has_in_air) {
    const double skin = 0.028;
    EXPECT_NEAR(immersed(skin, 1.33), 0.0007, 5e-5); // "Real-Time Rendering", table 9.4
    EXPECT_TRUE(exactly(cavity_f90(skin), 1.0, "before"));
    EXPECT_LT(cavity_f90(immersed(skin, 1.33)), 0.04); // what the wrong order would do
}

// ---- metalness --------------------------------------------------------------------------------------------

TEST(metalness, at_one_half_every_slider_is_an_index_of_1_5) {
    EXPECT_TRUE(same(disney_f0(0.5), 0.04, "Disney"));
    EXPECT_TRUE(same(frostbite_f0(0.5), 0.04, "Frostbite"));
    EXPECT_TRUE(exactly(unity_f0<double>(), 0.04, "Unity"));
    EXPECT_TRUE(same(gltf_f0(1.5, 1.0, 1.0), 0.04, "glTF"));
    EXPECT_TRUE(same(openpbr_surface(0.7, 0.0, 1.5, 1.0).f0, 0.04, "OpenPBR"));
}

TEST(metalness, is_all_f0_for_a_metal_and_all_albedo_for_a_dielectric) {
    const surface_color<double> metal = metalness_surface(0.7, 1.0, 0.04);
    EXPECT_TRUE(exactly(metal.f0, 0.7, "metal"));
    EXPECT_TRUE(exactly(metal.albedo, 0.0, "metal"));
    const surface_color<double> plastic = metalness_surface(0.7, 0.0, 0.04);
    EXPECT_TRUE(exactly(plastic.f0, 0.04, "plastic"));
    EXPECT_TRUE(exactly(plastic.albedo, 0.7, "plastic"));
}

TEST(metalness, sliders_and_their_f0_are_inverses) {
    for (const double x : {0.0, 0.1, 0.5, 1.0}) {
        EXPECT_TRUE(same(disney_specular(disney_f0(x)), x, digits(x)));
        EXPECT_TRUE(same(frostbite_reflectance(frostbite_f0(x)), x, digits(x)));
        EXPECT_TRUE(same(openpbr_specular_weight(gltf_f0(1.5, 1.0, x), 1.5), x, digits(x)));
    }
}

TEST(unity_surface, keeps_for_the_diffuse_light_what_is_not_reflected) {
    const surface_color<double> half = unity_surface(0.5, 0.5);
    EXPECT_TRUE(same(half.f0, 0.04 + (0.5 - 0.04) * 0.5, "f0: lerp(0.04, base, m)"));
    EXPECT_TRUE(same(half.albedo, 0.5 * (0.96 - 0.5 * 0.96), "albedo: base (0.96 - 0.96 m)"));
}

TEST(gltf_f0, is_limited_before_the_strength) {
    EXPECT_TRUE(exactly(gltf_f0(3.0, 10.0, 0.5), 0.5, "f0 0.25, color 10, strength 0.5"));
    EXPECT_TRUE(same(gltf_f0(1.5, 0.5, 0.5), 0.01, "tinted"));
    EXPECT_TRUE(exactly(gltf_f0(1.0, 1.0, 1.0), 0.0, "no boundary"));
}

TEST(openpbr_eta, has_the_weighted_f0_on_either_side_of_1) {
    for (const double eta : {0.5, 0.75, 1.0001, 1.5, 2.5})
        for (const double w : {0.0, 0.25, 1.0, 1.2}) {
            const double modulated = openpbr_eta(eta, w);
            const double f0 = w * normal_reflectance(1.0, eta, 0.0);
            EXPECT_TRUE(within(normal_reflectance(1.0, modulated, 0.0), f0, 1e-16 + 1e-12 * f0, digits(eta)));
            EXPECT_EQ(modulated > 1, eta > 1 && w > 0) << eta << " " << w;
        }
    EXPECT_TRUE(same(openpbr_eta(1.5, 1.0), 1.5, "weight 1"));
    EXPECT_TRUE(exactly(openpbr_eta(1.5, 0.0), 1.0, "weight 0"));
}

TEST(openpbr_surface, weighs_the_metal_too) {
    EXPECT_TRUE(same(openpbr_surface(0.8, 1.0, 1.5, 0.5).f0, 0.4, "metal"));
    EXPECT_TRUE(same(openpbr_surface(0.8, 0.0, 1.5, 0.5).f0, 0.02, "dielectric"));
    EXPECT_TRUE(same(openpbr_surface(0.8, 0.25, 1.5, 0.5).albedo, 0.6, "albedo"));
}

// ---- every number type ------------------------------------------------------------------------------------

TEST(shading, is_made_of_models_and_instantiates_with_strict) {
    const strict a = ratio<strict, 3, 10>(), c = ratio<strict, 1, 2>(), n = ratio<strict, 3, 2>(), ten = 10;
    EXPECT_TRUE(exactly(opacity_fresnel(a, c).value(), opacity_fresnel(0.3, 0.5), "fresnel"));
    EXPECT_TRUE(exactly(opacity_silhouette(a, c).value(), opacity_silhouette(0.3, 0.5), "silhouette"));
    EXPECT_TRUE(exactly(opacity_slab(a, c).value(), opacity_slab(0.3, 0.5), "slab"));
    EXPECT_TRUE(exactly(opacity_total(a, c).value(), opacity_total(0.3, 0.5), "total"));
    EXPECT_TRUE(exactly(opacity_attenuation(c, a).value(), opacity_attenuation(0.5, 0.3), "attenuation"));
    EXPECT_TRUE(exactly(fresnel_highlight(a, c, c, ten, a).value(),
                        fresnel_highlight(0.3, 0.5, 0.5, 10.0, 0.3), "highlight"));
    EXPECT_TRUE(exactly(cavity_f90(a).value(), cavity_f90(0.3), "cavity"));
    EXPECT_TRUE(exactly(immersed(a, n).value(), immersed(0.3, 1.5), "immersed"));
    EXPECT_TRUE(exactly(unity_surface(a, c).albedo.value(), unity_surface(0.3, 0.5).albedo, "unity"));
    EXPECT_TRUE(exactly(gltf_f0(n, a, c).value(), gltf_f0(1.5, 0.3, 0.5), "gltf"));
    EXPECT_TRUE(
        exactly(openpbr_surface(a, c, n, c).f0.value(), openpbr_surface(0.3, 0.5, 1.5, 0.5).f0, "openpbr"));
    EXPECT_TRUE(exactly(openpbr_eta(n, c).value(), openpbr_eta(1.5, 0.5), "openpbr_eta"));
    EXPECT_TRUE(exactly(disney_specular(disney_f0(a)).value(), disney_specular(disney_f0(0.3)), "disney"));
    EXPECT_TRUE(exactly(frostbite_reflectance(frostbite_f0(a)).value(),
                        frostbite_reflectance(frostbite_f0(0.3)), "frostbite"));
}

TEST(shading, agrees_in_float_and_in_50_digits) {
    const real50 c = real50(3) / 8;
    EXPECT_TRUE(within(opacity_slab(0.25f, 0.375f), 0.48658287f, 1e-7f, "float")); // 1 - e^(-2/3)
    EXPECT_TRUE(
        within_relative(opacity_slab(real50(1) / 4, c), real50(1 - exp(-real50(2) / 3)), 1e-50, "50"));
    EXPECT_TRUE(
        within_relative(opacity_slab(real50(1) / 8, c), real50(1 - exp(-real50(1) / 3)), 1e-16, "50"));
    EXPECT_TRUE(within_relative(immersed(real50(1) / 25, real50(4) / 3), real50(1) / 289, 1e-40, "50"));
}

} // namespace
} // namespace fresnel::test
