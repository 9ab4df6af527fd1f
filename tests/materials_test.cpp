#include "error.hpp"
#include "materials/catalog.hpp"
#include "materials/embedded.hpp"
#include "materials/page.hpp"
#include "materials/table.hpp"

#include <fresnel/material.hpp>

#include "database.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <set>
#include <string>

namespace fresnel {
namespace {

/// A formula against the same arithmetic done apart, relative.
constexpr double arithmetic = 1e-14;

/// A tabulated value that the interpolation must give back.
constexpr double interpolated = 1e-12;

/// An index printed in a data sheet or a handbook with five decimals.
constexpr double five_decimals = 1e-5;

/// The reflectance of one author's sample against another's: what sound samples differ by.
constexpr double between_authors = 0.06;

double formula(int number, std::vector<double> coefficients, double um) {
    return value_at(dispersion{number, std::move(coefficients), 100, 100000}, 1000 * um);
}

std::string message_of(const std::function<void()>& run) {
    try {
        run();
    } catch (const bad_input& error) {
        return error.what();
    }
    return "no error";
}

page read(const std::string& text) { return read_page(text, "page.yml"); }

std::string with_table(const std::string& type, const std::string& rows) {
    return "REFERENCES: |\n    A. Author.\nDATA:\n  - type: " + type + "\n    data: |\n" + rows;
}

const samples& table_of(const std::optional<spectrum>& quantity) {
    return std::get<samples>(quantity.value());
}

bool has(const std::vector<std::string>& diagnostics, std::string_view part) {
    return std::ranges::any_of(diagnostics,
                               [&](const std::string& d) { return d.find(part) != std::string::npos; });
}

// ---- spectra --------------------------------------------------------------------------------------------------

TEST(spectrum, is_linear_between_points_and_constant_beyond_them) {
    const samples table{{400, 500, 700}, {1, 2, 6}};
    EXPECT_DOUBLE_EQ(value_at(table, 450), 1.5);
    EXPECT_DOUBLE_EQ(value_at(table, 600), 4);
    EXPECT_EQ(value_at(table, 500), 2);
    EXPECT_EQ(value_at(table, 100), 1);
    EXPECT_EQ(value_at(table, 900), 6);
}

TEST(spectrum, of_one_point_is_constant) { EXPECT_EQ(value_at(samples{{500}, {1.5}}, 700), 1.5); }

TEST(spectrum, of_no_point_is_not_a_number) { EXPECT_TRUE(std::isnan(value_at(samples{}, 500))); }

TEST(spectrum, formula_is_constant_beyond_its_range) {
    const dispersion law{5, {1.5, 0.01, -2}, 400, 800};
    EXPECT_EQ(value_at(law, 300), value_at(law, 400));
    EXPECT_EQ(value_at(law, 10600), value_at(law, 800));
}

// Expected numbers: each formula worked out by hand at 2 um, where um^2 = 4.

TEST(dispersion_formula, one_is_sellmeier_with_squared_poles) {
    EXPECT_NEAR(formula(1, {0.5, 3, 1}, 2), std::sqrt(1 + 0.5 + 3 * 4 / 3.0), arithmetic);
    EXPECT_NEAR(formula(1, {0, 3, 1, 1.5, 0.5}, 2), std::sqrt(1 + 4 + 1.6), arithmetic);
}

TEST(dispersion_formula, two_is_sellmeier_with_plain_poles) {
    EXPECT_NEAR(formula(2, {0.25, 3, 2}, 2), std::sqrt(1.25 + 6), arithmetic);
}

TEST(dispersion_formula, three_is_a_polynomial) {
    EXPECT_NEAR(formula(3, {2, 0.5, 2, 8, -2}, 2), std::sqrt(2 + 2 + 2.0), arithmetic);
}

TEST(dispersion_formula, four_has_two_resonances_and_a_polynomial) {
    // 2 + 3 * 2^1 / (4 - 3^1) + 1 * 2^2 / (4 - 2^1) + 0.25 * 2^3
    EXPECT_NEAR(formula(4, {2, 3, 1, 3, 1, 1, 2, 2, 1, 0.25, 3}, 2), std::sqrt(2 + 6 + 2 + 2.0), arithmetic);
}

TEST(dispersion_formula, four_skips_a_resonance_of_zero_strength) {
    // um^2 - 2^2 = 0: 0 / 0 unless it is skipped
    EXPECT_NEAR(formula(4, {2.25, 0, 0, 2, 2, 0, 0, 2, 2}, 2), 1.5, arithmetic);
}

TEST(dispersion_formula, five_is_cauchy) {
    EXPECT_NEAR(formula(5, {1.5, 0.4, -2, 1.6, -4}, 2), 1.7, arithmetic);
}

TEST(dispersion_formula, six_is_for_gases) {
    EXPECT_NEAR(formula(6, {0.01, 0.03, 1.25}, 2), 1 + 0.01 + 0.03, arithmetic);
    EXPECT_NEAR(formula(6, {0.01, 0, 0.25}, 2), 1.01,
                arithmetic); // 1 / um^2 = 0.25: 0 / 0 unless it is skipped
}

TEST(dispersion_formula, seven_is_herzberger) {
    const double l = 1 / (4 - 0.028);
    EXPECT_NEAR(formula(7, {3, 0.5, 0.25, 0.01, 0.002, 0.0003}, 2),
                3 + 0.5 * l + 0.25 * l * l + 0.04 + 0.032 + 0.0192, arithmetic);
}

TEST(dispersion_formula, eight_is_retro) {
    // (n^2 - 1) / (n^2 + 2) = 0.1 + 0.2 * 4 / (4 - 2) + 0.025 * 4 = 0.6, hence n^2 = 2.2 / 0.4
    EXPECT_NEAR(formula(8, {0.1, 0.2, 2, 0.025}, 2), std::sqrt(5.5), arithmetic);
}

TEST(dispersion_formula, nine_is_exotic) {
    // 2 + 3 / (4 - 1) + 2 (2 - 1) / (1 + 1)
    EXPECT_NEAR(formula(9, {2, 3, 1, 2, 1, 1}, 2), 2, arithmetic);
}

TEST(dispersion_formula, missing_trailing_coefficients_are_zero) {
    EXPECT_EQ(formula(2, {1.25}, 2), 1.5);
    EXPECT_EQ(formula(4, {2.25}, 2), 1.5);
    EXPECT_EQ(formula(7, {1.5}, 2), 1.5);
    EXPECT_EQ(formula(9, {2.25}, 2), 1.5);
    EXPECT_EQ(formula(2, {0, 1.25}, 2), 1.5); // a strength without its pole
}

TEST(dispersion_formula, pole_is_not_a_number) {
    EXPECT_TRUE(std::isnan(formula(1, {0, 3, 2}, 2)));   // infinite
    EXPECT_TRUE(std::isnan(formula(1, {0, 3, 2.1}, 2))); // n^2 < 0
    EXPECT_TRUE(std::isnan(formula(6, {0, 1, 0.25}, 2)));
    EXPECT_TRUE(std::isnan(formula(10, {1.5}, 2)));
}

// ---- materials ------------------------------------------------------------------------------------------------

TEST(material, without_k_absorbs_nothing_yet_its_k_stays_absent) {
    material glass;
    glass.n = samples{{500}, {1.5}};
    EXPECT_EQ(index_at(glass, 500).n, 1.5);
    EXPECT_EQ(index_at(glass, 500).k, 0);
    EXPECT_FALSE(glass.k.has_value());
}

TEST(material, negative_k_of_a_noisy_page_counts_as_zero) {
    material noisy;
    noisy.n = samples{{500}, {1.5}}, noisy.k = samples{{500}, {-1e-6}};
    EXPECT_EQ(index_at(noisy, 500).k, 0);
}

TEST(material, of_an_index_range_has_its_middle) {
    material garnet;
    garnet.kind = material_kind::index;
    garnet.index = {1.75, 2.25};
    EXPECT_EQ(index_at(garnet, 500).n, 2);
    EXPECT_EQ(index_at(low_end(garnet), 500).n, 1.75);
    EXPECT_EQ(index_at(high_end(garnet), 500).n, 2.25);
    EXPECT_TRUE(has_range(garnet));
    EXPECT_FALSE(has_range(low_end(garnet)));
}

TEST(material, of_an_f0_has_the_index_that_gives_it) {
    material stone;
    stone.kind = material_kind::f0;
    stone.f0 = {0.03, 0.05};
    const double n = index_at(stone, 500).n;
    EXPECT_NEAR((n - 1) * (n - 1) / ((n + 1) * (n + 1)), 0.04, arithmetic);
    EXPECT_NEAR(n, 1.5, arithmetic);
}

TEST(material, vacuum_reflects_nothing) {
    const material* vacuum = find_material("vacuum");
    ASSERT_NE(vacuum, nullptr);
    EXPECT_EQ(normal_reflectance(1.0, index_at(*vacuum, 550).n, 0.0), 0);
    material none;
    none.kind = material_kind::f0;
    EXPECT_EQ(index_at(none, 550).n, 1);
}

// ---- the reader of pages --------------------------------------------------------------------------------------

TEST(page_reader, turns_micrometres_into_nanometres_digit_for_digit) {
    EXPECT_EQ(nanometres("0.1879"), "187.9");
    EXPECT_EQ(nanometres("1.937"), "1937");
    EXPECT_EQ(nanometres("0.20"), "200");
    EXPECT_EQ(nanometres("0.20000"), "200.00");
    EXPECT_EQ(nanometres("12"), "12000");
    EXPECT_EQ(nanometres("0.0000248"), "0.0248");
    EXPECT_EQ(nanometres(".5"), "500");
    EXPECT_EQ(nanometres("4.429E-02"), "44.29");
    EXPECT_EQ(nanometres("1.5e+1"), "15000");
    EXPECT_EQ(nanometres("1.5e40"), "1.5e43");
}

TEST(page_reader, keeps_separate_grids_of_n_and_k) {
    const page p =
        read("REFERENCES: r\nDATA:\n  - type: tabulated n\n    data: |\n        0.4 1.5\n        0.5 1.6\n"
             "  - type: tabulated k\n    data: |\n        0.45 0.1\n        0.9 0.2\n");
    EXPECT_EQ(table_of(p.n), (samples{{400, 500}, {1.5, 1.6}}));
    EXPECT_EQ(table_of(p.k), (samples{{450, 900}, {0.1, 0.2}}));
    EXPECT_EQ(material_of(p, "x.yml").range_nm, (std::array<double, 2>{450, 500}));
    EXPECT_TRUE(p.diagnostics.empty());
}

TEST(page_reader, averages_repeated_wavelengths_and_says_so) {
    const page p = read(
        with_table("tabulated nk", "        0.4 1 0\n        0.5 2 1\n        0.5 3 2\n        0.5 4 3\n"));
    EXPECT_EQ(table_of(p.n), (samples{{400, 500}, {1, 3}}));
    EXPECT_EQ(table_of(p.k), (samples{{400, 500}, {0, 2}}));
    EXPECT_TRUE(has(p.diagnostics, "n: 2 repeated wavelengths"));
}

TEST(page_reader, sorts_rows_out_of_order_and_says_so) {
    const page p = read(with_table("tabulated n", "        0.6 3\n        0.4 1\n        0.5 2\n"));
    EXPECT_EQ(table_of(p.n), (samples{{400, 500, 600}, {1, 2, 3}}));
    EXPECT_TRUE(has(p.diagnostics, "out of order"));
}

TEST(page_reader, flags_negative_n_and_k) {
    const page p = read(with_table("tabulated nk", "        0.4 -1 0\n        0.5 2 -1e-6\n"));
    EXPECT_TRUE(has(p.diagnostics, "n: 1 of 2 values negative"));
    EXPECT_TRUE(has(p.diagnostics, "k: 1 of 2 values negative"));
}

TEST(page_reader, takes_a_single_row_as_constant) {
    const page p = read(with_table("tabulated nk", "        0.5 1.5 0.1\n"));
    EXPECT_EQ(value_at(*p.n, 700), 1.5);
    EXPECT_EQ(value_at(*p.k, 300), 0.1);
}

TEST(page_reader, reads_a_page_of_k_alone_but_makes_no_material_of_it) {
    const page p = read(with_table("tabulated k", "        0.5 0.1\n"));
    EXPECT_FALSE(p.n.has_value());
    EXPECT_EQ(value_at(*p.k, 500), 0.1);
    EXPECT_NE(message_of([&] { material_of(p, "x.yml"); }).find("k only"), std::string::npos);
}

TEST(page_reader, reads_a_formula_with_its_range) {
    const page p = read("REFERENCES: r\nDATA:\n  - type: formula 2\n    wavelength_range: 0.182 1.129\n"
                        "    coefficients: 0 5.684E-1 5.1E-3\n");
    EXPECT_EQ(std::get<dispersion>(*p.n), (dispersion{2, {0, 0.5684, 0.0051}, 182, 1129}));
}

TEST(page_reader, finds_a_pole_inside_the_range_and_only_there) {
    const auto with_range = [](const std::string& range) {
        return read("REFERENCES: r\nDATA:\n  - type: formula 1\n    wavelength_range: " + range +
                    "\n    coefficients: 0 1 0.5\n");
    };
    EXPECT_TRUE(has(with_range("0.4 0.8").diagnostics, "pole near"));
    EXPECT_TRUE(with_range("0.6 0.8").diagnostics.empty());
}

TEST(page_reader, counts_the_first_n_where_two_are_given) {
    const page p = read(
        "REFERENCES: r\nDATA:\n  - type: formula 5\n    wavelength_range: 0.4 0.8\n    coefficients: 1.5\n"
        "  - type: tabulated nk\n    data: |\n        0.5 1.6 0.1\n");
    EXPECT_EQ(value_at(*p.n, 500), 1.5);
    EXPECT_EQ(value_at(*p.k, 500), 0.1);
    EXPECT_TRUE(has(p.diagnostics, "given twice"));
}

TEST(page_reader, skips_what_it_does_not_know) {
    const page p =
        read("NOVELTY: {a: [1, 2], b: {c: d}}\nREFERENCES: r\nDATA:\n  - type: tabulated n\n    extra: [1]\n"
             "    wavelength_range: 0.4 0.5\n    data: |\n        0.4 1.5\n\n        0.5 1.6\n"
             "CONDITIONS:\n    temperature: 293\n    list: [1, 2]\nPROPERTIES:\n    nd: 1.5\n");
    EXPECT_EQ(table_of(p.n).value.size(), 2U);
    EXPECT_EQ(p.conditions.at("temperature"), "293");
    EXPECT_FALSE(p.conditions.contains("list"));
    EXPECT_EQ(p.properties.at("nd"), "1.5");
}

TEST(page_reader, gives_references_as_plain_text_with_their_doi) {
    const page p =
        read("REFERENCES: |\n    A. Author.\n    <a href=\"https://doi.org/10.1016/0040-6090(87)90361-2\">"
             "<i>J. Opt.</i> <b>6</b>, 1 (1972)</a>\nDATA:\n  - type: tabulated n\n    data: |\n        0.4 "
             "1.5\n");
    EXPECT_EQ(p.references, "A. Author. J. Opt. 6, 1 (1972)");
    EXPECT_EQ(p.doi, "10.1016/0040-6090(87)90361-2");
}

TEST(page_reader, strips_html_and_markdown) {
    EXPECT_EQ(plain_text("H<sub>2</sub>O &amp; <i>ice</i><br>at  0\n&deg;C"), "H2O & ice at 0 °C");
    EXPECT_EQ(plain_text("[J. Opt.](https://doi.org/x) **6**, *n* `k`"), "J. Opt. 6, n k");
    EXPECT_EQ(plain_text("n < 3, 2 * 3 * 4, * a note"), "n < 3, 2 * 3 * 4, * a note");
}

TEST(page_reader, names_file_and_line_of_a_bad_row) {
    EXPECT_EQ(message_of([] { read(with_table("tabulated nk", "        0.4 1 0\n        0.5 x 0\n")); }),
              "page.yml:7: n 'x' is not a number");
    EXPECT_EQ(message_of([] { read(with_table("tabulated nk", "        0.4 1 0\n        0.5 1\n")); }),
              "page.yml:7: 2 numbers; a row of 'tabulated nk' has 3");
    EXPECT_EQ(message_of([] { read(with_table("tabulated n", "        -0.4 1\n")); }),
              "page.yml:6: wavelength -0.4 um; it must be above 0");
    EXPECT_EQ(message_of([] { read(with_table("tabulated n", "        0.4 nan\n")); }),
              "page.yml:6: n 'nan' is not a number");
}

TEST(page_reader, refuses_what_is_not_a_page) {
    const std::string formula_without_range =
        "REFERENCES: r\nDATA:\n  - type: formula 1\n    coefficients: 0 1 2\n";
    const std::string too_many =
        "REFERENCES: r\nDATA:\n  - type: formula 8\n    wavelength_range: 1 2\n    coefficients: 1 2 3 4 5\n";
    const std::string texts[] = {"",
                                 "\n \n",
                                 "hello",
                                 "[1, 2]",
                                 "{{{{",
                                 "a: b: c",
                                 "REFERENCES: only\n",
                                 "DATA: []",
                                 "DATA: text",
                                 "DATA: &a [*a]",
                                 "\x01\x02\xff\xfe noise",
                                 std::string("REFERENCES: \0", 13),
                                 with_table("tabulated x", "        0.4 1\n"),
                                 with_table("formula 10", "        0.4 1\n"),
                                 with_table("tabulated n", "\n"),
                                 formula_without_range,
                                 too_many,
                                 std::string(100000, '['),
                                 std::string(1 << 20, '\0')};
    for (const std::string& text : texts)
        EXPECT_TRUE(message_of([&] { read(text); }).starts_with("page.yml:")) << text.substr(0, 80);
}

TEST(page_reader, refuses_files_that_hold_no_text) {
    const std::filesystem::path folder = std::filesystem::path(testing::TempDir()) / "materials_test";
    std::filesystem::create_directories(folder);
    std::ofstream(folder / "large.yml") << std::string((16 << 20) + 1, 'a');
    EXPECT_NE(message_of([&] { read_page_file((folder / "none.yml").string()); }).find("cannot be opened"),
              std::string::npos);
    EXPECT_NE(message_of([&] { read_page_file(folder.string()); }).find("is a folder"), std::string::npos);
    EXPECT_NE(message_of([&] { read_page_file((folder / "large.yml").string()); }).find("16 MiB"),
              std::string::npos);
    std::filesystem::remove_all(folder);
}

// ---- the reader of a user's table -----------------------------------------------------------------------------

material csv(const std::string& text) { return read_csv_material(text, "my.csv"); }

TEST(csv_reader, takes_columns_and_rows_in_any_order) {
    const material m = csv("# mine\nk, n ,wavelength_nm\r\n0.2,1.6,500\r\n\n0.1,1.5,400\n");
    EXPECT_EQ(table_of(m.n), (samples{{400, 500}, {1.5, 1.6}}));
    EXPECT_EQ(table_of(m.k), (samples{{400, 500}, {0.1, 0.2}}));
    EXPECT_EQ(m.range_nm, (std::array<double, 2>{400, 500}));
}

TEST(csv_reader, needs_no_k) {
    const material m = csv("\xEF\xBB\xBFwavelength_nm,n\n400,1.5");
    EXPECT_FALSE(m.k.has_value());
    EXPECT_EQ(m.category, "dielectric");
}

TEST(csv_reader, names_line_and_column_of_a_bad_cell) {
    const std::pair<const char*, const char*> cases[] = {
        {"", "my.csv: is empty; its first line must be wavelength_nm,n,k"},
        {"wavelength_nm,n\n", "my.csv: has a header but no rows"},
        {"wavelength_nm,n,k\n400,1.5,0\n500,abc,0\n", "my.csv:3:5: n 'abc' is not a number"},
        {"wavelength_nm,n,k\n400,1.5,-1\n", "my.csv:2:9: k is -1; it must be in [0, 10000]"},
        {"wavelength_nm,n,k\n400,1e60,0\n", "my.csv:2:5: n is 1e60; it must be in [0, 10000]"},
        {"wavelength_nm,n\n0,1.5\n", "my.csv:2:1: wavelength_nm is 0; it must be above 0"},
        {"wavelength_nm,n\n400,1.5,7\n", "my.csv:2: 3 cells; the header has 2"},
        {"wavelength_nm,n\n500,1.5\n400,1\n500,1.6\n",
         "my.csv:4: wavelength_nm 500 was given before, in line 2"},
        {"wavelength,n\n",
         "my.csv:1:1: column 'wavelength' is unknown; the header is wavelength_nm,n or wavelength_nm,n,k"},
        {"n,n\n", "my.csv:1:3: column 'n' is given twice"},
        {"n,k\n", "my.csv:1: the header must name the columns wavelength_nm and n, and may name k"},
        {"wavelength_nm,n\n400,\"1.5\"x\n", "my.csv:2:10: 'x' follows a closing quote; a comma must"},
        {"wavelength_nm,n\n400,\"1.5\n", "my.csv:2:5: a quote is not closed"}};
    for (const auto& [text, message] : cases)
        EXPECT_EQ(message_of([&] { csv(text); }), message);
}

// ---- the built-in materials -----------------------------------------------------------------------------------

std::vector<material> of_kind(material_kind kind) {
    std::vector<material> some;
    std::ranges::copy_if(builtin_materials(), std::back_inserter(some),
                         [&](const material& m) { return m.kind == kind; });
    return some;
}

TEST(builtin, are_66_spectra_23_indices_and_12_reflectances_or_more) {
    EXPECT_GE(of_kind(material_kind::spectral).size(), 66U);
    EXPECT_EQ(of_kind(material_kind::index).size(), 23U);
    EXPECT_EQ(of_kind(material_kind::f0).size(), 12U);
}

TEST(builtin, names_and_aliases_are_unique) {
    std::set<std::string> seen;
    for (const material& m : builtin_materials()) {
        EXPECT_TRUE(seen.insert(m.name).second) << m.name;
        for (const std::string& alias : m.aliases)
            EXPECT_TRUE(seen.insert(alias).second) << alias;
    }
}

TEST(builtin, all_state_citation_licence_and_quality) {
    for (const material& m : builtin_materials()) {
        EXPECT_FALSE(m.citation.empty()) << m.name;
        EXPECT_FALSE(m.licence.empty()) << m.name;
        EXPECT_TRUE(m.quality.ends_with('.')) << m.name << ": " << m.quality;
        EXPECT_TRUE(m.category == "metal" || m.category == "semimetal" || m.category == "semiconductor" ||
                    m.category == "dielectric")
            << m.name << ": " << m.category;
        EXPECT_EQ(m.page.empty(), m.kind != material_kind::spectral) << m.name;
        for (const char mark : {'<', '`', '[', ']'})
            EXPECT_EQ(m.citation.find(mark), std::string::npos) << m.citation;
    }
}

TEST(builtin, all_have_a_physical_index_over_the_visible_range) {
    for (const material& m : builtin_materials())
        for (int nm = 360; nm <= 830; nm += 5) {
            const optical_index index = index_at(m, nm);
            EXPECT_TRUE(index.n > 0 && index.n < 8 && index.k >= 0 && index.k < 12)
                << m.name << " at " << nm << " nm: " << index.n << " + " << index.k << " i";
        }
}

TEST(builtin, metals_absorb_and_dielectrics_do_not) {
    for (const material& m : of_kind(material_kind::spectral)) {
        const double k = index_at(m, 550).k;
        if (m.category == "metal") {
            EXPECT_GT(k, 0.9) << m.name;
        }
        if (m.category == "dielectric") {
            EXPECT_LT(k, 0.01) << m.name;
        }
    }
}

TEST(builtin, known_range_says_where_the_visible_is_extrapolated) {
    for (const material& m : of_kind(material_kind::spectral)) {
        EXPECT_LT(m.range_nm[0], m.range_nm[1]) << m.name;
        const bool covered = m.range_nm[0] <= 380 && m.range_nm[1] >= 780;
        EXPECT_EQ(covered, m.quality.find("held constant") == std::string::npos) << m.name;
        EXPECT_EQ(m.k.has_value(), m.quality.find("k not given") == std::string::npos) << m.name;
    }
}

struct expected_index {
    const char* name;
    double nm, n, k;
};

TEST(builtin, tables_give_back_the_numbers_of_their_papers) {
    // Johnson and Christy 1972, Table I, at 2.26, 1.88 and 2.75 eV.
    const expected_index cases[] = {
        {"copper", 548.6, 1.02, 2.577}, {"copper", 659.5, 0.22, 3.747}, {"copper", 450.9, 1.24, 2.397},
        {"gold", 548.6, 0.43, 2.455},   {"gold", 659.5, 0.14, 3.697},   {"gold", 450.9, 1.38, 1.914},
        {"silver", 548.6, 0.06, 3.586}, {"silver", 659.5, 0.05, 4.483}, {"silver", 450.9, 0.04, 2.657}};
    for (const auto& [name, nm, n, k] : cases) {
        const optical_index index = index_at(load_material(name), nm);
        EXPECT_NEAR(index.n, n, interpolated) << name << ' ' << nm;
        EXPECT_NEAR(index.k, k, interpolated) << name << ' ' << nm;
    }
}

TEST(builtin, metals_reflect_as_other_authors_samples_do) {
    const std::pair<const char*, const char*> pairs[] = {
        {"copper", "copper-babar"},       {"gold", "gold-olmon"},        {"silver", "silver-yang"},
        {"aluminium", "aluminium-rakic"}, {"nickel", "nickel-rakic-ld"}, {"silicon", "silicon-aspnes"},
        {"diamond", "diamond-peter"}};
    const auto reflectance = [](const char* name, double nm) {
        const optical_index index = index_at(load_material(name), nm);
        return normal_reflectance(1.0, index.n, index.k);
    };
    for (const auto& [name, other] : pairs)
        for (const double nm : {450.0, 550.0, 650.0})
            EXPECT_NEAR(reflectance(name, nm), reflectance(other, nm), between_authors)
                << name << ' ' << other << ' ' << nm;
}

TEST(builtin, dielectrics_agree_with_data_sheets) {
    // n_d: SCHOTT data sheets; Malitson 1965; Daimon and Masumura 2007 (20 C); Malitson 1963.
    const expected_index cases[] = {{"n-bk7", 587.5618, 1.51680, 0},
                                    {"sf10", 587.5618, 1.72825, 0},
                                    {"k7", 587.5618, 1.51112, 0},
                                    {"fused-silica", 587.5618, 1.45846, 0},
                                    {"f2", 587.5618, 1.62004, 0}};
    for (const auto& [name, nm, n, k] : cases)
        EXPECT_NEAR(index_at(load_material(name), nm).n, n, five_decimals) << name;
}

TEST(builtin, ranges_of_tables_are_as_printed) {
    EXPECT_EQ(find_material("garnet")->index, (std::array<double, 2>{1.73, 1.89}));
    EXPECT_EQ(find_material("cubic-zirconia-wloka")->index, (std::array<double, 2>{2.14, 2.20}));
    EXPECT_EQ(find_material("skin")->f0, (std::array<double, 2>{0.028, 0.028}));
    EXPECT_EQ(find_material("fabric")->f0, (std::array<double, 2>{0.04, 0.056}));
}

TEST(builtin, traps_are_left_out) {
    for (const material& m : builtin_materials()) {
        EXPECT_FALSE(m.page.ends_with("/Werner")) << m.name; // electron energy loss, far too bright
        EXPECT_NE(m.page, "main/Zn/nk/Querry");
        EXPECT_NE(m.page, "main/Cr/nk/Sytchkova"); // a film of 12 nm
        EXPECT_NE(m.page, "main/Mg/nk/Palm");      // a film of 25 nm
        if (m.page.ends_with("-DFT")) {
            EXPECT_NE(m.quality.find("not measured"), std::string::npos) << m.name;
        }
    }
}

TEST(catalog, finds_by_name_alias_and_page_whatever_the_case) {
    const material* copper = find_material("copper");
    ASSERT_NE(copper, nullptr);
    for (const char* name : {"Copper", "CU", "main/Cu/nk/Johnson", "MAIN/cu/nk/johnson"})
        EXPECT_EQ(find_material(name), copper) << name;
    EXPECT_EQ(find_material("aluminum"), find_material("Al"));
    EXPECT_EQ(find_material(""), nullptr);
    EXPECT_EQ(find_material("coper"), nullptr);
}

TEST(catalog, suggests_the_nearest_name) {
    EXPECT_EQ(message_of([] { load_material("coper"); }),
              "material 'coper' is unknown (did you mean 'copper'?); `fresnel materials` lists them");
    EXPECT_EQ(message_of([] { load_material("xyz"); }), // two letters of three are another word
              "material 'xyz' is unknown; `fresnel materials` lists them");
    EXPECT_EQ(message_of([] { load_material("qwertyuiopasdf"); }),
              "material 'qwertyuiopasdf' is unknown; `fresnel materials` lists them");
}

TEST(catalog, embedded_files_are_those_of_the_data_folder) {
    EXPECT_TRUE(embedded_data("materials/none.txt").empty());
    EXPECT_FALSE(embedded_data("cie/d65.csv").empty());
    const std::filesystem::path data = std::filesystem::path(FRESNEL_SOURCE_DIR) / "data";
    for (const std::string_view name : embedded_names("materials/"))
        EXPECT_EQ(embedded_data(name), read_text_file((data / name).string())) << name;
}

TEST(catalog, every_material_is_in_the_documentation) {
    const std::string text = read_text_file(FRESNEL_SOURCE_DIR "/docs/materials.md");
    for (const material& m : builtin_materials())
        EXPECT_NE(text.find("| `" + m.name + "` |"), std::string::npos) << m.name;
}

TEST(material_file, names_the_line_of_an_error) {
    const std::pair<const char*, const char*> cases[] = {
        {"name: x\n", "m.txt: has no n"},
        {"colour: red\n", "m.txt:1: key 'colour' is unknown"},
        {"name: x\n\nn\n400 1.5\n390 1.6\n", "m.txt:3: wavelengths of 'n' must increase; 390 nm does not"},
        {"name: x\n\nn k\n400 1.5\n", "m.txt:4: 2 numbers; a row of 'n k' has 3"},
        {"name: x\n\n400 1.5\n", "m.txt:3: numbers must follow a line that says what they are"},
        {"name: x\n\nnk\n400 1.5\n", "m.txt:3: 'nk' is not a block; n k, n, k and n formula are"},
        {"name: x\n\nn\n", "m.txt:3: 'n' is followed by no numbers"},
        {"name: x\n\nn formula 2\n1 2\n", "m.txt:3: 'n formula 2' must read 'n formula NUMBER LO to HI nm'"},
        {"name: x\n\nn formula 1e99 1 to 2 nm\n1 2\n",
         "m.txt:3: 'n formula 1e99 1 to 2 nm' must have a formula of 1 to 9 and a range that increases from "
         "above 0"}};
    for (const auto& [text, message] : cases)
        EXPECT_EQ(message_of([&] { read_material(text, "m.txt"); }), message);
}

// ---- the whole database ---------------------------------------------------------------------------------------

/// The pages that the catalogue lists, one for each time it does: some are on several shelves.
std::vector<std::string> listed_pages(const std::filesystem::path& root) {
    std::vector<std::string> pages;
    std::ifstream catalogue(root / "catalog-nk.yml");
    for (std::string line; std::getline(catalogue, line);) {
        const std::size_t at = line.find(" data: ");
        if (at != std::string::npos && line.find(".yml") != std::string::npos)
            pages.emplace_back(trimmed(line.substr(at + 7)));
    }
    return pages;
}

TEST(database, is_read_whole_and_has_the_known_counts) {
    const std::optional<std::filesystem::path> found = fresnel::test::find_database();
    if (!found) GTEST_SKIP() << "there is no refractiveindex.info database; set FRESNEL_DATABASE to read one";
    const std::filesystem::path& root = *found;
    const auto start = std::chrono::steady_clock::now();
    std::map<std::string, page> files;
    std::map<std::string, int> blocks, flagged;
    std::size_t entries = 0;
    for (std::string name : listed_pages(root)) {
        std::erase(name, '"');
        if (!files.contains(name)) files[name] = read_page_file((root / "data" / name).string());
        ++entries;
        for (const page_block& block : files[name].blocks)
            ++blocks[block.type];
    }
    for (const auto& [name, p] : files)
        for (const char* what : {"repeated", "out of order", "pole", "n: ", "k: "}) {
            const bool sign = what[1] == ':';
            flagged[what] += std::ranges::any_of(p.diagnostics, [&](const std::string& d) {
                return d.find(what) != std::string::npos &&
                       (!sign || d.find("negative") != std::string::npos);
            });
        }
    const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    EXPECT_LT(seconds, 30); // 1 s on an idle desktop core

    EXPECT_EQ(entries, 3576U);
    EXPECT_EQ(files.size(), 3478U);
    const std::map<std::string, int> expected = {
        {"tabulated k", 1792}, {"formula 3", 1028}, {"tabulated nk", 944}, {"formula 2", 823},
        {"tabulated n", 255},  {"formula 1", 175},  {"formula 5", 150},    {"formula 4", 133},
        {"formula 6", 46},     {"formula 8", 3},    {"formula 7", 1},      {"formula 9", 1}};
    EXPECT_EQ(blocks, expected);
    EXPECT_EQ(flagged["repeated"], 32);
    EXPECT_EQ(flagged["out of order"], 17);
    EXPECT_EQ(flagged["k: "], 15);
    EXPECT_EQ(flagged["n: "], 10);
    EXPECT_EQ(flagged["pole"], 5); // CS2/Chemnitz and GaSe Chen-n-o, Chen-n-e, Kato-o, Kato-e
}

} // namespace
} // namespace fresnel
