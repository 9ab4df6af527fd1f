// From spectra to colours and between colours: the laws, the printed numbers of the standards, and the whole
// integration a second time in another way.

#include "materials/observer.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <limits>
#include <map>
#include <sstream>

namespace {

using namespace fresnel;

constexpr double rounding = 1e-14;          // a few dozen operations on numbers near 1
constexpr double one_operation = 1e-15;     // a 3x3 product of numbers near 1
constexpr double four_decimals = 1e-4;      // a published table printed with four
constexpr double another_quadrature = 5e-4; // step, rule and the standards' rounded whites differ

constexpr std::array spaces = {color_space::srgb, color_space::p3, color_space::rec2020, color_space::acescg};

void expect_near(const std::array<double, 3>& actual, const std::array<double, 3>& expected, double tolerance,
                 const std::string& what) {
    for (std::size_t c = 0; c < 3; ++c)
        EXPECT_NEAR(actual[c], expected[c], tolerance) << what << ", component " << c;
}

TEST(color, a_perfect_reflector_is_white_in_every_rgb_space) {
    for (const color_space space : spaces) {
        const recipe& how = default_recipe(space);
        EXPECT_EQ(integrate(how, std::vector<double>(471, 1)), (rgb{1, 1, 1})) << to_string(space);
        EXPECT_TRUE(in_gamut(integrate(how, std::vector<double>(471, 1)))) << to_string(space);
    }
    const recipe& how = default_recipe(color_space::xyz);
    EXPECT_EQ(integrate(how, std::vector<double>(471, 1)), how.white);
    EXPECT_EQ(how.white[1], 1);
}

TEST(color, a_grey_reflector_is_the_same_grey_in_every_rgb_space) {
    for (const color_space space : spaces)
        expect_near(integrate(default_recipe(space), [](double) { return 0.04; }), {0.04, 0.04, 0.04},
                    rounding, "n = 1.5");
}

TEST(color, a_function_of_wavelength_and_its_samples_integrate_to_the_same) {
    const recipe& how = default_recipe(color_space::rec2020);
    const auto ramp = [](double nm) { return (nm - 360) / 470; };
    std::vector<double> samples;
    for (const double nm : how.wavelength_nm)
        samples.push_back(ramp(nm));
    EXPECT_EQ(integrate(how, ramp), integrate(how, samples));
}

TEST(color, a_number_of_reflectances_other_than_the_recipes_is_refused) {
    for (const std::size_t count : {0u, 470u, 472u})
        EXPECT_THROW(integrate(default_recipe(color_space::srgb), std::vector<double>(count, 1)),
                     std::invalid_argument)
            << count;
}

TEST(color, the_recipe_spans_360_to_830_nm_in_steps_of_1) {
    const recipe& how = default_recipe(color_space::srgb);
    ASSERT_EQ(how.wavelength_nm.size(), 471u);
    for (std::size_t i = 0; i < 471; ++i)
        EXPECT_EQ(how.wavelength_nm[i], 360 + static_cast<double>(i));
}

TEST(color, d65_and_the_aces_white_are_where_their_standards_put_them) {
    const auto chromaticity_of = [](const tristimulus& w) {
        const double sum = w[0] + w[1] + w[2];
        return chromaticity{w[0] / sum, w[1] / sum};
    };
    const chromaticity d65 = chromaticity_of(default_recipe(color_space::srgb).white);
    EXPECT_NEAR(d65.x, 0.3127, 1e-4);
    EXPECT_NEAR(d65.y, 0.3290, 1e-4);
    const chromaticity d60 = chromaticity_of(default_recipe(color_space::acescg).white);
    EXPECT_NEAR(d60.x, 0.32168, 1e-4);
    EXPECT_NEAR(d60.y, 0.33767, 1e-4);
}

TEST(color, matrices_are_those_that_the_standards_print) {
    const matrix3 srgb = rgb_to_xyz(primaries(color_space::srgb), to_xyz(d65_white));
    expect_near(srgb[0], {0.4124, 0.3576, 0.1805}, four_decimals, "IEC 61966-2-1, X");
    expect_near(srgb[1], {0.2126, 0.7152, 0.0722}, four_decimals, "IEC 61966-2-1, Y");
    expect_near(srgb[2], {0.0193, 0.1192, 0.9505}, four_decimals, "IEC 61966-2-1, Z");
    const matrix3 ap1 = rgb_to_xyz(primaries(color_space::acescg), to_xyz(aces_white));
    constexpr double ten_decimals = 1e-10;
    expect_near(ap1[0], {0.6624541811, 0.1340042065, 0.1561876870}, ten_decimals, "ACES S-2014-004, X");
    expect_near(ap1[1], {0.2722287168, 0.6740817658, 0.0536895174}, ten_decimals, "ACES S-2014-004, Y");
    expect_near(ap1[2], {-0.0055746495, 0.0040607335, 1.0103391003}, ten_decimals, "ACES S-2014-004, Z");
    const matrix3 rec2020 = rgb_to_xyz(primaries(color_space::rec2020), to_xyz(d65_white));
    expect_near(rec2020[1], {0.2627, 0.6780, 0.0593}, four_decimals, "ITU-R BT.2020, Y");
    const matrix3 p3 = rgb_to_xyz(primaries(color_space::p3), to_xyz(d65_white));
    expect_near(p3[1], {0.2290, 0.6917, 0.0793}, four_decimals, "SMPTE EG 432-1, Y");
    EXPECT_THROW(primaries(color_space::xyz), std::invalid_argument);
}

TEST(color, bradford_from_d65_to_the_aces_white_is_the_academys) {
    constexpr double six_digits = 6e-6; // printed 1.01303
    const matrix3 m = bradford(to_xyz(d65_white), to_xyz(aces_white));
    expect_near(m[0], {1.01303, 0.00610531, -0.014971}, six_digits, "aces-dev D65 to D60, X");
    expect_near(m[1], {0.00769823, 0.998165, -0.00503203}, six_digits, "aces-dev D65 to D60, Y");
    expect_near(m[2], {-0.00284131, 0.00468516, 0.924507}, six_digits, "aces-dev D65 to D60, Z");
}

TEST(color, bradford_takes_one_white_to_the_other) {
    const tristimulus from = to_xyz(d65_white), to = to_xyz(aces_white);
    expect_near(bradford(from, to) * from, to, one_operation, "white");
}

// The choice of the illuminant's own white moves no colour by more than this; docs/color.md says so.
TEST(color, the_standards_rounded_white_would_move_white_by_at_most_3_in_10000) {
    double most = 0;
    for (const color_space space : {color_space::srgb, color_space::p3, color_space::rec2020}) {
        const matrix3 rounded = rgb_to_xyz(primaries(space), to_xyz(d65_white));
        for (const double v : inverse(rounded) * default_recipe(space).white)
            most = std::max(most, std::abs(v - 1));
    }
    EXPECT_LT(most, 3e-4);
    EXPECT_GT(most, 2e-4);
}

TEST(color, a_matrix_times_its_inverse_is_one) {
    for (const color_space space : spaces) {
        const matrix3 m = default_recipe(space).to_xyz;
        for (const matrix3& one : {m * inverse(m), inverse(m) * m})
            for (std::size_t i = 0; i < 3; ++i)
                for (std::size_t j = 0; j < 3; ++j)
                    EXPECT_NEAR(one[i][j], i == j ? 1 : 0, one_operation) << to_string(space);
    }
}

TEST(color, names_of_spaces_and_policies_are_read_back) {
    for (const std::string_view name : color_space_names)
        EXPECT_EQ(to_string(parse_color_space(name).value()), name);
    for (const std::string_view name : gamut_names)
        EXPECT_EQ(to_string(parse_gamut(name).value()), name);
    for (const char* bad : {"", "sRGB", "srgb ", "divid", "rec709"}) {
        EXPECT_FALSE(parse_color_space(bad)) << bad;
        EXPECT_FALSE(parse_gamut(bad)) << bad;
    }
}

TEST(color, the_recipe_names_observer_range_illuminant_adaptation_space_and_gamut) {
    EXPECT_EQ(recipe_text(color_space::srgb),
              "CIE 1931 2°, 360–830 nm at 1 nm, D65 without adaptation, linear sRGB, gamut none");
    EXPECT_EQ(
        recipe_text(color_space::acescg, gamut::divide),
        "CIE 1931 2°, 360–830 nm at 1 nm, ACES white (D60), Bradford to AP1, linear ACEScg, gamut divide");
    EXPECT_EQ(
        recipe_text(color_space::xyz, gamut::clamp),
        "CIE 1931 2°, 360–830 nm at 1 nm, D65 without adaptation, XYZ with Y = 1 for white, gamut clamp");
}

TEST(color, conversion_to_another_space_and_back_is_the_identity_and_keeps_white) {
    for (const color_space from : spaces)
        for (const color_space to : spaces) {
            const recipe &a = default_recipe(from), &b = default_recipe(to);
            expect_near(convert({1, 1, 1}, a, b), {1, 1, 1}, rounding, "white");
            expect_near(convert(convert({0.9, 0.5, 0.1}, a, b), b, a), {0.9, 0.5, 0.1}, rounding, "back");
        }
}

TEST(color, conversion_within_d65_needs_no_adaptation) {
    const recipe &srgb = default_recipe(color_space::srgb), &wide = default_recipe(color_space::rec2020);
    const auto bump = [](double nm) { return std::exp(-(nm - 560) * (nm - 560) / 5000); };
    expect_near(convert(integrate(srgb, bump), srgb, wide), integrate(wide, bump), rounding,
                "sRGB to Rec.2020");
}

// Gold's red lies outside sRGB; the three answers to that which circulate are the three policies.
TEST(color, gamut_policies_keep_clamp_or_divide) {
    const rgb gold = {1.022, 0.782, 0.344};
    EXPECT_FALSE(in_gamut(gold));
    EXPECT_EQ(apply_gamut(gold, gamut::none), gold);
    EXPECT_EQ(apply_gamut(gold, gamut::clamp), (rgb{1, 0.782, 0.344}));
    expect_near(apply_gamut(gold, gamut::divide), {1, 0.782 / 1.022, 0.344 / 1.022}, rounding, "divide");
    EXPECT_EQ(apply_gamut({0.5, -0.1, 0.2}, gamut::divide), (rgb{0.5, 0, 0.2}));
    EXPECT_TRUE(in_gamut({0, 0.5, 1}));
    EXPECT_FALSE(in_gamut({0, 0.5, 1 + 1e-9}));
    EXPECT_FALSE(in_gamut({-1e-9, 0.5, 1}));
}

TEST(color, divide_keeps_the_ratios_and_leaves_what_is_inside) {
    const rgb gold = {1.02, 0.78, 0.34}, divided = apply_gamut(gold, gamut::divide);
    EXPECT_EQ(divided[0], 1);
    EXPECT_NEAR(divided[1] / divided[2], gold[1] / gold[2], rounding);
    const rgb copper = {0.955, 0.638, 0.538};
    for (const gamut policy : {gamut::none, gamut::clamp, gamut::divide})
        EXPECT_EQ(apply_gamut(copper, policy), copper) << to_string(policy);
}

TEST(color, white_of_every_space_is_white_on_the_screen_and_not_marked) {
    for (const color_space space : spaces)
        EXPECT_EQ(to_hex(to_screen({1, 1, 1}, space)), "#ffffff") << to_string(space);
}

TEST(color, a_colour_outside_srgb_is_marked_in_its_hex) {
    EXPECT_EQ(to_hex(to_screen({1.022, 0.782, 0.344}, color_space::srgb)), "#ffe59e (clamped)")
        << "gold, (255, 229, 158) in Real-Time Rendering table 9.2";
    EXPECT_EQ(to_hex(to_screen({0, 1, 0}, color_space::rec2020)), "#00ff00 (clamped)");
    EXPECT_EQ(to_hex(to_screen({0.5, 0.5, 0.5}, color_space::acescg)), "#bcbcbc");
}

TEST(color, what_is_not_a_number_is_outside_the_gamut_and_encodes_to_0) {
    const rgb broken = {std::numeric_limits<double>::quiet_NaN(), 1, 0};
    EXPECT_FALSE(to_screen(broken).in_gamut);
    EXPECT_EQ(to_screen(broken).codes, (rgb8{0, 255, 0}));
    const double infinity = std::numeric_limits<double>::infinity();
    EXPECT_EQ(encode_srgb8({infinity, -infinity, 2}), (rgb8{255, 0, 255}));
}

TEST(color, every_8_bit_code_survives_decoding_and_encoding) {
    for (int code = 0; code < 256; ++code) {
        const double linear = decode_srgb(code / 255.0);
        EXPECT_EQ(encode_srgb8({linear, linear, linear})[0], code);
        EXPECT_NEAR(encode_srgb(linear), code / 255.0, rounding);
    }
    EXPECT_EQ(encode_srgb8(decode_srgb8({1, 128, 254})), (rgb8{1, 128, 254}));
}

// IEC 61966-2-1 rounds the junction of its two pieces: it is not quite continuous.
TEST(color, srgb_transfer_function_joins_within_3_in_100_million) {
    const double junction = 0.0031308;
    EXPECT_NEAR(encode_srgb(junction), encode_srgb(std::nextafter(junction, 1)), 3e-8);
    EXPECT_NEAR(decode_srgb(0.04045), decode_srgb(std::nextafter(0.04045, 1)), 3e-8);
}

TEST(color, published_codes_of_linear_values) {
    EXPECT_EQ(encode_srgb8({0.955, 0.638, 0.538}), (rgb8{250, 209, 194}))
        << "copper, Real-Time Rendering table 9.2";
    EXPECT_EQ(to_hex(encode_srgb8({0.955, 0.638, 0.538})), "#fad1c2");
}

TEST(color, hex_is_read_with_three_or_six_digits_and_nothing_else) {
    EXPECT_EQ(parse_hex("#fad1c2"), (rgb8{250, 209, 194}));
    EXPECT_EQ(parse_hex("FAD1C2"), (rgb8{250, 209, 194}));
    EXPECT_EQ(parse_hex("#fa0"), (rgb8{255, 170, 0}));
    for (const char* bad :
         {"", "#", "#ff", "#ffff", "#gggggg", "#fad1c21", "0x12", "##fad1c", "#fad1c ", "#-12345"})
        EXPECT_FALSE(parse_hex(bad)) << bad;
}

TEST(color, lab_of_white_black_and_the_published_red) {
    const tristimulus white = to_xyz(d65_white);
    expect_near(to_lab(white, white), {100, 0, 0}, rounding * 100, "white");
    expect_near(to_lab({0, 0, 0}, white), {0, 0, 0}, rounding * 100, "black");
    const lab red = to_lab(rgb_to_xyz(primaries(color_space::srgb), white) * rgb{1, 0, 0}, white);
    expect_near(red, {53.24, 80.09, 67.20}, 0.01, "red of sRGB, a value widely printed with two decimals");
}

TEST(color, ciede2000_of_the_34_pairs_of_sharma_wu_and_dalal) {
    struct pair {
        lab p, q;
        double expected;
    };
    const std::vector<pair> pairs = {{{50, 2.6772, -79.7751}, {50, 0, -82.7485}, 2.0425},
                                     {{50, 3.1571, -77.2803}, {50, 0, -82.7485}, 2.8615},
                                     {{50, 2.8361, -74.0200}, {50, 0, -82.7485}, 3.4412},
                                     {{50, -1.3802, -84.2814}, {50, 0, -82.7485}, 1.0000},
                                     {{50, -1.1848, -84.8006}, {50, 0, -82.7485}, 1.0000},
                                     {{50, -0.9009, -85.5211}, {50, 0, -82.7485}, 1.0000},
                                     {{50, 0, 0}, {50, -1, 2}, 2.3669},
                                     {{50, -1, 2}, {50, 0, 0}, 2.3669},
                                     {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0009}, 7.1792},
                                     {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0010}, 7.1792},
                                     {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0011}, 7.2195},
                                     {{50, 2.4900, -0.0010}, {50, -2.4900, 0.0012}, 7.2195},
                                     {{50, -0.0010, 2.4900}, {50, 0.0009, -2.4900}, 4.8045},
                                     {{50, -0.0010, 2.4900}, {50, 0.0010, -2.4900}, 4.8045},
                                     {{50, -0.0010, 2.4900}, {50, 0.0011, -2.4900}, 4.7461},
                                     {{50, 2.5, 0}, {50, 0, -2.5}, 4.3065},
                                     {{50, 2.5, 0}, {73, 25, -18}, 27.1492},
                                     {{50, 2.5, 0}, {61, -5, 29}, 22.8977},
                                     {{50, 2.5, 0}, {56, -27, -3}, 31.9030},
                                     {{50, 2.5, 0}, {58, 24, 15}, 19.4535},
                                     {{50, 2.5, 0}, {50, 3.1736, 0.5854}, 1.0000},
                                     {{50, 2.5, 0}, {50, 3.2972, 0}, 1.0000},
                                     {{50, 2.5, 0}, {50, 1.8634, 0.5757}, 1.0000},
                                     {{50, 2.5, 0}, {50, 3.2592, 0.3350}, 1.0000},
                                     {{60.2574, -34.0099, 36.2677}, {60.4626, -34.1751, 39.4387}, 1.2644},
                                     {{63.0109, -31.0961, -5.8663}, {62.8187, -29.7946, -4.0864}, 1.2630},
                                     {{61.2901, 3.7196, -5.3901}, {61.4292, 2.2480, -4.9620}, 1.8731},
                                     {{35.0831, -44.1164, 3.7933}, {35.0232, -40.0716, 1.5901}, 1.8645},
                                     {{22.7233, 20.0904, -46.6940}, {23.0331, 14.9730, -42.5619}, 2.0373},
                                     {{36.4612, 47.8580, 18.3852}, {36.2715, 50.5065, 21.2231}, 1.4146},
                                     {{90.8027, -2.0831, 1.4410}, {91.1528, -1.6435, 0.0447}, 1.4441},
                                     {{90.9257, -0.5406, -0.9208}, {88.6381, -0.8985, -0.7239}, 1.5381},
                                     {{6.7747, -0.2908, -2.4247}, {5.8714, -0.0985, -2.2286}, 0.6377},
                                     {{2.0776, 0.0795, -1.1350}, {0.9033, -0.0636, -0.5514}, 0.9082}};
    ASSERT_EQ(pairs.size(), 34u);
    constexpr double half_of_the_last_decimal = 5.1e-5;
    for (const pair& one : pairs) {
        EXPECT_NEAR(delta_e_2000(one.p, one.q), one.expected, half_of_the_last_decimal);
        EXPECT_NEAR(delta_e_2000(one.q, one.p), one.expected, half_of_the_last_decimal);
    }
}

TEST(color, equal_colours_do_not_differ) {
    for (const color_space space : spaces)
        EXPECT_EQ(delta_e_2000(rgb{0.9, 0.5, 0.1}, rgb{0.9, 0.5, 0.1}, space), 0);
}

// ---- the same integration in another way ------------------------------------------------------------------
// Long double, half-nanometre trapezoids over the files themselves, and the white that each standard prints
// instead of the one that the tables have.

using real = long double;
using column = std::array<real, 3>;

// A table of data/cie as a function of wavelength, linear in between.
struct table {
    std::map<real, column> rows;

    explicit table(const std::string& name) {
        std::ifstream file(FRESNEL_SOURCE_DIR "/data/cie/" + name);
        for (std::string line; std::getline(file, line);) {
            std::replace(line.begin(), line.end(), ',', ' ');
            std::istringstream cells(line);
            real nm = 0;
            if (column v{}; cells >> nm >> v[0]) cells >> v[1] >> v[2], rows[nm] = v;
        }
    }
    column at(real nm) const {
        const auto above = rows.lower_bound(nm);
        if (above == rows.begin() || above->first == nm) return above->second;
        const auto below = std::prev(above);
        const real t = (nm - below->first) / (above->first - below->first);
        column v{};
        for (std::size_t i = 0; i < 3; ++i)
            v[i] = below->second[i] + t * (above->second[i] - below->second[i]);
        return v;
    }
};

// x with a x0 + b x1 + c x2 = v, by elimination without pivots.
column solve(column a, column b, column c, column v) {
    std::array<std::array<real, 4>, 3> m{};
    for (std::size_t i = 0; i < 3; ++i)
        m[i] = {a[i], b[i], c[i], v[i]};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t row = 0; row < 3; ++row)
            if (row != i)
                for (std::size_t k = 4; k-- > i;)
                    m[row][k] -= m[row][i] / m[i][i] * m[i][k];
    return {m[0][3] / m[0][0], m[1][3] / m[1][1], m[2][3] / m[2][2]};
}

column point(real x, real y) { return {x / y, 1, (1 - x - y) / y}; }

// The Bradford cones of a colour, one row after the other.
column cones(const column& v) {
    return {0.8951L * v[0] + 0.2664L * v[1] - 0.1614L * v[2],
            -0.7502L * v[0] + 1.7135L * v[1] + 0.0367L * v[2],
            0.0389L * v[0] - 0.0685L * v[1] + 1.0296L * v[2]};
}

column adapted(const column& v, const column& from, const column& to) {
    column scaled = cones(v);
    for (std::size_t i = 0; i < 3; ++i)
        scaled[i] *= cones(to)[i] / cones(from)[i];
    return solve({0.8951L, -0.7502L, 0.0389L}, {0.2664L, 1.7135L, -0.0685L}, {-0.1614L, 0.0367L, 1.0296L},
                 scaled);
}

struct standard {
    color_space space;
    std::string illuminant;
    column white, r, g, b;
};

template <class F>
column integrate_again(const standard& s, F reflectance) {
    static const table eye("cie1931_2deg_1nm.csv");
    const table light(s.illuminant);
    column color{}, white{};
    for (int half = 720; half <= 1660; ++half) {
        const real nm = half / 2.0L, end = half == 720 || half == 1660 ? 0.5L : 1.0L;
        for (std::size_t i = 0; i < 3; ++i) {
            const real w = end * eye.at(nm)[i] * light.at(nm)[0];
            white[i] += w;
            color[i] += w * static_cast<real>(reflectance(static_cast<double>(nm)));
        }
    }
    for (std::size_t i = 0; i < 3; ++i)
        color[i] /= white[1];
    const real Y = white[1];
    const column own = {white[0] / Y, 1, white[2] / Y};
    if (s.space == color_space::acescg) color = adapted(color, own, s.white);
    const column scale = solve(s.r, s.g, s.b, s.white);
    column result = solve(s.r, s.g, s.b, color);
    for (std::size_t i = 0; i < 3; ++i)
        result[i] /= scale[i];
    return result;
}

std::vector<standard> standards() {
    const column d65 = point(0.3127L, 0.3290L);
    return {
        {color_space::srgb, "d65.csv", d65, point(0.64L, 0.33L), point(0.30L, 0.60L), point(0.15L, 0.06L)},
        {color_space::p3, "d65.csv", d65, point(0.68L, 0.32L), point(0.265L, 0.69L), point(0.15L, 0.06L)},
        {color_space::rec2020, "d65.csv", d65, point(0.708L, 0.292L), point(0.17L, 0.797L),
         point(0.131L, 0.046L)},
        {color_space::acescg, "aces_d60.csv", point(0.32168L, 0.33767L), point(0.713L, 0.293L),
         point(0.165L, 0.83L), point(0.128L, 0.044L)},
        {color_space::xyz, "d65.csv", d65, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
}

template <class F>
void expect_the_same_in_every_space(const std::string& what, F reflectance) {
    for (const standard& s : standards()) {
        column again = integrate_again(s, reflectance);
        if (s.space == color_space::xyz)
            for (std::size_t i = 0; i < 3; ++i)
                again[i] *= s.white[i];
        expect_near(
            integrate(default_recipe(s.space), reflectance),
            {static_cast<double>(again[0]), static_cast<double>(again[1]), static_cast<double>(again[2])},
            another_quadrature, what + " in " + std::string(to_string(s.space)));
    }
}

TEST(color, smooth_spectra_agree_with_another_integration) {
    expect_the_same_in_every_space("a perfect reflector", [](double) { return 1.0; });
    expect_the_same_in_every_space("a ramp", [](double nm) { return (nm - 360) / 470; });
    expect_the_same_in_every_space("a wave", [](double nm) { return 0.5 + 0.5 * std::sin(nm / 40); });
}

TEST(color, metal_like_edges_agree_with_another_integration) {
    for (const double edge_nm : {450.0, 520.0, 580.0})
        for (const double width_nm : {5.0, 15.0, 40.0})
            expect_the_same_in_every_space(
                "an edge at " + std::to_string(edge_nm) + " nm, " + std::to_string(width_nm) + " wide",
                [=](double nm) { return 0.35 + 0.62 / (1 + std::exp((edge_nm - nm) / width_nm)); });
}

// n and k of Johnson and Christy 1974, Phys. Rev. B 9, 5056 (refractiveindex.info, CC0), around the visible.
struct index_row {
    double nm, n, k;
};
constexpr std::array<index_row, 17> chromium = {{{354, 1.84, 2.64},
                                                 {368, 1.87, 2.69},
                                                 {381, 1.92, 2.74},
                                                 {397, 2.00, 2.83},
                                                 {413, 2.08, 2.93},
                                                 {431, 2.19, 3.04},
                                                 {451, 2.33, 3.14},
                                                 {471, 2.51, 3.24},
                                                 {496, 2.75, 3.30},
                                                 {521, 2.94, 3.33},
                                                 {549, 3.18, 3.33},
                                                 {582, 3.22, 3.30},
                                                 {617, 3.17, 3.30},
                                                 {659, 3.09, 3.34},
                                                 {704, 3.05, 3.39},
                                                 {756, 3.08, 3.42},
                                                 {830, 3.21, 3.48}}};

double chromium_at_normal_incidence(double nm) {
    const auto above = std::upper_bound(chromium.begin(), chromium.end() - 1, nm,
                                        [](double x, const index_row& r) { return x < r.nm; });
    const index_row &lo = *(above - 1), &hi = *above;
    const double t = (nm - lo.nm) / (hi.nm - lo.nm), n = std::lerp(lo.n, hi.n, t),
                 k = std::lerp(lo.k, hi.k, t);
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
}

TEST(color, f0_of_chromium_is_that_of_real_time_rendering_table_9_2) {
    constexpr double published_to_three_decimals =
        7e-4; // .0005 of the print, and .0002 of its own integration
    expect_near(integrate(default_recipe(color_space::srgb), chromium_at_normal_incidence),
                {0.549, 0.556, 0.554}, published_to_three_decimals, "chromium");
    expect_the_same_in_every_space("chromium", chromium_at_normal_incidence);
}

} // namespace
