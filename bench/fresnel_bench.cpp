// How fast the models are, and how near to what the machine can do at most.
//
//   fresnel_bench                                        everything, which takes minutes
//   fresnel_bench --benchmark_filter=^conductor/          one model
//   fresnel_bench --benchmark_format=json
//   fresnel_bench --benchmark_format=csv                 a counter that a benchmark has not is 0
//
// A benchmark is MODEL/PATH/SIZE: the model, the instruction set, how many values (1024 lie in the first cache, 2^24 do
// not lie in any). Its counters are medians of rounds in which the model, what bounds it and its rivals take turns, so
// that a change of clock or a busy neighbour meets all of them:
//   ns_per_value     time of one reflectance
//   share_of_limit   the limit's time over it. The limit is the largest of: the model's divisions and square roots at
//                    the instruction set's own rate; its other operations where n_i is 1, as it is here, each at the rate of
//                    multiply-adds, exp2 and pow at their own; reading its inputs and writing its output. Where additions have units beside
//                    those of multiplications, a model of few multiplications passes it
//   share_of_mix     the time of the kernel's own instructions when none waits for another's result, over it. More than
//                    the limit where units share what they need, as the divider and the multipliers may; the compiler
//                    orders these by itself, so that short models can take less than their mix; and kernels of
//                    AVX-512 take some roots beside the divider, which the mix does not. Of models of + - * / sqrt,
//                    AVX2 and AVX-512, in the first cache
//   times_textbook, times_complex_class, times_memo   how many times the forms of rivals.hpp take
// One thread throughout; inputs include total internal reflection.

#include "fits.hpp"
#include "rivals.hpp"
#include "units.hpp"

#include "analysis/graph.hpp"
#include "batch/core.hpp"

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <functional>
#include <map>
#include <new>
#include <random>
#include <string>
#include <vector>

#ifdef __linux__
#include <sys/mman.h>
#endif

namespace fresnel::bench {
namespace {

constexpr std::size_t small_size = 1024, large_size = std::size_t{1} << 24;

// ---- timing -----------------------------------------------------------------------------------------------

using work = std::function<void()>;

double seconds(const work& run, int times) {
    const auto start = std::chrono::steady_clock::now();
    for (int i = 0; i < times; ++i)
        run();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count() / times;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Times of several works that take turns: seconds[work], medians over the rounds.
std::vector<double> take_turns(const std::vector<work>& works, bool large) {
    const int rounds = large ? 15 : 41;
    std::vector<int> times;
    for (const work& run : works) {
        const double once = seconds(run, 1);
        times.push_back(std::clamp(static_cast<int>(1e-4 / once), 1, 10000));
    }
    std::vector<std::vector<double>> taken(works.size());
    for (int round = 0; round < rounds; ++round)
        for (std::size_t i = 0; i < works.size(); ++i)
            taken[i].push_back(seconds(works[i], times[i]));
    std::vector<double> result;
    for (const std::vector<double>& of_one : taken)
        result.push_back(median(of_one));
    return result;
}

// ---- inputs -----------------------------------------------------------------------------------------------

/// Arrays that begin with a page of 2 MiB and lie in such pages where the system has them, as those of a caller who
/// cares do: with pages of 4 KiB, looking these up is what a model in memory waits for.
template <class T>
struct aligned {
    static constexpr std::align_val_t page{std::size_t{1} << 21};
    using value_type = T;
    T* allocate(std::size_t n) {
        void* p = ::operator new(n * sizeof(T), page);
#ifdef __linux__
        if (n >= large_size) madvise(p, n * sizeof(T), MADV_HUGEPAGE);
#endif
        return static_cast<T*>(p);
    }
    void deallocate(T* p, std::size_t) { ::operator delete(p, page); }
    bool operator==(const aligned&) const { return true; }
};
using floats = std::vector<float, aligned<float>>;

/// Where a parameter's values are drawn from: what scenes hold.
std::pair<float, float> range_of(const parameter& p) {
    if (p.name == "n_t" || p.name == "n") return {0.4f, 2.5f};
    if (p.name == "k_t" || p.name == "k") return {0, 10};
    if (p.name == "eta") return {0.4f, 1};
    if (p.name == "power" || p.name == "alpha") return {3, 8};
    return {0.02f, 0.98f};
}

floats random_values(std::pair<float, float> range, std::size_t count, unsigned seed) {
    std::mt19937 generator(seed);
    std::uniform_real_distribution<float> draw(range.first, range.second);
    floats values(count);
    for (float& value : values)
        value = draw(generator);
    return values;
}

/// The arrays of a model's parameters and of cos_i. n_i is 1 for all values, not an array.
struct inputs {
    std::vector<floats> columns;
    std::vector<batch_argument> parameters;
    std::vector<const float*> arrays; ///< those that are read, cos_i last
    std::vector<const float*> all;    ///< with one for n_i

    inputs(const batch_model& model, std::size_t count) {
        static const float one = 1;
        for (std::size_t i = 0; i < model.parameter_count; ++i) {
            const parameter& p = model.parameters[i];
            const bool same = p.name == "n_i";
            columns.push_back(
                random_values(range_of(p), same ? small_size : count, static_cast<unsigned>(i)));
            all.push_back(columns.back().data());
            if (!same) arrays.push_back(all.back());
            parameters.push_back(same ? batch_argument::same(one) : batch_argument::array(all.back()));
        }
        columns.push_back(random_values({0, 1}, count, 99));
        arrays.push_back(columns.back().data());
        all.push_back(arrays.back());
    }
    const float* cos_i() const { return arrays.back(); }
};

// ---- limits -----------------------------------------------------------------------------------------------

constexpr std::pair<std::string_view, unit_kernels (*)()> every_units[] = {
    {"scalar", scalar_units},
#if defined(__x86_64__)
    {"sse2", sse2_units},
    {"avx2", avx2_units},
    {"avx512", avx512_units},
#elif defined(__aarch64__)
    {"neon", neon_units},
#endif
};

unit_kernels units_of(std::string_view set) {
    for (const auto& [name, units] : every_units)
        if (name == set) return units();
    return {};
}

bool is_polynomial(const operation_count& n) { return n.division + n.root + n.exponential + n.power == 0; }

/// Works that measure the units, and what their times say about a model.
struct limit {
    static constexpr std::size_t operations =
        13 * 16 * 512; ///< whole rounds of every unit, many for each call
    static constexpr std::size_t count = 5;

    static std::vector<work> works(const unit_kernels& units) {
        return {[=] { units.division(operations); }, [=] { units.root(operations); },
                [=] { units.multiply(operations); }, [=] { units.exp2(operations); },
                [=] { units.pow(operations); }};
    }

    /// Seconds per value from the times of those works.
    static double seconds_per_value(const operation_count& n, const double* times, double stream) {
        const double divider = n.division * times[0] + n.root * times[1];
        const double others = n.cheap * times[2] + n.exponential * times[3] + n.power * times[4];
        return std::max({divider / operations, others / operations, stream});
    }
};

// ---- results ----------------------------------------------------------------------------------------------

/// What the summary at the end is made of: counters by benchmark.
std::map<std::string, std::map<std::string, double>> results;

constexpr std::array every_counter{"ns_per_value",
                                   "share_of_limit",
                                   "share_of_mix",
                                   "times_textbook",
                                   "times_memo",
                                   "times_complex_class",
                                   "ns_division",
                                   "ns_square_root",
                                   "ns_multiply_add",
                                   "ns_exp2",
                                   "ns_pow",
                                   "milliseconds",
                                   "fits",
                                   "gigabytes_per_second_in_cache",
                                   "gigabytes_per_second_in_memory"};

/// The counters that every row has, 0 where the benchmark has none: all of them in a table, otherwise none.
std::vector<std::string> columns;

void report(benchmark::State& state, const std::string& name, const work& run,
            const std::map<std::string, double>& counters) {
    for (auto _ : state)
        run();
    for (const std::string& column : columns)
        state.counters[column] = 0;
    for (const auto& [counter, value] : counters)
        state.counters[counter] = value;
    results[name] = counters;
}

void run_model(benchmark::State& state, const std::string& name, const batch_model& model,
               const instruction_set& set, std::size_t count) {
    const inputs in(model, count);
    floats R(count), rival_R(count);
    float* const outputs[] = {R.data()};
    batch_job job;
    make_job(quantity::reflectance, model, set, in.parameters, batch_argument::array(in.cos_i()), count,
             outputs, job);
    const unit_kernels units = units_of(set.name);
    const int arrays = static_cast<int>(in.arrays.size());
    std::vector<work> works = {[&] { run_job(job, 0, count); },
                               [&] { units.stream(in.arrays.data(), arrays, rival_R.data(), count); }};
    for (const work& unit : limit::works(units))
        works.push_back(unit);
    const operation_count operations = count_operations_in_vacuum(model.name);
    const bool mixed = units.mix && count == small_size && operations.exponential + operations.power == 0;
    if (mixed) works.push_back([&] { units.mix(model.name, in.all.data(), rival_R.data(), count); });

    using rival = void (*)(const index_arrays&, float*, std::size_t);
    std::vector<std::pair<const char*, rival>> rivals;
    if (model.name.starts_with("conductor"))
        rivals = {{"times_textbook", textbook_conductor},
                  {"times_complex_class", complex_class_conductor},
                  {"times_memo", memo_conductor}};
    if (model.name.starts_with("dielectric")) rivals = {{"times_textbook", textbook_dielectric}};
    if (count == large_size) rivals.clear();
    const index_arrays index{in.arrays[0], in.arrays[arrays > 2 ? 1 : 0], in.cos_i()};
    const std::size_t first_rival = works.size();
    for (const auto& entry : rivals)
        works.push_back(
            [&index, &rival_R, count, form = entry.second] { form(index, rival_R.data(), count); });

    const std::vector<double> times = take_turns(works, count == large_size);
    const double values = static_cast<double>(count);
    const double per_value = times[0] / values;
    std::map<std::string, double> counters{
        {"ns_per_value", per_value * 1e9},
        {"share_of_limit",
         limit::seconds_per_value(operations, times.data() + 2, times[1] / values) / per_value}};
    if (mixed) counters["share_of_mix"] = times[2 + limit::count] / times[0];
    for (std::size_t i = 0; i < rivals.size(); ++i)
        counters[rivals[i].first] = times[first_rival + i] / times[0];
    report(state, name, works[0], counters);
}

/// A metal's table of 81 wavelengths, 90 angles and 3 channels.
void run_spectral_table(benchmark::State& state, const std::string& name, const instruction_set& set) {
    constexpr std::size_t wavelengths = 81, angles = 90;
    const floats n = random_values({0.2f, 1.5f}, wavelengths, 1), k = random_values({2, 4}, wavelengths, 2);
    const floats cos_i = random_values({0, 1}, angles, 3), weight = random_values({0, 0.02f}, wavelengths, 4);
    floats rgb[3] = {floats(angles), floats(angles), floats(angles)};
    const spectral_call call{
        n.data(), k.data(),     {weight.data(), weight.data(), weight.data()}, wavelengths,
        1,        cos_i.data(), {rgb[0].data(), rgb[1].data(), rgb[2].data()}, angles};

    const auto twice = [](const floats& values) { return std::vector<double>(values.begin(), values.end()); };
    const std::vector<double> n2 = twice(n), k2 = twice(k), cos2 = twice(cos_i), weight2 = twice(weight);
    std::vector<double> rgb2[3] = {twice(rgb[0]), twice(rgb[1]), twice(rgb[2])};
    const double* const weights2[] = {weight2.data(), weight2.data(), weight2.data()};
    double* const to[] = {rgb2[0].data(), rgb2[1].data(), rgb2[2].data()};

    const std::vector<work> works = {[&] { run_spectral(set, call); },
                                     [&] {
                                         textbook_spectral_table(n2.data(), k2.data(), weights2, wavelengths,
                                                                 cos2.data(), angles, to);
                                     }};
    const std::vector<double> times = take_turns(works, false);
    report(
        state, name, works[0],
        {{"ns_per_value", times[0] * 1e9 / (wavelengths * angles)}, {"times_textbook", times[1] / times[0]}});
}

/// Every fit of every built-in material, on one core.
void run_fits(benchmark::State& state, const std::string& name) {
    const std::function<int()> fit_all = all_fits();
    const work run = [&] { benchmark::DoNotOptimize(fit_all()); };
    std::vector<double> taken;
    for (int round = 0; round < 9; ++round)
        taken.push_back(seconds(run, 1));
    report(state, name, run, {{"milliseconds", median(taken) * 1e3}, {"fits", fit_all()}});
}

void run_units(benchmark::State& state, const std::string& name, const unit_kernels& units) {
    const floats x = random_values({0, 1}, large_size, 1);
    floats y(large_size);
    const float* const arrays[] = {x.data()};
    std::vector<work> works = limit::works(units);
    works.push_back([&] { units.stream(arrays, 1, y.data(), small_size); });
    std::vector<double> times = take_turns(works, false);
    times.push_back(take_turns({[&] { units.stream(arrays, 1, y.data(), large_size); }}, true)[0]);
    const double each = 1e9 / limit::operations;
    const double bytes = 2 * sizeof(float) * 1e-9;
    report(state, name, works[0],
           {{"ns_division", times[0] * each},
            {"ns_square_root", times[1] * each},
            {"ns_multiply_add", times[2] * each},
            {"ns_exp2", times[3] * each},
            {"ns_pow", times[4] * each},
            {"gigabytes_per_second_in_cache", bytes * static_cast<double>(small_size) / times[5]},
            {"gigabytes_per_second_in_memory", bytes * static_cast<double>(large_size) / times[6]}});
}

// ---- all of it --------------------------------------------------------------------------------------------

template <class Run>
void add(const std::string& name, Run run) {
    benchmark::RegisterBenchmark(name.c_str(), [name, run](benchmark::State& state) {
        run(state, name);
    })->Unit(benchmark::kNanosecond);
}

void add_all() {
    for (const instruction_set& set : built_instruction_sets()) {
        if (!set.supported()) continue;
        add(fmt::format("machine/{}", set.name),
            [&set](auto& state, auto& name) { run_units(state, name, units_of(set.name)); });
    }
    for (const instruction_set& set : built_instruction_sets())
        if (set.supported())
            add(fmt::format("spectral_table/{}/81x90x3", set.name),
                [&set](auto& state, auto& name) { run_spectral_table(state, name, set); });
    add("fits/every_material", run_fits);
    for (const batch_model& model : batch_models())
        for (const instruction_set& set : built_instruction_sets())
            for (const std::size_t count : {small_size, large_size})
                if (set.supported())
                    add(fmt::format("{}/{}/{}", model.name, set.name, count),
                        [&model, &set, count](auto& state, auto& name) {
                            run_model(state, name, model, set, count);
                        });
}

/// A goal of the project, at least (milliseconds: at most), and what was measured, where it was.
void print_goal(std::FILE* to, const std::string& benchmark, const std::string& counter, double goal) {
    const auto found = results.find(benchmark);
    if (found == results.end() || !found->second.contains(counter)) return;
    fmt::print(to, "{:<36} {:<20} {:>8.2f} {:>8.2f}\n", benchmark, counter, goal, found->second.at(counter));
}

void print_goals(std::FILE* to) {
    if (results.empty()) return;
    fmt::print(to, "\n{:<36} {:<20} {:>8} {:>8}\n", "benchmark", "counter", "goal", "here");
    for (const std::string set : {"avx512", "avx2"}) {
        for (const batch_model& model : batch_models()) {
            const std::string small = fmt::format("{}/{}/{}", model.name, set, small_size);
            const std::string large = fmt::format("{}/{}/{}", model.name, set, large_size);
            if (model.name == "conductor") print_goal(to, small, "share_of_limit", 0.75);
            if (model.name == "conductor_fast" || model.name.starts_with("dielectric"))
                print_goal(to, small, "share_of_limit", 0.8);
            if (is_polynomial(count_operations(model.name))) print_goal(to, small, "share_of_limit", 0.9);
            print_goal(to, large, "share_of_limit", 0.85);
        }
        const std::string conductor = fmt::format("conductor/{}/{}", set, small_size);
        if (set == "avx512") print_goal(to, conductor, "times_textbook", 80);
        print_goal(to, conductor, "times_complex_class", set == "avx512" ? 20 : 12);
        if (set == "avx512") print_goal(to, "spectral_table/avx512/81x90x3", "times_textbook", 55);
    }
    print_goal(to, "fits/every_material", "milliseconds", 150);
}

} // namespace
} // namespace fresnel::bench

int main(int argc, char** argv) {
    using namespace fresnel::bench;
    add_all();
    // the counters have their own rounds; Google Benchmark's time needs few
    char short_time[] = "--benchmark_min_time=0.01";
    std::vector<char*> arguments(argv, argv + argc);
    bool console = true; // otherwise the goals would stand behind the JSON or the table
    for (const std::string_view argument : arguments) {
        if (argument.starts_with("--benchmark_format=")) console = argument.ends_with("=console");
        if (argument.ends_with("=csv")) columns.assign(every_counter.begin(), every_counter.end());
    }
    arguments.insert(arguments.begin() + 1, short_time);
    int count = static_cast<int>(arguments.size());
    benchmark::Initialize(&count, arguments.data());
    if (benchmark::ReportUnrecognizedArguments(count, arguments.data())) return 2;
    benchmark::RunSpecifiedBenchmarks();
    print_goals(console ? stdout : stderr);
}
