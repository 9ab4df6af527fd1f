#pragma once

#include "emit/verify.hpp"

#include <functional>

namespace fresnel::conform {

/// A place that text was to be run at and could not be.
struct skipped_receiver {
    std::string receiver, reason;
};

/// The table of `fresnel shader --verify`.
struct verification {
    std::vector<std::string> receivers; ///< what ran: device and compiler
    std::vector<emit::verify_result> results;
    std::vector<skipped_receiver> skipped;

    bool passed() const;
};

/// Runs every case in GLSL on OpenGL, with `precise` and without, in HLSL and WGSL on Vulkan, in C by gcc and by
/// clang, and in CUDA by nvcc, on `rows` inputs (0: default_rows). `at` is told of each receiver and case before it runs.
verification verify(std::span<const emit::verify_case> cases, std::size_t rows = 0,
                    const std::function<void(std::string_view receiver, std::string_view id)>& at = {});

} // namespace fresnel::conform
