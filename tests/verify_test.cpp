// The printed text, run, gives the bits of the model in C++.

#include "command.hpp"

#include "conform/program.hpp"
#include "conform/verify.hpp"
#include "emit/library.hpp"
#include "emit/verify.hpp"
#include "error.hpp"

#include <bit>
#include <cmath>
#include <cstring>

namespace fresnel::test {
namespace {

using emit::verify_case;
using emit::verify_data;

#if defined(__SANITIZE_ADDRESS__)
#define FRESNEL_SANITIZED 1
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FRESNEL_SANITIZED 1
#endif
#endif

// 0 is the number of rows that the claims are made of; sanitizers make it too slow.
#ifdef FRESNEL_SANITIZED
constexpr std::size_t rows = 2048;
#else
constexpr std::size_t rows = 0;
#endif

verify_case case_of(const std::string& id) {
    for (const verify_case& c : emit::verify_cases())
        if (c.id == id) return c;
    throw failure("no case " + id);
}

std::vector<verify_case> every_case() { return emit::verify_cases(); }

// ---- inputs -----------------------------------------------------------------------------------------------

TEST(verify, every_model_has_a_case_of_each_overload) {
    const std::vector<verify_case> cases = every_case();
    for (const model_row<float>& row : model_table<float>()) {
        std::vector<std::string> kinds;
        for (const verify_case& c : cases)
            if (c.name == row.name) kinds.emplace_back(emit::to_string(c.kind));
        std::vector<std::string> expected = {"scalar", "directions"};
        if (row.kind == model_kind::exact) expected.emplace_back("boundary");
        if (!row.parameters.empty()) expected.insert(expected.end(), {"rgb", "rgb_directions", "fixed"});
        EXPECT_EQ(kinds, expected) << row.name;
    }
}

TEST(verify, inputs_hold_the_edges) {
    const verify_data data = make_data(case_of("dielectric"), 1 << 14);
    const auto holds = [&](float n_i, float n_t, float cos_i) {
        for (std::size_t i = 0; i < data.rows; ++i)
            if (data.inputs[3 * i] == n_i && data.inputs[3 * i + 1] == n_t && data.inputs[3 * i + 2] == cos_i)
                return true;
        return false;
    };
    for (const float cos_i : {0.0f, 1.0f, 0.5f, 1 - 0x1p-24f, 1e-4f})
        for (const float n_t : {1.0f, 1 + 0x1p-23f, 1 - 0x1p-24f, 1 + 1e-4f, 1.5f, 1000.0f, 0.001f})
            EXPECT_TRUE(holds(1, n_t, cos_i)) << n_t << " " << cos_i;
}

TEST(verify, inputs_are_deterministic_and_meet_no_subnormal_number) {
    for (const char* id : {"conductor", "f82_tint_rgb", "schlick_directions", "refracted_direction"}) {
        const verify_case c = case_of(id);
        const verify_data a = make_data(c, 4096), b = make_data(c, 4096);
        ASSERT_EQ(a.inputs.size(), 4096u * static_cast<std::size_t>(c.columns()));
        EXPECT_EQ(std::memcmp(a.inputs.data(), b.inputs.data(), a.inputs.size() * sizeof(float)), 0) << id;
        for (const float x : a.inputs)
            EXPECT_NE(std::fpclassify(x), FP_SUBNORMAL) << id;
        for (const float y : a.expected)
            EXPECT_NE(std::fpclassify(y), FP_SUBNORMAL) << id;
    }
}

TEST(verify, infinities_and_nan_are_among_the_inputs) {
    const verify_data data = make_data(case_of("schlick"), 1 << 14);
    std::size_t infinite = 0, nan = 0;
    for (const float x : data.inputs)
        infinite += std::isinf(x) ? 1u : 0u, nan += std::isnan(x) ? 1u : 0u;
    EXPECT_GT(infinite, 100u);
    EXPECT_GT(nan, 100u);
}

// A row that languages leave open is never one of finite inputs: nothing in the domain is exempt from the comparison.
TEST(verify, no_finite_input_is_left_open) {
    for (const verify_case& c : every_case()) {
        const verify_data data = make_data(c, 4096);
        const auto columns = static_cast<std::size_t>(c.columns());
        for (std::size_t i = 0; i < data.rows; ++i) {
            bool finite = true;
            for (std::size_t k = 0; k < columns; ++k)
                finite = finite && std::isfinite(data.inputs[i * columns + k]);
            const std::span<const float> x(&data.inputs[i * columns], columns);
            EXPECT_FALSE(finite && data.open[i] != 0)
                << c.id << ": " << testing::PrintToString(std::vector<float>(x.begin(), x.end()));
        }
    }
}

// ---- comparison -------------------------------------------------------------------------------------------

TEST(verify, one_changed_bit_is_found) {
    const verify_case c = case_of("conductor_boundary");
    const verify_data data = make_data(c, 1024);
    std::vector<float> values = data.expected;
    EXPECT_EQ(compare_bits(c, data, values).differing, 0u);
    std::size_t row = 0;
    while (data.open[row] != 0 || values[4 * row + 2] == 0)
        ++row;
    values[4 * row + 2] = std::nextafter(values[4 * row + 2], 2.0f);
    const emit::difference found = compare_bits(c, data, values);
    EXPECT_EQ(found.differing, 1u);
    EXPECT_EQ(found.max_ulp, 1u);
    EXPECT_EQ(found.inputs,
              std::vector<float>(data.inputs.begin() + static_cast<std::ptrdiff_t>(4 * row),
                                 data.inputs.begin() + static_cast<std::ptrdiff_t>(4 * row + 4)));
    values.pop_back();
    EXPECT_THROW(compare_bits(c, data, values), failure);
}

TEST(verify, sign_of_zero_and_nan_are_bits_too) {
    const verify_case c = case_of("one_minus_cos");
    verify_data data;
    data.rows = 3, data.inputs = {1, 1, 1}, data.expected = {0, 0, std::nanf("")}, data.open = {0, 0, 0};
    const emit::difference found = compare_bits(c, data, std::vector<float>{0, -0.0f, std::nanf("1")});
    EXPECT_EQ(found.differing, 1u);
    EXPECT_EQ(found.max_difference, 0);
    EXPECT_EQ(compare_bits(c, data, std::vector<float>{0, 0, 1}).differing, 1u);
}

// ---- receivers --------------------------------------------------------------------------------------------

std::unique_ptr<conform::shader_runner> runner_or_reason(std::string_view language, std::string& reason) {
    try {
        return conform::open_runner(language);
    } catch (const render::no_device& none) {
        reason = none.what();
        return nullptr;
    }
}

TEST(verify, every_text_gives_what_is_claimed_of_it) {
    const std::vector<verify_case> cases = every_case();
    const conform::verification all = conform::verify(cases, rows);
    for (const conform::skipped_receiver& s : all.skipped)
        std::cout << "skipped: " << s.receiver << ": " << s.reason << "\n";
    std::map<std::string, std::size_t> ran;
    for (const emit::verify_result& r : all.results) {
        ++ran[r.receiver];
        EXPECT_TRUE(r.passed()) << r.what.id << " in " << r.receiver << ": " << r.found.differing << " of "
                                << r.found.rows << " differ, by up to " << r.found.max_difference
                                << "; allowed " << r.allowed;
        if (rows == 0 && r.what.kind == emit::overload::scalar) {
            EXPECT_GE(r.found.rows, 250'000u) << r.what.id;
        }
    }
    for (const char* receiver : {"glsl precise", "glsl", "c gcc"})
        EXPECT_EQ(ran[receiver], cases.size()) << receiver;
}

// What is claimed, so that a loosened bound does not pass unnoticed.
TEST(verify, arithmetic_alone_is_claimed_bit_by_bit) {
    std::vector<std::string> bounded, rearranged;
    for (const verify_case& c : every_case()) {
        if (c.kind == emit::overload::scalar && emit::allowed_difference(c, true) > 0)
            rearranged.push_back(c.name);
        if (emit::allowed_difference(c, false) > 0 && c.kind != emit::overload::geometry)
            bounded.push_back(c.name);
        EXPECT_EQ(emit::allowed_difference(c, false) > 0,
                  c.transcendental || c.name == "incidence_cosine" || c.name == "reflected_direction")
            << c.id;
    }
    std::sort(bounded.begin(), bounded.end());
    bounded.erase(std::unique(bounded.begin(), bounded.end()), bounded.end());
    EXPECT_EQ(bounded, (std::vector<std::string>{"bias_scale_power", "hoffman", "lazanyi", "schlick_power",
                                                 "spherical_gaussian"}));
    EXPECT_EQ(rearranged,
              (std::vector<std::string>{"conductor_precise", "schlick_power", "spherical_gaussian", "lazanyi",
                                        "gulbrandsen", "f82_tint", "hoffman", "bias_scale_power"}));
}

/// A device like real ones, whose quotients are off in the last place.
class nearly_exact final : public conform::shader_runner {
public:
    std::string name() const override { return "nearly exact"; }
    std::vector<float> run(const conform::program&, std::span<const float> inputs) override {
        std::vector<float> results;
        for (std::size_t i = 0; i < inputs.size(); i += 2)
            results.insert(results.end(), {inputs[i] * (1 / inputs[i + 1]), std::sqrt(inputs[i]), 0});
        return results;
    }
};

TEST(verify, devices_that_round_in_their_own_way_are_known) {
    nearly_exact other;
    EXPECT_FALSE(conform::rounds_exactly("glsl", other));
    for (const char* language : {"glsl", "hlsl", "wgsl"}) {
        std::string reason;
        const auto runner = runner_or_reason(language, reason);
        if (runner)
            EXPECT_TRUE(conform::rounds_exactly(language, *runner)) << language;
        else
            std::cout << "skipped: " << language << ": " << reason << "\n";
    }
}

// A text with one constant, sign or name changed is seen to differ, in each language that runs here.
TEST(verify, a_changed_text_is_found) {
    struct {
        const char *id, *before, *after;
    } const changes[] = {{"schlick", "1.0 - cos_i", "1.0 - 1.0000001 * cos_i"},
                         {"schlick_rgb", "x2 * x2 * x", "x2 * x * x"},
                         {"dielectric", "n_t - n_i", "n_t + n_i"},
                         {"f82_tint", "0.46266437", "0.46266440"}};
    for (const char* language : {"glsl", "hlsl", "wgsl"}) {
        std::string reason;
        const auto runner = runner_or_reason(language, reason);
        if (!runner) {
            std::cout << "skipped: " << language << ": " << reason << "\n";
            continue;
        }
        const emit::language& l = emit::find_language(language);
        for (const auto& change : changes) {
            const verify_case c = case_of(change.id);
            const verify_data data = make_data(c, 4096);
            std::string text = emit::verify_text(l, {&c, 1}, {.precise = std::string(language) != "wgsl"});
            std::size_t changed = 0;
            for (std::size_t at = text.find(change.before); at != std::string::npos;
                 at = text.find(change.before, at + std::strlen(change.after)), ++changed)
                text.replace(at, std::strlen(change.before), change.after);
            ASSERT_GT(changed, 0u) << change.before << " is not in the text of " << change.id << "\n" << text;
            const std::vector<float> values = runner->run(
                {text, emit::verify_call(l, c, conform::column), c.columns(), c.results}, data.inputs);
            EXPECT_GT(compare_bits(c, data, values).differing, 0u) << change.id << " in " << language;
        }
    }
}

// ---- the command ------------------------------------------------------------------------------------------

class verify_command : public command_test {};

TEST_F(verify_command, prints_the_table) {
    const outcome result = run("shader --verify schlick --rows 2000");
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* piece : {"schlick ", "schlick_rgb", "schlick_fixed", "glsl precise", "c gcc", "open"})
        EXPECT_NE(result.out.find(piece), std::string::npos) << piece << "\n" << result.out;
    const nlohmann::json table = json("shader --verify schlick --rows 2000 --json");
    for (const nlohmann::json& row : table["results"]) {
        EXPECT_TRUE(row["passed"].get<bool>()) << row.dump();
        EXPECT_EQ(row["inputs"], 2000);
    }
}

TEST_F(verify_command, compares_what_another_runner_wrote) {
    ASSERT_EQ(run("shader --verify schlick --rows 500 --dump d").code, 0);
    const std::filesystem::path d = folder / "work" / "d";
    const nlohmann::json cases = nlohmann::json::parse(read_text(d / "cases.json"));
    for (const nlohmann::json& c : cases) {
        const std::string id = c["id"];
        EXPECT_EQ(std::filesystem::file_size(d / c["inputs"]), c["columns"].get<std::size_t>() * 500 * 4);
        EXPECT_NE(read_text(d / c["text"]["wgsl"]).find("fn schlick"), std::string::npos);
        std::filesystem::copy_file(d / c["expected"], d / (id + ".copy.out.f32"));
    }
    EXPECT_EQ(cases[0]["call"]["glsl"], "schlick(x[0], x[1])");
    EXPECT_EQ(cases[0]["call"]["wgsl"], "schlick(x[0], x[1])");
    EXPECT_EQ(run("shader --verify schlick --compare d").code, 0);

    std::string bytes = read_text(d / "schlick.copy.out.f32");
    bytes[2] = static_cast<char>(bytes[2] ^ 0x40);
    write("d/schlick.copy.out.f32", bytes);
    const outcome result = run("shader --verify schlick --compare d");
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.out.find("FAILS"), std::string::npos) << result.out;
}

TEST_F(verify_command, refuses_what_it_cannot_use) {
    expect_refused("shader --verify schlik", {"schlik", "did you mean 'schlick'"});
    expect_refused("shader --verify schlick --rows 99999999", {"--rows", "99999999", "[1, 4000000]"});
    for (const std::string count : {"0", "-1", "1.5", "1e300"})
        expect_refused("shader --verify schlick --rows " + count,
                       {"--rows '" + count + "': must be a whole number in [1, 4000000]"});
    expect_refused("shader --verify schlick --compare nowhere", {"--compare nowhere: holds no"});
    expect_refused("shader --verify schlick --dump a --compare b", {"--dump", "--compare"});
    expect_refused("shader schlick --rows 100", {"--rows requires --verify"});
    expect_refused("shader --verify schlick --lang hlsl", {"--lang excludes --verify"});
}

} // namespace
} // namespace fresnel::test
