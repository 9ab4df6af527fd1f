#include "analysis/drawing.hpp"

#include "materials/observer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fresnel {

namespace {

// The smallest multiple of step below, and above.
double floor_to(double value, double step) { return std::floor(value / step) * step; }
double ceil_to(double value, double step) { return std::ceil(value / step) * step; }

// The least and the greatest of all curves and of two values to begin with; gaps are passed over.
std::array<double, 2> extent(const std::vector<series>& curves, std::array<double, 2> ends) {
    for (const series& s : curves)
        for (const double y : s.y)
            if (std::isfinite(y)) ends = {std::min(ends[0], y), std::max(ends[1], y)};
    return ends;
}

// Halfway and the like between two codes, channel by channel.
rgb8 blend(const rgb8& from, const rgb8& to, double t) {
    rgb8 result{};
    for (std::size_t c = 0; c < 3; ++c)
        result[c] = static_cast<std::uint8_t>(std::lround(from[c] + (to[c] - from[c]) * t));
    return result;
}

} // namespace

const axis theta_axis = {"angle of incidence θ (degrees)", 0, 90, 15};

std::string viridis(double t) {
    const double at = std::clamp(t, 0.0, 1.0) * (viridis_stops.size() - 1);
    const auto i = std::min(static_cast<std::size_t>(at), viridis_stops.size() - 2);
    return to_hex(
        blend(*parse_hex(viridis_stops[i]), *parse_hex(viridis_stops[i + 1]), at - static_cast<double>(i)));
}

std::string shaded(std::string_view color, double amount) {
    const rgb8 end = amount < 0 ? rgb8{0, 0, 0} : rgb8{255, 255, 255};
    return to_hex(blend(*parse_hex(color), end, std::abs(amount)));
}

std::array<const char*, 3> channel_letters(color_space space) {
    if (space == color_space::xyz) return {"X", "Y", "Z"};
    return {"R", "G", "B"};
}

std::string space_title(color_space space) {
    const std::string& text = default_recipe(space).text;
    return text.substr(text.rfind(", ") + 2);
}

std::string slug(std::string name) {
    name = std::filesystem::path(name).filename().string();
    for (char& c : name)
        if (std::isalnum(static_cast<unsigned char>(c)) == 0) c = '-';
    return name;
}

series channel_series(const std::vector<rgb>& values, const std::vector<double>& x, std::size_t channel) {
    series s{"", x, {}, channel_colors[channel]};
    for (const rgb& v : values)
        s.y.push_back(v[channel]);
    return s;
}

axis reflectance_axis(const std::string& label, const std::vector<series>& curves) {
    const auto [lowest, highest] = extent(curves, {1, 1});
    const double tick = lowest < 0.5 ? 0.2 : 0.1;
    return {label, std::max(0.0, floor_to(lowest - 0.06, tick)), highest > 1.001 ? ceil_to(highest, 0.05) : 1,
            tick};
}

axis error_axis(const std::string& label, const std::vector<series>& curves) {
    const auto [lowest, highest] = extent(curves, {-1e-6, 1e-6});
    const double room = 0.15 * (highest - lowest);
    return {label, lowest - room, highest + room, 0};
}

strip color_strip(const std::string& label, const std::vector<rgb>& values, color_space space,
                  std::size_t step) {
    strip s{label, {}};
    for (std::size_t a = 0; a < values.size(); a += step)
        s.pixels.push_back(encode_srgb8(to_srgb(values[a], space)));
    return s;
}

height_field spectral_height_field(const material& substance, double ambient, polarization which) {
    std::vector<double> wavelengths, angles;
    for (int nm = 380; nm <= 780; nm += 20)
        wavelengths.push_back(nm);
    for (int theta = 0; theta <= 90; theta += 3)
        angles.push_back(theta);
    const spectral_surface s = exact_surface(substance, ambient, wavelengths, angles, which);
    height_field h{{"wavelength (nm)", 380, 780, 100},
                   {"θ (degrees)", 0, 90, 30},
                   {"reflectance", 0, 1, 0.25},
                   wavelengths,
                   angles,
                   {}};
    for (std::size_t w = 0; w < wavelengths.size(); ++w) {
        std::vector<double>& column = h.z.emplace_back();
        for (std::size_t a = 0; a < angles.size(); ++a)
            column.push_back(s.R[a][w]);
    }
    return h;
}

} // namespace fresnel
