#include "batch/batch.hpp"

#include "batch/kernels.hpp"
#include "error.hpp"

#include <fresnel/models.hpp>

#include <algorithm>
#include <cstdlib>
#include <string>
#include <system_error>
#include <thread>

namespace fresnel {

namespace {

// ---- instruction sets -------------------------------------------------------------------------------------

struct instruction_set {
    std::string_view name;
    std::size_t lanes;
    bool (*supported)();
    const model_kernels* (*kernels)();
};

constexpr auto always = [] { return true; };

/// What this library was built for, narrowest first.
constexpr instruction_set built[] = {
    {"scalar", 1, always, scalar_kernels},
#if defined(__x86_64__)
    {"sse2", 8, always, sse2_kernels},
    {"avx2", 16, [] { return __builtin_cpu_supports("avx2") != 0; }, avx2_kernels},
    {"avx512", 64,
     [] {
         return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                __builtin_cpu_supports("avx512dq") && __builtin_cpu_supports("avx512bw");
     },
     avx512_kernels},
#elif defined(__aarch64__)
    {"neon", 16, always, neon_kernels},
#elif defined(__wasm__)
    {"simd128", 8, always, simd128_kernels},
#endif
};

const instruction_set& find_instruction_set(std::string_view wanted) {
    const instruction_set* widest = nullptr;
    std::string allowed;
    for (const instruction_set& set : built) {
        if (!set.supported()) continue;
        if (set.name == wanted) return set;
        allowed += std::string(allowed.empty() ? "" : ", ") + std::string(set.name);
        widest = &set;
    }
    if (wanted.empty()) return *widest;
    throw bad_input("instruction set '" + std::string(wanted) + "' is not one of " + allowed);
}

/// The set that FRESNEL_ISA names, or the widest. Looked up once.
const instruction_set& default_instruction_set() {
    static const instruction_set& set = []() -> const instruction_set& {
        const char* forced = std::getenv("FRESNEL_ISA");
        return find_instruction_set(forced ? forced : "");
    }();
    return set;
}

// ---- models -----------------------------------------------------------------------------------------------

struct model_place {
    std::string_view name;
    std::size_t index, parameters;
};

model_place find_place(std::string_view name) {
    model_place found{};
    std::size_t index = 0;
    std::vector<std::string> names;
    for_each_model([&](const auto& row) {
        if (row.name == name) found = {row.name, index, row.parameters.size()};
        names.emplace_back(row.name);
        ++index;
    });
    if (!found.name.empty()) return found;
    throw bad_input("model '" + std::string(name) + "' is unknown" + did_you_mean(name, names));
}

// ---- running ----------------------------------------------------------------------------------------------

/// A call as the user made it, checked: the inputs are the parameters and cos_i.
struct job {
    std::vector<batch_argument> inputs;
    std::vector<float*> outputs;
    kernel run;
    std::size_t lanes;
};

/// One batch's worth of floats, for values that have to be repeated or cut off.
using lane_buffer = std::array<float, most_lanes>;

/// The pointers and steps of a job from value `begin` on. Single values are repeated in buffers of their own.
class kernel_arguments {
public:
    kernel_arguments(const job& work, std::size_t begin) : lanes_(work.lanes), repeated_(work.inputs.size()) {
        for (std::size_t k = 0; k < work.inputs.size(); ++k) {
            const auto [data, stride] = work.inputs[k];
            if (stride == 0) repeated_[k].fill(*data);
            inputs_.push_back(stride == 0 ? repeated_[k].data() : data + begin);
            steps_.push_back(stride == 0 ? 0 : lanes_);
        }
        for (float* output : work.outputs)
            outputs_.push_back(output + begin);
    }

    /// Whole batches straight from and to the arrays.
    void run_whole(kernel run, std::size_t count) const {
        run({inputs_.data(), steps_.data(), outputs_.data(), count});
    }

    /// The `rest` values after the first `done`, fewer than a batch, through buffers.
    void run_rest(kernel run, std::size_t done, std::size_t rest) const {
        std::vector<lane_buffer> in(inputs_.size()), out(outputs_.size());
        std::vector<const float*> in_at;
        std::vector<float*> out_at;
        for (std::size_t k = 0; k < in.size(); ++k) {
            const float* from = inputs_[k] + (steps_[k] ? done : 0);
            std::copy_n(from, rest, in[k].begin());
            std::fill(in[k].begin() + static_cast<std::ptrdiff_t>(rest), in[k].end(), *from);
            in_at.push_back(in[k].data());
        }
        for (lane_buffer& buffer : out)
            out_at.push_back(buffer.data());
        run({in_at.data(), steps_.data(), out_at.data(), lanes_});
        for (std::size_t k = 0; k < out.size(); ++k)
            std::copy_n(out[k].begin(), rest, outputs_[k] + done);
    }

private:
    std::size_t lanes_;
    std::vector<lane_buffer> repeated_;
    std::vector<const float*> inputs_;
    std::vector<std::size_t> steps_;
    std::vector<float*> outputs_;
};

void run_range(const job& work, std::size_t begin, std::size_t end) {
    const kernel_arguments arguments(work, begin);
    const std::size_t rest = (end - begin) % work.lanes;
    const std::size_t whole = end - begin - rest;
    if (whole > 0) arguments.run_whole(work.run, whole);
    if (rest > 0) arguments.run_rest(work.run, whole, rest);
}

constexpr std::size_t values_per_thread = 65536;

std::size_t thread_count(std::size_t count, unsigned wanted) {
    if (wanted > 0) return std::min<std::size_t>(wanted, std::max<std::size_t>(count, 1));
    const std::size_t useful = count / values_per_thread;
    return std::clamp<std::size_t>(std::thread::hardware_concurrency(), 1, std::max<std::size_t>(useful, 1));
}

/// Runs the job in equal parts; a part for which the system grants no thread is run by the caller.
void run_threads(const job& work, std::size_t count, unsigned wanted) {
    const std::size_t threads = thread_count(count, wanted);
    const std::size_t part = (count / threads + most_lanes) / most_lanes * most_lanes;
    std::vector<std::jthread> running;
    for (std::size_t begin = part; begin < count; begin += part) {
        const std::size_t end = std::min(begin + part, count);
        try {
            running.emplace_back([&work, begin, end] { run_range(work, begin, end); });
        } catch (const std::system_error&) {
            run_range(work, begin, end);
        }
    }
    run_range(work, 0, std::min(part, count));
}

// ---- checking ---------------------------------------------------------------------------------------------

void check_argument(std::string_view what, const batch_argument& argument) {
    if (!argument.data) throw bad_input(std::string(what) + " is null");
    if (argument.stride > 1)
        throw bad_input(std::string(what) + " has stride " + std::to_string(argument.stride) +
                        ": must be 0 or 1");
}

void check_arguments(const model_place& model, std::size_t channels,
                     std::span<const batch_argument> parameters, const batch_argument& cos_i,
                     std::size_t count) {
    const std::size_t expected = channels * model.parameters;
    if (parameters.size() != expected)
        throw bad_input("model '" + std::string(model.name) + "' has " + std::to_string(expected) +
                        " parameters here, not " + std::to_string(parameters.size()));
    if (count == 0) return; // no pointer is followed
    for (std::size_t k = 0; k < parameters.size(); ++k)
        check_argument("parameter " + std::to_string(k), parameters[k]);
    check_argument("cos_i", cos_i);
}

const model_kernels& kernels_of(const instruction_set& set, const model_place& model) {
    return set.kernels()[model.index];
}

const instruction_set& chosen(const batch_options& options) {
    return options.instruction_set.empty() ? default_instruction_set()
                                           : find_instruction_set(options.instruction_set);
}

void run(kernel run, std::size_t lanes, std::span<const batch_argument> parameters,
         const batch_argument& cos_i, std::size_t count, std::span<float* const> outputs, unsigned threads) {
    if (count == 0) return;
    for (const float* output : outputs)
        if (!output) throw bad_input("an output is null");
    job work{{parameters.begin(), parameters.end()}, {outputs.begin(), outputs.end()}, run, lanes};
    work.inputs.push_back(cos_i);
    run_threads(work, count, threads);
}

} // namespace

void evaluate_batch(std::string_view model, std::span<const batch_argument> parameters, batch_argument cos_i,
                    std::size_t count, float* R, const batch_options& options) {
    const model_place place = find_place(model);
    const instruction_set& set = chosen(options);
    check_arguments(place, 1, parameters, cos_i, count);
    run(kernels_of(set, place).reflectance, set.lanes, parameters, cos_i, count, {&R, 1}, options.threads);
}

void evaluate_batch_polarised(std::string_view model, std::span<const batch_argument> parameters,
                              batch_argument cos_i, std::size_t count, const batch_polarised& results,
                              const batch_options& options) {
    const model_place place = find_place(model);
    const instruction_set& set = chosen(options);
    check_arguments(place, 1, parameters, cos_i, count);
    const model_kernels& kernels = kernels_of(set, place);
    if (!kernels.polarised)
        throw bad_input("model '" + std::string(model) + "' is not exact and has no R_s, R_p");
    float* const outputs[] = {results.R_s, results.R_p, results.T_s, results.T_p};
    const bool transmitted = results.T_s || results.T_p;
    run(transmitted ? kernels.powers : kernels.polarised, set.lanes, parameters, cos_i, count,
        std::span(outputs).first(transmitted ? 4 : 2), options.threads);
}

void evaluate_batch_rgb(std::string_view model, std::span<const batch_argument> parameters,
                        batch_argument cos_i, std::size_t count, const std::array<float*, 3>& rgb,
                        const batch_options& options) {
    const model_place place = find_place(model);
    const instruction_set& set = chosen(options);
    check_arguments(place, 3, parameters, cos_i, count);
    run(kernels_of(set, place).rgb, set.lanes, parameters, cos_i, count, rgb, options.threads);
}

std::vector<std::string_view> instruction_sets() {
    std::vector<std::string_view> names;
    for (const instruction_set& set : built)
        if (set.supported()) names.push_back(set.name);
    return names;
}

std::string_view choose_instruction_set(std::string_view wanted) {
    return wanted.empty() ? default_instruction_set().name : find_instruction_set(wanted).name;
}

} // namespace fresnel
