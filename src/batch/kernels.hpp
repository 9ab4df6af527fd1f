#pragma once

// What the kernels of every instruction set have in common. Only plain types here: this header is compiled with
// several sets of flags, and an inline function in it could end up in the wrong one.

#include "batch/batch.hpp"

#include <cstddef>

namespace fresnel {

/// The most values that any instruction set computes at a time.
inline constexpr int most_lanes = 64;

/// From so many on (16 MiB), results would drive everything else out of the caches, and themselves.
inline constexpr std::size_t values_past_caches = std::size_t{1} << 22;

/// What a kernel reads and writes: places `begin` to `end` of arrays. An output may be an input's array itself, but must
/// not overlap one otherwise.
struct kernel_call {
    const batch_argument* inputs; ///< the parameters (for rgb those of red, of green, of blue), then cos_i
    float* const* outputs;
    std::size_t begin, end; ///< a multiple of the model's lanes apart
    /// So many results that no cache would keep them; those at `begin` lie at multiples of 64 bytes.
    bool past_caches = false;
    bool fetch_ahead = false; ///< past the caches, memory is to be asked for inputs before they are read
};

using kernel = void (*)(const kernel_call&);

/// The kernels of one model.
struct model_kernels {
    std::size_t lanes;  ///< what a call computes is a multiple of it, a power of two
    kernel reflectance; ///< 1 output: unpolarised R
    kernel rgb;         ///< 3 outputs: R of each channel
    kernel polarised;   ///< 2 outputs: R_s, R_p; null for a model without polarisation
    kernel powers;      ///< 4 outputs: R_s, R_p, T_s, T_p; null likewise
};

/// A spectral table: reflectance by `conductor` at every wavelength and angle, weighted and added into three channels.
struct spectral_call {
    const float *n_t, *k_t;  ///< for each wavelength
    const float* weights[3]; ///< for each wavelength
    std::size_t wavelengths;
    float n_i;
    const float* cos_i; ///< for each angle
    float* rgb[3];      ///< for each angle
    std::size_t angles; ///< for a kernel a multiple of its spectral_lanes
};

/// What is compiled once for each instruction set.
struct kernel_table {
    const model_kernels* models; ///< in the registry's order
    std::size_t spectral_lanes;
    void (*spectral)(const spectral_call&);
};

kernel_table scalar_kernels();
kernel_table sse2_kernels();
kernel_table avx2_kernels();
kernel_table avx512_kernels();
kernel_table neon_kernels();
kernel_table simd128_kernels();

} // namespace fresnel
