#pragma once

#include "analysis/curve.hpp"
#include "figure/figure.hpp"

#include <array>
#include <string>
#include <vector>

// Pieces that figures of materials share.

namespace fresnel {

/// Colours of the red, green and blue channel's curves.
inline constexpr std::array<const char*, 3> channel_colors = {"#d92b2b", "#1fa84a", "#3b6fd4"};

/// One channel of colours against x.
series channel_series(const std::vector<rgb>& values, const std::vector<double>& x, std::size_t channel);

/// Colours of a working space as a strip of 8-bit sRGB, clamped to its gamut.
strip color_strip(const std::string& label, const std::vector<rgb>& values, color_space space);

/// Exact reflectance from 380 to 780 nm and 0 to 90 degrees, to be drawn in perspective.
height_field wavelength_surface(const material& substance, double ambient);

/// The largest multiple of step not above value, and the smallest not below.
double floor_to(double value, double step);
double ceil_to(double value, double step);

} // namespace fresnel
