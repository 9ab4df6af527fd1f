#pragma once

#include "analysis/graph.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::emit {

/// An argument of an emitted function: one number, two or three.
struct argument {
    std::string name;
    int width;           ///< 1, 2 for a twofold, or 3 for an RGB value or a vector
    std::string meaning; ///< what stands after the name in the text's comment: what it is, its domain
};

inline constexpr std::string_view angle_meaning = "cosine of incidence, [0, 1]";

/// A function of this library as a graph, ready to be printed in any language. Its results are the reflectance alone, or
/// R_s, R_p, T_s and T_p, or the two of a twofold.
struct function : recorded {
    std::string name;
    std::vector<argument> arguments;  ///< in the order of the registry, cos_i last
    std::vector<std::string> comment; ///< what is said above it, a line each
    bool directions = false;          ///< whether its triples are directions in space, not RGB values
    bool components = false;          ///< whether its three results are the components of one

    int width() const { return components ? 3 : results.size() == 2 ? 2 : graph[results.front().node].width; }
};

/// Parameters that are constants: a value for each channel, as the user wrote it, which a text holds as a float.
using fixed_values = std::map<std::string, std::array<double, 3>>;

/// Throws bad_input for what is no parameter of the model, and for a value outside the range of the registry.
void check_fixed(const model_row<double>& row, const fixed_values& fixed);

/// What of a model is recorded.
struct request {
    int width = 1;         ///< 3: every parameter but n_i is RGB, they share the angle
    bool boundary = false; ///< of an exact model R_s, R_p, T_s and T_p
    fixed_values fixed;    ///< equal values for width 1
};

/// Runs a model on symbols. Its comment says the registry's error unless a constant lies outside what that was taken over:
/// an f0 of no gem, an f90 that is not 1, an index outside the stated range, any constant of a model that was fitted. Throws
/// bad_input for an unknown model, and as check_fixed does.
function record(std::string_view model, const request& wanted = {});

/// incidence_cosine, which the overloads of two directions call, then reflected_direction, refracted_direction,
/// refracted_cosine, critical_cosine, brewster_cosine, f0_from_eta and eta_from_f0: what surrounds the models in every
/// library.
std::vector<function> record_geometry();

/// phong_lobe, opacity_fresnel, opacity_silhouette, opacity_attenuation and opacity_total: highlights and thin layers.
std::vector<function> record_shading();

/// two_sum, halves, two_product and the sums, differences and products of twofolds: what compensated models call.
std::vector<function> record_twofold();

/// Whether a function calls those of record_twofold.
bool calls_twofold(const function& f);

/// The same function with a node for each component, for languages that cannot compute with three values at once: an
/// input f0 becomes f0.x, f0.y and f0.z, with `component` making those names.
function scalarized(const function& f, std::string (*component)(std::string_view name, int i));

} // namespace fresnel::emit
