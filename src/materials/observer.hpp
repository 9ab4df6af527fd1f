#pragma once

#include <fresnel/color.hpp>

namespace fresnel {

/// The recipe by which every colour is made unless another is asked for: CIE 1931 2 degree observer at 1 nm
/// from 360 to 830 nm; sRGB, P3, Rec.2020 and XYZ under D65 without adaptation; ACEScg under the illuminant
/// of the ACES white, adapted by Bradford to AP1's white. Built on the first call.
const recipe& default_recipe(color_space space);

/// The colour of a perfect reflector by the default recipe: (1, 1, 1), and in XYZ that of its illuminant.
rgb white_of(color_space space);

/// The line that accompanies every colour made by the default recipe and limited by a policy: "CIE 1931 2°,
/// 360–830 nm at 1 nm, D65 without adaptation, linear sRGB, gamut none".
std::string recipe_text(color_space space, gamut policy = gamut::none);

/// CIEDE2000 of two colours of a space, seen under its illuminant beside a white of (1, 1, 1).
double delta_e_2000(const rgb& p, const rgb& q, color_space space);

/// The colour in linear sRGB, for screens; not limited to [0, 1].
rgb to_srgb(const rgb& color, color_space space);

/// A colour of linear sRGB in another space: the inverse of `to_srgb`.
rgb from_srgb(const rgb& linear, color_space space);

/// The colour as an 8-bit sRGB screen shows it, marked where it lies outside sRGB.
screen_color to_screen(const rgb& color, color_space space);

} // namespace fresnel
