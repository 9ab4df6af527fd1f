#include "analysis/drawing.hpp"

#include "materials/observer.hpp"

#include <cmath>

namespace fresnel {

series channel_series(const std::vector<rgb>& values, const std::vector<double>& x, std::size_t channel) {
    series s{"", x, {}, channel_colors[channel]};
    for (const rgb& v : values)
        s.y.push_back(v[channel]);
    return s;
}

strip color_strip(const std::string& label, const std::vector<rgb>& values, color_space space) {
    strip s{label, {}};
    for (const rgb& v : values)
        s.pixels.push_back(encode_srgb8(to_srgb(v, space)));
    return s;
}

height_field wavelength_surface(const material& substance, double ambient) {
    std::vector<double> wavelengths, angles;
    for (int nm = 380; nm <= 780; nm += 20)
        wavelengths.push_back(nm);
    for (int theta = 0; theta <= 90; theta += 3)
        angles.push_back(theta);
    const spectral_surface s = exact_surface(substance, ambient, wavelengths, angles);
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

double floor_to(double value, double step) { return std::floor(value / step) * step; }
double ceil_to(double value, double step) { return std::ceil(value / step) * step; }

} // namespace fresnel
