// F0 of the built-in materials, integrated a second time in another way, and against values others published.

#include "analysis/curve.hpp"
#include "materials/embedded.hpp"

#include "database.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <optional>
#include <sstream>

namespace {

using namespace fresnel;

// What three printed decimals leave open, and what the four-digit sRGB matrix of IEC 61966-2-1 adds to it: the
// published colours were made with that one, ours with the matrix that the primaries and the white define.
constexpr double published_to_three_decimals = 5e-4, four_digit_matrix = 1.6e-4;

// XYZ under D65 to linear sRGB as IEC 61966-2-1 prints it.
constexpr matrix3 printed_srgb = {
    {{3.2406, -1.5372, -0.4986}, {-0.9689, 1.8758, 0.0415}, {0.0557, -0.2040, 1.0570}}};

using real = long double;
using real3 = std::array<real, 3>;

// ---- an independent integration: long double, half-nanometre steps, trapezoids, the standards' rounded whites -

// A table of an embedded CSV file, read with a string stream, as functions of wavelength linear in between.
struct table {
    std::map<real, std::vector<real>> rows;

    explicit table(std::string_view path) {
        std::istringstream text{std::string(embedded_data(path))};
        for (std::string line; std::getline(text, line);) {
            if (line.empty() || std::isdigit(static_cast<unsigned char>(line[0])) == 0) continue;
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream cells(line);
            real nm = 0, value = 0;
            cells >> nm;
            while (cells >> value)
                rows[nm].push_back(value);
        }
    }
    real at(real nm, std::size_t column) const {
        const auto above = rows.lower_bound(nm);
        if (above == rows.begin()) return above->second[column];
        if (above == rows.end()) return rows.rbegin()->second[column];
        const auto below = std::prev(above);
        const real t = (nm - below->first) / (above->first - below->first);
        return (1 - t) * below->second[column] + t * above->second[column];
    }
};

// Cramer's rule for columns a, b, c.
real3 solve(const real3& a, const real3& b, const real3& c, const real3& v) {
    const auto det = [](const real3& p, const real3& q, const real3& r) {
        return p[0] * (q[1] * r[2] - q[2] * r[1]) - q[0] * (p[1] * r[2] - p[2] * r[1]) +
               r[0] * (p[1] * q[2] - p[2] * q[1]);
    };
    const real d = det(a, b, c);
    return {det(v, b, c) / d, det(a, v, c) / d, det(a, b, v) / d};
}

real3 point(real x, real y) { return {x / y, 1, (1 - x - y) / y}; }

// XYZ under a white to RGB: the primaries scaled so that their sum is the white.
real3 to_rgb(const real3& color, const std::array<real3, 3>& p, const real3& white) {
    const real3 scale = solve(p[0], p[1], p[2], white);
    real3 result = solve(p[0], p[1], p[2], color);
    for (std::size_t i = 0; i < 3; ++i)
        result[i] /= scale[i];
    return result;
}

real3 adapted(const real3& color, const real3& from, const real3& to) {
    const real3 x = {0.8951L, -0.7502L, 0.0389L}, y = {0.2664L, 1.7135L, -0.0685L},
                z = {-0.1614L, 0.0367L, 1.0296L};
    const auto cone = [&](const real3& v) {
        real3 r{};
        for (std::size_t i = 0; i < 3; ++i)
            r[i] = x[i] * v[0] + y[i] * v[1] + z[i] * v[2];
        return r;
    };
    real3 c = cone(color);
    for (std::size_t i = 0; i < 3; ++i)
        c[i] *= cone(to)[i] / cone(from)[i];
    return solve(x, y, z, c);
}

// The colour of a reflectance R(nm) in sRGB or ACEScg.
template <class F>
real3 integrate_again(color_space space, F reflectance) {
    static const table eye("cie/cie1931_2deg_1nm.csv"), d65("cie/d65.csv"), d60("cie/aces_d60.csv");
    const bool aces = space == color_space::acescg;
    real3 color{}, white{};
    for (int half = 720; half <= 1660; ++half) {
        const real nm = half / 2.0L, end = half == 720 || half == 1660 ? 0.5L : 1;
        const real power = (aces ? d60 : d65).at(nm, 0) * end, R = reflectance(nm);
        for (std::size_t i = 0; i < 3; ++i) {
            white[i] += power * eye.at(nm, i);
            color[i] += power * eye.at(nm, i) * R;
        }
    }
    for (std::size_t i = 0; i < 3; ++i)
        color[i] /= white[1];
    const real Y = white[1];
    for (real& w : white)
        w /= Y;
    if (!aces) return to_rgb(color, {point(.64L, .33L), point(.30L, .60L), point(.15L, .06L)}, white);
    const real3 aces_point = point(0.32168L, 0.33767L);
    return to_rgb(adapted(color, white, aces_point),
                  {point(.713L, .293L), point(.165L, .830L), point(.128L, .044L)}, aces_point);
}

real normal_reflectance_of(const material& m, real nm) {
    const optical_index i = index_at(m, static_cast<double>(nm));
    const auto n = static_cast<real>(i.n), k = static_cast<real>(i.k);
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

void expect_same_f0(const material& m, color_space space) {
    const rgb ours = colour_at_normal(m, space, 1).f0;
    const real3 again = integrate_again(space, [&](real nm) { return normal_reflectance_of(m, nm); });
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(ours[c], static_cast<double>(again[c]), 5e-4)
            << m.name << " in " << to_string(space) << ", component " << c;
}

TEST(f0, every_built_in_material_agrees_with_an_independent_integration_in_srgb) {
    for (const material& m : builtin_materials())
        expect_same_f0(m, color_space::srgb);
}

TEST(f0, every_built_in_material_agrees_with_an_independent_integration_in_acescg) {
    for (const material& m : builtin_materials())
        expect_same_f0(m, color_space::acescg);
}

// ---- published values -------------------------------------------------------------------------------------

struct published_row {
    const char *name, *page;
    rgb srgb, acescg, tint_srgb, tint_acescg;
};

// physicallybased.info, database version 2 of 2026-03-28 (CC0): colours of pure metals and their F82 tints, with the
// page each was made from.
const std::vector<published_row> physicallybased = {
    {"Aluminum",
     "main/Al/nk/Cheng",
     {0.916, 0.923, 0.924},
     {0.918, 0.922, 0.923},
     {0.91, 0.936, 0.959},
     {0.921, 0.934, 0.955}},
    {"Beryllium",
     "main/Be/nk/Rakic-BB",
     {0.539, 0.533, 0.534},
     {0.537, 0.534, 0.534},
     {0.731, 0.738, 0.755},
     {0.734, 0.738, 0.752}},
    {"Cobalt",
     "main/Co/nk/Werner-DFT",
     {0.699, 0.704, 0.671},
     {0.699, 0.703, 0.676},
     {0.727, 0.772, 0.823},
     {0.747, 0.77, 0.815}},
    {"Copper",
     "main/Cu/nk/Johnson",
     {0.932, 0.623, 0.522},
     {0.811, 0.643, 0.542},
     {0.982, 0.947, 0.945},
     {0.97, 0.95, 0.946}},
    {"Gold",
     "main/Au/nk/Babar",
     {1.059, 0.773, 0.307},
     {0.929, 0.788, 0.374},
     {0.971, 1.018, 0.994},
     {0.987, 1.013, 0.997}},
    {"Iron",
     "main/Fe/nk/Johnson",
     {0.53, 0.513, 0.494},
     {0.523, 0.514, 0.497},
     {0.765, 0.767, 0.802},
     {0.767, 0.768, 0.797}},
    {"Lead",
     "main/Pb/nk/Werner-DFT",
     {0.626, 0.64, 0.693},
     {0.633, 0.64, 0.686},
     {0.758, 0.773, 0.799},
     {0.765, 0.772, 0.795}},
    {"Lithium",
     "main/Li/nk/Rasigni",
     {0.916, 0.89, 0.807},
     {0.902, 0.89, 0.819},
     {0.985, 0.998, 1.027},
     {0.991, 0.998, 1.023}},
    {"Molybdenum",
     "main/Mo/nk/Werner-DFT",
     {0.589, 0.612, 0.594},
     {0.597, 0.61, 0.596},
     {0.683, 0.696, 0.726},
     {0.689, 0.695, 0.721}},
    {"Nickel",
     "main/Ni/nk/Johnson",
     {0.697, 0.641, 0.563},
     {0.672, 0.643, 0.575},
     {0.815, 0.834, 0.871},
     {0.824, 0.833, 0.865}},
    {"Platinum",
     "main/Pt/nk/Werner-DFT",
     {0.765, 0.73, 0.676},
     {0.749, 0.732, 0.684},
     {0.793, 0.815, 0.84},
     {0.802, 0.814, 0.836}},
    {"Potassium",
     "main/K/nk/Monin",
     {0.983, 0.956, 0.906},
     {0.971, 0.957, 0.914},
     {1.002, 1.011, 1.032},
     {1.006, 1.01, 1.029}},
    {"Tungsten",
     "main/W/nk/Werner-DFT",
     {0.537, 0.536, 0.519},
     {0.536, 0.535, 0.522},
     {0.695, 0.704, 0.714},
     {0.699, 0.703, 0.713}},
    {"Vanadium",
     "main/V/nk/Werner-DFT",
     {0.534, 0.526, 0.546},
     {0.532, 0.527, 0.543},
     {0.705, 0.715, 0.695},
     {0.708, 0.714, 0.698}},
};

// The page among the built-in materials, or in a checkout of the database where there is one.
std::optional<material> page_of(const char* page) {
    if (const material* m = find_material(page)) return *m;
    const std::optional<std::filesystem::path> database = test::find_database();
    if (!database) return std::nullopt;
    const std::filesystem::path file = *database / "data" / (std::string(page) + ".yml");
    if (!std::filesystem::exists(file)) return std::nullopt;
    return load_material(file.string());
}

TEST(f0, is_what_physicallybased_info_publishes_from_the_same_pages) {
    int compared = 0;
    for (const published_row& row : physicallybased) {
        const std::optional<material> m = page_of(row.page);
        if (!m) {
            std::printf("%s: %s is not built in and there is no database\n", row.name, row.page);
            continue;
        }
        ++compared;
        const normal_colour srgb = colour_at_normal(*m, color_space::srgb, 1);
        const normal_colour aces = colour_at_normal(*m, color_space::acescg, 1);
        const rgb as_printed = printed_srgb * colour_at_normal(*m, color_space::xyz, 1).f0;
        for (std::size_t c = 0; c < 3; ++c) {
            EXPECT_NEAR(as_printed[c], row.srgb[c], published_to_three_decimals) << row.name << " sRGB " << c;
            EXPECT_NEAR(srgb.f0[c], row.srgb[c], published_to_three_decimals + four_digit_matrix) << row.name;
            EXPECT_NEAR(aces.f0[c], row.acescg[c], published_to_three_decimals)
                << row.name << " ACEScg " << c;
            EXPECT_NEAR(srgb.f82_tint[c], row.tint_srgb[c], published_to_three_decimals)
                << row.name << " tint " << c;
            EXPECT_NEAR(aces.f82_tint[c], row.tint_acescg[c], published_to_three_decimals)
                << row.name << " tint " << c;
        }
    }
    EXPECT_GE(compared, 6) << "pages in common with the built-in materials";
}

// ---- laws ---------------------------------------------------------------------------------------------------

TEST(f0, of_a_vacuum_is_black_and_of_an_f0_row_the_row_itself) {
    for (const material& m : builtin_materials()) {
        const bool vacuum = m.kind == material_kind::index && m.index[0] == 1 && m.index[1] == 1;
        if (!vacuum && m.kind != material_kind::f0) continue;
        const double expected = vacuum ? 0 : (m.f0[0] + m.f0[1]) / 2;
        for (const double v : colour_at_normal(m, color_space::srgb, 1).f0)
            EXPECT_NEAR(v, expected, 1e-9) << m.name;
    }
}

TEST(f0, of_a_material_immersed_in_its_own_index_is_black) {
    material glass;
    glass.name = "glass", glass.kind = material_kind::index, glass.index = {1.5, 1.5};
    EXPECT_EQ(colour_at_normal(glass, color_space::acescg, 1.5).f0, (rgb{0, 0, 0}));
}

// "Real-Time Rendering", 4th ed., table 9.4: Schott K7 and diamond in air and in water, three decimals.
TEST(f0, under_water_is_that_of_real_time_rendering) {
    const auto green = [](const char* name, double ambient) {
        return colour_at_normal(load_material(name), color_space::srgb, ambient).f0[1];
    };
    EXPECT_NEAR(green("k7", 1), 0.042, 6e-4);
    EXPECT_NEAR(green("k7", 1.33), 0.004, 6e-4);
    EXPECT_NEAR(green("diamond", 1), 0.172, 1e-3);
    EXPECT_NEAR(green("diamond", 1.33), 0.084, 1.1e-3);
}

TEST(f0, average_of_glass_is_the_closed_form) {
    material glass;
    glass.name = "glass", glass.kind = material_kind::index, glass.index = {1.5, 1.5};
    // OpenPBR's check values: E(1.5) = 0.0917779593423512, E(1 / 1.5) = 0.596345759707712
    for (const double v : colour_at_normal(glass, color_space::srgb, 1).average)
        EXPECT_NEAR(v, 0.0917779593423512, 1e-7);
    glass.index = {1, 1};
    for (const double v : colour_at_normal(glass, color_space::srgb, 1.5).average)
        EXPECT_NEAR(v, 0.596345759707712, 1e-7);
}

} // namespace
