#pragma once

// Models on arrays, at the speed of the machine's widest instructions.
//
// Every instruction set gives the same bits, and as the scalar code does (a NaN is a NaN, its payload aside), in the
// default floating-point environment: rounding to nearest, denormals kept, on every thread that calls. The
// arguments are not checked against the models' domains: what lies outside gives some number or NaN.

#include <array>
#include <cstddef>
#include <span>
#include <string_view>
#include <vector>

namespace fresnel {

/// One argument of a model: `count` floats, aligned as a float is, or one for all of them.
struct batch_argument {
    const float* data;
    std::size_t stride; ///< 1: an array; 0: data[0] everywhere

    static batch_argument array(const float* data) { return {data, 1}; }
    static batch_argument same(const float& value) { return {&value, 0}; }
    /// A number written out, or a double: the float would be gone at the call.
    static batch_argument same(const float&&) = delete;
};

/// How to run; the result does not depend on it.
struct batch_options {
    std::string_view instruction_set = {}; ///< empty: FRESNEL_ISA of the environment, or the widest there is
    /// 0: as many as the machine has, but no more than one for every 65,536 values. Otherwise the most to use; never more
    /// than four for each that the machine has.
    unsigned threads = 0;
};

/// Where the parts of a polarised result go: R_s and R_p, and T_s and T_p both or neither (null).
struct batch_polarised {
    float *R_s, *R_p;
    float *T_s = nullptr, *T_p = nullptr;
};

// The arrays' length is `count`; where that is 0, pointers may be null. An output may be the array of an argument itself,
// for a result in place, but must not overlap one in any other way; nor may outputs overlap each other. Single values are
// read before any result is written, and may lie anywhere. All three throw bad_input where the model or the instruction
// set is unknown, the parameters are not as many as the model's, a stride is neither 0 nor 1 or a pointer is null.

/// Unpolarised reflectance R. `parameters` in the order of the registry.
void evaluate_batch(std::string_view model, std::span<const batch_argument> parameters, batch_argument cos_i,
                    std::size_t count, float* R, const batch_options& options = {});

/// R_s, R_p and, where asked for, T_s, T_p; bad_input unless the model is exact.
void evaluate_batch_polarised(std::string_view model, std::span<const batch_argument> parameters,
                              batch_argument cos_i, std::size_t count, const batch_polarised& results,
                              const batch_options& options = {});

/// R of three channels that share their angle. `parameters`: those of red, then of green, then of blue.
void evaluate_batch_rgb(std::string_view model, std::span<const batch_argument> parameters,
                        batch_argument cos_i, std::size_t count, const std::array<float*, 3>& rgb,
                        const batch_options& options = {});

/// The spectrum that a spectral table is made of: one value for each wavelength.
struct spectral_index {
    std::span<const float> n_t, k_t; ///< of the material
    std::array<std::span<const float>, 3>
        weights;   ///< of each channel: what a reflectance of 1 there adds to it
    float n_i = 1; ///< of the medium outside
};

/// Reflectance of a material at many angles as three channels, integrated over the spectrum by `conductor`.
///
/// cos_i     the angles                    [0, 1], any number
/// rgb       for each channel as many floats as there are angles; must overlap nothing else
/// throws    bad_input where the spectrum's arrays differ in length, a channel is null, or the instruction set is unknown
void spectral_table(const spectral_index& spectrum, std::span<const float> cos_i,
                    const std::array<float*, 3>& rgb, std::string_view instruction_set = {});

/// The instruction sets that this machine runs, narrowest first: scalar, then sse2, avx2, avx512 or neon or simd128.
std::vector<std::string_view> instruction_sets();

/// The name that `wanted` stands for: itself, or where it is empty FRESNEL_ISA of the environment, or the widest; throws
/// bad_input with the allowed names where this machine has no such instruction set.
std::string_view choose_instruction_set(std::string_view wanted);

/// How many threads at most share a batch of `count` values where `wanted` is batch_options::threads.
std::size_t choose_threads(std::size_t count, unsigned wanted);

} // namespace fresnel
