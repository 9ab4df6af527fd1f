#include "batch/batch.hpp"

#include "batch/core.hpp"
#include "error.hpp"

#include <algorithm>
#include <string>
#include <system_error>
#include <thread>

namespace fresnel {

namespace {

// ---- what a name stands for -------------------------------------------------------------------------------

const batch_model& model_named(std::string_view name) {
    if (const batch_model* found = find_batch_model(name)) return *found;
    std::vector<std::string> names;
    for (const batch_model& row : batch_models())
        names.emplace_back(row.name);
    throw bad_input("model '" + std::string(name) + "' is unknown" + did_you_mean(name, names));
}

[[noreturn]] void refuse_instruction_set(const std::string& what) {
    std::string allowed;
    for (const std::string_view name : instruction_sets())
        allowed += (allowed.empty() ? "" : ", ") + std::string(name);
    throw bad_input(what + " is not one of " + allowed);
}

/// The default where the name is empty.
const instruction_set& instruction_set_named(std::string_view name) {
    const instruction_set* found = name.empty() ? default_instruction_set() : find_instruction_set(name);
    if (found) return *found;
    if (!name.empty()) refuse_instruction_set("instruction set '" + std::string(name) + "'");
    refuse_instruction_set("instruction set '" + std::string(instruction_set_of_environment()) +
                           "', from FRESNEL_ISA of the environment,");
}

// ---- what is wrong with a call ----------------------------------------------------------------------------

constexpr std::string_view channels[] = {"red", "green", "blue"};

/// "f0", or "f0 of green" where there are three; after the parameters "cos_i".
std::string input_name(quantity wanted, const batch_model& model, std::size_t place) {
    if (place == parameters_of(wanted, model)) return "cos_i";
    const std::string name(model.parameters[place % model.parameter_count].name);
    return wanted == quantity::rgb ? name + " of " + std::string(channels[place / model.parameter_count])
                                   : name;
}

std::string output_name(quantity wanted, std::size_t place) {
    constexpr std::string_view parts[] = {"R_s", "R_p", "T_s", "T_p"};
    switch (wanted) {
    case quantity::reflectance:
        break;
    case quantity::polarised:
        return std::string(parts[place]);
    case quantity::rgb:
        return std::string(channels[place]);
    }
    return "R";
}

std::string message_of(const refusal& refused, quantity wanted, const batch_model& model,
                       std::span<const batch_argument> parameters, const batch_argument& cos_i) {
    const auto input = [&] { return input_name(wanted, model, refused.place); };
    const std::string name = "model '" + std::string(model.name) + "'";
    switch (refused.why) {
    case refusal::parameter_count:
        return name + " has " + std::to_string(parameters_of(wanted, model)) + " parameters here, not " +
               std::to_string(parameters.size());
    case refusal::null_input:
        return input() + " is null";
    case refusal::bad_stride:
        return input() + " has stride " +
               std::to_string(refused.place == parameters.size() ? cos_i.stride
                                                                 : parameters[refused.place].stride) +
               ": must be 0 or 1";
    case refusal::not_polarised:
        return name + " is not exact and has no R_s, R_p";
    case refusal::null_output:
        return output_name(wanted, refused.place) + " is null";
    case refusal::none:
        break;
    }
    return "";
}

} // namespace

// ---- threads ----------------------------------------------------------------------------------------------

#if defined(__STDCPP_THREADS__)

std::size_t choose_threads(std::size_t count, unsigned wanted) {
    constexpr std::size_t values_per_thread = 65536, most_per_processor = 4;
    static const std::size_t processors = std::max(std::thread::hardware_concurrency(), 1u);
    if (wanted == 0) return std::clamp<std::size_t>(count / values_per_thread, 1, processors);
    const std::size_t most = std::min<std::size_t>(wanted, most_per_processor * processors);
    return std::clamp<std::size_t>(count / most_lanes, 1, most);
}

namespace {

/// Runs the job in equal parts, of whole batches but for the last; a part for which the system grants no thread is run by
/// the caller.
void run_threads(const batch_job& job, std::size_t count, unsigned wanted) {
    const std::size_t whole = choose_threads(count, wanted) * most_lanes;
    const std::size_t part = (count + whole - 1) / whole * most_lanes;
    std::vector<std::jthread> running;
    for (std::size_t begin = part; begin < count; begin += part) {
        const std::size_t end = std::min(begin + part, count);
        try {
            running.emplace_back([&job, begin, end] { run_job(job, begin, end); });
        } catch (const std::system_error&) {
            run_job(job, begin, end);
        }
    }
    run_job(job, 0, std::min(part, count));
}

} // namespace

#else // WebAssembly, unless compiled with -pthread

std::size_t choose_threads(std::size_t, unsigned) { return 1; }

namespace {

void run_threads(const batch_job& job, std::size_t count, unsigned) { run_job(job, 0, count); }

} // namespace

#endif

namespace {

void evaluate(quantity wanted, std::string_view model, std::span<const batch_argument> parameters,
              batch_argument cos_i, std::size_t count, std::span<float* const> outputs,
              const batch_options& options) {
    const batch_model& row = model_named(model);
    const instruction_set& set = instruction_set_named(options.instruction_set);
    batch_job job;
    const refusal refused = make_job(wanted, row, set, parameters, cos_i, count, outputs, job);
    if (refused.why != refusal::none) throw bad_input(message_of(refused, wanted, row, parameters, cos_i));
    run_threads(job, count, options.threads);
}

} // namespace

void evaluate_batch(std::string_view model, std::span<const batch_argument> parameters, batch_argument cos_i,
                    std::size_t count, float* R, const batch_options& options) {
    evaluate(quantity::reflectance, model, parameters, cos_i, count, {&R, 1}, options);
}

void evaluate_batch_polarised(std::string_view model, std::span<const batch_argument> parameters,
                              batch_argument cos_i, std::size_t count, const batch_polarised& results,
                              const batch_options& options) {
    float* const outputs[] = {results.R_s, results.R_p, results.T_s, results.T_p};
    evaluate(quantity::polarised, model, parameters, cos_i, count, outputs, options);
}

void evaluate_batch_rgb(std::string_view model, std::span<const batch_argument> parameters,
                        batch_argument cos_i, std::size_t count, const std::array<float*, 3>& rgb,
                        const batch_options& options) {
    evaluate(quantity::rgb, model, parameters, cos_i, count, rgb, options);
}

void spectral_table(const spectral_index& spectrum, std::span<const float> cos_i,
                    const std::array<float*, 3>& rgb, std::string_view instruction_set) {
    const std::size_t wavelengths = spectrum.n_t.size();
    const auto check = [&](const std::string& what, std::span<const float> values) {
        if (values.size() != wavelengths)
            throw bad_input(what + " has " + std::to_string(values.size()) +
                            " wavelengths: must be as many as n_t has, " + std::to_string(wavelengths));
    };
    check("k_t", spectrum.k_t);
    for (std::size_t k = 0; k < 3; ++k)
        check("weights[" + std::to_string(k) + "] (" + std::string(channels[k]) + ")", spectrum.weights[k]);
    for (std::size_t k = 0; k < 3; ++k)
        if (!rgb[k] && !cos_i.empty()) throw bad_input(std::string(channels[k]) + " is null");
    const auto& w = spectrum.weights;
    run_spectral(instruction_set_named(instruction_set), {spectrum.n_t.data(),
                                                          spectrum.k_t.data(),
                                                          {w[0].data(), w[1].data(), w[2].data()},
                                                          wavelengths,
                                                          spectrum.n_i,
                                                          cos_i.data(),
                                                          {rgb[0], rgb[1], rgb[2]},
                                                          cos_i.size()});
}

std::vector<std::string_view> instruction_sets() {
    std::vector<std::string_view> names;
    for (const instruction_set& set : built_instruction_sets())
        if (set.supported()) names.push_back(set.name);
    return names;
}

std::string_view choose_instruction_set(std::string_view wanted) {
    return instruction_set_named(wanted).name;
}

} // namespace fresnel
