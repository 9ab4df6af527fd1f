#include "sources/parts.hpp"

#include "analysis/curve.hpp"
#include "analysis/fit.hpp"

#include <fresnel/approx.hpp>

#include <fmt/format.h>

namespace fresnel {

namespace {

using namespace draw;

// Rim curves over one of the three controls, the others as given.
regenerated rim(const std::string& control, const std::vector<std::array<double, 3>>& settings,
                std::size_t varied, std::string says, std::string measured, std::string chosen) {
    panel p{horizontal(against::theta), axis_of("R", 0, 1, 0.2), {}, {}};
    panel unclamped{horizontal(against::theta), axis_of("R without the clamp", -0.6, 2.2, 0.4), {}, {}};
    for (std::size_t i = 0; i < settings.size(); ++i) {
        const auto [bias, scale, power] = settings[i];
        const std::string label = fmt::format("{} = {}", control, settings[i][varied]);
        p.curves.push_back(curve(
            label, [=](double c) { return bias_scale_power(bias, scale, power, c); },
            ramp(i, settings.size())));
        unclamped.curves.push_back(curve(
            label, [=](double c) { return bias + scale * std::pow(1 - c, power); },
            ramp(i, settings.size())));
    }
    figure f{"",
             "",
             "Above as the formula has it, clamped to [0, 1]; below as the shader has it, without.",
             {p, unclamped},
             {}};
    return {f, std::move(says), std::move(measured), std::move(chosen)};
}

regenerated over_bias() {
    return rim(
        "bias", {{0, 1, 5}, {0.1, 1, 5}, {0.25, 1, 5}, {0.5, 1, 5}, {-0.25, 1, 5}}, 0,
        "Leaving the bias out still gives good results, and makes wonky ones harder.",
        "With bias 0 and scale in [0, 1] the value never leaves [0, 1]; any bias above 0 with scale 1 does, "
        "and the listing, which has no clamp, then extrapolates.",
        "scale 1, power 5");
}

regenerated over_scale() {
    return rim("scale", {{0, 0.25, 5}, {0, 0.5, 5}, {0, 1, 5}, {0, 1.5, 5}, {0, 2, 5}}, 1,
               "Scale is one of three values exposed to control the look.",
               "Above 1 the rim is flat white where the clamp cuts it.", "bias 0, power 5");
}

regenerated over_power() {
    return rim("power", {{0, 1, 1}, {0, 1, 2}, {0, 1, 3.5}, {0, 1, 5}, {0, 1, 10}}, 2,
               "Power is one of three values exposed to control the look.",
               "Power 5 with bias F0 and scale 1 − F0 is Schlick's approximation.", "bias 0, scale 1");
}

} // namespace

std::vector<source_figure> halladay_figures() {
    const std::string of = "Halladay 2014, The Basics of Fresnel Shading, the empirical approximation";
    return {{"halladay-bias", of, "Rim curves over the bias", over_bias},
            {"halladay-scale", of, "Rim curves over the scale", over_scale},
            {"halladay-power", of, "Rim curves over the power", over_power}};
}

} // namespace fresnel
