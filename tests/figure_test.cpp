#include "figure/figure.hpp"

#include "command.hpp"
#include "error.hpp"
#include "figure/leftover.hpp"

#include <png.h>

#include <cmath>
#include <limits>
#include <regex>
#include <set>

namespace {

using namespace fresnel;

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

class figures : public test::command_test {
protected:
    std::string dir() const { return (folder / "work").string(); }
    std::string text(const std::string& name) const { return test::read_text(folder / "work" / name); }
};

figure curves(const std::string& id) {
    figure f;
    f.id = id, f.title = "a title", f.caption = "a caption";
    f.panels = {{{"angle θ (degrees)", 0, 90, 15},
                 {"reflectance", 0, 1, 0},
                 {{"exact", {0, 45, 90}, {0.1, 0.2, 1}}},
                 {{45, 0.2, "here"}}}};
    return f;
}

figure strip_figure() {
    figure f;
    f.id = "strips", f.title = "strips";
    f.colors.x = {"angle θ (degrees)", 0, 90, 30};
    f.colors.rows.push_back({"exact", {{250, 209, 194}, {251, 220, 200}, {255, 255, 255}}});
    f.colors.rows.push_back({"schlick", {{12, 34, 56}, {1, 2, 3}, {9, 9, 9}}});
    return f;
}

struct picture {
    unsigned width, height;
    std::vector<std::uint8_t> rgb;
    std::array<std::uint8_t, 3> at(unsigned x, unsigned y) const {
        const std::size_t i = 3 * (static_cast<std::size_t>(y) * width + x);
        return {rgb[i], rgb[i + 1], rgb[i + 2]};
    }
};

picture read_png(const std::string& path) {
    png_image image{};
    image.version = PNG_IMAGE_VERSION;
    EXPECT_NE(png_image_begin_read_from_file(&image, path.c_str()), 0) << path;
    image.format = PNG_FORMAT_RGB;
    picture p{image.width, image.height, std::vector<std::uint8_t>(PNG_IMAGE_SIZE(image))};
    png_image_finish_read(&image, nullptr, p.rgb.data(), 0, nullptr);
    return p;
}

// Every element that opens also closes, in order.
void expect_well_formed(const std::string& xml) {
    std::vector<std::string> open;
    const std::regex tag("<(/?)([A-Za-z][A-Za-z0-9:]*)[^<>]*?(/?)>");
    for (std::sregex_iterator it(xml.begin(), xml.end(), tag), end; it != end; ++it) {
        if ((*it)[3].length() > 0) continue;
        if ((*it)[1].length() == 0) {
            open.push_back((*it)[2]);
        } else {
            ASSERT_FALSE(open.empty());
            EXPECT_EQ(open.back(), (*it)[2]);
            open.pop_back();
        }
    }
    EXPECT_TRUE(open.empty());
}

TEST_F(figures, every_format_is_written_and_nothing_else) {
    write_figures({curves("one"), strip_figure()}, dir(), {format::svg, format::png, format::pdf});
    EXPECT_EQ(files(), (std::vector<std::string>{"one.pdf", "one.png", "one.svg", "strips.pdf", "strips.png",
                                                 "strips.svg"}));
    EXPECT_EQ(text("one.pdf").substr(0, 4), "%PDF");
    EXPECT_EQ(text("one.png").substr(1, 3), "PNG");
}

TEST_F(figures, labels_come_out_literally) {
    const std::string hostile = "it's \"x_{1}^2\" `touch bad` \\n $HOME & <θ λ>";
    figure f = curves("hostile");
    f.title = hostile, f.panels[0].curves[0].label = hostile, f.panels[0].markers[0].label = hostile;
    write_figures({f}, dir(), {format::svg});
    EXPECT_EQ(files(), std::vector<std::string>{"hostile.svg"});
    const std::string svg = text("hostile.svg");
    expect_well_formed(svg);
    for (const char* piece : {"x_{1}^2", "`touch bad`", "\\n $HOME &amp; &lt;θ λ&gt;"})
        EXPECT_NE(svg.find(piece), std::string::npos) << piece;
}

TEST_F(figures, svg_has_a_title_follows_the_colour_scheme_and_has_no_ground_of_its_own) {
    write_figures({curves("one")}, dir(), {format::svg});
    const std::string svg = text("one.svg");
    EXPECT_NE(svg.find("<title>a title</title>"), std::string::npos);
    EXPECT_NE(svg.find("<desc>a caption</desc>"), std::string::npos);
    EXPECT_NE(svg.find("prefers-color-scheme:dark"), std::string::npos);
    EXPECT_NE(svg.find("fill=\"currentColor\""), std::string::npos);
    EXPECT_EQ(svg.find("color=\"black\""), std::string::npos);
    EXPECT_EQ(svg.find("fill=\"#ffffff\""), std::string::npos);
    EXPECT_EQ(svg.find("black"), std::string::npos);
}

TEST_F(figures, ids_of_two_figures_in_one_page_do_not_meet) {
    write_figures({curves("one"), curves("two")}, dir(), {format::svg});
    std::set<std::string> seen;
    const std::regex id("id=['\"]([^'\"]*)['\"]");
    const std::string page = inline_svg(curves("one"), dir()) + inline_svg(curves("two"), dir());
    expect_well_formed(page);
    EXPECT_EQ(page.find("<style"), std::string::npos);
    for (std::sregex_iterator it(page.begin(), page.end(), id), end; it != end; ++it)
        EXPECT_TRUE(seen.insert((*it)[1]).second || (*it)[1].str().find("gnuplot_plot") != std::string::npos)
            << (*it)[1];
}

TEST_F(figures, the_first_pixel_of_a_strip_is_the_first_colour) {
    write_figures({strip_figure()}, dir(), {format::png});
    const picture p = read_png(dir() + "/strips.png");
    for (const strip& row : strip_figure().colors.rows) {
        unsigned first = p.width;
        for (unsigned y = 0; y < p.height; ++y)
            for (unsigned x = 0; x < first; ++x)
                if (p.at(x, y) == row.pixels.front()) first = x;
        ASSERT_LT(first, p.width) << row.label << ": the colour is not in the picture";
        // and the strip starts with it: left of it lies the white ground
        for (unsigned y = 0; y < p.height; ++y)
            if (p.at(first, y) == row.pixels.front()) {
                EXPECT_GE(p.at(first - 3, y)[0], 250) << row.label;
            }
    }
}

TEST_F(figures, a_plain_strip_is_its_pixels) {
    write_strip_png(dir() + "/plain.png", strip_figure().colors.rows, 4);
    const picture p = read_png(dir() + "/plain.png");
    EXPECT_EQ(p.width, 3u);
    EXPECT_EQ(p.height, 8u);
    EXPECT_EQ(p.at(0, 3), (std::array<std::uint8_t, 3>{250, 209, 194}));
    EXPECT_EQ(p.at(2, 4), (std::array<std::uint8_t, 3>{9, 9, 9}));
}

TEST_F(figures, gaps_empty_series_and_surfaces_are_drawn) {
    figure f = curves("gaps");
    f.panels[0].curves = {
        {"gap", {0, 30, 60, 90}, {0.1, nan, 0.3, 1}}, {"empty", {}, {}}, {"all gaps", {0, 1}, {nan, nan}}};
    figure s;
    s.id = "surface", s.title = "surface";
    s.surface = {{"x", 0, 1, 0}, {"y", 0, 1, 0}, {"z", 0, 1, 0}, {0, 1}, {0, 1}, {{0, 1}, {1, 0}}};
    write_figures({f, s}, dir(), {format::svg, format::png});
    EXPECT_EQ(files().size(), 4u);
    expect_well_formed(text("gaps.svg"));
    expect_well_formed(text("surface.svg"));
}

TEST_F(figures, json_holds_what_was_drawn) {
    const nlohmann::json j = nlohmann::json::parse(to_json(curves("one")).dump());
    EXPECT_EQ(j["id"], "one");
    EXPECT_EQ(j["caption"], "a caption");
    EXPECT_EQ(j["series"][0]["y"], (std::vector<double>{0.1, 0.2, 1}));
    EXPECT_EQ(j["series"][0]["x_axis"]["label"], "angle θ (degrees)");
    EXPECT_EQ(j["markers"][0]["label"], "here");
    EXPECT_EQ(to_json(strip_figure())["strips"][0]["srgb8"][0], (std::vector<int>{250, 209, 194}));
}

TEST_F(figures, csv_has_two_columns_for_each_series) {
    figure f = curves("one");
    f.panels[0].curves.push_back({"a, \"b\"", {0}, {0.5}});
    EXPECT_EQ(to_csv(f),
              "x of exact,exact,\"x of a, \"\"b\"\"\",\"a, \"\"b\"\"\"\n0,0.1,0,0.5\n45,0.2,,\n90,1,,\n");
}

TEST_F(figures, a_place_that_cannot_be_written_is_a_failure_that_names_it) {
    try {
        write_figures({curves("one")}, dir() + "/missing", {format::svg});
        FAIL() << "written into a folder that is not there";
    } catch (const failure& error) {
        EXPECT_NE(std::string(error.what()).find("missing/one.svg"), std::string::npos) << error.what();
    }
    EXPECT_THROW(write_file("/proc/fresnel", "x"), failure);
    EXPECT_EQ(final_path(staged_folder(dir()).path / "one.svg"), dir() + "/one.svg");
    EXPECT_TRUE(files().empty());
}

TEST_F(figures, a_malformed_figure_is_refused_before_gnuplot_sees_it) {
    figure f = curves("one");
    f.panels[0].curves[0].y.pop_back();
    EXPECT_THROW(write_figures({f}, dir(), {format::svg}), std::invalid_argument);
    f = curves("one"), f.panels[0].curves[0].color = "#12'; !ls";
    EXPECT_THROW(write_figures({f}, dir(), {format::svg}), std::invalid_argument);
    f = curves("../one");
    EXPECT_THROW(write_figures({f}, dir(), {format::svg}), std::invalid_argument);
    f = strip_figure(), f.colors.rows[0].pixels.pop_back();
    EXPECT_THROW(write_figures({f}, dir(), {format::svg}), std::invalid_argument);
    EXPECT_TRUE(files().empty());
}

} // namespace
