#pragma once

#include <string>
#include <string_view>

namespace fresnel::emit {

/// What a parameter is called where people look at it: "IOR", "Edge Tint".
std::string parameter_label(std::string_view name);

} // namespace fresnel::emit
