#include "inputs.hpp"
#include "tolerances.hpp"

#include "batch/batch.hpp"
#include "batch/core.hpp"
#include "error.hpp"

#include <fresnel/fresnel.h>
#include <fresnel/models.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <limits>
#include <string>
#include <thread>
#include <vector>

namespace fresnel::test {
namespace {

using floats = std::vector<float>;

/// A model's arguments at many points: the parameters, then cos_i.
struct points {
    std::string model;
    std::vector<floats> columns;
    std::size_t parameters() const { return columns.size() - 1; }
    std::size_t size() const { return columns.back().size(); }
};

/// What makes a vector unit and a scalar one differ, if anything does.
constexpr float special_values[] = {0,
                                    1,
                                    -0.0F,
                                    std::numeric_limits<float>::denorm_min(),
                                    0x1p-126F,
                                    1e-20F,
                                    1e35F,
                                    std::numeric_limits<float>::max(),
                                    std::numeric_limits<float>::infinity(),
                                    -std::numeric_limits<float>::infinity(),
                                    std::numeric_limits<float>::quiet_NaN()};

float argument(const parameter& p, random_numbers& random) {
    if (random.one_in(50))
        return special_values[static_cast<std::size_t>(
            random.uniform(0, static_cast<double>(std::size(special_values))))];
    if (random.one_in(20)) return static_cast<float>(random.one_in(2) ? p.min : p.max);
    if (random.one_in(10)) return static_cast<float>(p.default_value);
    const double low = p.min > 0 ? p.min : p.max * 1e-5;
    return static_cast<float>(random.one_in(2) && p.min >= 0 ? random.log_uniform(low, p.max)
                                                             : random.uniform(p.min, std::min(p.max, 5.0)));
}

template <class Row>
points random_points(const Row& row, std::size_t count) {
    random_numbers random(21);
    points result{std::string(row.name), std::vector<floats>(row.parameters.size() + 1)};
    for (std::size_t i = 0; i < count; ++i) {
        std::size_t k = 0;
        for (const parameter& p : row.parameters)
            result.columns[k++].push_back(argument(p, random));
        result.columns[k].push_back(argument(row::cos_i, random));
        // an index match now and then, also where squares are too small for their rounding errors to be floats
        if (row.kind == model_kind::exact && random.one_in(20)) {
            result.columns[1].back() = result.columns[0].back();
            if (random.one_in(4)) {
                result.columns[k].back() = static_cast<float>(random.log_uniform(1e-37, 1e-8));
                if (k == 3) result.columns[2].back() = static_cast<float>(random.log_uniform(1e-44, 1e-8));
            }
        }
    }
    return result;
}

constexpr std::size_t enough = 1000003 / thinning;

std::vector<batch_argument> arrays(const std::vector<floats>& columns, std::size_t from = 0) {
    std::vector<batch_argument> result;
    for (const floats& column : columns)
        result.push_back(batch_argument::array(column.data() + from));
    return result;
}

batch_options one_thread(std::string_view set) { return {.instruction_set = set, .threads = 1}; }

/// R of a path at all points.
floats reflectances(const points& at, const batch_options& options) {
    floats R(at.size());
    auto arguments = arrays(at.columns);
    const batch_argument cos_i = arguments.back();
    arguments.pop_back();
    evaluate_batch(at.model, arguments, cos_i, at.size(), R.data(), options);
    return R;
}

/// R_s, R_p, T_s and T_p of a path at all points, one after the other.
floats polarised_parts(const points& at, const batch_options& options) {
    floats parts(4 * at.size());
    float* p = parts.data();
    const std::size_t n = at.size();
    auto arguments = arrays(at.columns);
    const batch_argument cos_i = arguments.back();
    arguments.pop_back();
    evaluate_batch_polarised(at.model, arguments, cos_i, n, {p, p + n, p + 2 * n, p + 3 * n}, options);
    return parts;
}

bool same_bits(float a, float b) {
    return std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b) ||
           (std::isnan(a) && std::isnan(b));
}

/// All values equal bit for bit, any two NaN counting as equal; shows the first that differ.
testing::AssertionResult identical(const points& at, const floats& actual, const floats& expected) {
    if (actual.size() != expected.size()) return testing::AssertionFailure() << "different lengths";
    for (std::size_t i = 0; i < actual.size(); ++i) {
        if (same_bits(actual[i], expected[i])) continue;
        auto failure = testing::AssertionFailure() << at.model << " at";
        for (const floats& column : at.columns)
            failure << ' ' << digits(column[i % at.size()]);
        return failure << "\nexpected " << digits(expected[i]) << "\nactual   " << digits(actual[i]);
    }
    return testing::AssertionSuccess();
}

/// Whether `results` gives the same at all points of every model that it takes, whatever the path.
template <class Results>
void expect_the_scalar_bits(bool polarised, Results results) {
    for_each_model([&](const auto& row) {
        if (polarised && row.kind != model_kind::exact) return;
        const points at = random_points(row, enough);
        const floats expected = results(at, one_thread("scalar"));
        for (const std::string_view set : instruction_sets())
            EXPECT_TRUE(identical(at, results(at, one_thread(set)), expected)) << set;
    });
}

TEST(batch, every_path_gives_the_bits_of_the_scalar_path) { expect_the_scalar_bits(false, reflectances); }

TEST(batch, every_path_gives_the_polarised_bits_of_the_scalar_path) {
    expect_the_scalar_bits(true, polarised_parts);
}

/// Calls test(row, so many of its points, path) for every model and every path but the scalar one.
template <class Test>
void for_each_vector_path(std::size_t count, Test test) {
    for_each_model([&](const auto& row) {
        const points at = random_points(row, count);
        for (const std::string_view set : instruction_sets()) {
            SCOPED_TRACE(set);
            if (set != "scalar") test(row, at, set);
        }
    });
}

bool has_power(std::string_view model) {
    for (const std::string_view name :
         {"schlick_power", "spherical_gaussian", "lazanyi", "hoffman", "bias_scale_power"})
        if (name == model) return true;
    return false;
}

TEST(batch, models_of_arithmetic_and_roots_give_the_bits_of_float) {
    for_each_model([](const auto& row) {
        if (has_power(row.name)) return;
        const points at = random_points(row, enough);
        floats expected;
        for (std::size_t i = 0; i < at.size(); ++i) {
            floats values;
            for (std::size_t k = 0; k < at.parameters(); ++k)
                values.push_back(at.columns[k][i]);
            expected.push_back(reflectance(evaluate(row, values, at.columns.back()[i])));
        }
        EXPECT_TRUE(identical(at, reflectances(at, one_thread("scalar")), expected));
    });
}

TEST(batch, reflectance_is_the_mean_of_the_polarised_parts) {
    for_each_model([](const auto& row) {
        if (row.kind != model_kind::exact) return;
        const points at = random_points(row, 1000);
        const floats parts = polarised_parts(at, one_thread("scalar"));
        floats mean;
        for (std::size_t i = 0; i < at.size(); ++i)
            mean.push_back((parts[i] + parts[at.size() + i]) / 2);
        EXPECT_TRUE(identical(at, reflectances(at, one_thread("scalar")), mean));
    });
}

constexpr float guard = 12345;

/// R of `count` values from the place `from` on, between guards, from and to places that no vector is aligned to.
floats guarded(const points& at, std::size_t from, std::size_t count, std::string_view set) {
    floats R(count + 2, guard);
    auto arguments = arrays(at.columns, from);
    // exactly as long as they may be read, so that a sanitizer sees a read past the end
    std::vector<floats> copies;
    for (batch_argument& argument : arguments)
        argument = batch_argument::array(copies.emplace_back(argument.data, argument.data + count).data());
    const batch_argument cos_i = arguments.back();
    arguments.pop_back();
    evaluate_batch(at.model, arguments, cos_i, count, R.data() + 1, one_thread(set));
    EXPECT_EQ(R.front(), guard);
    EXPECT_EQ(R.back(), guard);
    return {R.begin() + 1, R.end() - 1};
}

TEST(batch, any_length_and_place_gives_the_same_and_touches_nothing_else) {
    for_each_vector_path(4000, [](const auto& row, const points& all, std::string_view set) {
        if (row.name != "conductor" && row.name != "schlick" && row.name != "hoffman") return;
        const floats expected = reflectances(all, one_thread("scalar"));
        for (std::size_t count = 0; count <= 67; ++count) {
            const std::size_t from = count % 5;
            const floats R = guarded(all, from, count, set);
            for (std::size_t i = 0; i < count; ++i)
                ASSERT_TRUE(same_bits(R[i], expected[from + i])) << row.name << ' ' << count << ' ' << i;
        }
    });
}

TEST(batch, a_single_value_stands_for_an_array_of_it) {
    for_each_vector_path(4000, [](const auto& row, const points& all, std::string_view set) {
        points at = all;
        std::vector<batch_argument> single;
        for (std::size_t k = 0; k < at.columns.size(); ++k) {
            at.columns[k].resize(101);
            if (k < at.parameters()) at.columns[k].assign(101, at.columns[k][7]);
        }
        for (std::size_t k = 0; k < at.parameters(); ++k)
            single.push_back(batch_argument::same(at.columns[k][0]));
        floats R(101);
        const batch_argument cos_i = batch_argument::array(at.columns.back().data());
        evaluate_batch(row.name, single, cos_i, 101, R.data(), one_thread(set));
        EXPECT_TRUE(identical(at, R, reflectances(at, one_thread(set))));
    });
}

TEST(batch, vacuum_outside_gives_the_same_bits_as_an_array_of_ones) {
    for_each_vector_path(100003 / thinning, [](const auto& row, const points& all, std::string_view set) {
        if (row.kind != model_kind::exact) return;
        points at = all;
        at.columns[0].assign(at.size(), 1.0F);
        auto arguments = arrays(at.columns);
        const batch_argument cos_i = arguments.back();
        arguments.pop_back();
        arguments[0] = batch_argument::same(at.columns[0][0]);
        const std::size_t n = at.size();

        floats R(n), parts(4 * n);
        evaluate_batch(row.name, arguments, cos_i, n, R.data(), one_thread(set));
        EXPECT_TRUE(identical(at, R, reflectances(at, one_thread("scalar"))));
        float* p = parts.data();
        evaluate_batch_polarised(row.name, arguments, cos_i, n, {p, p + n, p + 2 * n, p + 3 * n},
                                 one_thread(set));
        EXPECT_TRUE(identical(at, parts, polarised_parts(at, one_thread("scalar"))));
    });
}

/// The first element at a multiple of 64 bytes, which is one of the first sixteen.
float* first_aligned(floats& values) {
    const std::size_t misplaced = reinterpret_cast<std::uintptr_t>(values.data()) % 64 / sizeof(float);
    return values.data() + (16 - misplaced) % 16;
}

/// R, and for exact models R_s, R_p, T_s, T_p, of kernels that are told what arrays past a processor's caches
/// would tell them.
void expect_same_bits_however_called(const points& at, const std::vector<batch_argument>& inputs,
                                     std::size_t model, bool polarised) {
    const floats expected = reflectances(at, one_thread("scalar"));
    const floats expected_parts = polarised ? polarised_parts(at, one_thread("scalar")) : floats{};
    for (const instruction_set& set : built_instruction_sets()) {
        if (!set.supported()) continue;
        SCOPED_TRACE(set.name);
        const model_kernels& kernels = set.kernels().models[model];
        const auto run = [&](kernel kernel, std::size_t parts, kernel_call call) {
            floats all(parts * at.size() + 16);
            float* const first = first_aligned(all);
            float* outputs[4] = {};
            for (std::size_t k = 0; k < parts; ++k)
                outputs[k] = first + k * at.size();
            call.inputs = inputs.data();
            call.outputs = outputs;
            call.end = at.size();
            kernel(call);
            return floats(first, first + parts * at.size());
        };
        for (const bool past_caches : {false, true})
            for (const bool fetch_ahead : {false, true}) {
                const kernel_call call{nullptr, nullptr, 0, 0, past_caches, fetch_ahead};
                EXPECT_TRUE(identical(at, run(kernels.reflectance, 1, call), expected));
                if (polarised) {
                    EXPECT_TRUE(identical(at, run(kernels.powers, 4, call), expected_parts));
                }
            }
    }
}

/// Whatever processor this is.
TEST(batch, kernels_give_the_same_bits_however_they_are_called) {
    const float vacuum = 1;
    std::size_t model = 0;
    for_each_model([&](const auto& row) {
        points at = random_points(row, most_lanes * (1000 / thinning));
        const bool polarised = row.kind == model_kind::exact;
        std::vector<batch_argument> inputs = arrays(at.columns);
        expect_same_bits_however_called(at, inputs, model, polarised);
        if (polarised) {
            at.columns[0].assign(at.size(), vacuum);
            inputs[0] = batch_argument::same(vacuum);
            expect_same_bits_however_called(at, inputs, model, polarised);
        }
        ++model;
    });
}

TEST(batch, so_many_results_that_they_pass_the_caches_are_the_same) {
    const std::size_t count = values_past_caches + 37;
    random_numbers random(5);
    floats cos_i(count), R(count + 48), expected(count);
    for (float& c : cos_i)
        c = static_cast<float>(random.uniform(0, 1));
    const float n_i = 1, n_t = 0.2F, k_t = 3;
    const std::vector metal{batch_argument::same(n_i), batch_argument::same(n_t), batch_argument::same(k_t)};
    const auto evaluate = [&](std::size_t from, std::size_t n, float* to, std::string_view set) {
        evaluate_batch("conductor", metal, batch_argument::array(cos_i.data() + from), n, to,
                       one_thread(set));
    };
    for (const std::string_view set : instruction_sets()) {
        evaluate(0, count / 2, expected.data(), set);
        evaluate(count / 2, count - count / 2, expected.data() + count / 2, set);
        for (const std::size_t place : {0u, 1u, 4u, 15u}) { // at a multiple of 64 bytes, and not
            float* const to = first_aligned(R) + 16 + place;
            to[-1] = to[count] = guard;
            evaluate(0, count, to, set);
            EXPECT_TRUE(std::equal(expected.begin(), expected.end(), to)) << set << ' ' << place;
            EXPECT_TRUE(to[-1] == guard && to[count] == guard) << set << ' ' << place;
        }
        std::copy(cos_i.begin(), cos_i.end(), R.begin());
        evaluate_batch("conductor", metal, batch_argument::array(R.data()), count, R.data(), one_thread(set));
        EXPECT_TRUE(std::equal(expected.begin(), expected.end(), R.begin())) << set << " in place";
    }
}

/// Of a job of `conductor` in the widest instruction set, the call that computes whole batches of the values from 0 to
/// `end`; without computing any. n_i and n_t are single values, k_t an array if `arrays`.
kernel_call whole_batches(quantity wanted, const float* cos_i, std::vector<float*> outputs, std::size_t end,
                          bool arrays = true) {
    static kernel_call longest;
    const float index = 1;
    std::vector metal(3, batch_argument::same(index));
    if (arrays) metal[2] = batch_argument::array(cos_i);
    batch_job job;
    EXPECT_EQ(make_job(wanted, *find_batch_model("conductor"), *find_instruction_set(""), metal,
                       batch_argument::array(cos_i), values_past_caches, outputs, job)
                  .why,
              refusal::none);
    longest = {};
    job.run = [](const kernel_call& call) {
        if (call.end - call.begin > longest.end - longest.begin) longest = call;
    };
    run_job(job, 0, end);
    return longest;
}

/// malloc gives places that are no multiples of 64 bytes, and a thread gets a part.
TEST(batch, many_results_pass_the_caches_wherever_they_begin) {
    const std::size_t n = values_past_caches;
    floats cos_i(n), memory(2 * n + 64);
    float* const R = first_aligned(memory);
    for (const std::size_t place : {0u, 4u, 15u})
        for (const std::size_t end : {n, n / 2}) {
            const kernel_call one = whole_batches(quantity::reflectance, cos_i.data(), {R + place}, end);
            EXPECT_TRUE(one.past_caches) << place << ' ' << end;
            EXPECT_EQ(one.begin, (16 - place) % 16);
            float* const s = R + place;
            EXPECT_TRUE(
                whole_batches(quantity::polarised, cos_i.data(), {s, s + n + 16, nullptr, nullptr}, end)
                    .past_caches);
        }
}

TEST(batch, results_stay_in_the_caches_in_place_or_where_outputs_lie_differently) {
    const std::size_t n = values_past_caches;
    floats cos_i(n + 16), memory(2 * n + 64);
    float* const R = first_aligned(memory);
    float* const c = first_aligned(cos_i);
    EXPECT_FALSE(whole_batches(quantity::reflectance, c, {c}, n).past_caches);
    EXPECT_FALSE(whole_batches(quantity::polarised, c, {R, c, nullptr, nullptr}, n).past_caches);
    EXPECT_FALSE(whole_batches(quantity::polarised, c, {R, R + n + 1, nullptr, nullptr}, n).past_caches);
    EXPECT_FALSE(whole_batches(quantity::reflectance, c, {R}, n, false).past_caches) << "one array";
}

TEST(batch, rgb_is_three_models_at_one_angle) {
    for_each_vector_path(4000, [](const auto& row, const points& all, std::string_view set) {
        constexpr std::size_t n = 1003;
        points channel[3];
        std::vector<batch_argument> parameters;
        for (std::size_t c = 0; c < 3; ++c) {
            channel[c].model = all.model;
            for (const floats& column : all.columns)
                channel[c].columns.emplace_back(column.begin() + static_cast<std::ptrdiff_t>(c * n),
                                                column.begin() + static_cast<std::ptrdiff_t>((c + 1) * n));
            channel[c].columns.back() = channel[0].columns.back();
            for (std::size_t k = 0; k < channel[c].parameters(); ++k)
                parameters.push_back(batch_argument::array(channel[c].columns[k].data()));
        }
        floats R(n), G(n), B(n);
        evaluate_batch_rgb(row.name, parameters, batch_argument::array(channel[0].columns.back().data()), n,
                           {R.data(), G.data(), B.data()}, one_thread(set));
        const floats* const results[] = {&R, &G, &B};
        for (std::size_t c = 0; c < 3; ++c)
            EXPECT_TRUE(identical(channel[c], *results[c], reflectances(channel[c], one_thread("scalar"))));
    });
}

TEST(batch, threads_give_what_one_thread_gives) {
    for_each_model([](const auto& row) {
        if (row.name != "conductor") return;
        const points at = random_points(row, 300007 / thinning);
        const floats expected = reflectances(at, {.threads = 1});
        for (const unsigned threads : {0u, 2u, 3u, 7u, 64u, 4'000'000'000u})
            EXPECT_TRUE(identical(at, reflectances(at, {.threads = threads}), expected)) << threads;
    });
}

TEST(batch, threads_are_as_many_as_the_machine_and_the_values_have_use_for) {
    const std::size_t processors = std::max(std::thread::hardware_concurrency(), 1u);
    const std::size_t many = std::size_t{1} << 30;
    EXPECT_EQ(choose_threads(0, 0), 1u);
    EXPECT_EQ(choose_threads(131071, 0), 1u);
    EXPECT_EQ(choose_threads(131072, 0), std::min<std::size_t>(2, processors));
    EXPECT_EQ(choose_threads(many, 0), processors);
    EXPECT_EQ(choose_threads(0, 7), 1u);
    EXPECT_EQ(choose_threads(129, 3), 2u);
    EXPECT_EQ(choose_threads(many, 3), 3u);
    EXPECT_EQ(choose_threads(many, 4'000'000'000), 4 * processors);
}

TEST(batch, results_may_replace_an_argument) {
    const float f0 = 0.04F;
    floats c(1001, 0.25F);
    evaluate_batch("schlick", {{batch_argument::same(f0)}}, batch_argument::array(c.data()), c.size(),
                   c.data());
    for (const float R : c)
        ASSERT_EQ(R, schlick(0.04F, 0.25F));
}

/// With every instruction set and whatever the threads: the value is read before any result is written.
TEST(batch, a_single_value_may_lie_in_the_results) {
    const floats f0(1003, 0.04F), half(1003, 0.5F);
    for (const std::string_view set : instruction_sets())
        for (const unsigned threads : {1u, 4u})
            for (const std::size_t place : {0u, 500u, 1002u}) {
                floats R(1003);
                const batch_argument single{&R[place], 0};
                const batch_options how{.instruction_set = set, .threads = threads};
                R[place] = 0.04F;
                evaluate_batch("schlick", {{single}}, batch_argument::array(half.data()), R.size(), R.data(),
                               how);
                EXPECT_EQ(R, floats(1003, schlick(0.04F, 0.5F))) << set << ' ' << threads << ' ' << place;
                R[place] = 0.5F;
                evaluate_batch("schlick", {{batch_argument::array(f0.data())}}, single, R.size(), R.data(),
                               how);
                EXPECT_EQ(R, floats(1003, schlick(0.04F, 0.5F))) << set << ' ' << threads << ' ' << place;
            }
}

/// The message of the bad_input that f throws; empty where it throws none.
template <class F>
std::string refusal(F f) {
    try {
        f();
    } catch (const bad_input& e) {
        return e.what();
    }
    return "";
}

TEST(batch, refuses_what_it_cannot_run_and_says_why) {
    const float x = 0.5F;
    float R[4] = {};
    const batch_argument one = batch_argument::same(x);
    const auto message = [&](std::string_view model, std::vector<batch_argument> parameters, float* to,
                             std::string_view set = "") {
        return refusal([&] { evaluate_batch(model, parameters, one, 1, to, one_thread(set)); });
    };
    EXPECT_EQ(message("schlick", {one}, R), "");
    EXPECT_EQ(message("schlik", {one}, R), "model 'schlik' is unknown (did you mean 'schlick'?)");
    EXPECT_EQ(message("foo", {one}, R), "model 'foo' is unknown"); // f82 is another word
    EXPECT_EQ(message("schlick", {}, R), "model 'schlick' has 1 parameters here, not 0");
    EXPECT_EQ(message("schlick", {{nullptr, 1}}, R), "f0 is null");
    EXPECT_EQ(message("schlick", {{&x, 2}}, R), "f0 has stride 2: must be 0 or 1");
    EXPECT_EQ(message("schlick", {one}, nullptr), "R is null");
    EXPECT_TRUE(
        message("schlick", {one}, R, "mmx").starts_with("instruction set 'mmx' is not one of scalar"));
    EXPECT_EQ(refusal([&] { evaluate_batch_polarised("schlick", {{one}}, one, 1, {R, R + 1}); }),
              "model 'schlick' is not exact and has no R_s, R_p");
    EXPECT_EQ(refusal([&] {
                  evaluate_batch_polarised("dielectric", std::vector{one, one}, one, 1,
                                           {R, R + 1, R + 2, nullptr});
              }),
              "T_p is null");
}

TEST(batch, refusals_name_the_argument_and_the_channel) {
    const float x = 0.5F;
    float R[4] = {};
    const batch_argument one = batch_argument::same(x), none{nullptr, 1}, odd{&x, 3};
    const auto rgb = [&](std::vector<batch_argument> parameters, batch_argument cos_i,
                         std::array<float*, 3> to) {
        return refusal([&] { evaluate_batch_rgb("air_conductor", parameters, cos_i, 1, to); });
    };
    const std::array<float*, 3> to{R, R + 1, R + 2};
    EXPECT_EQ(rgb({6, one}, one, to), "");
    EXPECT_EQ(rgb({one, one, one, none, one, one}, one, to), "k of green is null");
    EXPECT_EQ(rgb({one, one, one, one, odd, one}, one, to), "n of blue has stride 3: must be 0 or 1");
    EXPECT_EQ(rgb({6, one}, none, to), "cos_i is null");
    EXPECT_EQ(rgb({6, one}, odd, to), "cos_i has stride 3: must be 0 or 1");
    EXPECT_EQ(rgb({6, one}, one, {nullptr, R, R}), "red is null");
    EXPECT_EQ(rgb({6, one}, one, {R, R, nullptr}), "blue is null");
    const auto polarised = [&](const batch_polarised& parts) {
        return refusal([&] { evaluate_batch_polarised("dielectric", std::vector{one, one}, one, 1, parts); });
    };
    EXPECT_EQ(polarised({nullptr, R}), "R_s is null");
    EXPECT_EQ(polarised({R, nullptr}), "R_p is null");
    EXPECT_EQ(polarised({R, R + 1, nullptr, R + 2}), "T_s is null");
}

/// The widest, or what FRESNEL_ISA of the environment says: ctest runs this with several.
TEST(batch, a_spectral_table_adds_the_weighted_reflectances_of_its_wavelengths) {
    random_numbers random(17);
    const auto draw = [&](std::size_t count, double lo, double hi) {
        floats values(count);
        for (float& v : values)
            v = static_cast<float>(random.uniform(lo, hi));
        return values;
    };
    constexpr std::size_t wavelengths = 81;
    const floats n = draw(wavelengths, 0.1, 3), k = draw(wavelengths, 0, 6);
    const floats weights[] = {draw(wavelengths, -0.01, 0.02), draw(wavelengths, 0, 0.02),
                              draw(wavelengths, 0, 0.02)};
    for (const std::size_t angles : {0u, 1u, 15u, 90u, 91u, 96u, 200u}) {
        const floats cos_i = draw(angles, 0, 1);
        for (const std::string_view set : instruction_sets()) {
            floats rgb[3] = {floats(angles + 1, guard), floats(angles + 1, guard), floats(angles + 1, guard)};
            spectral_table({n, k, {weights[0], weights[1], weights[2]}, 1.25f}, cos_i,
                           {rgb[0].data(), rgb[1].data(), rgb[2].data()}, set);
            for (std::size_t channel = 0; channel < 3; ++channel) {
                for (std::size_t j = 0; j < angles; ++j) {
                    float sum = 0;
                    for (std::size_t i = 0; i < wavelengths; ++i)
                        sum =
                            sum + weights[channel][i] * conductor(1.25f, n[i], k[i], cos_i[j]).reflectance();
                    ASSERT_TRUE(same_bits(rgb[channel][j], sum)) << set << ' ' << angles << ' ' << j;
                }
                EXPECT_EQ(rgb[channel][angles], guard);
            }
        }
    }
    EXPECT_EQ(refusal([&] { spectral_table({n, {}, {}}, {}, {}); }),
              "k_t has 0 wavelengths: must be as many as n_t has, 81");
    EXPECT_EQ(refusal([&] { spectral_table({n, k, {n, {n.data(), 3}, n}}, {}, {}); }),
              "weights[1] (green) has 3 wavelengths: must be as many as n_t has, 81");
    float R = 0;
    EXPECT_EQ(refusal([&] { spectral_table({n, k, {n, n, n}}, {&n[0], 1}, {&R, &R, nullptr}); }),
              "blue is null");
    EXPECT_EQ(refusal([&] { spectral_table({n, k, {n, n, n}}, {}, {}); }), "");
}

TEST(batch, every_machine_has_the_scalar_path_and_its_widest_by_default) {
    const auto sets = instruction_sets();
    EXPECT_EQ(sets.front(), "scalar");
    EXPECT_GT(sets.size(), 1u);
    for (const std::string_view set : sets)
        EXPECT_EQ(choose_instruction_set(set), set);

    const char* set_in_environment = std::getenv("FRESNEL_ISA");
    const std::string forced(set_in_environment ? set_in_environment : "");
    if (forced.empty()) {
        EXPECT_EQ(choose_instruction_set(""), sets.back());
    } else if (std::ranges::count(sets, forced)) {
        EXPECT_EQ(choose_instruction_set(""), forced);
    } else {
        const float x = 0.5F;
        float R = 7;
        const std::string message = refusal(
            [&] { evaluate_batch("schlick", {{batch_argument::same(x)}}, batch_argument::same(x), 1, &R); });
        EXPECT_TRUE(message.starts_with("instruction set '" + forced +
                                        "', from FRESNEL_ISA of the environment, is not one of scalar"))
            << message;
        EXPECT_EQ(R, 7);
    }
}

/// The pointers and strides of a model's parameters as C takes them: all arrays but the first.
struct c_arguments {
    std::vector<const float*> parameters;
    std::vector<std::size_t> strides;

    c_arguments(const points& at, std::size_t from) {
        for (std::size_t k = 0; k < at.parameters(); ++k) {
            parameters.push_back(at.columns[k].data() + (k == 0 ? 0 : from));
            strides.push_back(k == 0 ? 0 : 1);
        }
    }
};

/// At 1003 points, with one value of the first parameter.
template <class Row>
points points_for_c(const Row& row) {
    points at = random_points(row, 1003);
    if (at.parameters() > 0) at.columns[0].assign(at.size(), at.columns[0][5]);
    return at;
}

TEST(batch, c_functions_give_the_same_bits_and_from_several_threads) {
    for_each_model([](const auto& row) {
        const points at = points_for_c(row);
        floats R(at.size());
        std::vector<std::thread> threads;
        for (std::size_t from = 0; from < at.size(); from += 251)
            threads.emplace_back([&, from] {
                const c_arguments in(at, from);
                const std::size_t count = std::min<std::size_t>(251, at.size() - from);
                EXPECT_EQ(fresnel_evaluate(at.model.c_str(), in.parameters.data(), in.strides.data(),
                                           at.columns.back().data() + from, 1, count, R.data() + from),
                          FRESNEL_OK);
            });
        for (std::thread& thread : threads)
            thread.join();
        EXPECT_TRUE(identical(at, R, reflectances(at, {})));
    });
}

TEST(batch, c_functions_give_the_same_polarised_bits) {
    for_each_model([](const auto& row) {
        const points at = points_for_c(row);
        const c_arguments in(at, 0);
        const std::size_t n = at.size();
        floats parts(4 * n);
        float* p = parts.data();
        const fresnel_error error =
            fresnel_evaluate_polarised(at.model.c_str(), in.parameters.data(), in.strides.data(),
                                       at.columns.back().data(), 1, n, p, p + n, p + 2 * n, p + 3 * n);
        if (row.kind != model_kind::exact) {
            EXPECT_EQ(error, FRESNEL_NOT_POLARISED);
            return;
        }
        EXPECT_EQ(error, FRESNEL_OK);
        EXPECT_TRUE(identical(at, parts, polarised_parts(at, {})));
    });
}

TEST(batch, c_functions_list_the_registry) {
    std::size_t index = 0;
    for_each_model([&](const auto& row) {
        const char* name = fresnel_model_name(index++);
        ASSERT_NE(name, nullptr);
        EXPECT_EQ(name, row.name);
        std::size_t count = 99;
        EXPECT_EQ(fresnel_model_parameter_count(name, &count), FRESNEL_OK);
        ASSERT_EQ(count, row.parameters.size());
        for (std::size_t k = 0; k < count; ++k) {
            fresnel_parameter actual{};
            ASSERT_EQ(fresnel_model_parameter(name, k, &actual), FRESNEL_OK);
            const parameter& expected = row.parameters[k];
            EXPECT_EQ(actual.name, expected.name);
            EXPECT_EQ(actual.unit, expected.unit);
            EXPECT_EQ(actual.min, expected.min);
            EXPECT_EQ(actual.max, expected.max);
            EXPECT_EQ(actual.default_value, expected.default_value);
        }
    });
    EXPECT_EQ(index, fresnel_model_count());
}

} // namespace
} // namespace fresnel::test
