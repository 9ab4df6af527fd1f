#include "commands.hpp"

#include "analysis/model_table.hpp"
#include "emit/cost.hpp"
#include "emit/technique.hpp"
#include "error.hpp"
#include "files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace fresnel::cli {

namespace {

using emit::shader_stage;

constexpr std::array all_stages = {shader_stage::fragment, shader_stage::vertex, shader_stage::compute};

struct options {
    std::vector<std::string> models, program;
    std::string gpu, stage, technique;
    bool isa = false, recorded = false, json = false, csv = false;
    std::vector<std::string> gpus, stages; ///< the two as lists
};

std::vector<std::string> split(std::string_view list) {
    std::vector<std::string> names;
    for (std::size_t from = 0; !list.empty() && from <= list.size();) {
        const std::size_t comma = std::min(list.find(',', from), list.size());
        names.emplace_back(list.substr(from, comma - from));
        from = comma + 1;
    }
    return names;
}

std::vector<std::string> names_of_models() {
    std::vector<std::string> names;
    for (const model_row<double>& row : model_table<double>())
        names.emplace_back(row.name);
    return names;
}

std::vector<std::string> names_of_stages() {
    std::vector<std::string> names;
    for (const shader_stage stage : all_stages)
        names.emplace_back(to_string(stage));
    return names;
}

// The devices of the table, in its order, after those that can be imagined.
std::vector<std::string> names_of_gpus(bool recorded) {
    std::vector<std::string> names;
    if (!recorded) return {emit::null_devices().begin(), emit::null_devices().end()};
    for (const cost_row& row : cost_table())
        if (std::find(names.begin(), names.end(), row.gpu) == names.end()) names.push_back(row.gpu);
    return names;
}

void check_names(std::string_view option, const std::vector<std::string>& given,
                 const std::vector<std::string>& allowed) {
    for (const std::string& name : given)
        if (std::find(allowed.begin(), allowed.end(), name) == allowed.end())
            throw bad_input(fmt::format("{} '{}': is none of {}{}", option, name, fmt::join(allowed, ", "),
                                        did_you_mean(name, allowed)));
}

bool holds(const std::vector<std::string>& names, const std::string& name) {
    return names.empty() || std::find(names.begin(), names.end(), name) != names.end();
}

std::vector<shader_stage> chosen_stages(const options& given) {
    std::vector<shader_stage> stages;
    for (const shader_stage stage : all_stages)
        if (holds(given.stages, std::string(to_string(stage)))) stages.push_back(stage);
    return stages;
}

nlohmann::json number(double value) {
    return std::isnan(value) ? nlohmann::json() : nlohmann::json(std::round(100 * value) / 100 + 0.0);
}

nlohmann::json to_json(const cost_row& row) {
    return {{"model", row.model},
            {"gpu", row.gpu},
            {"stage", row.stage},
            {"n_i", row.n_i.empty() ? nlohmann::json() : nlohmann::json(row.n_i)},
            {"instructions", number(row.instructions)},
            {"latency", number(row.latency)},
            {"inverse_throughput", number(row.inverse_throughput)},
            {"registers", number(row.registers)},
            {"tool", row.tool},
            {"version", row.version}};
}

std::string text_of(double value, int digits) {
    return std::isnan(value) ? "" : fmt::format("{:.{}f}", value, digits);
}

void print(const std::vector<cost_row>& rows) {
    fmt::print("{:<20} {:<5} {:<10} {:<9} {:>12} {:>8} {:>11} {:>9}  {}\n", "model", "n_i", "gpu", "stage",
               "instructions", "latency", "throughput⁻¹", "registers", "by");
    for (const cost_row& row : rows)
        print_row("{:<20} {:<5} {:<10} {:<9} {:>12} {:>8} {:>12} {:>9}  {} {}", row.model, row.n_i, row.gpu,
                  row.stage, text_of(row.instructions, 1), text_of(row.latency, 0),
                  text_of(row.inverse_throughput, 1), text_of(row.registers, 0), row.tool, row.version);
}

void print_listings(const options& given) {
    for (const std::string& model : given.models)
        for (const std::string& gpu : given.gpus)
            for (const shader_stage stage : chosen_stages(given)) {
                const emit::cost_subject subject = emit::subject_of(model);
                const emit::shader_program program = emit::listing_program(subject, stage);
                const emit::compilation made = emit::compile_for(gpu, {&program, 1}, true);
                fmt::print("; {} on {}, {} stage, by {}\n; inputs are read and results written around "
                           "it\n\n{}\n{}\n",
                           model, gpu, to_string(stage), made.driver, subject.text,
                           made.programs.front().at(stage).assembly);
            }
}

std::vector<cost_row> recorded_rows(const options& given) {
    std::vector<cost_row> rows;
    for (const cost_row& row : cost_table())
        if (holds(given.models, row.model) && holds(given.gpus, row.gpu) && holds(given.stages, row.stage))
            rows.push_back(row);
    return rows;
}

std::string text_of_file(const std::string& path) {
    const auto text = file_content(path);
    if (!text || text->empty()) throw bad_input(fmt::format("--program '{}': cannot be read", path));
    return *text;
}

std::vector<cost_row> program_rows(const options& given) {
    constexpr int attributes = 8; // as many as OpenGL's oldest shaders were used with
    const emit::shader_program program{{{shader_stage::vertex, text_of_file(given.program[0])},
                                        {shader_stage::fragment, text_of_file(given.program[1])}},
                                       attributes};
    std::vector<cost_row> rows;
    for (const cost_row& row : emit::measure_program(given.program[1], program, given.gpus))
        if (holds(given.stages, row.stage)) rows.push_back(row);
    return rows;
}

std::vector<cost_row> technique_rows(const options& given) {
    const emit::technique& how = emit::find_technique(given.technique);
    const emit::dialect& glsl = emit::find_dialect("glsl");
    constexpr int attributes = 8;
    std::vector<cost_row> rows;
    for (const std::string& model : given.models) {
        const auto text = [&](emit::stage s) {
            return technique_text(glsl, how, {model}, s, "fresnel cost");
        };
        const emit::shader_program program{{{shader_stage::vertex, text(emit::stage::vertex)},
                                            {shader_stage::fragment, text(emit::stage::fragment)}},
                                           attributes};
        for (const cost_row& row : emit::measure_program(model, program, given.gpus))
            if (holds(given.stages, row.stage)) rows.push_back(row);
    }
    return rows;
}

void check(const options& given) {
    if (!given.technique.empty()) {
        emit::find_technique(given.technique);
        if (given.models.empty()) throw bad_input("--technique: name one or more models");
        if (given.isa || given.recorded || !given.program.empty())
            throw bad_input("--technique: takes no --isa, no --recorded and no --program");
    }
    if (!given.program.empty() && (!given.models.empty() || given.isa || given.recorded))
        throw bad_input("--program: takes no MODEL, no --isa and no --recorded");
    for (const std::string& model : given.models)
        find_model<double>(model);
    check_names("--gpu", given.gpus, names_of_gpus(given.recorded));
    check_names("--stage", given.stages, names_of_stages());
    if (given.isa && given.models.empty()) throw bad_input("--isa: name one or more models");
    if (given.isa && (given.json || given.csv || given.recorded))
        throw bad_input("--isa: prints text only, without --json, --csv and --recorded");
    if (given.json && given.csv) throw bad_input("--json and --csv: choose one of the two");
}

void run(options given) {
    given.gpus = split(given.gpu), given.stages = split(given.stage);
    check(given);
    if (given.stages.empty() && given.program.empty() && given.technique.empty() && !given.recorded)
        given.stages = {"fragment"};
    if (given.gpus.empty() && !given.recorded)
        given.gpus = given.isa ? std::vector<std::string>{"navi21"}
                               : std::vector<std::string>{"polaris10", "navi21", "gfx1100"};
    if (given.isa) return print_listings(given);
    if (given.models.empty() && given.program.empty() && !given.recorded) {
        given.models = names_of_models();
        if (isatty(STDERR_FILENO) != 0) say("cost: every model, some seconds\n");
    }
    const std::vector<cost_row> rows =
        given.recorded             ? recorded_rows(given)
        : !given.program.empty()   ? program_rows(given)
        : !given.technique.empty() ? technique_rows(given)
                                   : emit::measure_cost_rows(given.models, given.gpus, chosen_stages(given));
    if (given.csv) return fmt::print("{}", to_csv(rows));
    if (!given.json) return print(rows);
    nlohmann::json list = nlohmann::json::array();
    for (const cost_row& row : rows)
        list.push_back(to_json(row));
    print_json(list);
}

} // namespace

void add_cost(CLI::App& app) {
    CLI::App* command = add_command(
        app, "cost", "What a model costs on graphics processors, measured without one",
        "  fresnel cost schlick dielectric\n"
        "  fresnel cost conductor --gpu navi21,gfx1100 --stage vertex,fragment\n"
        "  fresnel cost powers_4_8 --isa                    the listing of one evaluation\n"
        "  fresnel cost --json                              every model\n"
        "  fresnel cost schlick --technique per-pixel       the program that uses it\n"
        "  fresnel cost --program a.vert a.frag             what a program of yours costs\n"
        "  fresnel cost --recorded --gpu sm_86              the table that was measured before\n\n"
        "What one more evaluation adds to a shader, by Mesa's compiler for AMD: 16 evaluations on inputs of\n"
        "their own, less a shader that only reads those inputs, by 16. Latency and inverse throughput are\n"
        "cycles in the compiler's model of the device; registers are vector registers alive at once in a\n"
        "shader that evaluates once. n_i is 1, or free: a parameter like the others.");
    const auto given = std::make_shared<options>();
    command->add_option("MODEL", given->models, "registry names; all if none is given");
    command->add_option("--gpu", given->gpu, "polaris10, navi21, gfx1100 (all three by default) or another")
        ->type_name("NAME,...");
    command->add_option("--stage", given->stage, "fragment (the default), vertex or compute")
        ->type_name("NAME,...");
    command
        ->add_option("--program", given->program,
                     "a GLSL program of your own, written for OpenGL or Vulkan: what all of each stage costs")
        ->type_name("VERTEX FRAGMENT")
        ->expected(2);
    command
        ->add_option("--technique", given->technique,
                     "the whole program of `fresnel shader --technique`: what all of each stage costs")
        ->type_name("T");
    command->add_flag("--isa", given->isa, "print the instructions of one evaluation");
    command->add_flag("--recorded", given->recorded,
                      "print the table of this version, other compilers' rows too");
    command->add_flag("--json", given->json, "print JSON");
    command->add_flag("--csv", given->csv, "print CSV, as in data/cost.csv");
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
