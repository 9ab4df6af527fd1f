// Plots: what is drawn, against what, in which format, and what is refused.

#include "command.hpp"

#include "analysis/curve.hpp"
#include "analysis/drawing.hpp"
#include "materials/catalog.hpp"
#include "tolerances.hpp"

#include <cmath>
#include <limits>
#include <map>

namespace {

using namespace fresnel;

/// A table of numbers with named columns; an empty cell is a NaN.
struct table {
    std::vector<std::string> names;
    std::map<std::string, std::vector<double>> column;
};

std::vector<std::string> split(const std::string& text, char at) {
    std::vector<std::string> pieces;
    std::istringstream stream(text);
    for (std::string piece; std::getline(stream, piece, at);)
        pieces.push_back(piece);
    return pieces;
}

table read_table(const std::string& csv) {
    const std::vector<std::string> lines = split(csv, '\n');
    table result{split(lines.at(0), ','), {}};
    for (std::size_t i = 1; i < lines.size(); ++i) {
        const std::vector<std::string> cells = split(lines[i], ',');
        for (std::size_t c = 0; c < cells.size(); ++c)
            result.column[result.names.at(c)].push_back(
                cells[c].empty() ? std::numeric_limits<double>::quiet_NaN() : std::stod(cells[c]));
    }
    return result;
}

class plots : public test::command_test {
protected:
    table csv(const std::string& arguments) const {
        const test::outcome result = run("plot " + arguments);
        EXPECT_EQ(result.code, 0) << arguments << "\n" << result.err;
        return read_table(result.out);
    }
    std::vector<double> evaluated(const std::string& arguments, const std::string& key) const {
        std::vector<double> values;
        std::string angles = "0"; // every quarter of a degree, without the rounding of a range
        for (int i = 1; i <= 360; ++i)
            angles += "," + std::to_string(i / 4.0);
        const nlohmann::json all = json("eval " + arguments + " --json --theta " + angles);
        for (const nlohmann::json& one : all["results"])
            values.push_back(one[key]);
        return values;
    }
    std::string written(const std::string& name) const { return test::read_text(folder / "work" / name); }
};

double largest(const std::vector<double>& values) {
    double most = 0;
    for (const double v : values)
        most = std::max(most, std::abs(v));
    return most;
}

// ---- values -------------------------------------------------------------------------------------------------

TEST_F(plots, columns_are_what_eval_gives) {
    const table t = csv("dielectric schlick --n-t 1.5 --f0 0.04");
    EXPECT_EQ(t.names, (std::vector<std::string>{"angle of incidence θ (degrees)", "dielectric", "schlick"}));
    EXPECT_EQ(t.column.at("dielectric"), evaluated("dielectric --n-t 1.5", "R"));
    EXPECT_EQ(t.column.at("schlick"), evaluated("schlick --f0 0.04", "R"));
    EXPECT_EQ(t.column.at(t.names[0]).size(), 361u);
}

TEST_F(plots, polarizations_are_those_of_eval_and_their_mean) {
    const table t = csv("conductor --n-t 0.2 --k-t 3 --polarization s,p,r");
    EXPECT_EQ(t.column.at("conductor s"), evaluated("conductor --n-t 0.2 --k-t 3", "Rs"));
    EXPECT_EQ(t.column.at("conductor p"), evaluated("conductor --n-t 0.2 --k-t 3", "Rp"));
    EXPECT_EQ(t.column.at("conductor mean"), evaluated("conductor --n-t 0.2 --k-t 3", "R"));
}

TEST_F(plots, a_material_is_its_exact_curve_in_every_space) {
    for (const color_space space : {color_space::srgb, color_space::acescg}) {
        const table t = csv("copper --ambient 1.33 --space " + std::string(to_string(space)));
        const rgb_curve exact = exact_curve(*find_material("copper"), space, 1.33);
        for (std::size_t a = 0; a < exact.value.size(); ++a)
            for (std::size_t c = 0; c < 3; ++c)
                EXPECT_EQ(t.column.at(t.names[c + 1])[a], exact.value[a][c]);
    }
    EXPECT_EQ(csv("copper").names, (std::vector<std::string>{"angle of incidence θ (degrees)", "copper R",
                                                             "copper G", "copper B"}));
}

TEST_F(plots, s_and_p_of_a_colour_average_to_the_colour) {
    const table t = csv("gold --polarization s,p,r");
    for (const std::string channel : {" R", " G", " B"})
        for (std::size_t a = 0; a < 361; ++a)
            EXPECT_NEAR((t.column.at("gold s" + channel)[a] + t.column.at("gold p" + channel)[a]) / 2,
                        t.column.at("gold mean" + channel)[a], 1e-14);
}

TEST_F(plots, one_wavelength_is_the_boundary_of_its_index) {
    const table t = csv("copper --wavelength 650");
    EXPECT_EQ(t.column.at("copper"), evaluated("conductor --material copper --wavelength 650", "R"));
}

TEST_F(plots, a_colourless_material_is_one_curve) {
    EXPECT_EQ(csv("n-bk7").names.size(), 2u);
    EXPECT_EQ(csv("copper").names.size(), 4u);
    // the luminance of a glass is near its reflectance at 555 nm, the peak of the eye
    EXPECT_NEAR(csv("n-bk7").column.at("n-bk7")[0], csv("n-bk7 --wavelength 555").column.at("n-bk7")[0],
                1e-4);
}

TEST_F(plots, the_middle_of_a_range_lies_between_its_ends) {
    const table t = csv("stone");
    ASSERT_EQ(t.names.size(), 4u);
    EXPECT_NEAR(t.column.at("stone")[0], (0.035 + 0.056) / 2, 1e-6);
    EXPECT_NEAR(t.column.at("stone low end")[0], 0.035, 1e-6);
    EXPECT_NEAR(t.column.at("stone high end")[0], 0.056, 1e-6);
}

TEST_F(plots, the_axis_counts_degrees_cosines_or_sines) {
    const table degrees = csv("schlick"), cosines = csv("schlick --against cos"),
                sines = csv("schlick --against sin");
    EXPECT_EQ(cosines.names[0], "cos θ");
    EXPECT_EQ(sines.names[0], "sin θ");
    EXPECT_EQ(degrees.column.at("schlick"), cosines.column.at("schlick"));
    for (std::size_t a = 0; a < 361; ++a) {
        const double c = cosines.column.at("cos θ")[a], s = sines.column.at("sin θ")[a];
        EXPECT_NEAR(c * c + s * s, 1, 1e-15);
        EXPECT_NEAR(c, std::cos(degrees.column.at(degrees.names[0])[a] * std::acos(-1.0) / 180), 1e-15);
    }
}

// ---- fits, errors, families ---------------------------------------------------------------------------------

TEST_F(plots, a_model_beside_a_material_is_fitted_to_it_as_by_compare) {
    const table t = csv("copper schlick f82");
    const nlohmann::json models = json("compare copper --json")["materials"][0]["models"];
    const table error = csv("copper schlick f82 --error");
    for (const nlohmann::json& m : models) {
        if (m["name"] != "schlick" && m["name"] != "f82") continue;
        const std::string name = m["name"];
        EXPECT_NEAR(largest(error.column.at(name + " R")), m["max_error"][0].get<double>(), 1e-12) << name;
        EXPECT_NEAR(largest(error.column.at(name + " B")), m["max_error"][2].get<double>(), 1e-12) << name;
    }
    EXPECT_NEAR(t.column.at("schlick G")[0], t.column.at("copper G")[0], 1e-12);
    EXPECT_EQ(csv("schlick --fit copper").column.at("schlick G"), t.column.at("schlick G"));
    EXPECT_EQ(csv("copper schlick --f0 0.5").column.at("schlick")[0], 0.5) << "what is given is not fitted";
}

TEST_F(plots, in_xyz_a_model_is_relative_to_white_as_by_compare) {
    const nlohmann::json models = json("compare copper --space xyz --json")["materials"][0]["models"];
    const table t = csv("copper schlick --space xyz"), error = csv("schlick --error copper --space xyz");
    const auto schlick =
        std::find_if(models.begin(), models.end(), [](const auto& m) { return m["name"] == "schlick"; });
    EXPECT_NEAR(largest(error.column.at("schlick Z")), (*schlick)["max_error"][2].get<double>(), 1e-12);
    EXPECT_NEAR(t.column.at("schlick Z").back(), t.column.at("copper Z").back(), 1e-12);
}

TEST_F(plots, an_approximation_beside_an_exact_model_is_fitted_to_it) {
    const double f0 = 1.4 * 1.4 / (3.4 * 3.4); // ((2.4 - 1) / (2.4 + 1))^2
    EXPECT_NEAR(csv("dielectric schlick --n-t 2.4").column.at("schlick")[0], f0, 1e-12);
}

TEST_F(plots, an_error_is_the_difference_of_the_curves) {
    const table curves = csv("gold schlick gulbrandsen"), error = csv("schlick gulbrandsen --error gold");
    EXPECT_EQ(error.names.size(), 7u) << "the reference itself is not drawn";
    for (const std::string name : {"schlick", "gulbrandsen"})
        for (const std::string channel : {" R", " G", " B"})
            for (std::size_t a = 0; a < 361; ++a)
                EXPECT_EQ(error.column.at(name + channel)[a],
                          curves.column.at(name + channel)[a] - curves.column.at("gold" + channel)[a]);
    EXPECT_NEAR(largest(csv("dielectric schlick --error").column.at("schlick")), 0.0358, 1e-3)
        << "Schlick's error at 85 degrees on glass";
}

TEST_F(plots, a_family_has_a_curve_for_each_value) {
    const table t = csv("dielectric --family n_t=1.1,1.5,2.5");
    ASSERT_EQ(t.names.size(), 4u);
    EXPECT_EQ(t.column.at("dielectric n_t = 1.5"), evaluated("dielectric --n-t 1.5", "R"));
    EXPECT_EQ(csv("dielectric --family n-t=1.1:2.5:8").names.size(), 9u);
    const nlohmann::json figure = json("plot bias_scale_power --family bias=0:0.5:6 --json");
    EXPECT_EQ(figure["series"][0]["label"], "bias = 0");
    EXPECT_EQ(figure["series"][5]["label"], "bias = 0.5");
    EXPECT_NE(figure["series"][0]["color"], figure["series"][5]["color"]);
}

TEST_F(plots, the_error_of_a_family_follows_its_reference) {
    const table t = csv("schlick --error dielectric --family n_t=1.3,1.5,2.4");
    for (const std::string n : {"1.3", "1.5", "2.4"})
        EXPECT_NEAR(t.column.at("schlick n_t = " + n)[0], 0, 1e-12) << "f0 is that of each index";
    EXPECT_GT(largest(t.column.at("schlick n_t = 1.3")), largest(t.column.at("schlick n_t = 1.5")));
}

TEST_F(plots, a_family_over_a_coloured_material_has_a_panel_for_each_channel) {
    const nlohmann::json figure = json("plot copper schlick_power --family power=3,5 --json");
    EXPECT_EQ(figure["series"].back()["panel"], 2);
    EXPECT_EQ(figure["series"].size(), 9u);
}

TEST_F(plots, exact_n_i_is_the_ambient_index) {
    EXPECT_EQ(csv("dielectric --n-t 1.5 --ambient 1.333").column.at("dielectric"),
              evaluated("dielectric --n-t 1.5 --n-i 1.333", "R"));
}

// ---- looks --------------------------------------------------------------------------------------------------

TEST_F(plots, channels_keep_their_colours_and_models_their_dashes) {
    const nlohmann::json series = json("plot copper schlick f82 --json")["series"];
    for (std::size_t c = 0; c < 3; ++c)
        for (std::size_t m = 0; m < 3; ++m)
            EXPECT_EQ(series[3 * m + c]["color"], channel_colors[c]);
    EXPECT_EQ(series[0]["style"], "solid");
    EXPECT_EQ(series[3]["style"], "dashed");
    EXPECT_EQ(series[6]["style"], "dotted");
    EXPECT_EQ(series[0]["label"], "copper R");
    EXPECT_EQ(series[4]["label"], "");
    EXPECT_EQ(series[4]["name"], "schlick G");
}

TEST_F(plots, the_axis_holds_every_curve) {
    for (const std::string what :
         {"gold schlick", "silver", "dielectric", "gold schlick --error", "schlick"}) {
        const nlohmann::json figure = json("plot " + what + " --json");
        for (const nlohmann::json& s : figure["series"])
            for (const double y : s["y"].get<std::vector<double>>()) {
                EXPECT_GE(y, s["y_axis"]["lo"].get<double>()) << what;
                EXPECT_LE(y, s["y_axis"]["hi"].get<double>()) << what;
            }
    }
    EXPECT_GE(json("plot silver --json")["series"][0]["y_axis"]["lo"].get<double>(), 0.8);
}

TEST_F(plots, strips_begin_with_the_colour_of_normal_incidence) {
    const nlohmann::json copper = json("f0 copper --json")["srgb8"];
    const nlohmann::json strips = json("plot copper schlick --strip --json")["strips"];
    ASSERT_EQ(strips.size(), 2u);
    EXPECT_EQ(strips[0]["srgb8"].front(), copper);
    EXPECT_EQ(strips[0]["srgb8"].back(), (std::vector<int>{255, 255, 255}));
    const nlohmann::json by_cosine = json("plot copper --strip --against cos --json")["strips"];
    EXPECT_EQ(by_cosine[0]["srgb8"].back(), copper) << "cos θ = 1 is at the right";
}

TEST_F(plots, a_surface_holds_the_reflectance_of_each_wavelength) {
    const table t = csv("gold --surface");
    EXPECT_EQ(t.names, (std::vector<std::string>{"wavelength (nm)", "θ (degrees)", "reflectance"}));
    const double at_500 = csv("gold --wavelength 500").column.at("gold")[0];
    for (std::size_t i = 0; i < t.column.at("reflectance").size(); ++i)
        if (t.column.at("wavelength (nm)")[i] == 500 && t.column.at("θ (degrees)")[i] == 0) {
            EXPECT_EQ(t.column.at("reflectance")[i], at_500);
        }
}

TEST(drawing, shades_run_from_black_over_the_colour_to_white) {
    EXPECT_EQ(shaded("#d92b2b", 0), "#d92b2b");
    EXPECT_EQ(shaded("#d92b2b", -1), "#000000");
    EXPECT_EQ(shaded("#d92b2b", 1), "#ffffff");
    EXPECT_EQ(viridis(0), "#440154");
    EXPECT_EQ(viridis(1), "#fde725");
}

// ---- files --------------------------------------------------------------------------------------------------

TEST_F(plots, every_format_is_written_and_nothing_else) {
    const test::outcome result =
        run("plot copper schlick --out a.svg --out a.png --out a.pdf --out a.csv --out a.json");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(files(), (std::vector<std::string>{"a.csv", "a.json", "a.pdf", "a.png", "a.svg"}));
    EXPECT_NE(written("a.svg").find("<svg"), std::string::npos);
    EXPECT_NE(written("a.svg").find("</svg>"), std::string::npos);
    EXPECT_EQ(written("a.png").substr(0, 8), "\x89PNG\r\n\x1a\n");
    EXPECT_EQ(written("a.pdf").substr(0, 5), "%PDF-");
    EXPECT_EQ(written("a.csv"), run("plot copper schlick").out);
    EXPECT_EQ(nlohmann::json::parse(written("a.json"))["series"].size(), 6u);
    EXPECT_EQ(nlohmann::json::parse(written("a.json"))["id"], "a");
}

TEST_F(plots, every_kind_of_plot_is_drawn) {
    for (const std::string what :
         {"n-bk7 --polarization s,p,r", "dielectric schlick --error --family n_t=1.1:2.5:8", "gold --surface",
          "gems schlick --strip --against sin", "gold silver copper lazanyi --wavelength 450",
          "copper schlick_power --family power=3:6:4 --title 'it''s <R> & G'"}) {
        const test::outcome result = run("plot " + what + " --out 'my figure.svg'");
        EXPECT_EQ(result.code, 0) << what << "\n" << result.err;
        EXPECT_GT(written("my figure.svg").size(), 5000u) << what;
    }
}

TEST_F(plots, help_shows_examples) {
    for (const std::string command : {"plot", "identify"})
        EXPECT_NE(run(command + " --help").out.find("Examples:"), std::string::npos) << command;
}

TEST_F(plots, the_caption_says_how_parameters_were_found) {
    const std::string caption = json("plot copper schlick --json")["caption"];
    for (const char* piece : {"schlick (fitted to copper): f0 = 0.93", "CIE 1931", "ambient 1"})
        EXPECT_NE(caption.find(piece), std::string::npos) << caption;
}

// ---- bad input ----------------------------------------------------------------------------------------------

TEST_F(plots, what_cannot_be_plotted_is_refused) {
    expect_refused("plot", {"WHAT"});
    expect_refused("plot coper", {"coper", "copper"});
    expect_refused("plot shlick", {"shlick", "schlick"});
    expect_refused("plot missing.csv", {"missing.csv"});
    expect_refused("plot schlick --n-t 1.5", {"n_t = 1.5", "f0"});
    expect_refused("plot schlick --f0 2", {"f0 = 2", "[0, 1]"});
    expect_refused("plot copper --f0 0.5", {"f0 = 0.5", "none"});
    expect_refused("plot schlick --against tan", {"tan", "theta, cos or sin"});
    expect_refused("plot dielectric --polarization q", {"'q'", "r, s, p"});
    expect_refused("plot dielectric --polarization s,s", {"s twice"});
    expect_refused("plot dielectric schlick --polarization s", {"--polarization", "schlick"});
    expect_refused("plot copper --wavelength 0", {"--wavelength = 0", "[1, 1e9]"});
    expect_refused("plot copper --wavelength red", {"red", "number"});
    expect_refused("plot copper --space rgb", {"rgb", "srgb"});
    expect_refused("plot copper --fit gold", {"--fit 'gold'", "no model"});
    expect_refused("plot schlick --fit golld", {"golld", "gold"});
}

TEST_F(plots, colours_that_nothing_depends_on_are_refused) {
    expect_refused("plot schlick --ambient 1.333", {"--ambient 1.333", "material", "n_i"});
    expect_refused("plot schlick --space p3", {"--space p3", "material", "--fit"});
    expect_refused("plot gold --wavelength 500 --space p3", {"--space p3", "--wavelength"});
    expect_refused("plot gold --surface --space p3", {"--space p3", "--surface"});
}

TEST_F(plots, errors_families_and_surfaces_that_make_no_sense_are_refused) {
    expect_refused("plot schlick --error", {"--error 'schlick'", "approximation"});
    expect_refused("plot gold --error schlick", {"--error 'schlick'", "exact"});
    expect_refused("plot gold --error", {"--error 'gold'", "nothing"});
    expect_refused("plot gold --error golld", {"golld", "gold"});
    expect_refused("plot schlick --family 3", {"--family '3'", "PARAM=LIST"});
    expect_refused("plot schlick --family n_t=1:2:3", {"n_t = 1", "f0"});
    expect_refused("plot schlick --family f0=0:2:3", {"f0 = 2", "[0, 1]"});
    expect_refused("plot schlick --family f0=0:1:1000", {"1000 values", "64"});
    expect_refused("plot schlick --family f0=0:1", {"0:1", "COUNT"});
    expect_refused("plot schlick --f0 0.5 --family f0=0,1", {"f0", "once"});
    expect_refused("plot schlick --surface", {"--surface", "material"});
    expect_refused("plot gold silver --surface", {"--surface", "one material"});
    expect_refused("plot gold --surface --strip", {"--surface"});
}

TEST_F(plots, a_file_that_cannot_be_written_is_refused_before_anything_is_written) {
    expect_refused("plot copper --out good.csv --out x.jpg", {"x.jpg", ".svg, .png, .pdf, .csv or .json"});
    expect_refused("plot copper --out good.csv --out nowhere/x.svg", {"nowhere/x.svg"});
    expect_refused("plot coper --out good.csv", {"coper"});
    std::filesystem::create_directory(folder / "work" / "folder.svg");
    expect_refused("plot copper --out folder.svg", {"folder.svg", "folder"});
    expect_refused(
        "plot aluminium beryllium bismuth brass bronze caesium calcium chromium cobalt copper electrum "
        "gold indium iridium --out good.csv --out many.svg",
        {"many.svg", "legend", "13"});
}

} // namespace
