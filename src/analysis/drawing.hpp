#pragma once

#include "analysis/curve.hpp"
#include "figure/figure.hpp"

#include <array>
#include <string>
#include <string_view>
#include <vector>

// What the figures of this project share: their colours, axes and names.

namespace fresnel {

inline constexpr std::array<const char*, 3> channel_colors = {"#d92b2b", "#1fa84a", "#3b6fd4"};

/// At least 3 : 1 against white and #14171b, and apart from each other under colour blindness.
inline constexpr std::array<const char*, 6> model_colors = {"#0072b2", "#d55e00", "#1f9d78",
                                                            "#9b4df0", "#b58a5a", "#d966a8"};

/// A colour of the perceptually even ramp viridis, as #rrggbb.
///
/// t   [0, 1]: from dark violet over green to yellow
std::string viridis(double t);

/// The colour as much lighter (towards white) or darker (towards black).
///
/// color    #rrggbb
/// amount   [-1, 1]: -1 is black, 0 the colour itself, 1 white
std::string shaded(std::string_view color, double amount);

extern const axis theta_axis;

/// The letters of a space's channels: R G B, or X Y Z.
std::array<const char*, 3> channel_letters(color_space space);

/// The space as a label says it: "linear sRGB".
std::string space_title(color_space space);

/// A name that is safe in a file name and as an id: anything else becomes a dash.
std::string slug(std::string name);

/// One channel of a curve against x, in the channel's colour.
series channel_series(const std::vector<rgb>& values, const std::vector<double>& x, std::size_t channel);

/// An axis for reflectances that holds all curves: from 0, or a little below a curve that is everywhere high, to 1
/// or the top of a gold that exceeds it.
axis reflectance_axis(const std::string& label, const std::vector<series>& curves);

/// An axis for signed errors that holds all curves, 0, and some room for labels.
axis error_axis(const std::string& label, const std::vector<series>& curves);

/// A curve as the colours that white light is reflected in, every `step`th value a pixel.
strip color_strip(const std::string& label, const std::vector<rgb>& values, color_space space,
                  std::size_t step = 2);

/// Exact reflectance of a material over wavelength and angle, unpolarised or of one polarization.
height_field spectral_height_field(const material& substance, double ambient,
                                   polarization which = polarization::mean);

} // namespace fresnel
