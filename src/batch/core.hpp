#pragma once

// What the C++ functions of batch.hpp and the C functions of fresnel.h are made of: the models and the instruction
// sets by name, the check of a call, its evaluation. Nothing here allocates, throws or needs the runtime library of
// C++; tests/core_calls.cmake lists all that the compiled code calls.

#include "batch/batch.hpp"
#include "batch/kernels.hpp"

#include <fresnel/models.hpp>

#include <algorithm>
#include <cstddef>
#include <span>
#include <string_view>

namespace fresnel {

// ---- models -----------------------------------------------------------------------------------------------

/// A row of the registry without its types, so that rows make an array.
struct batch_model {
    std::string_view name;
    const parameter* parameters;
    std::size_t parameter_count;
};

/// Every model, in the registry's order.
std::span<const batch_model> batch_models() noexcept;

/// Null where no model has that name.
const batch_model* find_batch_model(std::string_view name) noexcept;

// ---- instruction sets -------------------------------------------------------------------------------------

struct instruction_set {
    std::string_view name;
    bool (*supported)();
    kernel_table (*kernels)();
};

/// What this library was built for, narrowest first; a machine may support only some.
std::span<const instruction_set> built_instruction_sets() noexcept;

/// The widest supported one where the name is empty; null where no supported one has that name.
const instruction_set* find_instruction_set(std::string_view name) noexcept;

/// FRESNEL_ISA of the environment, empty where that is not set.
std::string_view instruction_set_of_environment() noexcept;

/// The one that the environment names, or the widest; null where it names none that is supported. Once found, it
/// stays.
const instruction_set* default_instruction_set() noexcept;

// ---- evaluation -------------------------------------------------------------------------------------------

inline constexpr std::size_t most_parameters =
    std::apply([](const auto&... rows) { return std::max({rows.parameters.size()...}); }, registry);
inline constexpr std::size_t most_inputs =
    3 * most_parameters + 1; ///< those of red, green and blue, and cos_i
inline constexpr std::size_t most_outputs = 4;

/// What to compute, and where it goes: R; R_s, R_p and T_s, T_p (these null if not wanted); red, green and blue.
enum class quantity { reflectance, polarised, rgb };

/// A call that has been checked. Its single values are copies, read once: the caller's may lie in an output.
struct batch_job {
    batch_job() = default;
    batch_job(const batch_job&) = delete; ///< `inputs` point into it
    batch_job& operator=(const batch_job&) = delete;

    kernel run;
    std::size_t lanes;
    std::size_t input_count, output_count;
    batch_argument inputs[most_inputs]; ///< the parameters, then cos_i
    float singles[most_inputs];         ///< of the inputs that are single values
    float* outputs[most_outputs];
    bool past_caches; ///< as kernel_call's, for the whole call, however many threads share it
};

/// Why a call cannot be run; `place` is that of the one at fault among the inputs, or among the outputs.
struct refusal {
    enum reason { none, parameter_count, null_input, bad_stride, not_polarised, null_output };
    reason why = none;
    std::size_t place = 0;
};

/// How many parameters a call must bring: three times as many for rgb.
std::size_t parameters_of(quantity wanted, const batch_model& model) noexcept;

/// The first of the inputs whose pointer is null or whose stride is neither 0 nor 1.
refusal check_inputs(std::span<const batch_argument> inputs) noexcept;

/// Makes a job of a call, unless it refuses it. Of an empty call (count 0) no pointer is looked at.
refusal make_job(quantity wanted, const batch_model& model, const instruction_set& set,
                 std::span<const batch_argument> parameters, batch_argument cos_i, std::size_t count,
                 std::span<float* const> outputs, batch_job& job) noexcept;

/// Fills a spectral table of any number of angles.
void run_spectral(const instruction_set& set, const spectral_call& call) noexcept;

/// Computes the values from place `begin` to `end`, on this thread.
void run_job(const batch_job& job, std::size_t begin, std::size_t end) noexcept;

} // namespace fresnel
