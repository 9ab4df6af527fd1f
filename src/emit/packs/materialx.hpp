#pragma once

#include "emit/function.hpp"

#include <string>
#include <vector>

namespace fresnel::emit {

/// What stands beside the nodes of the MaterialX pack: how it is used, and a document that uses it, the colours of a
/// measured metal at two angles.
std::string materialx_readme();
std::string materialx_example();

/// Angles and indices around the models: the geometry's functions of numbers alone, which are nodes too.
std::vector<function> materialx_functions();

} // namespace fresnel::emit
