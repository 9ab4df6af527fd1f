#pragma once

#include <nlohmann/json.hpp>

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// AMD's shader compiler without AMD's hardware: Mesa's Vulkan driver RADV on a device that it only imagines. Pipelines
// are compiled and described, nothing runs. The numbers are those of the compiler's own model of the device.

namespace fresnel::emit {

enum class shader_stage { vertex, fragment, compute };

std::string_view to_string(shader_stage stage);

/// A compute shader, or a vertex and a fragment shader: GLSL 4.50 texts for Vulkan.
struct shader_program {
    std::map<shader_stage, std::string> sources;
    int attributes = 0; ///< vertex attributes, vec4 each, at locations 0, 1, ...
};

/// What the driver made of one stage.
struct compiled_shader {
    std::map<std::string, double> statistics; ///< by the driver's names: "Instructions", "Latency", ...
    std::string assembly;                     ///< only where it was asked for

    /// Throws failure where the driver gives no statistic of that name.
    double operator[](const std::string& name) const;
};

using compiled_program = std::map<shader_stage, compiled_shader>;

/// The devices that can be imagined, as the driver calls them; the first three are measured by default.
std::span<const std::string_view> null_devices();

/// What `compile_for` returns: the driver's name and version ("Mesa 22.3.6"), and an entry per program.
struct compilation {
    std::string driver;
    std::vector<compiled_program> programs;
};

/// Compiles the programs for one device, in a child process: the driver chooses its device when it is loaded. Its cache
/// on disk stays off. Throws bad_input for a device that is not of `null_devices`, and failure where the driver is not
/// installed or refuses a program, with the compiler's message.
compilation compile_for(std::string_view device, std::span<const shader_program> programs,
                        bool with_assembly = false);

} // namespace fresnel::emit
