// Errors, ranks and the report that is made of them.

#include "analysis/compare.hpp"

#include "command.hpp"
#include "materials/observer.hpp"

#include <png.h>

#include <cmath>

namespace {

using namespace fresnel;

// Schlick's largest error in linear sRGB as measured before this project, with fitted colour-matching functions.
TEST(compare, schlick_misses_metals_by_what_was_measured_elsewhere) {
    const std::vector<std::pair<const char*, double>> known = {{"iron", 0.178},     {"chromium", 0.200},
                                                               {"vanadium", 0.232}, {"tungsten", 0.214},
                                                               {"copper", 0.043},   {"magnesium", 0.045}};
    for (const auto& [name, error] : known)
        EXPECT_NEAR(compare(*find_material(name), color_space::srgb, 1).find("schlick")->error.worst(), error,
                    0.005)
            << name;
}

TEST(compare, errors_are_those_of_the_curves) {
    const comparison result = compare(*find_material("iron"), color_space::acescg, 1.2);
    for (const model_fit& m : result.models)
        for (std::size_t c = 0; c < 3; ++c) {
            double largest = 0;
            for (std::size_t a = 0; a < m.curve.size(); ++a)
                largest = std::max(largest, std::abs(m.curve[a][c] - result.exact.value[a][c]));
            EXPECT_EQ(m.error.max[c], largest) << m.name;
            EXPECT_LE(m.error.rms[c], m.error.max[c]) << m.name;
            EXPECT_LE(m.error.cosine[c], m.error.max[c]) << m.name;
        }
}

TEST(compare, ranks_by_the_largest_error_and_recommends_nothing_that_is_beaten_at_its_price) {
    for (const char* name : {"copper", "gold", "iron", "water", "n-bk7", "skin", "silicon"}) {
        const comparison result = compare(*find_material(name), color_space::srgb, 1);
        for (std::size_t i = 0; i < result.models.size(); ++i) {
            EXPECT_EQ(result.models[i].rank, static_cast<int>(i) + 1);
            if (i == 0) continue;
            EXPECT_GE(result.models[i].error.worst(), result.models[i - 1].error.worst());
        }
        const model_fit& best = result.best_choice();
        const double limit = best.error.delta_e_max <= invisible ? invisible : slight;
        for (const model_fit& m : result.models) {
            const bool artistic = find_model<double>(m.name).kind == model_kind::artistic;
            EXPECT_TRUE(artistic || m.cost >= best.cost || m.error.delta_e_max > limit)
                << name << " " << m.name;
        }
    }
}

// A conductor reflects everything at grazing incidence, which in XYZ is white and not (1, 1, 1).
TEST(compare, in_xyz_is_relative_to_its_white) {
    for (const char* name : {"copper", "gold", "iron", "n-bk7"}) {
        const comparison srgb = compare(*find_material(name), color_space::acescg, 1);
        const comparison xyz = compare(*find_material(name), color_space::xyz, 1);
        for (const model_fit& m : xyz.models) {
            const rgb grazing = m.curve.back(), exact = xyz.exact.value.back();
            for (std::size_t i = 0;
                 i < 3 && m.name != "constant" && m.name != "bias_scale_power" && m.name != "schlick_f90";
                 ++i)
                EXPECT_NEAR(grazing[i], exact[i], 1e-12) << name << " " << m.name;
        }
        const char* exact_model = name == std::string("n-bk7") ? "dielectric" : "conductor";
        EXPECT_LT(xyz.find(exact_model)->error.worst(), 0.02) << name;
        EXPECT_NEAR(xyz.best_choice().error.delta_e_max, srgb.best_choice().error.delta_e_max, 1) << name;
        for (std::size_t i = 0; i < 3; ++i) {
            EXPECT_NEAR(xyz.colour.gulbrandsen_r[i], xyz.colour.f0[i] / xyz.exact.value.back()[i], 1e-12);
            EXPECT_LE(xyz.colour.f82_tint[i], 1) << name;
        }
    }
}

TEST(compare, a_dielectric_is_exact_with_an_index_per_channel) {
    for (const char* name : {"n-bk7", "diamond", "water"}) {
        const comparison result = compare(*find_material(name), color_space::srgb, 1);
        const model_fit* m = result.find("dielectric");
        ASSERT_NE(m, nullptr);
        EXPECT_LT(m->error.worst(), 1e-3) << name;
    }
}

TEST(compare, finds_the_largest_error_between_the_critical_angles_of_a_spectrum) {
    const material& water = *find_material("water");
    const comparison c = compare(water, color_space::srgb, 1.5);
    const model_fit& m = *c.find("dielectric");
    for (double theta = 61; theta < 64; theta += 0.007) {
        const rgb exact = colour_at(water, color_space::srgb, 1.5, cosine_of_degrees(theta));
        for (std::size_t i = 0; i < 3; ++i) {
            const double model = evaluate("dielectric", m.values[i], {cosine_of_degrees(theta)})[0];
            EXPECT_LE(std::abs(model - exact[i]), m.error.max[i] + 2e-3) << theta << " " << i;
        }
    }
    EXPECT_NEAR(m.error.max[0], 0.184, 2e-3);
    EXPECT_NEAR(m.error.delta_e_max, 8.1, 0.1);
}

TEST(compare, a_medium_against_itself_reflects_nothing) {
    const comparison result = compare(*find_material("vacuum"), color_space::srgb, 1);
    EXPECT_EQ(result.surface, surface_class::matched);
    EXPECT_EQ(result.best_choice().error.worst(), 0);
}

// ---- the report ---------------------------------------------------------------------------------------------

using report = test::command_test;

std::array<std::uint8_t, 3> first_pixel_of_the_top_strip(const std::string& path, const rgb8& wanted) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << path;
    image.format = PNG_FORMAT_RGB;
    std::vector<std::uint8_t> pixels(PNG_IMAGE_SIZE(image));
    png_image_finish_read(&image, nullptr, pixels.data(), 0, nullptr);
    // from the top: the first row with a long run of colour is the exact strip; its first coloured pixel counts
    for (std::size_t y = image.height / 20; y < image.height; ++y) {
        const std::uint8_t* row = pixels.data() + 3 * y * image.width;
        std::size_t run = 0;
        for (std::size_t x = 0; x < image.width; ++x) {
            const bool close = std::abs(row[3 * x] - wanted[0]) + std::abs(row[3 * x + 1] - wanted[1]) +
                                   std::abs(row[3 * x + 2] - wanted[2]) <
                               24;
            run = close ? run + 1 : 0;
            if (run == 100) {
                const std::uint8_t* first = row + 3 * (x - 99);
                return {first[0], first[1], first[2]};
            }
        }
    }
    return {0, 0, 0};
}

TEST_F(report, has_its_files_its_keys_and_strips_that_begin_with_f0) {
    const auto result = run("compare copper skin --out out");
    ASSERT_EQ(result.code, 0) << result.err;
    for (const char* name : {"copper", "skin"})
        for (const char* kind : {"curves", "errors", "strips", "surface"})
            for (const char* ending : {"svg", "png"})
                EXPECT_TRUE(std::filesystem::exists(folder / "work/out/figures" /
                                                    (std::string(name) + "-" + kind + "." + ending)));
    const nlohmann::json all = nlohmann::json::parse(test::read_text(folder / "work/out/report.json"));
    ASSERT_EQ(all["materials"].size(), 2u);
    for (const nlohmann::json& m : all["materials"]) {
        for (const char* key : {"name", "page", "space", "f0", "models"})
            EXPECT_TRUE(m.contains(key)) << key;
        for (const nlohmann::json& one : m["models"])
            for (const char* key :
                 {"name", "rank", "parameters", "max_error", "rms_error", "cosine_error", "delta_e_max"})
                EXPECT_TRUE(one.contains(key)) << key;
        for (const nlohmann::json& one : m["models"])
            if (one.contains("least_squares")) {
                for (std::size_t c = 0; c < 3; ++c)
                    EXPECT_LE(one["least_squares"]["rms_error"][c], one["rms_error"][c]) << one["name"];
            }
    }
    const rgb8 f0 = encode_srgb8(colour_at_normal(*find_material("copper"), color_space::srgb, 1).f0);
    const auto first =
        first_pixel_of_the_top_strip((folder / "work/out/figures/copper-strips.png").string(), f0);
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(first[c], f0[c], 1) << "strip of copper, component " << c;
}

TEST_F(report, page_needs_no_other_file_and_says_what_to_use) {
    ASSERT_EQ(run("compare copper --out out").code, 0);
    const std::string page = test::read_text(folder / "work/out/index.html");
    for (const char* outside : {"src=", "<link", "<script", "url(http", "@import"})
        EXPECT_EQ(page.find(outside), std::string::npos) << outside;
    EXPECT_NE(page.find(verdict(compare(*find_material("copper"), color_space::srgb, 1)).substr(0, 20)),
              std::string::npos);
    EXPECT_NE(page.find("prefers-color-scheme"), std::string::npos);
}

TEST_F(report, files_of_one_name_have_figures_of_their_own_and_one_material_has_one_entry) {
    for (const char* dir : {"d1", "d2"}) {
        std::filesystem::create_directory(folder / "work" / dir);
        write(std::string(dir) + "/a.csv", "wavelength_nm,n,k\n500,0.5,3\n600,0.4,3\n");
    }
    EXPECT_EQ(run("compare d1/a.csv d2/a.csv --out out").code, 0);
    for (const char* name : {"a-csv-curves.svg", "a-csv-2-curves.svg"})
        EXPECT_TRUE(std::filesystem::exists(folder / "work/out/figures" / name)) << name;
    EXPECT_EQ(json("compare copper copper --json")["materials"].size(), 1u);
}

TEST_F(report, is_the_same_text_json_and_file) {
    const nlohmann::json printed = json("compare iron --json --space acescg --ambient 1.33");
    ASSERT_EQ(run("compare iron --space acescg --ambient 1.33 --out out").code, 0);
    EXPECT_EQ(printed, nlohmann::json::parse(test::read_text(folder / "work/out/report.json")));
    EXPECT_EQ(printed["materials"][0]["space"], "acescg");
}

} // namespace
