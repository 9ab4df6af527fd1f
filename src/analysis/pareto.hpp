#pragma once

#include "analysis/compare.hpp"
#include "figure/figure.hpp"

#include <string>

namespace fresnel {

/// Whether no other model of the comparison costs at most as many instructions (navi21, fragment stage, of the recorded
/// table) and has at most as large a worst error, and less of one; an error below 1e-4 counts as 1e-4. Artistic models
/// are left out.
bool on_frontier(const comparison& all, const model_fit& model);

/// Worst error against instructions, a point for each model of a comparison; the models on the frontier are joined.
figure pareto_figure(const comparison& all, const std::string& id, const std::string& title);

} // namespace fresnel
