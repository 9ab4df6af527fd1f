#pragma once

#include "analysis/cost_table.hpp"
#include "emit/null_device.hpp"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::emit {

/// A GLSL function of floats whose cost is wanted.
struct cost_subject {
    std::string name;      ///< of the function
    std::size_t arguments; ///< how many floats it takes; the last is cos_i
    std::string text;
};

/// The function of a model as `fresnel shader` prints it, with n_i = 1 or as an argument.
cost_subject subject_of(std::string_view model, bool air = true);

/// A program that evaluates the subject `times` times, each time on inputs of its own, and keeps the sum of the results;
/// without the subject the cosines take the results' place. All inputs are read and summed besides, so that two such
/// programs differ in the evaluations alone. A fragment shader's inputs are interpolated, a vertex shader's are its
/// attributes, a compute shader's come from a buffer.
shader_program cost_program(const cost_subject& subject, shader_stage stage, int times, bool evaluates);

/// One evaluation by itself, cos_i and the parameters read as above: what `--isa` shows.
shader_program listing_program(const cost_subject& subject, shader_stage stage);

/// What a subject costs on a device, by differences: of 16 evaluations and none, divided by 16.
struct measured_cost {
    double instructions, latency, inverse_throughput;
    double registers;      ///< vector registers alive at once with one evaluation
    double instructions_8; ///< the same from 8 evaluations, to see that the method is linear
};

/// The costs of all subjects, in order, with the driver's name. Throws as `compile_for` does.
std::vector<measured_cost> measure_costs(std::span<const cost_subject> subjects, std::string_view gpu,
                                         shader_stage stage, std::string* driver = nullptr);

/// Rows of the table for these models, in the order given: stages within devices within models, n_i = 1 before n_i
/// free. Throws bad_input for an unknown model or device.
std::vector<cost_row> measure_cost_rows(std::span<const std::string> models,
                                        std::span<const std::string> gpus,
                                        std::span<const shader_stage> stages);

/// What the stages of a whole program cost, all of it: rows with `name` for the model. The program may be written for
/// OpenGL: its uniforms, textures, attributes and what the stages share find their places by themselves.
std::vector<cost_row> measure_program(const std::string& name, const shader_program& program,
                                      std::span<const std::string> gpus);

} // namespace fresnel::emit
