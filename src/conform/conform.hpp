#pragma once

#include <array>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

namespace fresnel::conform {

/// Somebody's function, and the model that it is meant to be.
struct conform_request {
    std::string file; ///< as messages call it
    std::string text;
    std::string language; ///< glsl, hlsl or wgsl
    std::string function;
    std::string model;                        ///< of the registry
    std::vector<std::string> arguments = {};  ///< for each argument an expression; none: by its name
    std::map<std::string, double> fixed = {}; ///< parameters that do not vary
    std::map<std::string, std::array<double, 2>> ranges = {}; ///< of parameters, inside the registry's
    double tolerance = 1e-4;                                  ///< largest absolute error
    double relative = 1e-2; ///< largest relative error against an exact model
    bool exact = false;     ///< compare with the exact equations as well
    std::size_t rows = 1 << 17;
};

/// One input on which the function fails.
struct failed_input {
    std::vector<std::pair<std::string, double>>
        inputs;                   ///< the model's parameters, of three channels r, g and b, and cos_i
    std::vector<float> arguments; ///< what the function was given
    std::vector<double> expected;
    std::vector<float> got;
    std::string why;
};

/// A cosine at which the function jumps and the model does not.
struct discontinuity {
    std::vector<std::pair<std::string, double>> inputs;
    double jump;
};

struct conformance {
    std::string device;
    std::string signature;                                  ///< "vec3 F(vec3 f0, float u)"
    std::vector<std::pair<std::string, std::string>> bound; ///< argument and what it is given
    std::vector<std::pair<std::string, double>> fixed;      ///< parameters that were not varied
    std::size_t inputs = 0;
    std::optional<double> max_error, rms_error; ///< absolute; without a value where every result is NaN
    std::optional<double> max_relative_error;   ///< where the model is above 1e-13
    std::optional<double> exact_max_error, exact_rms_error;
    std::size_t nan = 0, negative = 0, above_one = 0;
    std::size_t beyond_nan = 0,
                beyond_range = 0;          ///< for cosines just outside [0, 1] NaN, or not a reflectance
    std::optional<double> lowest, highest; ///< values
    std::vector<discontinuity> discontinuities;
    std::vector<failed_input> first_failures;
    std::vector<std::string> findings; ///< what is wrong, a sentence each

    bool conforms() const { return findings.empty(); }
};

/// Runs the function over edges and random inputs in [0, 1] of cos_i, just outside of it, and over fine sweeps of the
/// angle. An error counts only where it is larger than what a change of cos_i by four floats makes of the model, so that
/// the steep rise before a critical angle is held against nobody.
///
/// Throws bad_input for an unknown model, function or argument, or text that its compiler refuses, and
/// render::no_device where the language cannot be run.
conformance conform(const conform_request& wanted);

} // namespace fresnel::conform
