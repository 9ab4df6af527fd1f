#pragma once

// What the kernels of every instruction set have in common. Only plain types here: this header is compiled with
// several sets of flags, and an inline function in it could end up in the wrong one.

#include <cstddef>

namespace fresnel {

/// The most values that any instruction set computes at a time.
inline constexpr int most_lanes = 64;

/// Arrays that a kernel reads and writes. An input with step 0 gives the same values again and again, any other the
/// next ones. An output may be an input's array itself, but must not overlap one otherwise.
struct kernel_call {
    const float* const* inputs; ///< the parameters (for rgb those of red, of green, of blue), then cos_i
    const std::size_t* steps;   ///< 0 or not, for each input
    float* const* outputs;
    std::size_t count; ///< a multiple of the lanes
};

using kernel = void (*)(const kernel_call&);

/// The kernels of one model.
struct model_kernels {
    kernel reflectance; ///< 1 output: unpolarised R
    kernel rgb;         ///< 3 outputs: R of each channel
    kernel polarised;   ///< 2 outputs: R_s, R_p; null for a model without polarisation
    kernel powers;      ///< 4 outputs: R_s, R_p, T_s, T_p; null likewise
};

// One per instruction set, each an array in the registry's order.
const model_kernels* scalar_kernels();
const model_kernels* sse2_kernels();
const model_kernels* avx2_kernels();
const model_kernels* avx512_kernels();
const model_kernels* neon_kernels();
const model_kernels* simd128_kernels();

} // namespace fresnel
