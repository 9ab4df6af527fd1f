#include "batch/core.hpp"

#include <fresnel/fresnel.h>

namespace fresnel {
namespace {

// C reads the registry's texts to their end.
constexpr bool terminated(std::string_view text) { return text.data()[text.size()] == '\0'; }

constexpr bool all_terminated() {
    bool all = true;
    for_each_model([&](const auto& row) {
        all = all && terminated(row.name);
        for (const parameter& p : row.parameters)
            all = all && terminated(p.name) && terminated(p.unit);
    });
    return all;
}
static_assert(all_terminated());

// ---- the arguments of a call ------------------------------------------------------------------------------

/// As C gives them.
struct c_call {
    const char* model;
    const float* const* parameters;
    const std::size_t* strides;
    batch_argument cos_i;
    std::size_t count;
};

/// A call's model and its inputs as the core takes them: the parameters, then cos_i.
struct core_call {
    const batch_model* model;
    std::size_t parameter_count;
    batch_argument inputs[most_inputs];

    std::span<const batch_argument> parameters() const { return {inputs, parameter_count}; }
    std::span<const batch_argument> all_inputs() const { return {inputs, parameter_count + 1}; }
};

/// Pointers that are missing become null arguments, for the core to refuse.
fresnel_error translate(quantity wanted, const c_call& from, core_call& to) {
    if (!from.model) return FRESNEL_BAD_ARGUMENT;
    to.model = find_batch_model(from.model);
    if (!to.model) return FRESNEL_UNKNOWN_MODEL;
    to.parameter_count = parameters_of(wanted, *to.model);
    const bool given = from.parameters && from.count > 0;
    for (std::size_t k = 0; k < to.parameter_count; ++k)
        to.inputs[k] = {given ? from.parameters[k] : nullptr, given && from.strides ? from.strides[k] : 1};
    to.inputs[to.parameter_count] = from.cos_i;
    return FRESNEL_OK;
}

fresnel_error error_of(const refusal& refused) {
    switch (refused.why) {
    case refusal::none:
        return FRESNEL_OK;
    case refusal::not_polarised:
        return FRESNEL_NOT_POLARISED;
    case refusal::parameter_count:
    case refusal::null_input:
    case refusal::bad_stride:
    case refusal::null_output:
        break;
    }
    return FRESNEL_BAD_ARGUMENT;
}

fresnel_error evaluate(quantity wanted, const c_call& call, std::span<float* const> outputs) {
    core_call in;
    if (const fresnel_error error = translate(wanted, call, in)) return error;
    const instruction_set* set = default_instruction_set();
    if (!set) return FRESNEL_BAD_INSTRUCTION_SET;
    batch_job job;
    const refusal refused =
        make_job(wanted, *in.model, *set, in.parameters(), call.cos_i, call.count, outputs, job);
    if (refused.why == refusal::none) run_job(job, 0, call.count);
    return error_of(refused);
}

// ---- ranges -----------------------------------------------------------------------------------------------

/// The place of the first value out of range, `count` where there is none. A bound of 0.01 admits 0.01f.
std::size_t first_outside(const parameter& range, const batch_argument& values, std::size_t count) {
    const float min = static_cast<float>(range.min), max = static_cast<float>(range.max);
    const std::size_t different = values.stride == 0 ? std::min<std::size_t>(count, 1) : count;
    for (std::size_t i = 0; i < different; ++i)
        if (!(values.data[i] >= min && values.data[i] <= max)) return i;
    return count;
}

} // namespace
} // namespace fresnel

using namespace fresnel;

const char* fresnel_error_string(fresnel_error error) {
    switch (error) {
    case FRESNEL_OK:
        return "no error";
    case FRESNEL_UNKNOWN_MODEL:
        return "no model has that name";
    case FRESNEL_BAD_ARGUMENT:
        return "a pointer is NULL that may not be, or a stride is neither 0 nor 1";
    case FRESNEL_OUT_OF_RANGE:
        return "a value is outside its range, or there is no item of that index";
    case FRESNEL_NOT_POLARISED:
        return "the model is not exact and has no R_s, R_p";
    case FRESNEL_BAD_INSTRUCTION_SET:
        return "FRESNEL_ISA of the environment names no instruction set that this machine runs";
    }
    return "not an error code of fresnel";
}

const char* fresnel_version(void) { return FRESNEL_VERSION; }

const char* fresnel_isa(void) {
    const instruction_set* set = default_instruction_set();
    return set ? set->name.data() : nullptr;
}

size_t fresnel_model_count(void) { return batch_models().size(); }

const char* fresnel_model_name(size_t index) {
    return index < batch_models().size() ? batch_models()[index].name.data() : nullptr;
}

fresnel_error fresnel_model_parameter_count(const char* model, size_t* count) {
    if (!model || !count) return FRESNEL_BAD_ARGUMENT;
    const batch_model* row = find_batch_model(model);
    if (!row) return FRESNEL_UNKNOWN_MODEL;
    *count = row->parameter_count;
    return FRESNEL_OK;
}

fresnel_error fresnel_model_parameter(const char* model, size_t index, fresnel_parameter* parameter) {
    if (!model || !parameter) return FRESNEL_BAD_ARGUMENT;
    const batch_model* row = find_batch_model(model);
    if (!row) return FRESNEL_UNKNOWN_MODEL;
    if (index >= row->parameter_count) return FRESNEL_OUT_OF_RANGE;
    const auto& found = row->parameters[index];
    // the registry's names are literals, which end with a 0
    // NOLINTNEXTLINE(bugprone-suspicious-stringview-data-usage)
    *parameter = {found.name.data(), found.unit.data(), found.min, found.max, found.default_value};
    return FRESNEL_OK;
}

fresnel_error fresnel_evaluate(const char* model, const float* const* parameters, const size_t* strides,
                               const float* cos_i, size_t cos_i_stride, size_t count, float* R) {
    return evaluate(quantity::reflectance, {model, parameters, strides, {cos_i, cos_i_stride}, count},
                    {&R, 1});
}

fresnel_error fresnel_evaluate_polarised(const char* model, const float* const* parameters,
                                         const size_t* strides, const float* cos_i, size_t cos_i_stride,
                                         size_t count, float* R_s, float* R_p, float* T_s, float* T_p) {
    float* const outputs[] = {R_s, R_p, T_s, T_p};
    return evaluate(quantity::polarised, {model, parameters, strides, {cos_i, cos_i_stride}, count}, outputs);
}

fresnel_error fresnel_evaluate_rgb(const char* model, const float* const* parameters, const size_t* strides,
                                   const float* cos_i, size_t cos_i_stride, size_t count, float* red,
                                   float* green, float* blue) {
    float* const outputs[] = {red, green, blue};
    return evaluate(quantity::rgb, {model, parameters, strides, {cos_i, cos_i_stride}, count}, outputs);
}

fresnel_error fresnel_check(const char* model, const float* const* parameters, const size_t* strides,
                            const float* cos_i, size_t cos_i_stride, size_t count, size_t* argument,
                            size_t* index) {
    const c_call call{model, parameters, strides, {cos_i, cos_i_stride}, count};
    core_call in;
    if (const fresnel_error error = translate(quantity::reflectance, call, in)) return error;
    if (count == 0) return FRESNEL_OK;
    const refusal refused = check_inputs(in.all_inputs());
    if (refused.why != refusal::none) return error_of(refused);
    for (std::size_t k = 0; k <= in.parameter_count; ++k) {
        const bool is_angle = k == in.parameter_count;
        const std::size_t outside =
            first_outside(is_angle ? row::cos_i : in.model->parameters[k], in.inputs[k], count);
        if (outside == count) continue;
        if (argument) *argument = k;
        if (index) *index = outside;
        return FRESNEL_OUT_OF_RANGE;
    }
    return FRESNEL_OK;
}
