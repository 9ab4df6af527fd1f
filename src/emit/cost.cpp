#include "emit/cost.hpp"

#include "emit/library.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fresnel::emit {

namespace {

constexpr int times_measured = 16;

int vectors_of(std::size_t floats) { return static_cast<int>((floats + 3) / 4); }

// Input i of the program, a component of one of the vectors v0, v1, ...
std::string input(std::size_t i) { return fmt::format("v{}.{}", i / 4, "xyzw"[i % 4]); }

std::string summation(const cost_subject& subject, int times, bool evaluates) {
    std::string text = "    float F = 0.0, inputs = 1.0;\n";
    for (int t = 0; t < times; ++t) {
        std::vector<std::string> values;
        for (std::size_t a = 0; a < subject.arguments; ++a)
            values.push_back(input(static_cast<std::size_t>(t) * subject.arguments + a));
        text += fmt::format("    F += {};\n",
                            evaluates ? fmt::format("{}({})", subject.name, fmt::join(values, ", "))
                                      : values.back());
        for (const std::string& value : values)
            text += fmt::format("    inputs += {};\n", value);
    }
    return text;
}

std::string declarations(std::string_view line, int vectors) {
    std::string text;
    for (int i = 0; i < vectors; ++i)
        text += fmt::format(fmt::runtime(line), i);
    return text;
}

// Around the statements that make F and inputs: what declares and reads the inputs and writes the two.
shader_program program_of(shader_stage stage, int vectors, const std::string& function,
                          const std::string& statements) {
    const std::string head = "#version 450\n";
    if (stage == shader_stage::compute) {
        const std::string buffers =
            "layout(local_size_x = 64) in;\n"
            "layout(std430, binding = 0) readonly buffer read { vec4 values[]; };\n"
            "layout(std430, binding = 1) writeonly buffer written { vec2 results[]; };\n";
        const std::string reads = declarations(
            fmt::format("    vec4 v{{0}} = values[gl_GlobalInvocationID.x * {}u + {{0}}u];\n", vectors),
            vectors);
        return {{{stage, head + buffers + function + "void main() {\n" + reads + statements +
                             "    results[gl_GlobalInvocationID.x] = vec2(F, inputs);\n}\n"}}};
    }
    const std::string inputs = declarations("layout(location = {0}) in vec4 v{0};\n", vectors);
    if (stage == shader_stage::vertex)
        return {
            {{stage, head + inputs + "layout(location = 0) out vec2 made;\n" + function + "void main() {\n" +
                         statements + "    made = vec2(F, inputs);\n    gl_Position = v0;\n}\n"},
             {shader_stage::fragment, head +
                                          "layout(location = 0) in vec2 made;\nlayout(location = 0) out vec4 "
                                          "color;\nvoid main() { color = made.xyxy; }\n"}},
            vectors};
    const std::string passes =
        declarations("layout(location = {0}) in vec4 a{0};\nlayout(location = {0}) out vec4 v{0};\n",
                     vectors) +
        "void main() {\n" + declarations("    v{0} = a{0};\n", vectors) + "    gl_Position = a0;\n}\n";
    return {{{shader_stage::vertex, head + passes},
             {stage, head + inputs + "layout(location = 0) out vec4 color;\n" + function + "void main() {\n" +
                         statements + "    color = vec4(F, inputs, 0.0, 1.0);\n}\n"}},
            vectors};
}

} // namespace

cost_subject subject_of(std::string_view model, bool air) {
    const auto parameters = find_model<double>(model).parameters;
    model_request wanted{std::string(model)};
    const bool has_n_i = std::any_of(parameters.begin(), parameters.end(),
                                     [](const parameter& p) { return p.name == std::string_view("n_i"); });
    if (air && has_n_i) wanted.fixed["n_i"] = {1, 1, 1};
    const language& glsl = find_language("glsl");
    const style plain = {.precise = false, .comment = false};
    return {legal_name(glsl, model), parameters.size() + 1 - wanted.fixed.size(),
            twofold_text_for(glsl, wanted, plain) + scalar_text(glsl, wanted, plain)};
}

shader_program cost_program(const cost_subject& subject, shader_stage stage, int times, bool evaluates) {
    return program_of(stage, vectors_of(static_cast<std::size_t>(times) * subject.arguments),
                      evaluates ? subject.text : "", summation(subject, times, evaluates));
}

shader_program listing_program(const cost_subject& subject, shader_stage stage) {
    return cost_program(subject, stage, 1, true);
}

std::vector<measured_cost> measure_costs(std::span<const cost_subject> subjects, std::string_view gpu,
                                         shader_stage stage, std::string* driver) {
    std::vector<shader_program> programs;
    for (const cost_subject& subject : subjects) {
        for (const int times : {times_measured, times_measured / 2})
            for (const bool evaluates : {true, false})
                programs.push_back(cost_program(subject, stage, times, evaluates));
        programs.push_back(listing_program(subject, stage));
    }
    const compilation compiled = compile_for(gpu, programs);
    if (driver != nullptr) *driver = compiled.driver;
    std::vector<measured_cost> costs;
    for (std::size_t i = 0; i < programs.size(); i += 5) {
        const auto shader = [&](std::size_t k) { return compiled.programs[i + k].at(stage); };
        const auto difference = [&](const char* what) {
            return (shader(0)[what] - shader(1)[what]) / times_measured;
        };
        constexpr int half = times_measured / 2;
        costs.push_back({difference("Instructions"), std::max(0.0, difference("Latency")),
                         difference("Inverse Throughput"), shader(4)["Pre-Sched VGPRs"],
                         (shader(2)["Instructions"] - shader(3)["Instructions"]) / half});
    }
    return costs;
}

std::vector<cost_row> measure_cost_rows(std::span<const std::string> models,
                                        std::span<const std::string> gpus,
                                        std::span<const shader_stage> stages) {
    std::vector<cost_subject> subjects;
    std::vector<cost_row> heads;
    for (const std::string& model : models)
        for (const bool air : {true, false}) {
            const bool has_n_i =
                find_model<double>(model).parameters.size() + 1 != subject_of(model).arguments;
            if (!air && !has_n_i) continue;
            subjects.push_back(subject_of(model, air));
            cost_row& head = heads.emplace_back();
            head.model = model, head.n_i = !has_n_i ? "" : air ? "1" : "free", head.tool = "RADV";
        }
    std::vector<std::vector<cost_row>> by_subject(subjects.size());
    for (const std::string& gpu : gpus)
        for (const shader_stage stage : stages) {
            std::string driver;
            const std::vector<measured_cost> costs = measure_costs(subjects, gpu, stage, &driver);
            for (std::size_t i = 0; i < costs.size(); ++i) {
                cost_row row = heads[i];
                row.gpu = gpu, row.stage = to_string(stage), row.version = driver;
                row.instructions = costs[i].instructions, row.latency = costs[i].latency;
                row.inverse_throughput = costs[i].inverse_throughput, row.registers = costs[i].registers;
                by_subject[i].push_back(row);
            }
        }
    std::vector<cost_row> rows;
    for (const auto& some : by_subject)
        rows.insert(rows.end(), some.begin(), some.end());
    return rows;
}

std::vector<cost_row> measure_program(const std::string& name, const shader_program& program,
                                      std::span<const std::string> gpus) {
    std::vector<cost_row> rows;
    for (const std::string& gpu : gpus) {
        const compilation made = compile_for(gpu, {&program, 1});
        for (const auto& [stage, shader] : made.programs.front())
            rows.push_back({name, gpu, std::string(to_string(stage)), "", shader["Instructions"],
                            shader["Latency"], shader["Inverse Throughput"], shader["Pre-Sched VGPRs"],
                            "RADV", made.driver});
    }
    return rows;
}

} // namespace fresnel::emit
