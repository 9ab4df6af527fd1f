#pragma once

#include "analysis/curve.hpp"
#include "analysis/fit.hpp"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

namespace fresnel {

/// How far a model is from the exact curve, per colour channel.
struct curve_error {
    std::array<double, 3> max;       ///< largest |model - exact| over theta
    std::array<double, 3> max_theta; ///< where, in degrees
    std::array<double, 3> rms;       ///< root mean square, uniform in theta
    std::array<double, 3> cosine;    ///< integral of |model - exact| 2 c dc: what a diffuse light sees
    double delta_e_max;              ///< largest CIEDE2000 over theta, colours seen beside a white of R = 1
    double delta_e_theta;            ///< where, in degrees

    double worst() const { return std::max({max[0], max[1], max[2]}); }
    std::size_t worst_channel() const;
};

/// The error of colours at the exact curve's angles.
curve_error error_of(const std::vector<rgb>& model, const rgb_curve& exact);

/// The error of `schlick` on a material in air, f0 exact.
curve_error schlick_error(const material& substance, color_space space);

/// The f82 of least squares, with which a model is closer in the mean than with the exact f82; per channel.
struct fitted_f82 {
    std::array<double, 3> f82, rms;
};

/// One model fitted to a material.
struct model_fit {
    std::string name;
    std::array<parameters, 3> values; ///< per channel, as parts of white, in the order of the registry row
    std::vector<rgb> curve;           ///< the model at the exact curve's angles
    curve_error error;
    std::optional<fitted_f82> least_squares; ///< of f82, powers_4_12 and powers_2_8_16
    int cost;                                ///< operations of one evaluation, three channels
    int rank;                                ///< 1 is the smallest largest error
};

/// Everything `fresnel compare` knows of one material.
struct comparison {
    normal_colour colour;
    rgb_curve exact;
    surface_class surface;
    std::vector<model_fit> models; ///< by rank
    std::size_t recommended;       ///< index into models

    const model_fit& best_choice() const { return models[recommended]; }
    const model_fit* find(std::string_view model) const;
};

/// Fits every model that suits the material, measures and ranks them, and picks one: the cheapest, of those that
/// are not artistic, whose worst CIEDE2000 is at most 1, a difference that is not seen; if there is none, at most
/// 2; if none, the least.
comparison compare(const material& substance, color_space space, double ambient);

/// CIEDE2000 up to which a difference counts as invisible, and as slight.
inline constexpr double invisible = 1, slight = 2;

/// One sentence: which model to use, what it loses, and what Schlick's would lose.
std::string verdict(const comparison& result);

/// The object of one material in report.json.
nlohmann::json to_json(const comparison& result);

} // namespace fresnel
