#include "sources/parts.hpp"

#include "analysis/curve.hpp"
#include "analysis/drawing.hpp"

#include <fresnel/exact.hpp>

#include <fmt/format.h>

#include <cmath>

namespace fresnel {

namespace draw {

std::string ramp(std::size_t i, std::size_t n) {
    // without the ends, which vanish on dark and on light ground
    return viridis(n < 2 ? 0.4 : mix(0.1, 0.85, static_cast<double>(i) / static_cast<double>(n - 1)));
}

axis horizontal(against what) {
    switch (what) {
    case against::theta:
        return theta_axis;
    case against::cosine:
        return {"cos θ", 0, 1, 0.2};
    case against::sine:
        break;
    }
    return {"sin θ", 0, 1, 0.2};
}

axis axis_of(std::string label, double lo, double hi, double tick) {
    return {std::move(label), lo, hi, tick};
}

series curve(const std::string& label, const curve_function& f, const std::string& color, stroke style,
             double width, against what) {
    series s{label, {}, {}, color, style, width};
    for (int i = 0; i <= 360; ++i) {
        const double theta = 0.25 * i, c = cosine_of_degrees(theta);
        s.x.push_back(what == against::theta    ? theta
                      : what == against::cosine ? c
                                                : std::sqrt((1 - c) * (1 + c)));
        s.y.push_back(f(c));
    }
    return s;
}

series sampled(const std::string& label, const std::function<double(double)>& f, double lo, double hi,
               const std::string& color, stroke style, double width, int count) {
    series s{label, {}, {}, color, style, width};
    for (int i = 0; i < count; ++i) {
        s.x.push_back(mix(lo, hi, i / (count - 1.0)));
        s.y.push_back(f(s.x.back()));
    }
    return s;
}

series line(double x0, double y0, double x1, double y1, const std::string& color, double width,
            stroke style) {
    return {"", {x0, x1}, {y0, y1}, color, style, width};
}

std::vector<series> arrow(double x0, double y0, double x1, double y1, const std::string& color, double width,
                          double head) {
    const double length = std::hypot(x1 - x0, y1 - y0), ux = (x1 - x0) / length, uy = (y1 - y0) / length;
    const double bx = x1 - head * ux, by = y1 - head * uy, side = 0.45 * head;
    return {line(x0, y0, x1, y1, color, width),
            {"",
             {bx - side * uy, x1, bx + side * uy},
             {by + side * ux, y1, by - side * ux},
             color,
             stroke::solid,
             width}};
}

} // namespace draw

std::string rounding(double difference) {
    for (const double limit : {1e-40, 1e-12, 1e-6})
        if (difference < limit) return fmt::format("to less than {:g}", limit);
    return fmt::format("to {:.1g}", difference);
}

curve_function exact_dielectric(double eta) {
    return [eta](double c) { return dielectric(1.0, eta, c).reflectance(); };
}

curve_function exact_conductor(double n, double k) {
    return [n, k](double c) { return conductor(1.0, n, k, c).reflectance(); };
}

} // namespace fresnel
