#include "analysis/identify.hpp"

#include "analysis/curve.hpp"
#include "materials/catalog.hpp"
#include "materials/observer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <tuple>

namespace fresnel {

namespace {

// The bounds of the classes: see `class_of_f0`.
constexpr double water = 0.02, most_gems = 0.08, diamonds = 0.2, metals = 0.45;

// The built-in dielectrics have a chroma of at most 3.2, one step of an 8-bit code near 0.04 makes 1.
constexpr double visible_chroma = 5;

// CIEDE2000 beyond which two colours are no longer taken for the same surface.
constexpr double far = 5;

// Gold, the brightest of all in one channel, has 1.04 in the red of linear sRGB.
constexpr double brightest_channel = 1.1;

// A value counts as having reached a bound that rounding keeps it from.
bool reaches(double value, double bound) { return value >= bound - gamut_rounding; }

double luminance_of(const rgb& color, color_space space) { return (default_recipe(space).to_xyz * color)[1]; }

// ---- neighbours -------------------------------------------------------------------------------------------

// The reflectances between two ends include 0 where the index passes that of the ambient medium.
bool passes_match(const material& m, double ambient) {
    return (index_at(low_end(m), 550).n - ambient) * (index_at(high_end(m), 550).n - ambient) < 0;
}

// A material known as a range is colourless: its nearest value is that of the same luminance, or an end.
rgb nearest_f0(const material& m, color_space space, double ambient, double luminance) {
    if (!has_range(m)) return colour_at(m, space, ambient, 1);
    const double a = luminance_of(colour_at(low_end(m), space, ambient, 1), space);
    const double b = luminance_of(colour_at(high_end(m), space, ambient, 1), space);
    const double least = passes_match(m, ambient) ? 0 : std::min(a, b);
    return grey(std::clamp(luminance, least, std::max(a, b)), space);
}

// The colour as it would have been given: a code holds no colour outside sRGB, and a channel of exactly 1 was clamped.
rgb as_given(const rgb& f0, const identification& of, f0_source source) {
    if (source == f0_source::hex)
        return from_srgb(apply_gamut(to_srgb(f0, of.space), gamut::clamp), of.space);
    const bool clamped = of.space != color_space::xyz && *std::max_element(of.f0.begin(), of.f0.end()) == 1;
    return clamped ? apply_gamut(f0, gamut::clamp) : f0;
}

std::vector<neighbour> all_neighbours(const identification& of, f0_source source) {
    std::vector<neighbour> all;
    for (const material& m : builtin_materials()) {
        const rgb f0 = nearest_f0(m, of.space, of.ambient, of.luminance);
        all.push_back({&m, f0, delta_e_2000(of.f0, as_given(f0, of, source), of.space)});
    }
    // of two that are equally near, the one that is a single value says more; then the order of the catalogue
    const auto key = [](const neighbour& n) {
        return std::tuple(std::round(n.delta_e * 1e6), has_range(*n.substance), n.substance);
    };
    std::sort(all.begin(), all.end(),
              [&](const neighbour& a, const neighbour& b) { return key(a) < key(b); });
    return all;
}

// ---- warnings ---------------------------------------------------------------------------------------------

using warning = std::optional<std::string>;

std::string number(const rgb& f0) {
    return f0[0] == f0[1] && f0[1] == f0[2] ? fmt::format("{:.4g}", f0[0])
                                            : fmt::format("{:.4g} {:.4g} {:.4g}", f0[0], f0[1], f0[2]);
}

warning below_water(const identification& of) {
    if (reaches(of.luminance, water) || of.ambient != 1) return {};
    return fmt::format("F0 {0} is below {1}, the F0 of water: in air only ice and coatings come so low, and "
                       "some engines read it as occlusion; use {1} or more, or give --ambient for a surface "
                       "under a liquid.",
                       number(of.f0), water);
}

bool in_empty_band(const identification& of) {
    return reaches(of.luminance, diamonds) && !reaches(of.luminance, metals);
}

warning between_dielectrics_and_metals(const identification& of) {
    if (!in_empty_band(of)) return {};
    return fmt::format(
        "F0 {0} lies between {3} and {4}, where there are only semiconductors and a few rare crystals and "
        "dark metals: often it is a texel that mixes metal and dielectric; use {1} to {2} for a dielectric, "
        "more than {4} for a metal.",
        number(of.f0), water, most_gems, diamonds, metals);
}

warning coloured_dielectric(const identification& of) {
    if (reaches(of.luminance, diamonds)) return {};
    const recipe& how = default_recipe(of.space);
    const lab seen = to_lab(how.to_xyz * of.f0, how.white);
    const double chroma = std::hypot(seen[1], seen[2]);
    if (chroma < visible_chroma) return {};
    return fmt::format(
        "F0 {} has a colour (chroma {:.0f}), but that of a dielectric is colourless: its colour "
        "comes from below the surface; use {:.3f} in every channel and put the colour into "
        "the base colour.",
        number(of.f0), chroma, of.luminance);
}

// Only where the number itself is suspicious and decoding it lands among the dielectrics.
warning encoded(const identification& of, f0_source source) {
    if (source != f0_source::numbers || of.space == color_space::xyz || !in_empty_band(of)) return {};
    const rgb decoded = {decode_srgb(of.f0[0]), decode_srgb(of.f0[1]), decode_srgb(of.f0[2])};
    if (class_of_f0(luminance_of(decoded, of.space)) != "dielectric") return {};
    return fmt::format("F0 {} is the sRGB code of {}, an ordinary dielectric: F0 is linear; if the value was "
                       "picked from an image or a colour picker, use {} or give it as HEX.",
                       number(of.f0), number(decoded), number(decoded));
}

warning brighter_than_all(const identification& of) {
    const material* brightest = nullptr;
    double most = 0;
    for (const material& m : builtin_materials()) {
        const double Y = luminance_of(colour_at(m, of.space, of.ambient, 1), of.space);
        if (Y > most) most = Y, brightest = &m;
    }
    if (of.luminance <= most) return {};
    return fmt::format("F0 {} reflects {:.3f} of white light, more than the brightest built-in metal, {} "
                       "({:.3f}): lower it.",
                       number(of.f0), of.luminance, brightest->name, most);
}

warning outside_gamut(const identification& of) {
    if (of.space == color_space::xyz || in_gamut(of.f0)) return {};
    const double highest = *std::max_element(of.f0.begin(), of.f0.end());
    if (highest > brightest_channel)
        return fmt::format("F0 {} exceeds {}, which no measured metal reaches: a surface reflects at most "
                           "what it receives; divide the colour by {:.4g}.",
                           number(of.f0), brightest_channel, highest);
    return fmt::format("F0 {} lies outside [0, 1], which a saturated metal may (gold's red is 1.04 in linear "
                       "sRGB): clamp it where the renderer needs to, or use --space acescg.",
                       number(of.f0));
}

warning nothing_near(const identification& of) {
    const neighbour& first = of.nearest.front();
    if (first.delta_e <= far) return {};
    return fmt::format(
        "No built-in material is near: the nearest, {}, is ΔE {:.1f} away (1 is just visible); "
        "check the value, or start from F0 {}.",
        first.substance->name, first.delta_e, number(first.f0));
}

// The words by which the catalogue says that a dataset is no sound measurement.
bool is_doubtful(const material& m) {
    constexpr std::array words = {"Calculated", "not measurement", "without peer review",
                                  "few points", "only two points", "much darker than other pages"};
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return m.quality.find(word) != std::string::npos; });
}

warning doubtful_source(const identification& of) {
    const neighbour& first = of.nearest.front();
    if (first.delta_e > far || !is_doubtful(*first.substance)) return {};
    return fmt::format("The nearest dataset, {}, is to be taken with care ({}): compare with the others.",
                       first.substance->name,
                       first.substance->quality.substr(0, first.substance->quality.find(';')));
}

std::vector<std::string> warnings_of(const identification& of, f0_source source) {
    std::vector<std::string> all;
    for (const warning& one :
         {below_water(of), between_dielectrics_and_metals(of), encoded(of, source), coloured_dielectric(of),
          outside_gamut(of), brighter_than_all(of), nothing_near(of), doubtful_source(of)})
        if (one) all.push_back(*one);
    return all;
}

} // namespace

std::string_view class_of_f0(double luminance) {
    return reaches(luminance, metals)      ? "metal"
           : reaches(luminance, diamonds)  ? "semiconductor"
           : reaches(luminance, most_gems) ? "gem"
           : reaches(luminance, water)     ? "dielectric"
                                           : "submerged or coated";
}

rgb grey(double reflectance, color_space space) {
    const rgb white = white_of(space);
    return {reflectance * white[0], reflectance * white[1], reflectance * white[2]};
}

identification identify(const rgb& f0, color_space space, double ambient, f0_source source,
                        std::size_t count) {
    const double luminance = luminance_of(f0, space);
    identification result{space, ambient, f0, luminance, class_of_f0(luminance), {}, {}};
    result.nearest = all_neighbours(result, source);
    result.nearest.resize(std::min(count, result.nearest.size()));
    result.warnings = warnings_of(result, source);
    return result;
}

} // namespace fresnel
