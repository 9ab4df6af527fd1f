#include "conform/program.hpp"

#include "conform/embedding.hpp"

#include "emit/language.hpp"
#include "error.hpp"
#include "figure/figure.hpp"
#include "figure/tool.hpp"
#include "files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>
#include <map>
#include <random>

namespace fresnel::conform {

namespace {

// Names of the buffers and of what main declares, which no text of a user's is likely to hold.
constexpr std::string_view glsl_frame = R"(#version 430
{extensions}layout(local_size_x = 64) in;
layout(std430, binding = 0) readonly buffer fresnel_in {{ float fresnel_inputs[]; }};
layout(std430, binding = 1) writeonly buffer fresnel_out {{ float fresnel_outputs[]; }};
#line 1
{text}
void main() {{
    uint fresnel_row = gl_GlobalInvocationID.x;
    if (fresnel_row >= uint(fresnel_outputs.length()) / {results}u) return;
{loads}    {type} fresnel_value = {call};
{stores}}}
)";

constexpr std::string_view hlsl_frame = R"([[vk::binding(0)]] StructuredBuffer<float> fresnel_inputs;
[[vk::binding(1)]] RWStructuredBuffer<float> fresnel_outputs;
#line 1
{text}
[numthreads(64, 1, 1)] void main(uint3 fresnel_id : SV_DispatchThreadID) {{
    uint fresnel_row = fresnel_id.x, fresnel_length, fresnel_stride;
    fresnel_outputs.GetDimensions(fresnel_length, fresnel_stride);
    if (fresnel_row >= fresnel_length / {results}u) return;
{loads}    {type} fresnel_value = {call};
{stores}}}
)";

// The text comes first, since WGSL cannot say which line it is.
constexpr std::string_view wgsl_frame = R"({text}
@group(0) @binding(0) var<storage, read> fresnel_inputs: array<f32>;
@group(0) @binding(1) var<storage, read_write> fresnel_outputs: array<f32>;
@compute @workgroup_size(64)
fn main(@builtin(global_invocation_id) fresnel_id: vec3<u32>) {{
    let fresnel_row = fresnel_id.x;
    if (fresnel_row >= arrayLength(&fresnel_outputs) / {results}u) {{ return; }}
{loads}    let fresnel_value = {call};
{stores}}}
)";

std::string component(int results, int i) {
    if (results == 1) return "";
    if (results == 3) return fmt::format(".{}", "xyz"[i]);
    constexpr std::string_view names[] = {"R_s", "R_p", "T_s", "T_p"};
    return fmt::format(".{}", names[i]);
}

render::evaluation evaluation_of(const program& p, std::span<const float> inputs) {
    return {inputs.size() / static_cast<std::size_t>(p.columns), static_cast<std::size_t>(p.results)};
}

// ---- GLSL -------------------------------------------------------------------------------------------------

class glsl_runner final : public shader_runner {
public:
    std::string name() const override { return device_->name(); }
    std::vector<float> run(const program& p, std::span<const float> inputs) override {
        return device_->run(compute_shader("glsl", p), inputs, evaluation_of(p, inputs));
    }

private:
    std::unique_ptr<render::compute_device> device_ = render::open_opengl();
};

// ---- HLSL and WGSL, by SPIR-V -----------------------------------------------------------------------------

/// What makes SPIR-V of a language.
struct compiler {
    std::string tool;
    std::vector<std::string> options; ///< before the two files
    bool output_first;
    std::string remedy; ///< where there is no such tool
};

constexpr std::string_view own_naga = "fresnel-naga";

std::string naga() {
    if (const char* named = std::getenv("FRESNEL_NAGA")) return named;
    return std::string(!has_tool(std::string(own_naga)) && has_tool("naga") ? "naga" : own_naga);
}

compiler compiler_of(std::string_view language) {
    if (language == "hlsl")
        return {"glslangValidator",
                {"-D", "-V", "-S", "comp", "-e", "main", "-o"},
                true,
                "install glslang-tools"};
    return {naga(), {}, false, "run scripts/setup, or name the naga of the crate naga-cli in FRESNEL_NAGA"};
}

class spirv_runner final : public shader_runner {
public:
    explicit spirv_runner(std::string_view language)
        : language_(language), compiler_(compiler_of(language)), device_(open(compiler_)) {}

    std::string name() const override { return fmt::format("{}, by {}", device_->name(), compiler_.tool); }

    std::vector<float> run(const program& p, std::span<const float> inputs) override {
        const std::string source = compute_shader(language_, p);
        auto known = spirv_.find(source);
        if (known == spirv_.end()) known = spirv_.emplace(source, compiled(source)).first;
        return device_->run(known->second, inputs, evaluation_of(p, inputs));
    }

    // fresnel-naga takes longer to start than to compile; what it refuses here, it refuses once more in `run`.
    void prepare(std::span<const program> programs) override {
        if (compiler_.tool != own_naga) return;
        const scratch_folder scratch;
        std::vector<std::string> line = {compiler_.tool, "--pairs"}, sources;
        for (const program& p : programs) {
            const std::string name = (scratch.path / std::to_string(sources.size())).string();
            sources.push_back(compute_shader(language_, p));
            write_file(name + ".wgsl", sources.back());
            line.insert(line.end(), {name + ".wgsl", name + ".spv"});
        }
        run_tool(line);
        for (std::size_t i = 0; i < sources.size(); ++i)
            if (const auto made = file_content(scratch.path / (std::to_string(i) + ".spv")))
                spirv_[sources[i]] = *made;
    }

private:
    static std::unique_ptr<render::compute_device> open(const compiler& c) {
        if (!has_tool(c.tool)) throw render::no_device(fmt::format("{} is not there; {}", c.tool, c.remedy));
        return render::open_vulkan();
    }

    std::string compiled(const std::string& source) const {
        const scratch_folder scratch;
        const std::string in = (scratch.path / ("shader." + language_)).string();
        const std::string out = (scratch.path / "shader.spv").string();
        write_file(in, source);
        std::vector<std::string> line = {compiler_.tool};
        line.insert(line.end(), compiler_.options.begin(), compiler_.options.end());
        line.push_back(compiler_.output_first ? out : in);
        line.push_back(compiler_.output_first ? in : out);
        const tool_end end = run_tool(line);
        if (end.status != 0) throw render::refused_shader(without(end.said, scratch.path.string() + "/"));
        return read_file(out);
    }

    static std::string without(std::string text, const std::string& part) {
        for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at))
            text.erase(at, part.size());
        return text;
    }

    std::string language_;
    compiler compiler_;
    std::map<std::string, std::string> spirv_; ///< by its source: programs are run again on other inputs
    std::unique_ptr<render::compute_device> device_;
};

} // namespace

std::string column(int k) { return fmt::format("fresnel_x{}", k); }

std::string compute_shader(std::string_view language, const program& p) {
    const bool wgsl = language == "wgsl";
    std::string loads, stores;
    for (int k = 0; k < p.columns; ++k)
        loads += fmt::format("    {} {} = fresnel_inputs[fresnel_row * {}u + {}u];\n", wgsl ? "let" : "float",
                             column(k), p.columns, k);
    for (int k = 0; k < p.results; ++k)
        stores += fmt::format("    fresnel_outputs[fresnel_row * {}u + {}u] = fresnel_value{};\n", p.results,
                              k, component(p.results, k));
    const std::string_view type =
        p.results == 4 ? "fresnel_boundary" : emit::find_language(language).type(p.results);
    const std::string_view frame = wgsl ? wgsl_frame : language == "hlsl" ? hlsl_frame : glsl_frame;
    const embedded theirs = embed(language, p.text);
    return fmt::format(fmt::runtime(frame), fmt::arg("extensions", theirs.extensions),
                       fmt::arg("text", theirs.text), fmt::arg("results", p.results),
                       fmt::arg("loads", loads), fmt::arg("type", type),
                       fmt::arg("call", without_main(p.call)), fmt::arg("stores", stores));
}

std::unique_ptr<shader_runner> open_runner(std::string_view language) {
    if (language == "glsl") return std::make_unique<glsl_runner>();
    if (language == "hlsl" || language == "wgsl") return std::make_unique<spirv_runner>(language);
    throw bad_input(fmt::format("--lang = '{}': cannot be run here; must be glsl, hlsl or wgsl", language));
}

bool rounds_exactly(std::string_view language, shader_runner& runner) {
    const std::string_view text =
        language == "wgsl"
            ? "fn probe(a: f32, b: f32) -> vec3<f32> { return vec3<f32>(a / b, sqrt(a), 0.0); }"
        : language == "hlsl" ? "float3 probe(float a, float b) { return float3(a / b, sqrt(a), 0.0); }"
                             : "vec3 probe(float a, float b) { return vec3(a / b, sqrt(a), 0.0); }";
    const program p{std::string(text), fmt::format("probe({}, {})", column(0), column(1)), 2, 3};
    std::mt19937 generator(754);
    std::uniform_real_distribution<float> draw(0.25f, 4);
    std::vector<float> inputs(std::size_t{1} << 17);
    std::generate(inputs.begin(), inputs.end(), [&] { return draw(generator); });
    const std::vector<float> got = runner.run(p, inputs);
    for (std::size_t row = 0; 2 * row < inputs.size(); ++row) {
        const float a = inputs[2 * row], b = inputs[2 * row + 1];
        if (got[3 * row] != a / b || got[3 * row + 1] != std::sqrt(a)) return false;
    }
    return true;
}

} // namespace fresnel::conform
