#include "command.hpp"
#include "inputs.hpp"
#include "tolerances.hpp"

#include "analysis/metalness.hpp"

#include <gtest/gtest.h>

#include <cmath>

namespace {

using namespace fresnel;

class convert : public test::command_test {};

// ---- ior and f0 -------------------------------------------------------------------------------------------

TEST_F(convert, an_index_is_its_f0_its_angles_and_its_sliders) {
    const auto c = json("convert ior 1.5 --json");
    EXPECT_NEAR(c["f0"], 0.04, 1e-15);
    EXPECT_EQ(c["srgb8"], 56);
    EXPECT_NEAR(c["other_n"], 1 / 1.5, 1e-15);
    EXPECT_NEAR(c["disney_specular"], 0.5, 1e-12);
    EXPECT_NEAR(c["frostbite_reflectance"], 0.5, 1e-12);
    EXPECT_NEAR(c["openpbr_specular_weight"], 1, 1e-12);
    EXPECT_NEAR(c["critical_inside"], 41.810314895778596, 1e-9);
    EXPECT_EQ(c["residual"], 0);
    const auto wet = json("convert ior 1.5 --ambient 1.333 --json");
    EXPECT_NEAR(wet["gltf_ior"], 1.5 / 1.333, 1e-15) << "glTF knows no medium outside";
}

TEST_F(convert, an_index_out_of_a_sliders_range_has_none) {
    const auto diamond = json("convert ior 2.417 --json");
    EXPECT_TRUE(diamond["disney_specular"].is_null());
    EXPECT_TRUE(diamond["frostbite_reflectance"].is_null());
    const auto gold = json("convert ior 0.18 --k 3.07 --json");
    EXPECT_TRUE(gold["other_n"].is_null());
    EXPECT_TRUE(gold["critical_inside"].is_null());
}

TEST_F(convert, an_f0_is_two_indices) {
    const auto c = json("convert f0 0.04 --json");
    EXPECT_NEAR(c["n"][0], 1.5, 1e-14);
    EXPECT_NEAR(c["n_below"][2], 2 / 3.0, 1e-14);
    EXPECT_LT(c["residual"], 1e-15);
    const auto wet = json("convert f0 0.04 --ambient 1.333 --json");
    EXPECT_NEAR(wet["n"][0], 1.333 * 1.5, 1e-14);
    EXPECT_TRUE(json("convert f0 1 --json")["n"][0].is_null());
}

TEST_F(convert, a_hex_is_decoded) {
    const auto c = json("convert f0 '#383838' --json");
    EXPECT_NEAR(c["f0"][0], std::pow((56 / 255.0 + 0.055) / 1.055, 2.4), 1e-12);
}

TEST_F(convert, of_indices_refuses_bad_use) {
    expect_refused("convert", {"ior", "f0", "metalness", "opacity"});
    expect_refused("convert ior 0", {"n = 0", "[0.001, 1000]"});
    expect_refused("convert ior glass", {"glass", "number"});
    expect_refused("convert ior 1.5 --ambient -1", {"--ambient", "-1"});
    expect_refused("convert f0 1.5", {"F0", "1.5", "[0, 1]"});
    expect_refused("convert f0 255 226 155", {"F0", "255", "HEX"});
    expect_refused("convert f0 255", {"F0", "255", "HEX"});
    expect_refused("convert f0 0.1 0.2", {"F0", "three"});
}

// ---- metalness --------------------------------------------------------------------------------------------

TEST_F(convert, metalness_forwards_is_the_law) {
    const auto c =
        json("convert metalness --law unreal --base 1 .77 .34 --metalness .5 --specular .5 --json");
    EXPECT_NEAR(c["f0"][0], 0.52, 1e-15);
    EXPECT_NEAR(c["albedo"][2], 0.17, 1e-15);
    const auto unity = json("convert metalness --law unity --base .5 --json");
    EXPECT_NEAR(unity["f0"][0], 0.04, 1e-15);
    EXPECT_NEAR(unity["albedo"][0], 0.48, 1e-15);
    const auto all = json("convert metalness --base .5 --specular .25 --json")["laws"];
    ASSERT_EQ(all.size(), 6u);
    for (const auto& law : all)
        EXPECT_EQ(law["specular"], law["law"] == "unity" ? nlohmann::json() : nlohmann::json(0.25)) << law;
}

TEST_F(convert, metalness_backwards_finds_what_forwards_took) {
    const auto c = json("convert metalness --law frostbite --f0 .3 .25 .2 --albedo .5 .4 .3 --json");
    EXPECT_TRUE(c.contains("residual"));
    const auto back = json("convert metalness --law unreal --f0 .52 .405 .19 --albedo .5 .385 .17 --json");
    EXPECT_NEAR(back["metalness"], 0.5, 1e-9);
    EXPECT_NEAR(back["base"][1], 0.77, 1e-9);
    EXPECT_NEAR(back["specular"], 0.5, 1e-6);
    EXPECT_LT(back["residual"], 1e-12);
}

TEST_F(convert, metalness_of_a_metal_outside_srgb_has_a_residual) {
    const auto gold = json("convert metalness --law gltf --f0 1.038 .730 .364 --albedo 0 --json");
    EXPECT_NEAR(gold["residual"], 0.038, 1e-3);
    EXPECT_NEAR(gold["metalness"], 1, 1e-6);
}

TEST_F(convert, metalness_refuses_bad_use) {
    expect_refused("convert metalness", {"--base", "--f0"});
    expect_refused("convert metalness --law disny --base .5", {"disny", "disney"});
    expect_refused("convert metalness --base .5 --metalness 2", {"--metalness", "2", "[0, 1]"});
    expect_refused("convert metalness --base 300 200 100", {"--base", "300", "HEX"});
    expect_refused("convert metalness --f0 .5", {"--f0", "--albedo"});
    expect_refused("convert metalness --f0 1.3 --albedo 0", {"--f0", "1.3", "[0, 1.2]"});
    expect_refused("convert metalness --f0 .5 --albedo .5 --metalness 1", {"--metalness"});
    expect_refused("convert metalness --base .5 --f0 .5 --albedo .5", {"--base", "--f0"});
    expect_refused("convert metalness --law unity --base .5 --specular .5", {"--specular .5", "unity"});
}

surface_colors random_surface(const metalness_law& law, test::random_numbers& random, metalness_values& v) {
    v = {{random.uniform(0, 1), random.uniform(0, 1), random.uniform(0, 1)},
         random.one_in(5) ? (random.one_in(2) ? 1.0 : 0.0) : random.uniform(0, 1),
         law.specular_max * random.uniform(0, 1)};
    if (random.one_in(7)) v.base[1] = v.base[2] = v.base[0];
    return to_surface(law, v);
}

TEST(metalness_fit, gives_back_what_a_law_can_express) {
    test::random_numbers random(17);
    for (const metalness_law& law : metalness_laws())
        for (int i = 0; i < 100; ++i) {
            metalness_values v{};
            const surface_colors s = random_surface(law, random, v);
            EXPECT_LE(from_surface(law, s).residual, 1e-9)
                << law.name << " " << v.metalness << " " << v.specular;
        }
}

TEST(metalness_fit, finds_the_parameters_where_they_are_determined) {
    test::random_numbers random(18);
    for (const metalness_law& law : metalness_laws())
        for (int i = 0; i < 30; ++i) {
            const metalness_values v{{0.9, random.uniform(0.3, 0.6), 0.1},
                                     random.uniform(0.2, 0.8),
                                     law.specular_max * random.uniform(0.2, 0.8)};
            const metalness_fit found = from_surface(law, to_surface(law, v));
            EXPECT_NEAR(found.values.metalness, v.metalness, 1e-6) << law.name;
            EXPECT_NEAR(found.values.base[1], v.base[1], 1e-6) << law.name;
        }
}

TEST(metalness_fit, keeps_the_default_where_many_answers_are_right) {
    const metalness_law& law = find_metalness_law("unreal");
    const metalness_fit gray = from_surface(law, {{0.04, 0.04, 0.04}, {0.5, 0.5, 0.5}});
    EXPECT_NEAR(gray.values.metalness, 0, 1e-9);
    EXPECT_EQ(gray.values.specular, 0.5);
    const metalness_fit metal = from_surface(law, {{1, 0.77, 0.34}, {0, 0, 0}});
    EXPECT_NEAR(metal.values.metalness, 1, 1e-9);
    EXPECT_NEAR(metal.values.base[2], 0.34, 1e-9);
}

TEST(metalness_fit, is_no_worse_than_the_best_of_a_dense_grid_where_a_law_cannot) {
    test::random_numbers random(19);
    const auto error = [](const surface_colors& a, const surface_colors& b) {
        double sum = 0;
        for (std::size_t i = 0; i < 3; ++i)
            sum += std::pow(a.f0[i] - b.f0[i], 2) + std::pow(a.albedo[i] - b.albedo[i], 2);
        return sum;
    };
    for (const metalness_law& law : metalness_laws())
        for (int i = 0; i < 4; ++i) {
            surface_colors s{};
            for (std::size_t c = 0; c < 3; ++c)
                s.f0[c] = random.uniform(0, 1), s.albedo[c] = random.uniform(0, 1);
            const double ours = error(from_surface(law, s).reproduced, s);
            double grid = 10;
            for (int m = 0; m <= 50; ++m)
                for (int p = 0; p <= (law.specular_max > 0 ? 20 : 0); ++p) {
                    surface_colors best{};
                    for (std::size_t c = 0; c < 3; ++c) { // channels are independent once m and p are chosen
                        double least = 10;
                        for (int b = 0; b <= 50; ++b) {
                            const surface_colors t = to_surface(
                                law, {{b / 50.0, b / 50.0, b / 50.0}, m / 50.0, law.specular_max * p / 20});
                            const double e =
                                std::pow(t.f0[c] - s.f0[c], 2) + std::pow(t.albedo[c] - s.albedo[c], 2);
                            if (e < least) least = e, best.f0[c] = t.f0[c], best.albedo[c] = t.albedo[c];
                        }
                    }
                    grid = std::min(grid, error(best, s));
                }
            EXPECT_LE(ours, grid + 1e-12) << law.name;
        }
}

// ---- opacity ----------------------------------------------------------------------------------------------

TEST_F(convert, opacity_finds_the_attenuation_and_the_total) {
    const auto c = json("convert opacity --total 0.2 --fresnel 0.04 --theta 0,60,90 --json");
    EXPECT_NEAR(c["attenuation"], 1 / 6.0, 1e-15);
    EXPECT_NEAR(c["angles"][0]["total"], 0.2, 1e-15);
    EXPECT_NEAR(c["angles"][1]["attenuation"], 1 / 3.0, 1e-15);
    EXPECT_EQ(c["angles"][2]["total"], 1.0);
    EXPECT_NEAR(json("convert opacity --attenuation 0.5 --fresnel 0.5 --json")["total"], 0.75, 1e-15);
}

TEST_F(convert, opacity_refuses_more_by_reflection_than_in_total_naming_both) {
    expect_refused("convert opacity --total 0.1 --fresnel 0.2", {"--fresnel", "0.2", "0.1", "total"});
    expect_refused("convert opacity --fresnel 0.2", {"--total", "--attenuation"});
    expect_refused("convert opacity --total 2 --fresnel 0.2", {"--total", "2", "[0, 1]"});
    expect_refused("convert opacity --total .2", {"--fresnel"});
    expect_refused("convert opacity --total .2 --fresnel .1 --theta 100", {"theta", "100"});
}

} // namespace
