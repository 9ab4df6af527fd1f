#include "sources/sources.hpp"

#include "command.hpp"
#include "error.hpp"
#include "tolerances.hpp"

#include "analysis/curve.hpp"

#include <fresnel/exact.hpp>

#include <gtest/gtest.h>

#include <chrono>
#include <set>

namespace {

using namespace fresnel;

class figures_command : public test::command_test {};

const regenerated& made(const std::string& id) {
    static std::map<std::string, regenerated> all;
    if (all.count(id) == 0) all[id] = find_source_figure(id).make();
    return all[id];
}

/// The curve of that label.
const series& curve_of(const std::string& id, const std::string& label, std::size_t panel = 0) {
    for (const series& s : made(id).drawing.panels.at(panel).curves)
        if (s.label == label) return s;
    throw std::invalid_argument(id + " has no curve " + label);
}

double at(const series& s, double x) {
    for (std::size_t i = 0; i < s.x.size(); ++i)
        if (std::abs(s.x[i] - x) < 1e-9) return s.y[i];
    throw std::invalid_argument("no such x");
}

// ---- the set ----------------------------------------------------------------------------------------------

TEST(source_figures, say_what_the_text_says_what_is_measured_and_what_was_chosen) {
    std::set<std::string> ids;
    for (const source_figure& one : source_figures()) {
        EXPECT_TRUE(ids.insert(one.id).second) << one.id;
        const regenerated& m = made(one.id);
        EXPECT_FALSE(m.says.empty() || m.measured.empty() || m.chosen.empty()) << one.id;
        EXPECT_FALSE(m.drawing.caption.empty() || one.source.empty() || one.title.empty()) << one.id;
        EXPECT_TRUE(!m.drawing.panels.empty() || m.drawing.cells) << one.id;
    }
    for (const char* wanted : {"wloka-1",
                               "wloka-2",
                               "wloka-3",
                               "wloka-4",
                               "wloka-table-1",
                               "lagarde-conductor",
                               "lagarde-dielectric",
                               "lagarde-polarised",
                               "lagarde-range",
                               "lagarde-dip",
                               "lagarde-error-term",
                               "lagarde-result",
                               "lagarde-internal",
                               "highlights-opacity",
                               "highlights-weight",
                               "halladay-bias",
                               "halladay-scale",
                               "halladay-power",
                               "rtr4-9-20-glass",
                               "rtr4-9-20-copper",
                               "rtr4-9-20-aluminium",
                               "rtr4-9-21",
                               "rtr4-9-22-zinc",
                               "rtr4-9-24",
                               "rtr4-metalness",
                               "rtr4-gulbrandsen",
                               "rtr4-f90-power",
                               "rtr4-table-9-1",
                               "rtr4-table-9-2",
                               "rtr4-table-9-3",
                               "rtr4-table-9-4"})
        EXPECT_EQ(ids.count(wanted), 1u) << wanted;
}

TEST(source_figures, of_exact_reflectance_hold_the_numbers_of_the_exact_models) {
    EXPECT_EQ(at(curve_of("wloka-2", "R_s (perpendicular)"), 60), dielectric(1.0, 1.52, 0.5).R_s);
    EXPECT_EQ(at(curve_of("wloka-3", "n = 2"), 60), dielectric(1.0, 2.0, 0.5).reflectance());
    EXPECT_EQ(at(curve_of("rtr4-9-24", "internal"), 60), 1);
    EXPECT_EQ(at(curve_of("lagarde-polarised", "R_p", 1), 60), conductor(1.0, 1.5, 5.0, 0.5).R_p);
    EXPECT_NEAR(at(curve_of("wloka-4", "water, eq. 10", 1), 60),
                1 / 49.0 + 48 / 49.0 / 32 - dielectric(1.0, 4 / 3.0, 0.5).reflectance(), 1e-15);
}

TEST(source_figures, of_the_book_end_in_white_and_begin_at_f0) {
    for (const char* id : {"rtr4-9-20-glass", "rtr4-9-20-copper", "rtr4-9-20-aluminium"}) {
        const figure& f = made(id).drawing;
        EXPECT_TRUE(f.surface.has_value());
        EXPECT_EQ(f.panels.size(), 2u);
        EXPECT_EQ(f.colors.rows.size(), 1u);
        const auto last = f.colors.rows[0].pixels.back();
        EXPECT_EQ(last, (std::array<std::uint8_t, 3>{255, 255, 255})) << id;
        for (const panel& p : f.panels)
            for (const series& s : p.curves)
                EXPECT_NEAR(s.y.back(), 1, 1e-9) << id;
    }
    EXPECT_EQ(made("rtr4-9-22-zinc").drawing.colors.rows.size(), 2u);
}

// ---- published numbers ------------------------------------------------------------------------------------

TEST(published_tables, give_a_reason_for_every_number_that_is_not_matched) {
    for (const source_figure& one : source_figures())
        for (const check& c : made(one.id).checks)
            EXPECT_TRUE(c.matched() || !c.why.empty()) << one.id << ": " << c.what << " " << c.difference();
}

TEST(published_tables, of_the_book_are_matched_but_for_the_metals_no_open_page_reaches) {
    const std::set<std::string> unreachable = {"Titanium", "Iron", "Zinc"};
    for (const char* id : {"rtr4-table-9-2", "rtr4-table-9-3", "rtr4-table-9-4"})
        for (const check& c : made(id).checks)
            if (unreachable.count(c.what.substr(0, c.what.find(' '))) == 0) {
                EXPECT_TRUE(c.matched()) << id << ": " << c.what << " " << c.difference();
            }
}

TEST(published_tables, of_unreachable_metals_are_off_by_what_the_nearest_page_is) {
    const auto worst = [](const char* id, const std::string& metal) {
        double found = 0;
        for (const check& c : made(id).checks)
            if (c.what.rfind(metal, 0) == 0 && c.what.find("bits") == std::string::npos)
                found = std::max(found, std::abs(c.difference()));
        return found;
    };
    EXPECT_NEAR(worst("rtr4-table-9-2", "Iron"), 0.0154, 2e-4);
    EXPECT_NEAR(worst("rtr4-table-9-2", "Titanium"), 0.052, 1e-3);
    EXPECT_NEAR(worst("rtr4-table-9-2", "Zinc"), 0.144, 1e-3);
    EXPECT_NEAR(worst("lagarde-metals", "Cobalt"), 0.021, 3e-3);
}

TEST(published_tables, have_all_their_rows) {
    EXPECT_EQ(made("wloka-table-1").drawing.cells->rows.size(), 23u);
    EXPECT_EQ(made("rtr4-table-9-1").drawing.cells->rows.size(), 12u);
    EXPECT_EQ(made("rtr4-table-9-2").drawing.cells->rows.size(), 13u);
    EXPECT_EQ(made("rtr4-table-9-3").drawing.cells->rows.size(), 3u);
    EXPECT_EQ(made("rtr4-table-9-4").drawing.cells->rows.size(), 6u);
    EXPECT_EQ(made("rtr4-table-9-2").checks.size(), 13u * 6);
}

TEST(published_tables, of_metals_are_sorted_by_lightness_as_the_book_says) {
    double last = 0;
    for (const char* id : {"rtr4-table-9-2"}) {
        std::map<std::string, rgb> colors;
        std::vector<std::string> order;
        for (const check& c : made(id).checks) {
            if (c.what.find("bits") != std::string::npos) continue;
            const std::string name = c.what.substr(0, c.what.size() - 2);
            if (colors.count(name) == 0) order.push_back(name);
            colors[name][c.what.back() == 'R' ? 0 : c.what.back() == 'G' ? 1 : 2] = c.published;
        }
        for (const std::string& name : order) {
            const rgb& c = colors[name];
            const double Y = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
            EXPECT_GT(Y, last - 0.03) << name; // the book sorts by another lightness: nearly
            last = Y;
        }
    }
}

// ---- coverage ---------------------------------------------------------------------------------------------

std::vector<std::string> pieces_of(std::string_view where) {
    std::vector<std::string> pieces;
    for (std::size_t begin = 0; begin <= where.size();) {
        const std::size_t end = std::min(where.find("; ", begin), where.size());
        pieces.emplace_back(where.substr(begin, end - begin));
        begin = end + 2;
    }
    return pieces;
}

std::string all_tests() {
    std::string text;
    for (const auto& file :
         std::filesystem::directory_iterator(std::filesystem::path(FRESNEL_SOURCE_DIR) / "tests"))
        if (file.path().extension() == ".cpp") text += test::read_text(file.path());
    return text;
}

TEST(source_items, name_places_that_exist) {
    const std::string tests = all_tests();
    for (const source_item& item : source_items())
        for (const std::string& piece : pieces_of(item.where)) {
            const std::size_t space = piece.find(' ');
            const std::string kind = piece.substr(0, space),
                              name = space == std::string::npos ? "" : piece.substr(space + 1);
            if (kind == "figure")
                EXPECT_NO_THROW(find_source_figure(name)) << item.id;
            else if (kind == "claim")
                EXPECT_NO_THROW(find_claim(name)) << item.id;
            else if (kind == "test")
                EXPECT_TRUE(tests.find("TEST(" + name + ",") != std::string::npos ||
                            tests.find("TEST_F(" + name + ",") != std::string::npos)
                    << item.id << " " << name;
            else if (kind == "code")
                EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(FRESNEL_SOURCE_DIR) /
                                                    "include/fresnel" / name))
                    << item.id;
            else if (kind == "command")
                EXPECT_TRUE(std::filesystem::exists(std::filesystem::path(FRESNEL_SOURCE_DIR) / "apps/cli" /
                                                    (name + ".cpp")))
                    << item.id;
            else
                EXPECT_TRUE(piece == "picture" || piece == "listing" || piece == "remark")
                    << item.id << ": " << piece;
        }
}

TEST(source_items, are_all_there_once_and_not_blank) {
    std::map<char, int> count;
    std::set<std::string_view> ids;
    for (const source_item& item : source_items()) {
        EXPECT_TRUE(ids.insert(item.id).second) << item.id;
        EXPECT_FALSE(item.what.empty() || item.where.empty()) << item.id;
        ++count[item.id[0]];
    }
    EXPECT_EQ(count, (std::map<char, int>{{'G', 33}, {'H', 22}, {'L', 45}, {'R', 59}, {'W', 59}}));
}

TEST(source_items, of_every_claim_exist_and_point_back_at_it) {
    for (const claim& one : claims()) {
        std::istringstream words(one.items);
        for (std::string id; words >> id;) {
            bool found = false, back = false;
            for (const source_item& item : source_items())
                if (item.id == id) {
                    found = true;
                    for (const std::string& piece : pieces_of(item.where))
                        back = back || piece.rfind("claim ", 0) == 0 || piece.rfind("test ", 0) == 0 ||
                               piece.rfind("figure ", 0) == 0 || piece == "listing";
                }
            EXPECT_TRUE(found) << one.id << " " << id;
            EXPECT_TRUE(back) << one.id << " " << id;
        }
    }
}

// ---- the command ------------------------------------------------------------------------------------------

TEST_F(figures_command, lists_them) {
    const auto all = json("figures --list --json");
    EXPECT_EQ(all.size(), source_figures().size());
    for (const auto& one : all)
        for (const char* key : {"id", "source", "title"})
            EXPECT_TRUE(one[key].is_string());
}

TEST_F(figures_command, writes_a_picture_twice_its_data_and_a_page) {
    const test::outcome result = run("figures wloka-2 rtr4-table-9-3 wloka-1 --out made");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(files(), (std::vector<std::string>{
                           "made", "made/index.html", "made/rtr4-table-9-3.json", "made/rtr4-table-9-3.png",
                           "made/rtr4-table-9-3.svg", "made/wloka-1.json", "made/wloka-1.png",
                           "made/wloka-1.svg", "made/wloka-2.json", "made/wloka-2.png", "made/wloka-2.svg"}));
    const auto data = nlohmann::json::parse(test::read_text(folder / "work/made/rtr4-table-9-3.json"));
    EXPECT_EQ(data["id"], "rtr4-table-9-3");
    for (const char* key : {"source", "caption", "series", "checks"})
        EXPECT_TRUE(data.contains(key)) << key;
    for (const auto& c : data["checks"])
        for (const char* key : {"what", "published", "computed", "difference", "matched", "why"})
            EXPECT_TRUE(c.contains(key)) << key;
    const std::string page = test::read_text(folder / "work/made/index.html");
    EXPECT_NE(page.find("id=\"wloka-2\""), std::string::npos);
    EXPECT_NE(page.find("The text:"), std::string::npos);
    EXPECT_LT(page.find("id=\"wloka-2\""), page.find("id=\"rtr4-table-9-3\"")) << "in the order of the texts";
}

TEST_F(figures_command, prints_the_checks_of_a_table) {
    const auto table = json("figures rtr4-table-9-2 --json");
    EXPECT_EQ(table[0]["checks"].size(), 78u);
    EXPECT_NE(run("figures rtr4-table-9-2").out.find("Palladium G"), std::string::npos);
}

TEST_F(figures_command, refuses_bad_use) {
    expect_refused("figures", {"--out"});
    expect_refused("figures wloka-5 --out made", {"wloka-5", "wloka-"});
    write("file", "text");
    expect_refused("figures wloka-2 --out file", {"--out", "file"});
}

} // namespace
