#pragma once

#include "emit/null_device.hpp"

namespace fresnel::emit {

/// Compiles the programs on the first device that this process's Vulkan driver offers. Nothing is ever released: the
/// process is to end. Throws failure, for a text that does not compile with the compiler's message.
compilation compile_here(std::span<const shader_program> programs, bool with_assembly);

} // namespace fresnel::emit
