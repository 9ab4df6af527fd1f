#pragma once

#include "sources/sources.hpp"

#include "analysis/measure.hpp"

#include <string>
#include <vector>

// What the texts' figures share: axes, curves sampled from functions, and the list each text adds.

namespace fresnel {

std::vector<source_figure> wloka_figures();
std::vector<source_figure> lagarde_figures();
std::vector<source_figure> lagarde_tables();
std::vector<source_figure> highlight_figures();
std::vector<source_figure> halladay_figures();
std::vector<source_figure> rtr4_figures();
std::vector<source_figure> rtr4_tables();

std::vector<claim> wloka_claims();
std::vector<claim> lagarde_claims();
std::vector<claim> highlight_claims();
std::vector<claim> halladay_claims();
std::vector<claim> rtr4_claims();

namespace draw {

/// Colours that tell curves apart on light and dark ground; red, green and blue stand for channels.
inline constexpr const char* blue = "#3b7dd8";
inline constexpr const char* orange = "#e07b39";
inline constexpr const char* green = "#3f9d5a";
inline constexpr const char* red = "#d1495b";
inline constexpr const char* violet = "#8a63d2";
inline constexpr const char* gray = "#808080";

/// One of n colours from dark violet to yellow, for a family over a parameter.
std::string ramp(std::size_t i, std::size_t n);

enum class against { theta, cosine, sine };

axis horizontal(against what);
axis axis_of(std::string label, double lo = 0, double hi = 1, double tick = 0);

/// f at 361 angles from 0 to 90 degrees, drawn against theta, cos or sin theta.
series curve(const std::string& label, const curve_function& f, const std::string& color,
             stroke style = stroke::solid, double width = 2, against what = against::theta);

/// f(x) at `count` points of [lo, hi].
series sampled(const std::string& label, const std::function<double(double)>& f, double lo, double hi,
               const std::string& color, stroke style = stroke::solid, double width = 2, int count = 241);

/// A straight line between two points.
series line(double x0, double y0, double x1, double y1, const std::string& color = gray, double width = 1.6,
            stroke style = stroke::solid);

/// An arrow from one point to the other, as lines; the head is in units of y.
std::vector<series> arrow(double x0, double y0, double x1, double y1, const std::string& color,
                          double width = 2, double head = 0.05);

} // namespace draw

/// "less than 1e-12" and the like: the size of a difference that is rounding, in steps coarse enough to be the same
/// on every machine.
std::string rounding(double difference);

/// Exact unpolarised reflectance between media of relative index eta, and of one with k.
curve_function exact_dielectric(double eta);
curve_function exact_conductor(double n, double k);

} // namespace fresnel
