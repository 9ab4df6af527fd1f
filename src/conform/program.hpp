#pragma once

#include "render/compute.hpp"

#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::conform {

/// Functions in a shading language, and the call of one of them.
struct program {
    std::string text;
    std::string call; ///< an expression of the columns, each as `column` writes it
    int columns = 1;  ///< numbers of each evaluation
    int results = 1;  ///< 1, 3 of a vector, 4 of a fresnel_boundary
};

/// How a program's call writes column k of its inputs.
std::string column(int k);

/// A compute shader that calls it once for each row: inputs in storage buffer 0, results in storage buffer 1. The
/// first line of `text` stays line 1 in what the compiler says. `language` is glsl, hlsl or wgsl.
std::string compute_shader(std::string_view language, const program& p);

/// Runs programs in one language.
class shader_runner {
public:
    virtual ~shader_runner() = default;
    /// Device and compilers: "llvmpipe (LLVM 15.0.6, 256 bits), OpenGL 4.5".
    virtual std::string name() const = 0;
    /// Compiles what `run` will be given, where many at once take less time than each alone.
    virtual void prepare(std::span<const program>) {}
    /// `results` floats for each of the rows of `inputs`. Throws render::refused_shader with the compiler's message,
    /// a line each, in which the program's text is called "shader".
    virtual std::vector<float> run(const program& p, std::span<const float> inputs) = 0;
};

/// GLSL in OpenGL, HLSL by glslang and WGSL by naga in Vulkan: by the program that FRESNEL_NAGA names, else by
/// fresnel-naga, which scripts/setup installs, else by naga. Throws render::no_device with the reason where the
/// device or the compiler is not there.
std::unique_ptr<shader_runner> open_runner(std::string_view language);

/// Whether quotients and square roots in that language come out as IEEE 754 rounds them. Software devices do so; for
/// graphics cards a few units in the last place are within the rules of every shading language.
bool rounds_exactly(std::string_view language, shader_runner& runner);

} // namespace fresnel::conform
