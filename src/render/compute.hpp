#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <stdexcept>
#include <string>
#include <vector>

namespace fresnel::render {

/// A shader that its compiler refused; `what` is the compiler's message, several lines as it gave them.
struct refused_shader : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A device that this machine does not have; `what` is the reason, fit to follow "skipped: ".
struct no_device : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// How many evaluations a shader makes, of how many numbers each.
struct evaluation {
    std::size_t rows;    ///< at most 4 million
    std::size_t results; ///< floats that each row writes
};

/// Runs compute shaders over arrays of floats. A shader finds its inputs in storage buffer 0, writes its results to
/// storage buffer 1, and is run by groups of 64 in x until there is an invocation for every row, or a few more.
class compute_device {
public:
    virtual ~compute_device() = default;
    /// What it is: "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
    virtual std::string name() const = 0;
    /// The results, rows times results. `shader` is GLSL text, or SPIR-V words as bytes, as the device takes it.
    /// Throws refused_shader.
    virtual std::vector<float> run(const std::string& shader, std::span<const float> inputs,
                                   const evaluation& how) = 0;
};

/// OpenGL 4.3 compute shaders, GLSL text, in a context without window or screen. Mesa's software rasteriser unless the
/// environment sets LIBGL_ALWAYS_SOFTWARE=0. The context is left current on this thread: a texture that is bound in it
/// is there for the shaders. Throws no_device.
std::unique_ptr<compute_device> open_opengl();

/// Vulkan compute shaders, SPIR-V with the entry point `main`, on Mesa's software device lavapipe unless the
/// environment names another one in FRESNEL_VULKAN_DEVICE. Buffers are bindings 0 and 1 of set 0. Throws no_device.
std::unique_ptr<compute_device> open_vulkan();

} // namespace fresnel::render
