// What an F0 could be: its class, the nearest materials, and the warnings.

#include "analysis/identify.hpp"

#include "command.hpp"

#include "analysis/curve.hpp"
#include "materials/catalog.hpp"
#include "materials/observer.hpp"
#include "tolerances.hpp"

#include <cmath>

namespace {

using namespace fresnel;
using identifying = test::command_test;

std::string warnings(const nlohmann::json& found) {
    std::string all;
    for (const nlohmann::json& one : found["warnings"])
        all += one.get<std::string>() + "\n";
    return all;
}

bool mentions(const nlohmann::json& found, const std::string& words) {
    return warnings(found).find(words) != std::string::npos;
}

std::string first(const nlohmann::json& found) { return found["nearest"][0]["material"]; }

TEST(identify, the_classes_meet_at_the_bounds_of_the_published_tables) {
    const std::vector<std::pair<double, std::string>> bounds = {
        {0.02, "dielectric"}, {0.08, "gem"}, {0.2, "semiconductor"}, {0.45, "metal"}};
    std::string below = "submerged or coated";
    for (const auto& [bound, above] : bounds) {
        EXPECT_EQ(class_of_f0(bound), above);
        EXPECT_EQ(class_of_f0(std::nextafter(bound, 0)), above) << "rounding decides";
        EXPECT_EQ(class_of_f0(bound - 1e-6), below);
        below = above;
    }
}

TEST(identify, every_material_is_nearest_to_itself) {
    for (const material& m : builtin_materials()) {
        if (has_range(m)) continue;
        const identification found =
            identify(colour_at(m, color_space::acescg, 1, 1), color_space::acescg, 1, f0_source::numbers, 3);
        const bool there = std::any_of(found.nearest.begin(), found.nearest.end(),
                                       [&](const neighbour& n) { return n.substance == &m; });
        EXPECT_TRUE(there) << m.name;
        EXPECT_LT(found.nearest.front().delta_e, 1e-6) << m.name;
    }
}

TEST(identify, a_range_is_at_no_distance_inside_and_at_its_end_outside) {
    const material& stone = *find_material("stone"); // 0.035 to 0.056
    const auto distance = [&](double f0) {
        const identification found =
            identify(grey(f0, color_space::srgb), color_space::srgb, 1, f0_source::numbers, 200);
        for (const neighbour& n : found.nearest)
            if (n.substance == &stone) return std::pair(n.delta_e, n.f0[1]);
        return std::pair(-1.0, -1.0);
    };
    EXPECT_LT(distance(0.04).first, 1e-6);
    EXPECT_NEAR(distance(0.04).second, 0.04, 1e-9);
    EXPECT_NEAR(distance(0.02).second, 0.035, 1e-9);
    EXPECT_NEAR(distance(0.02).first,
                delta_e_2000(rgb{0.02, 0.02, 0.02}, rgb{0.035, 0.035, 0.035}, color_space::srgb), 1e-6);
    EXPECT_NEAR(distance(0.2).second, 0.056, 1e-9);
}

TEST(identify, the_space_of_a_colour_does_not_change_its_class_nor_its_neighbours) {
    const rgb copper = colour_at(*find_material("copper"), color_space::srgb, 1, 1);
    for (const color_space space : {color_space::p3, color_space::rec2020, color_space::xyz}) {
        const identification found = identify(from_srgb(copper, space), space, 1, f0_source::numbers, 1);
        EXPECT_EQ(found.surface, "metal");
        EXPECT_EQ(found.nearest[0].substance->name, "copper") << to_string(space);
    }
}

TEST(identify, srgb_comes_back_through_every_space) {
    for (const color_space space : {color_space::p3, color_space::acescg, color_space::xyz})
        for (std::size_t c = 0; c < 3; ++c) {
            const rgb gold = {1.04, 0.73, 0.36};
            EXPECT_TRUE(test::within(to_srgb(from_srgb(gold, space), space)[c], gold[c], 1e-12, "gold"));
        }
}

TEST_F(identifying, the_answer_has_its_keys) {
    const nlohmann::json found = json("identify 0.04 --json");
    for (const char* key : {"class", "nearest", "warnings", "f0", "space", "ambient", "luminance", "hex"})
        EXPECT_TRUE(found.contains(key)) << key;
    EXPECT_EQ(found["nearest"].size(), 5u);
    EXPECT_EQ(json("identify 0.04 --count 12 --json")["nearest"].size(), 12u);
    for (const char* key : {"material", "delta_e", "f0", "class", "page"})
        EXPECT_TRUE(found["nearest"][0].contains(key)) << key;
}

TEST_F(identifying, the_code_of_gold_is_gold) {
    const std::string code = json("f0 gold --json")["hex"];
    for (const std::string space : {"srgb", "acescg"}) {
        const nlohmann::json found = json("identify '" + code + "' --json --space " + space);
        EXPECT_EQ(found["class"], "metal");
        EXPECT_EQ(first(found), "gold");
        EXPECT_EQ(found["hex"], code);
        EXPECT_TRUE(found["warnings"].empty()) << warnings(found);
    }
    EXPECT_EQ(first(json("identify '#ffe29b' --json")).substr(0, 4),
              "gold"); // Real-Time Rendering, table 9.2
    EXPECT_EQ(first(json("identify ffdea3 --json")), "gold");
}

TEST_F(identifying, distances_rise) {
    const nlohmann::json found = json("identify 0.9 0.6 0.4 --count 167 --json");
    for (std::size_t i = 1; i < found["nearest"].size(); ++i)
        EXPECT_LE(found["nearest"][i - 1]["delta_e"].get<double>(),
                  found["nearest"][i]["delta_e"].get<double>() + 1e-6);
}

TEST_F(identifying, an_ordinary_dielectric_gives_no_warning) {
    const nlohmann::json found = json("identify 0.04 --json");
    EXPECT_EQ(found["class"], "dielectric");
    EXPECT_TRUE(found["warnings"].empty()) << warnings(found);
    EXPECT_TRUE(json("identify '#383838' --json")["warnings"].empty());
}

TEST_F(identifying, an_index_gives_the_f0_of_fresnel) {
    const nlohmann::json diamond = json("identify --ior 2.417 --json");
    EXPECT_EQ(diamond["class"], "gem");
    EXPECT_EQ(first(diamond).substr(0, 7), "diamond");
    EXPECT_NEAR(diamond["f0"][0].get<double>(), 1.417 * 1.417 / (3.417 * 3.417), 1e-15);
    const nlohmann::json wet = json("identify --ior 1.5 --ambient 1.333 --json");
    EXPECT_EQ(wet["class"], "submerged or coated");
    EXPECT_TRUE(wet["warnings"].empty()) << warnings(wet);
}

TEST_F(identifying, each_warning_appears_where_it_belongs_and_names_the_number) {
    EXPECT_TRUE(mentions(json("identify 0.009 --json"), "F0 0.009 is below 0.02"));
    EXPECT_FALSE(mentions(json("identify 0.02 --json"), "below"));
    EXPECT_TRUE(mentions(json("identify 0.3 --json"), "F0 0.3 lies between 0.2 and 0.45"));
    EXPECT_TRUE(mentions(json("identify 0.22 --json"), "sRGB code of 0.03968"));
    EXPECT_FALSE(mentions(json("identify 0.4 --json"), "sRGB code")) << "decodes to no dielectric";
    EXPECT_FALSE(mentions(json("identify 0.78 --json"), "sRGB code")) << "a metal as it stands";
    EXPECT_FALSE(mentions(json("identify '#818181' --json"), "sRGB code")) << "was decoded";
    EXPECT_TRUE(mentions(json("identify 0.08 0.04 0.02 --json"), "has a colour (chroma"));
    EXPECT_TRUE(mentions(json("identify 0.999 --json"), "more than the brightest built-in metal, silver"));
    EXPECT_TRUE(mentions(json("identify 1.04 0.73 0.36 --json"), "lies outside [0, 1]"));
    EXPECT_TRUE(mentions(json("identify 1.15 0.8 0.4 --json"), "exceeds 1.1"));
    EXPECT_TRUE(mentions(json("identify 0.2 0.9 0.1 --json"), "No built-in material is near"));
}

TEST_F(identifying, a_nearest_dataset_that_is_no_measurement_is_named) {
    const rgb computed = colour_at(*find_material("gold-rakic-ld"), color_space::srgb, 1, 1);
    const nlohmann::json found = json("identify --json " + std::to_string(computed[0]) + " " +
                                      std::to_string(computed[1]) + " " + std::to_string(computed[2]));
    EXPECT_TRUE(mentions(found, "gold-rakic-ld, is to be taken with care (Model, not measurement"));
}

TEST_F(identifying, text_names_the_class_the_dataset_and_the_warnings) {
    const std::string text = run("identify 1.04 0.73 0.36").out;
    for (const char* piece : {"metal", "main/Au/nk/Johnson", "warning: ", "gold", "CIE 1931"})
        EXPECT_NE(text.find(piece), std::string::npos) << piece << "\n" << text;
}

TEST_F(identifying, what_is_no_f0_is_refused) {
    expect_refused("identify", {"R G B", "HEX", "--ior"});
    expect_refused("identify 0.1 0.2", {"2 values", "R G B"});
    expect_refused("identify 255 226 155", {"F0 = 255", "[-0.2, 1.2]", "HEX"});
    expect_refused("identify 1.3", {"F0 = 1.3", "HEX"});
    expect_refused("identify shiny", {"shiny", "number"});
    expect_refused("identify nan", {"nan", "[-0.2, 1.2]"});
    expect_refused("identify '#12345'", {"#12345", "six digits"});
    expect_refused("identify --ior 0", {"ior = 0", "[0.001, 1000]"});
    expect_refused("identify 0.04 --ior 1.5", {"--ior", "not both"});
    expect_refused("identify 0.04 --count 0", {"--count = 0", "[1, "});
    expect_refused("identify 0.04 --count 2.5", {"--count = 2.5", "whole"});
    expect_refused("identify 0.04 --space rgb", {"rgb", "srgb"});
}

} // namespace
