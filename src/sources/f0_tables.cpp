#include "sources/parts.hpp"

#include "analysis/curve.hpp"
#include "materials/catalog.hpp"

#include <fmt/format.h>

#include <cmath>

// The published lists of F0. Each row names the open page that comes nearest to the printed numbers, which is not
// always the page we recommend: the lists were made from tables of unclear licence, and a row's tolerance is how
// near an open page gets.

namespace fresnel {

namespace {

/// Three colour components as printed, and as 8-bit codes where the list has them.
struct printed_color {
    rgb linear;
    std::array<int, 3> codes{-1, -1, -1};
};

struct metal_row {
    const char *name, *material;
    printed_color printed;
    double tolerance;
    const char* why = "";
};

constexpr const char* palik =
    "the old Palik table matches to 0.001 but has no open licence; this is the nearest open page";
constexpr const char* no_titanium =
    "no open page comes nearer than 0.05; the origin of the printed numbers is not known";
constexpr const char* no_iron =
    "no open page comes nearer than 0.015; the origin of the printed numbers is not known";
constexpr const char* no_zinc = "no sound page reaches the visible: the calculated one used here is 0.14 "
                                "away, an implausible measured one 0.08";
constexpr const char* no_cobalt =
    "no open page comes nearer than 0.02; the origin of the printed numbers is not known";

const metal_row table_9_2_rows[] = {
    {"Titanium", "titanium-mash", {{0.542, 0.497, 0.449}, {194, 187, 179}}, 0.001, no_titanium},
    {"Chromium", "chromium", {{0.549, 0.556, 0.554}, {196, 197, 196}}, 0.0007},
    {"Iron", "iron-querry", {{0.562, 0.565, 0.578}, {198, 198, 200}}, 0.001, no_iron},
    {"Nickel", "nickel-rakic-ld", {{0.660, 0.609, 0.526}, {212, 205, 192}}, 0.0095, palik},
    {"Platinum", "platinum-rakic-ld", {{0.673, 0.637, 0.585}, {214, 209, 201}}, 0.0050, palik},
    {"Copper", "copper-hagemann", {{0.955, 0.638, 0.538}, {250, 209, 194}}, 0.0020, palik},
    {"Palladium", "palladium", {{0.733, 0.697, 0.652}, {222, 217, 211}}, 0.0005},
    {"Mercury", "mercury", {{0.781, 0.780, 0.778}, {229, 228, 228}}, 0.0006},
    {"Brass (C260)", "brass", {{0.910, 0.778, 0.423}, {245, 228, 174}}, 0.0005},
    {"Zinc", "zinc", {{0.664, 0.824, 0.850}, {213, 234, 237}}, 0.001, no_zinc},
    {"Gold", "gold-mcpeak", {{1.000, 0.782, 0.344}, {255, 229, 158}}, 0.0016, palik},
    {"Aluminum", "aluminium", {{0.913, 0.922, 0.924}, {245, 246, 246}}, 0.0029, palik},
    {"Silver", "silver-rakic-ld", {{0.972, 0.960, 0.915}, {252, 250, 245}}, 0.0076, palik},
};

const metal_row table_9_3_rows[] = {
    {"Diamond", "diamond", {{0.171, 0.172, 0.176}, {115, 115, 116}}, 0.0009},
    {"Silicon", "silicon-franta", {{0.345, 0.369, 0.426}, {159, 164, 174}}, 0.0005},
    {"Titanium", "titanium-mash", {{0.542, 0.497, 0.449}, {194, 187, 179}}, 0.001, no_titanium},
};

const metal_row lagarde_rows[] = {
    {"Silver", "silver-rakic-ld", {{0.972, 0.960, 0.915}}, 0.0076, palik},
    {"Aluminium", "aluminium", {{0.913, 0.921, 0.925}}, 0.0029, palik},
    {"Gold",
     "gold-mcpeak",
     {{1.000, 0.766, 0.336}},
     0.0016,
     "0.766 is 0.7825 / 1.0219 of the Palik table, whose red is "
     "nearer to 1; the nearest open page has 1.053"},
    {"Copper", "copper-hagemann", {{0.955, 0.637, 0.538}}, 0.0024, palik},
    {"Chromium", "chromium", {{0.550, 0.556, 0.554}}, 0.0007},
    {"Nickel", "nickel-rakic-ld", {{0.660, 0.609, 0.526}}, 0.0095, palik},
    {"Titanium", "titanium-mash", {{0.542, 0.497, 0.449}}, 0.001, no_titanium},
    {"Cobalt", "cobalt", {{0.662, 0.655, 0.634}}, 0.001, no_cobalt},
    {"Platinum", "platinum-rakic-ld", {{0.672, 0.637, 0.585}}, 0.0060, palik},
    {"Iron", "iron-querry", {{0.560, 0.570, 0.580}}, 0.001, no_iron},
};

rgb f0_of(const char* name, double ambient, gamut policy) {
    return apply_gamut(colour_at(*find_material(name), color_space::srgb, ambient, 1), policy);
}

std::string text_of(const rgb& c) { return fmt::format("{:.3f} {:.3f} {:.3f}", c[0], c[1], c[2]); }

std::string text_of(const rgb8& c) { return fmt::format("{} {} {}", c[0], c[1], c[2]); }

table::cell swatch_of(const rgb& c) { return {"", encode_srgb8(c)}; }

/// A number for a reason: the same reason is given once.
std::string note_number(table& t, const std::string& sentence) {
    for (std::size_t i = 0; i < t.notes.size(); ++i)
        if (t.notes[i] == sentence) return fmt::format("{}", i + 1);
    t.notes.push_back(sentence);
    return fmt::format("{}", t.notes.size());
}

std::string sentence(std::string text) {
    text.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(text.front())));
    return text + ".";
}

/// The checks of one row: three linear components, and three codes where they are printed.
std::vector<check> checks_of(const metal_row& row, const rgb& computed, const std::string& where) {
    constexpr std::array<const char*, 3> letters = {"R", "G", "B"};
    std::vector<check> checks;
    const rgb8 codes = encode_srgb8(computed);
    for (std::size_t i = 0; i < 3; ++i)
        checks.push_back({fmt::format("{} {}{}", row.name, letters[i], where), row.printed.linear[i],
                          computed[i], row.tolerance, row.why});
    for (std::size_t i = 0; i < 3; ++i)
        if (row.printed.codes[i] >= 0)
            checks.push_back({fmt::format("{} {}{}, 8 bits", row.name, letters[i], where),
                              static_cast<double>(row.printed.codes[i]), static_cast<double>(codes[i]), 1,
                              row.why});
    return checks;
}

std::string largest_difference(const rgb& a, const rgb& b) {
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i)
        if (std::abs(b[i] - a[i]) > std::abs(worst)) worst = b[i] - a[i];
    return fmt::format("{:+.4f}", worst);
}

bool all_matched(const std::vector<check>& checks) {
    for (const check& c : checks)
        if (!c.matched()) return false;
    return true;
}

/// A list of colours: published and computed side by side.
regenerated color_list(std::span<const metal_row> rows, gamut policy, std::string title) {
    const bool with_codes = rows.front().printed.codes[0] >= 0;
    table t{{{"", 1.1, false}, {"published", 1.3}, {"computed", 1.5}, {"difference", 0.9}}, {}, {}};
    if (with_codes) t.columns.insert(t.columns.end(), {{"8 bits", 1.1}, {"computed", 1.1}});
    t.columns.insert(t.columns.end(), {{"published", 0.8}, {"ours", 0.7}, {"note", 0.4}});
    regenerated result;
    for (const metal_row& row : rows) {
        const rgb computed = f0_of(row.material, 1, policy);
        const std::vector<check> checks = checks_of(row, computed, "");
        std::vector<table::cell> cells = {
            {row.name},
            {text_of(row.printed.linear)},
            {text_of(computed)},
            {largest_difference(row.printed.linear, computed), {}, !all_matched(checks)}};
        if (with_codes) {
            cells.push_back({fmt::format("{}", fmt::join(row.printed.codes, " "))});
            cells.push_back({text_of(encode_srgb8(computed))});
        }
        cells.push_back(swatch_of(row.printed.linear));
        cells.push_back(swatch_of(computed));
        cells.push_back({*row.why == 0 ? "" : note_number(t, sentence(row.why))});
        t.rows.push_back(std::move(cells));
        result.checks.insert(result.checks.end(), checks.begin(), checks.end());
    }
    result.drawing.caption = std::move(title);
    result.drawing.cells = std::move(t);
    std::string pages;
    for (const metal_row& row : rows)
        pages +=
            fmt::format("{}{}: {}", pages.empty() ? "" : "; ", row.name, find_material(row.material)->page);
    result.chosen =
        fmt::format("CIE 1931 2°, 1 nm, D65 without adaptation, linear sRGB, gamut {}. Pages, each the "
                    "nearest open one: {}",
                    to_string(policy), pages);
    return result;
}

std::string match_text(const std::vector<check>& checks) {
    std::size_t matched = 0;
    for (const check& c : checks)
        matched += c.matched() ? 1 : 0;
    return fmt::format("{} of {} cells are matched within their row's tolerance", matched, checks.size());
}

regenerated table_9_2() {
    regenerated result = color_list(table_9_2_rows, gamut::clamp, "F0 of metals, published and computed.");
    result.says = "Metals, sorted by increasing lightness. Gold's red is outside sRGB and clamped.";
    const rgb gold = f0_of("gold-mcpeak", 1, gamut::none);
    result.measured =
        fmt::format("{}; titanium, iron and zinc are not reachable with any open page. Gold's red is {:.3f} "
                    "before the clamp.",
                    match_text(result.checks), gold[0]);
    return result;
}

regenerated table_9_3() {
    regenerated result = color_list(table_9_3_rows, gamut::clamp,
                                    "A semiconductor between a bright dielectric and a "
                                    "dark metal.");
    result.says = "A semiconductor's F0 lies between the brightest dielectrics and the darkest metals.";
    result.measured = match_text(result.checks) + "; the order holds in every channel.";
    return result;
}

regenerated lagarde_list() {
    regenerated result =
        color_list(lagarde_rows, gamut::divide, "Lagarde's list of F0, published and computed.");
    result.says = "A list of F0 made by the same method as table 9.2, but gold is divided by its red instead "
                  "of clamped.";
    result.measured = match_text(result.checks) + ".";
    return result;
}

// ---- table 9.1 --------------------------------------------------------------------------------------------

struct dielectric_row {
    const char *name, *published; ///< built-in f0 row that holds the printed range
    std::array<int, 2> codes;
    std::array<const char*, 2> measured; ///< materials that should lie inside the range
    double tolerance;                    ///< half a unit of the last printed digit
    const char* why = "";
};

const dielectric_row table_9_1_rows[] = {
    {"Water", "water-rtr4", {39, 39}, {"water", ""}, 0.005},
    {"Living tissue", "living-tissue", {39, 56}, {"", ""}, 0},
    {"Skin", "skin", {47, 47}, {"", ""}, 0},
    {"Eyes", "eyes", {44, 44}, {"", ""}, 0},
    {"Hair", "hair", {61, 61}, {"", ""}, 0},
    {"Teeth", "teeth", {68, 68}, {"", ""}, 0},
    {"Fabric",
     "fabric",
     {56, 67},
     {"pet", ""},
     0.0005,
     "polyester as a bottle's PET; its fibres are the highest of the fabrics"},
    {"Stone",
     "stone",
     {53, 67},
     {"quartz", "calcite"},
     0.0005,
     "calcite is the ordinary ray of a pure crystal; marble also shows the other one, 0.038"},
    {"Plastics, glass",
     "plastic",
     {56, 63},
     {"n-bk7", "polystyrene"},
     0.005,
     "polystyrene is one of the densest plastics"},
    {"Crystal glass", "crystal-glass", {63, 75}, {"f2", "sf5"}, 0.005},
    {"Gems", "gems", {63, 80}, {"sapphire", "quartz"}, 0.005, "quartz, as amethyst, lies at the lower end"},
    {"Diamond-like", "diamond-like", {101, 124}, {"cubic-zirconia", "diamond"}, 0.005},
};

double luminance_of(const char* name, double ambient) {
    return colour_at(*find_material(name), color_space::xyz, ambient, 1)[1];
}

std::string range_text(double lo, double hi) {
    return lo == hi ? fmt::format("{:.3g}", lo) : fmt::format("{:.3g}–{:.3g}", lo, hi);
}

int code_of(double linear) { return encode_srgb8({linear, linear, linear})[0]; }

regenerated table_9_1() {
    table t{{{"", 1.2, false},
             {"published", 1},
             {"8 bits", 0.7},
             {"computed", 0.7},
             {"swatch", 0.6},
             {"measured materials", 2.3, false},
             {"note", 0.4}},
            {},
            {}};
    regenerated result;
    for (const dielectric_row& row : table_9_1_rows) {
        const std::array<double, 2> f0 = find_material(row.published)->f0;
        const std::size_t first = result.checks.size();
        for (std::size_t end = 0; end < 2; ++end)
            if (end == 0 || f0[0] != f0[1])
                result.checks.push_back({fmt::format("{}, 8 bits of {}", row.name, f0[end]),
                                         static_cast<double>(row.codes[end]),
                                         static_cast<double>(code_of(f0[end])), 1});
        std::string materials;
        for (const char* name : row.measured) {
            if (*name == 0) continue;
            const double Y = luminance_of(name, 1);
            materials += fmt::format("{}{} {:.4f}", materials.empty() ? "" : ", ", name, Y);
            result.checks.push_back({fmt::format("{}: F0 of {}", row.name, name), std::clamp(Y, f0[0], f0[1]),
                                     Y, row.tolerance, row.why});
        }
        const bool matched =
            all_matched({result.checks.begin() + static_cast<std::ptrdiff_t>(first), result.checks.end()});
        t.rows.push_back(
            {{row.name},
             {range_text(f0[0], f0[1])},
             {range_text(row.codes[0], row.codes[1])},
             {range_text(code_of(f0[0]), code_of(f0[1]))},
             swatch_of(
                 {std::midpoint(f0[0], f0[1]), std::midpoint(f0[0], f0[1]), std::midpoint(f0[0], f0[1])}),
             {materials, {}, !matched},
             {*row.why == 0 ? "" : note_number(t, sentence(fmt::format("{}: {}", row.name, row.why)))}});
    }
    result.drawing.caption = "F0 of dielectrics, published, with measured materials beside them.";
    result.drawing.cells = std::move(t);
    result.says =
        "F0 of common dielectrics as linear and 8-bit numbers; a swatch shows the middle of a range. Unknown "
        "dielectrics take 0.04.";
    result.measured = match_text(result.checks) +
                      ". Skin, tissue, eyes, hair and teeth have no open page of n and k; "
                      "their 8-bit codes are checked.";
    result.chosen = "luminance of F0 under D65; a measured material counts as inside a range within 0.005, "
                    "half a unit of "
                    "the last printed digit";
    return result;
}

// ---- table 9.4 --------------------------------------------------------------------------------------------

struct immersed_row {
    const char *name, *material;
    printed_color air, water;
    double tolerance_air, tolerance_water;
    const char* why = "";
};

constexpr rgb gray_of(double x) { return {x, x, x}; }

const immersed_row table_9_4_rows[] = {
    {"Skin", "skin", {gray_of(0.028), {47, 47, 47}}, {gray_of(0.0007), {2, 2, 2}}, 0.0005, 0.00005},
    {"Schott K7",
     "k7",
     {gray_of(0.042), {58, 58, 58}},
     {gray_of(0.004), {13, 13, 13}},
     0.001,
     0.0006,
     "printed as one gray; the three channels differ by up to 0.0016"},
    {"Diamond",
     "diamond",
     {gray_of(0.172), {115, 115, 115}},
     {gray_of(0.084), {82, 82, 82}},
     0.0040,
     0.0030,
     "printed as one gray; the three channels differ by up to 0.0045"},
    {"Iron",
     "iron-querry",
     {{0.562, 0.565, 0.578}, {198, 198, 200}},
     {{0.470, 0.475, 0.492}, {182, 183, 186}},
     0.001,
     0.001,
     no_iron},
    {"Gold",
     "gold-mcpeak",
     {{1.000, 0.782, 0.344}, {255, 229, 158}},
     {{1.000, 0.747, 0.261}, {255, 224, 140}},
     0.0016,
     0.0030,
     palik},
    {"Silver",
     "silver-rakic-ld",
     {{0.972, 0.960, 0.915}, {252, 250, 245}},
     {{0.964, 0.950, 0.899}, {251, 249, 243}},
     0.0076,
     0.0095,
     palik},
};

constexpr double water_index = 1.33;

regenerated table_9_4() {
    table t{{{"", 0.9, false},
             {"air, published", 1.4},
             {"computed", 1.5},
             {"water, published", 1.5},
             {"computed", 1.8},
             {"air", 0.6},
             {"water", 0.6},
             {"note", 0.4}},
            {},
            {}};
    regenerated result;
    for (const immersed_row& row : table_9_4_rows) {
        const rgb air = f0_of(row.material, 1, gamut::clamp),
                  water = f0_of(row.material, water_index, gamut::clamp);
        const auto in_air =
            checks_of({row.name, row.material, row.air, row.tolerance_air, row.why}, air, " in air");
        const auto in_water =
            checks_of({row.name, row.material, row.water, row.tolerance_water, row.why}, water, " in water");
        result.checks.insert(result.checks.end(), in_air.begin(), in_air.end());
        result.checks.insert(result.checks.end(), in_water.begin(), in_water.end());
        const auto four = [](const rgb& c) {
            if (c[0] == c[1] && c[1] == c[2]) return fmt::format("{:.{}f}", c[0], c[0] < 0.01 ? 4 : 3);
            return c[0] < 0.01 ? fmt::format("{:.4f} {:.4f} {:.4f}", c[0], c[1], c[2]) : text_of(c);
        };
        t.rows.push_back({{row.name},
                          {four(row.air.linear)},
                          {four(air), {}, !all_matched(in_air)},
                          {four(row.water.linear)},
                          {four(water), {}, !all_matched(in_water)},
                          swatch_of(air),
                          swatch_of(water),
                          {*row.why == 0 ? "" : note_number(t, sentence(row.why))}});
    }
    result.drawing.caption = "F0 in air and in water.";
    result.drawing.cells = std::move(t);
    result.says = "Dielectrics near water's index change most under water, metals barely.";
    const auto ratio_of = [](const char* name) {
        return luminance_of(name, water_index) / luminance_of(name, 1);
    };
    result.measured = fmt::format(
        "{}. What is left of F0 under water: skin {:.1f} %, K7 {:.1f} %, diamond {:.1f} %, iron "
        "{:.1f} %, silver {:.1f} %.",
        match_text(result.checks), 100 * ratio_of("skin"), 100 * ratio_of("k7"), 100 * ratio_of("diamond"),
        100 * ratio_of("iron-querry"), 100 * ratio_of("silver-rakic-ld"));
    result.chosen =
        "water has n = 1.33; skin is the index above 1 that has F0 = 0.028 in air; pages as in table 9.2";
    return result;
}

} // namespace

std::vector<source_figure> lagarde_tables() {
    return {{"lagarde-metals", "Lagarde's list of metals, as in Unity's Metal Reflectance node",
             "Lagarde's F0 of metals", lagarde_list}};
}

std::vector<source_figure> rtr4_tables() {
    const auto of = [](std::string_view place) {
        return fmt::format("Real-Time Rendering, 4th ed., {}", place);
    };
    return {{"rtr4-table-9-1", of("table 9.1"), "F0 of dielectrics", table_9_1},
            {"rtr4-table-9-2", of("table 9.2"), "F0 of metals", table_9_2},
            {"rtr4-table-9-3", of("table 9.3"), "F0 of a semiconductor", table_9_3},
            {"rtr4-table-9-4", of("table 9.4"), "F0 in air and in water", table_9_4}};
}

} // namespace fresnel
