#pragma once

#include "emit/null_device.hpp"

namespace fresnel::emit {

/// Compiles the programs on the first device that this process's Vulkan driver offers. Throws failure, for a text
/// that does not compile with the compiler's message, or render::no_device.
compilation compile_here(std::span<const shader_program> programs, bool with_assembly);

} // namespace fresnel::emit
