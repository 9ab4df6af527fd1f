#pragma once

// What one instruction set of this machine can do at most: the times that the benchmarks divide by.

#include <cstddef>
#include <string_view>

namespace fresnel::bench {

/// Each runs `count` operations on single values, independent of each other, in registers.
struct unit_kernels {
    int lanes;
    void (*multiply)(std::size_t count); ///< at the rate of multiply-adds, which run in the same unit
    void (*division)(std::size_t count);
    void (*root)(std::size_t count);
    void (*exp2)(std::size_t count);
    void (*pow)(std::size_t count);
    /// Reads `inputs` arrays and writes their sum: what moving the values costs. 1 to 5 arrays.
    void (*stream)(const float* const* inputs, int input_count, float* output, std::size_t count);
    /// The instructions of a model's kernel, none of which waits for another's result: what the processor does of just
    /// these at most. `inputs` as a kernel's, n_i included, `count` a multiple of 64. Null where that is not built.
    void (*mix)(std::string_view model, const float* const* inputs, float* output, std::size_t count);
};

unit_kernels scalar_units();
unit_kernels sse2_units();
unit_kernels avx2_units();
unit_kernels avx512_units();
unit_kernels neon_units();

} // namespace fresnel::bench
