#pragma once

#include <fresnel/color.hpp>
#include <fresnel/material.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

/// What kind of surface reflects that much at normal incidence in air.
///
///   below 0.02    "submerged or coated"   water, the least of common surfaces, has 0.02
///   0.02 – 0.08   "dielectric"            liquids, plastics, glass, stone, most gems
///   0.08 – 0.2    "gem"                   the densest gems; diamond and its simulants from 0.13
///   0.2 – 0.45    "semiconductor"         hardly any material that is rendered
///   from 0.45     "metal"
///
/// luminance   Y of F0, 1 for a perfect reflector
/// source      Akenine-Moeller et al. 2018, "Real-Time Rendering", 4th ed., sec. 9.5.2, tables 9.1 to 9.3
std::string_view class_of_f0(double luminance);

/// A material and how far its F0 is from a colour.
struct neighbour {
    const material* substance; ///< a built-in one
    rgb f0;                    ///< where the material is known as a range, its value nearest to the colour
    double delta_e; ///< CIEDE2000 beside a white of F0 = 1; 0 inside a range. A code, and a colour with a
                    ///< channel of 1, is compared with the clamped colour of a material outside the gamut
};

/// What an F0 could be.
struct identification {
    color_space space;
    double ambient;
    rgb f0;
    double luminance;
    std::string_view surface;          ///< `class_of_f0`
    std::vector<neighbour> nearest;    ///< the nearest first
    std::vector<std::string> warnings; ///< sentences, each with the number and what to do
};

/// How an F0 was given: linear numbers may have been meant as encoded, codes cannot.
enum class f0_source { numbers, hex, index };

/// Finds the built-in materials whose F0 is nearest, and says what is suspicious about the value.
///
/// f0        linear colour of `space`, at a boundary with a medium of index `ambient`
/// count     how many materials, 1 or more
identification identify(const rgb& f0, color_space space, double ambient, f0_source source,
                        std::size_t count);

/// The colourless F0 of that reflectance in a space.
rgb grey(double reflectance, color_space space);

} // namespace fresnel
