#pragma once

// From a reflectance spectrum to a colour, and between colours. No tables here: the observer and the
// illuminants are compiled once (src/materials/observer.cpp) and handed in.
//
// A colour is linear light. A perfect reflector is exactly (1, 1, 1) in every RGB space and Y = 1 in XYZ.

#include <algorithm>
#include <array>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <numbers>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

namespace fresnel {

using rgb = std::array<double, 3>;         ///< linear red, green, blue of a space that the context names
using tristimulus = std::array<double, 3>; ///< CIE XYZ, Y = 1 for white

// ---- matrices ---------------------------------------------------------------------------------------------

using matrix3 = std::array<std::array<double, 3>, 3>; ///< rows first

/// A matrix times a column, whose number type may be any that a double converts to (a dual, an interval).
template <class T>
constexpr std::array<T, 3> operator*(const matrix3& m, const std::array<T, 3>& v) {
    const auto row = [&](std::size_t i) { return T(m[i][0]) * v[0] + T(m[i][1]) * v[1] + T(m[i][2]) * v[2]; };
    return {row(0), row(1), row(2)};
}

/// a b: the matrix that applies b first.
constexpr matrix3 operator*(const matrix3& a, const matrix3& b) {
    matrix3 result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[i][j] = a[i][0] * b[0][j] + a[i][1] * b[1][j] + a[i][2] * b[2][j];
    return result;
}

/// The matrix that scales each component by its own factor.
constexpr matrix3 diagonal(const std::array<double, 3>& d) {
    return {{{d[0], 0, 0}, {0, d[1], 0}, {0, 0, d[2]}}};
}

/// The inverse, by cofactors; infinite or NaN for a singular matrix, which independent primaries never give.
constexpr matrix3 inverse(const matrix3& m) {
    const auto minor = [&m](std::size_t i, std::size_t j) {
        const std::size_t r = (i + 1) % 3, s = (i + 2) % 3, p = (j + 1) % 3, q = (j + 2) % 3;
        return m[r][p] * m[s][q] - m[r][q] * m[s][p];
    };
    const double det = m[0][0] * minor(0, 0) + m[0][1] * minor(0, 1) + m[0][2] * minor(0, 2);
    matrix3 result{};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            result[i][j] = minor(j, i) / det;
    return result;
}

// ---- spaces -----------------------------------------------------------------------------------------------

enum class color_space { srgb, p3, rec2020, acescg, xyz };

/// The names that the command takes and prints, in the order of the enumerators.
inline constexpr std::array<std::string_view, 5> color_space_names = {"srgb", "p3", "rec2020", "acescg",
                                                                      "xyz"};

/// The name of a space, as the command spells it.
constexpr std::string_view to_string(color_space space) {
    return color_space_names[static_cast<std::size_t>(space)];
}

/// The space of that name; none if there is none. Names are lower case.
constexpr std::optional<color_space> parse_color_space(std::string_view name) {
    for (std::size_t i = 0; i < color_space_names.size(); ++i)
        if (color_space_names[i] == name) return static_cast<color_space>(i);
    return std::nullopt;
}

/// CIE 1931 chromaticity.
struct chromaticity {
    double x, y;
};

/// Red, green and blue of a space: IEC 61966-2-1 (sRGB), SMPTE EG 432-1 (P3), ITU-R BT.2020, ACES S-2014-004
/// (AP1). Throws std::invalid_argument for xyz, which has none.
constexpr std::array<chromaticity, 3> primaries(color_space space) {
    switch (space) {
    case color_space::srgb:
        return {{{0.640, 0.330}, {0.300, 0.600}, {0.150, 0.060}}};
    case color_space::p3:
        return {{{0.680, 0.320}, {0.265, 0.690}, {0.150, 0.060}}};
    case color_space::rec2020:
        return {{{0.708, 0.292}, {0.170, 0.797}, {0.131, 0.046}}};
    case color_space::acescg:
        return {{{0.713, 0.293}, {0.165, 0.830}, {0.128, 0.044}}};
    case color_space::xyz:
        break;
    }
    throw std::invalid_argument("primaries: xyz has none");
}

/// The ACES white point (TB-2018-001) and the rounded D65 of the RGB standards.
inline constexpr chromaticity aces_white{0.32168, 0.33767}, d65_white{0.3127, 0.3290};

/// The tristimulus values with Y = 1 of a chromaticity; y > 0.
constexpr tristimulus to_xyz(chromaticity c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

/// Linear RGB of those primaries to XYZ, (1, 1, 1) going to `white`.
constexpr matrix3 rgb_to_xyz(const std::array<chromaticity, 3>& p, const tristimulus& white) {
    const tristimulus r = to_xyz(p[0]), g = to_xyz(p[1]), b = to_xyz(p[2]);
    const matrix3 columns = {{{r[0], g[0], b[0]}, {r[1], g[1], b[1]}, {r[2], g[2], b[2]}}};
    return columns * diagonal(inverse(columns) * white);
}

/// Bradford's adaptation of XYZ from one white to another (Lam 1985; the matrix as in ICC.1:2022, annex E).
constexpr matrix3 bradford(const tristimulus& from, const tristimulus& to) {
    constexpr matrix3 cone = {
        {{0.8951, 0.2664, -0.1614}, {-0.7502, 1.7135, 0.0367}, {0.0389, -0.0685, 1.0296}}};
    const std::array<double, 3> a = cone * from, b = cone * to;
    return inverse(cone) * diagonal({b[0] / a[0], b[1] / a[1], b[2] / a[2]}) * cone;
}

// ---- spectrum to colour -----------------------------------------------------------------------------------

/// How a reflectance spectrum becomes a colour: everything that a published number must say.
struct recipe {
    color_space space;
    std::vector<double> wavelength_nm;
    std::vector<std::array<double, 3>> weight; ///< per wavelength: observer x illuminant x matrix, normalised
    tristimulus white;                         ///< the illuminant under the observer, Y = 1
    matrix3 to_xyz;                            ///< colours of the space to XYZ under `white`
    std::string text;                          ///< one line that accompanies every colour
};

/// An observer and the light it sees by, sampled at the same evenly spaced wavelengths.
struct observer {
    std::vector<double> wavelength_nm;
    std::vector<std::array<double, 3>> bars; ///< colour-matching functions x, y, z
    std::vector<double> power;               ///< of the illuminant, in any unit
};

/// Lets the last weight absorb the rounding of the sum of all, so that R = 1 is white to the last bit: the sum
/// of the others is within a factor of two of white, hence the difference is exact. It moves by less than 1e-14.
inline void settle_white(recipe& how) {
    const std::array<double, 3> target = how.space == color_space::xyz ? how.white : rgb{1, 1, 1};
    for (std::size_t c = 0; c < 3; ++c) {
        double others = 0;
        for (std::size_t i = 0; i + 1 < how.weight.size(); ++i)
            others += how.weight[i][c];
        how.weight.back()[c] = target[c] - others;
    }
}

/// Builds a recipe from at least two samples. `adapted_white` is the white to which XYZ is adapted by Bradford before
/// the matrix of the primaries, or none: then the primaries' white is the illuminant itself, and nothing is adapted.
inline recipe make_recipe(color_space space, const observer& eye, std::optional<chromaticity> adapted_white,
                          std::string text) {
    recipe how{space, eye.wavelength_nm, {}, {}, {}, std::move(text)};
    how.weight.reserve(eye.power.size());
    for (std::size_t i = 0; i < eye.power.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            how.white[c] += eye.bars[i][c] * eye.power[i];
    const double Y = how.white[1];
    for (double& component : how.white)
        component /= Y;

    how.to_xyz = diagonal({1, 1, 1});
    if (space != color_space::xyz) {
        const tristimulus target = adapted_white ? to_xyz(*adapted_white) : how.white;
        how.to_xyz = bradford(target, how.white) * rgb_to_xyz(primaries(space), target);
    }
    const matrix3 from_xyz = inverse(how.to_xyz);
    for (std::size_t i = 0; i < eye.power.size(); ++i) {
        const double scale = eye.power[i] / Y;
        how.weight.push_back(
            from_xyz * tristimulus{eye.bars[i][0] * scale, eye.bars[i][1] * scale, eye.bars[i][2] * scale});
    }
    settle_white(how);
    return how;
}

/// The colour of a reflectance spectrum: the sum of weight times reflectance.
///
/// reflectance   one for each of the recipe's wavelengths, [0, 1]; of any number type that takes a double
/// returns       linear colour in the recipe's space; may lie outside [0, 1], see `gamut`
/// throws        std::invalid_argument if there are more or fewer reflectances than wavelengths
template <class T>
std::array<T, 3> integrate(const recipe& how, const std::vector<T>& reflectance) {
    static_assert(!std::is_integral_v<T>, "weights are fractions");
    if (reflectance.size() != how.weight.size())
        throw std::invalid_argument("integrate: " + std::to_string(reflectance.size()) +
                                    " reflectances, must be " + std::to_string(how.weight.size()));
    std::array<T, 3> sum = {T(0), T(0), T(0)};
    for (std::size_t i = 0; i < reflectance.size(); ++i)
        for (std::size_t c = 0; c < 3; ++c)
            sum[c] = sum[c] + T(how.weight[i][c]) * reflectance[i];
    return sum;
}

/// The colour of a reflectance given as a function of wavelength in nm, called once at each of the recipe's.
template <std::invocable<double> F>
auto integrate(const recipe& how, F reflectance_of_nm) {
    std::vector<std::remove_cvref_t<std::invoke_result_t<F&, double>>> reflectance;
    reflectance.reserve(how.wavelength_nm.size());
    for (const double nm : how.wavelength_nm)
        reflectance.push_back(reflectance_of_nm(nm));
    return integrate(how, reflectance);
}

/// The matrix from one recipe's space to another's; adapts by Bradford where the whites differ.
inline matrix3 conversion_matrix(const recipe& from, const recipe& to) {
    return inverse(to.to_xyz) * bradford(from.white, to.white) * from.to_xyz;
}

/// A colour of one recipe's space in another's.
inline rgb convert(const rgb& color, const recipe& from, const recipe& to) {
    return conversion_matrix(from, to) * color;
}

// ---- gamut and encoding -----------------------------------------------------------------------------------

/// What to do with a component outside [0, 1]: leave it, clamp each, or divide by the largest and clamp at 0.
/// Meant for RGB: XYZ has no gamut of this kind (the Z of white is 1.089 under D65).
enum class gamut { none, clamp, divide };

/// The names that the command takes and prints, in the order of the enumerators.
inline constexpr std::array<std::string_view, 3> gamut_names = {"none", "clamp", "divide"};

/// The name of a policy, as the command spells it.
constexpr std::string_view to_string(gamut policy) { return gamut_names[static_cast<std::size_t>(policy)]; }

/// The policy of that name; none if there is none.
constexpr std::optional<gamut> parse_gamut(std::string_view name) {
    for (std::size_t i = 0; i < gamut_names.size(); ++i)
        if (gamut_names[i] == name) return static_cast<gamut>(i);
    return std::nullopt;
}

/// How far a colour may leave [0, 1] by the rounding of a sum and a matrix, without being called outside.
inline constexpr double gamut_rounding = 1e-12;

/// Whether every component is in [0, 1], up to rounding: white that went through a matrix still is. False for
/// NaN.
constexpr bool in_gamut(const rgb& color) {
    return std::all_of(color.begin(), color.end(),
                       [](double v) { return v >= -gamut_rounding && v <= 1 + gamut_rounding; });
}

/// A colour under a policy. `divide` keeps the ratios of the positive components (Lagarde's gold), `clamp` the
/// components that were inside (that of Real-Time Rendering).
constexpr rgb apply_gamut(rgb color, gamut policy) {
    if (policy == gamut::none) return color;
    const double largest = policy == gamut::divide ? std::max({color[0], color[1], color[2], 1.0}) : 1.0;
    for (double& v : color)
        v = std::clamp(v / largest, 0.0, 1.0);
    return color;
}

/// sRGB's transfer function, linear to encoded (IEC 61966-2-1). Beyond [0, 1] both pieces simply go on.
inline double encode_srgb(double linear) {
    return linear <= 0.0031308 ? 12.92 * linear : 1.055 * std::pow(linear, 1 / 2.4) - 0.055;
}

/// sRGB's transfer function, encoded to linear (IEC 61966-2-1).
inline double decode_srgb(double encoded) {
    return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4);
}

using rgb8 = std::array<std::uint8_t, 3>; ///< encoded sRGB

/// Linear sRGB to 8-bit codes, rounded to the nearest and clamped to the gamut; NaN becomes 0. `to_screen` also
/// says whether that changed the colour.
inline rgb8 encode_srgb8(const rgb& linear) {
    rgb8 codes{};
    for (std::size_t c = 0; c < 3; ++c) {
        const double inside = linear[c] > 0 ? std::min(linear[c], 1.0) : 0;
        codes[c] = static_cast<std::uint8_t>(std::lround(255 * encode_srgb(inside)));
    }
    return codes;
}

/// 8-bit codes to linear sRGB.
inline rgb decode_srgb8(const rgb8& codes) {
    return {decode_srgb(codes[0] / 255.0), decode_srgb(codes[1] / 255.0), decode_srgb(codes[2] / 255.0)};
}

/// A colour as an 8-bit sRGB screen shows it, and whether it could: if not, the codes are of the clamped colour.
struct screen_color {
    rgb8 codes;
    bool in_gamut;
};

/// Linear sRGB as a screen shows it.
inline screen_color to_screen(const rgb& linear) { return {encode_srgb8(linear), in_gamut(linear)}; }

/// "#rrggbb", lower case.
inline std::string to_hex(const rgb8& codes) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string text = "#";
    for (const std::uint8_t code : codes)
        text += digits[code / 16], text += digits[code % 16];
    return text;
}

/// "#rrggbb", and " (clamped)" after it where the screen cannot show the colour.
inline std::string to_hex(const screen_color& shown) {
    return to_hex(shown.codes) + (shown.in_gamut ? "" : " (clamped)");
}

/// "#rgb" or "#rrggbb", the # optional; none where it is neither.
inline std::optional<rgb8> parse_hex(std::string_view text) {
    if (text.starts_with('#')) text.remove_prefix(1);
    if (text.size() != 3 && text.size() != 6) return std::nullopt;
    rgb8 codes{};
    const std::size_t digits = text.size() / 3;
    for (std::size_t i = 0; i < text.size(); ++i) {
        const char c = text[i];
        const int value = c >= '0' && c <= '9'   ? c - '0'
                          : c >= 'a' && c <= 'f' ? c - 'a' + 10
                          : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                                 : -1;
        if (value < 0) return std::nullopt;
        const int shifted = digits == 1 ? value * 17 : i % 2 == 0 ? value * 16 : value;
        codes[i / digits] = static_cast<std::uint8_t>(codes[i / digits] + shifted);
    }
    return codes;
}

// ---- difference -------------------------------------------------------------------------------------------

using lab = std::array<double, 3>; ///< CIELAB L*, a*, b*

/// CIELAB of a colour seen beside a white, both XYZ under the same illuminant (CIE 015:2018, sec. 8.2.1).
inline lab to_lab(const tristimulus& color, const tristimulus& white) {
    const auto f = [](double t) {
        constexpr double d = 6.0 / 29;
        return t > d * d * d ? std::cbrt(t) : t / (3 * d * d) + 4.0 / 29;
    };
    const double x = f(color[0] / white[0]), y = f(color[1] / white[1]), z = f(color[2] / white[2]);
    return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

/// CIEDE2000 colour difference, all weights 1 (Sharma, Wu and Dalal 2005, "The CIEDE2000 color-difference
/// formula: implementation notes, supplementary test data, and mathematical observations").
inline double delta_e_2000(const lab& p, const lab& q) {
    const auto pow7 = [](double v) { return v * v * v * v * v * v * v; };
    const auto toned = [pow7](double c) { return std::sqrt(pow7(c) / (pow7(c) + pow7(25))); };
    constexpr double degree = std::numbers::pi / 180;

    const double G = 0.5 * (1 - toned((std::hypot(p[1], p[2]) + std::hypot(q[1], q[2])) / 2));
    const double a1 = p[1] * (1 + G), a2 = q[1] * (1 + G);
    const double C1 = std::hypot(a1, p[2]), C2 = std::hypot(a2, q[2]);
    const auto hue = [](double b, double a) {
        const double h = a == 0 && b == 0 ? 0 : std::atan2(b, a) / degree;
        return h < 0 ? h + 360 : h;
    };
    const double h1 = hue(p[2], a1), h2 = hue(q[2], a2);
    const bool grey = C1 * C2 == 0;
    const bool far = std::abs(h1 - h2) > 180;
    const double dh = grey ? 0 : !far ? h2 - h1 : h2 - h1 + (h2 <= h1 ? 360 : -360);
    const double dL = q[0] - p[0], dC = C2 - C1, dH = 2 * std::sqrt(C1 * C2) * std::sin(dh / 2 * degree);

    const double L = (p[0] + q[0]) / 2, C = (C1 + C2) / 2;
    const double h = grey ? h1 + h2 : !far ? (h1 + h2) / 2 : (h1 + h2 + (h1 + h2 < 360 ? 360 : -360)) / 2;
    const double T = 1 - 0.17 * std::cos((h - 30) * degree) + 0.24 * std::cos(2 * h * degree) +
                     0.32 * std::cos((3 * h + 6) * degree) - 0.20 * std::cos((4 * h - 63) * degree);
    const double L50 = (L - 50) * (L - 50);
    const double S_L = 1 + 0.015 * L50 / std::sqrt(20 + L50), S_C = 1 + 0.045 * C, S_H = 1 + 0.015 * C * T;
    const double turn = 30 * std::exp(-((h - 275) / 25) * ((h - 275) / 25));
    const double R_T = -2 * toned(C) * std::sin(2 * turn * degree);
    const double l = dL / S_L, c = dC / S_C, s = dH / S_H;
    return std::sqrt(l * l + c * c + s * s + R_T * c * s);
}

} // namespace fresnel
