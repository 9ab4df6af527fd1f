#include "batch/core.hpp"

#include <atomic>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace fresnel {

// ---- models -----------------------------------------------------------------------------------------------

namespace {

template <std::size_t... i>
struct rows_of {
    static constexpr batch_model rows[] = {{std::get<i>(registry).name,
                                            std::get<i>(registry).parameters.data(),
                                            std::get<i>(registry).parameters.size()}...};
};

template <std::size_t... i>
constexpr std::span<const batch_model> all_rows(std::index_sequence<i...>) {
    return rows_of<i...>::rows;
}

constexpr std::size_t model_count = std::tuple_size_v<decltype(registry)>;

} // namespace

std::span<const batch_model> batch_models() noexcept {
    return all_rows(std::make_index_sequence<model_count>{});
}

const batch_model* find_batch_model(std::string_view name) noexcept {
    for (const batch_model& row : batch_models())
        if (row.name == name) return &row;
    return nullptr;
}

// ---- instruction sets -------------------------------------------------------------------------------------

namespace {

constexpr auto always = [] { return true; };

constexpr instruction_set built[] = {
    {"scalar", always, scalar_kernels},
#if defined(__x86_64__)
    {"sse2", always, sse2_kernels},
    {"avx2", [] { return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma"); }, avx2_kernels},
    {"avx512",
     [] {
         return __builtin_cpu_supports("fma") && __builtin_cpu_supports("avx512f") &&
                __builtin_cpu_supports("avx512vl") && __builtin_cpu_supports("avx512dq") &&
                __builtin_cpu_supports("avx512bw");
     },
     avx512_kernels},
#elif defined(__aarch64__)
    {"neon", always, neon_kernels},
#elif defined(__wasm__)
    {"simd128", always, simd128_kernels},
#endif
};

} // namespace

std::span<const instruction_set> built_instruction_sets() noexcept { return built; }

const instruction_set* find_instruction_set(std::string_view name) noexcept {
    const instruction_set* widest = nullptr;
    for (const instruction_set& set : built) {
        if (!set.supported()) continue;
        if (set.name == name) return &set;
        widest = &set;
    }
    return name.empty() ? widest : nullptr;
}

std::string_view instruction_set_of_environment() noexcept {
    const char* name = std::getenv("FRESNEL_ISA");
    return name ? name : "";
}

const instruction_set* default_instruction_set() noexcept {
    // threads that come here at once find the same one
    static std::atomic<const instruction_set*> found = nullptr;
    const instruction_set* set = found.load(std::memory_order_relaxed);
    if (set) return set;
    set = find_instruction_set(instruction_set_of_environment());
    found.store(set, std::memory_order_relaxed);
    return set;
}

// ---- the check of a call ----------------------------------------------------------------------------------

namespace {

/// The kernel for what is wanted, null where the model has none, and how many of the outputs it writes.
std::pair<kernel, std::size_t> find_kernel(quantity wanted, const model_kernels& model,
                                           std::span<float* const> outputs) {
    switch (wanted) {
    case quantity::reflectance:
        return {model.reflectance, 1};
    case quantity::rgb:
        return {model.rgb, 3};
    case quantity::polarised:
        break;
    }
    const bool transmitted = outputs[2] || outputs[3];
    return transmitted ? std::pair{model.powers, 4} : std::pair{model.polarised, 2};
}

/// Whether a result replaces an argument: its memory is read in any case, and writing past the caches spares nothing.
bool in_place(const batch_job& job) {
    return std::any_of(job.inputs, job.inputs + job.input_count, [&](const batch_argument& in) {
        return std::any_of(job.outputs, job.outputs + job.output_count,
                           [&](const float* out) { return out == in.data; });
    });
}

/// How many inputs are arrays.
std::ptrdiff_t count_arrays(const batch_job& job) {
    return std::count_if(job.inputs, job.inputs + job.input_count,
                         [](const batch_argument& in) { return in.stride != 0; });
}

/// Copies the single values into the job: one that lies in an output would otherwise change on the way.
void keep_singles(batch_job& job) {
    for (std::size_t k = 0; k < job.input_count; ++k) {
        if (job.inputs[k].stride != 0) continue;
        job.singles[k] = *job.inputs[k].data;
        job.inputs[k].data = &job.singles[k];
    }
}

} // namespace

std::size_t parameters_of(quantity wanted, const batch_model& model) noexcept {
    return (wanted == quantity::rgb ? 3 : 1) * model.parameter_count;
}

refusal check_inputs(std::span<const batch_argument> inputs) noexcept {
    std::size_t k = 0;
    for (const auto& [data, stride] : inputs) {
        if (!data) return {refusal::null_input, k};
        if (stride > 1) return {refusal::bad_stride, k};
        ++k;
    }
    return {};
}

refusal make_job(quantity wanted, const batch_model& model, const instruction_set& set,
                 std::span<const batch_argument> parameters, batch_argument cos_i, std::size_t count,
                 std::span<float* const> outputs, batch_job& job) noexcept {
    if (parameters.size() != parameters_of(wanted, model)) return {refusal::parameter_count};
    const std::ptrdiff_t index = &model - batch_models().data();
    const kernel_table kernels = set.kernels();
    const auto [run, output_count] = find_kernel(wanted, kernels.models[index], outputs);
    if (!run) return {refusal::not_polarised};

    job.run = run;
    job.lanes = kernels.models[index].lanes;
    job.input_count = parameters.size() + 1;
    job.output_count = output_count;
    job.past_caches = false;
    std::copy(parameters.begin(), parameters.end(), job.inputs);
    job.inputs[parameters.size()] = cos_i;
    std::copy_n(outputs.begin(), output_count, job.outputs);

    if (count == 0) return {};
    const refusal refused = check_inputs({job.inputs, job.input_count});
    if (refused.why != refusal::none) return refused;
    for (std::size_t k = 0; k < output_count; ++k)
        if (!job.outputs[k]) return {refusal::null_output, k};
    keep_singles(job);
    // exact models of one array lose by it where pages have 4 KiB
    const bool gains = !kernels.models[index].polarised || count_arrays(job) > 1;
    job.past_caches = count >= values_past_caches && gains && !in_place(job);
    return {};
}

// ---- running ----------------------------------------------------------------------------------------------

namespace {

/// Intel's processors stop fetching ahead by themselves at the end of each page, where AMD's lose by being told to.
bool is_intel() noexcept {
#if defined(__x86_64__)
    return __builtin_cpu_is("intel");
#else
    return false;
#endif
}

/// How many values from a place on come before the next multiple of 64 bytes, where a cache line begins.
std::size_t values_to_line(const float* place) {
    return (0 - reinterpret_cast<std::uintptr_t>(place)) / sizeof(float) % 16;
}

/// One batch's worth of floats, for values that have to be cut off.
struct lane_buffer {
    float lane[most_lanes];
};

/// Whole batches straight from and to the arrays.
void run_whole(const batch_job& job, std::size_t begin, std::size_t end) noexcept {
    kernel_call call{job.inputs, job.outputs, begin, end};
    if (job.past_caches) {
        call.past_caches = std::all_of(job.outputs, job.outputs + job.output_count, [=](const float* p) {
            return reinterpret_cast<std::uintptr_t>(p + begin) % 64 == 0;
        });
        call.fetch_ahead = is_intel();
    }
    job.run(call);
}

/// Values that make no whole batches, at most `most_lanes`, through buffers.
void run_few(const batch_job& job, std::size_t begin, std::size_t count) noexcept {
    lane_buffer in[most_inputs], out[most_outputs];
    batch_argument inputs[most_inputs];
    float* outputs[most_outputs];
    for (std::size_t k = 0; k < job.input_count; ++k) {
        inputs[k] = job.inputs[k];
        if (inputs[k].stride == 0) continue;
        const float* from = inputs[k].data + begin;
        std::copy_n(from, count, in[k].lane);
        std::fill(in[k].lane + count, in[k].lane + most_lanes, *from);
        inputs[k].data = in[k].lane;
    }
    for (std::size_t k = 0; k < most_outputs; ++k)
        outputs[k] = out[k].lane;
    job.run({inputs, outputs, 0, (count + job.lanes - 1) & ~(job.lanes - 1)});
    for (std::size_t k = 0; k < std::min(job.output_count, most_outputs); ++k)
        std::copy_n(out[k].lane, count, job.outputs[k] + begin);
}

} // namespace

void run_spectral(const instruction_set& set, const spectral_call& call) noexcept {
    const kernel_table kernels = set.kernels();
    spectral_call whole = call;
    whole.angles = call.angles / kernels.spectral_lanes * kernels.spectral_lanes;
    kernels.spectral(whole);
    const std::size_t rest = call.angles - whole.angles;
    if (rest == 0) return;

    // the angles left over, as many as are computed at a time, through buffers
    lane_buffer cos_i, out[3];
    std::copy_n(call.cos_i + whole.angles, rest, cos_i.lane);
    std::fill(cos_i.lane + rest, cos_i.lane + most_lanes, 1.0f);
    spectral_call last = whole;
    last.cos_i = cos_i.lane;
    last.angles = kernels.spectral_lanes;
    for (int channel = 0; channel < 3; ++channel)
        last.rgb[channel] = out[channel].lane;
    kernels.spectral(last);
    for (int channel = 0; channel < 3; ++channel)
        std::copy_n(out[channel].lane, rest, call.rgb[channel] + whole.angles);
}

void run_job(const batch_job& job, std::size_t begin, std::size_t end) noexcept {
    if (job.past_caches) {
        // up to where a cache line of the results begins, which malloc's arrays do not
        const std::size_t head = std::min(values_to_line(job.outputs[0] + begin), end - begin);
        if (head > 0) run_few(job, begin, head);
        begin += head;
    }
    const std::size_t rest = (end - begin) & (job.lanes - 1);
    if (end - begin > rest) run_whole(job, begin, end - rest);
    if (rest > 0) run_few(job, end - rest, rest);
}

} // namespace fresnel
