#include "command.hpp"

#include "analysis/cost_table.hpp"
#include "analysis/model_table.hpp"
#include "emit/cost.hpp"
#include "error.hpp"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <map>
#include <regex>
#include <set>
#include <sstream>

namespace fresnel::test {
namespace {

using emit::cost_subject;
using emit::measured_cost;
using emit::shader_stage;

measured_cost cost_of(const cost_subject& subject, shader_stage stage = shader_stage::fragment) {
    return emit::measure_costs({&subject, 1}, "navi21", stage).front();
}

double instructions_of(std::string_view model) { return cost_of(emit::subject_of(model)).instructions; }

cost_subject schlick_with(const std::string& more) {
    return {"f", 2,
            "float f(float f0, float c) {\n    float m = 1.0 - c, m2 = m * m;\n    float F = f0 + (1.0 - f0) "
            "* (m2 * "
            "m2 * m);\n" +
                more + "    return F;\n}\n"};
}

std::string recorded_driver() {
    for (const cost_row& row : cost_table())
        if (row.tool == "RADV") return row.version;
    return "none";
}

// ---- the table --------------------------------------------------------------------------------------------

class recorded_costs : public testing::TestWithParam<std::pair<const char*, shader_stage>> {};

TEST_P(recorded_costs, are_what_this_machines_compiler_gives) {
    const auto& [gpu, stage] = GetParam();
    std::vector<std::string> models;
    for (const model_row<double>& row : model_table<double>())
        models.emplace_back(row.name);
    const std::string name = gpu;
    const std::vector<cost_row> measured =
        emit::measure_cost_rows(models, std::span(&name, 1), std::span(&stage, 1));
    if (measured.front().version != recorded_driver())
        GTEST_SKIP() << "skipped: data/cost.csv was made with " << recorded_driver() << ", here is "
                     << measured.front().version;
    std::vector<cost_row> recorded;
    for (const cost_row& row : cost_table())
        if (row.tool == "RADV" && row.gpu == gpu && row.stage == to_string(stage)) recorded.push_back(row);
    ASSERT_EQ(recorded.size(), measured.size());
    const auto text = [](const cost_row& row) { return to_csv({&row, 1}).substr(to_csv({}).size()); };
    for (std::size_t i = 0; i < recorded.size(); ++i)
        EXPECT_EQ(text(recorded[i]), text(measured[i])) << "scripts/cost radv makes the table anew";
}

INSTANTIATE_TEST_SUITE_P(devices, recorded_costs,
                         testing::Values(std::pair{"navi21", shader_stage::fragment},
                                         std::pair{"navi21", shader_stage::vertex},
                                         std::pair{"gfx1100", shader_stage::fragment},
                                         std::pair{"polaris10", shader_stage::compute}),
                         [](const auto& it) {
                             return fmt::format("{}_{}", it.param.first, to_string(it.param.second));
                         });

TEST(cost_table, has_every_model_on_three_devices_and_in_two_stages_apart) {
    for (const model_row<double>& row : model_table<double>())
        for (const char* gpu : {"polaris10", "navi21", "gfx1100"})
            for (const char* stage : {"fragment", "vertex"})
                EXPECT_NE(find_cost(row.name, gpu, stage), nullptr) << row.name << " " << gpu << " " << stage;
    EXPECT_EQ(find_cost("schlick", "voodoo"), nullptr);
}

// The names in the first column of the table of docs/cost.md, without what stands in brackets.
std::vector<std::string> documented_gpus() {
    std::istringstream lines(read_text(FRESNEL_SOURCE_DIR "/docs/cost.md"));
    std::vector<std::string> names;
    for (std::string line; std::getline(lines, line);) {
        if (!line.starts_with("| ") || line.starts_with("| rows ")) continue;
        std::istringstream cell(line.substr(2, line.find_first_of("|(", 2) - 2));
        for (std::string name; std::getline(cell >> std::ws, name, ',');)
            names.push_back(name.substr(0, name.find(' ')));
    }
    return names;
}

// The rows of each compiler, with its device and stage, where n_i is not a parameter; one row a model.
std::map<std::string, std::map<std::string, double>> instructions_by_compiler() {
    std::map<std::string, std::map<std::string, double>> by;
    for (const cost_row& row : cost_table())
        if (row.n_i != "free")
            by[fmt::format("{} {} {}", row.gpu, row.stage, row.tool)].emplace(row.model, row.instructions);
    return by;
}

TEST(cost_table, has_every_model_by_every_compiler_and_every_device_that_the_docs_name) {
    std::set<std::string> gpus;
    for (const auto& [compiler, costs] : instructions_by_compiler()) {
        const std::string gpu = compiler.substr(0, compiler.find(' '));
        gpus.insert(gpu);
        for (const model_row<double>& row : model_table<double>()) {
            const cost_row* longer = find_cost(row.name, "ps_3_0");
            const bool has_no_room = gpu == "ps_2_0" && longer != nullptr && longer->instructions > 50;
            EXPECT_NE(costs.contains(std::string(row.name)), has_no_room) << row.name << " " << compiler;
        }
    }
    const std::vector<std::string> documented = documented_gpus();
    EXPECT_EQ(gpus, std::set<std::string>(documented.begin(), documented.end()));
}

TEST(cost_table, every_model_costs_something_and_schlick_is_among_the_cheapest) {
    constexpr double near = 3; // instructions
    for (const auto& [compiler, costs] : instructions_by_compiler())
        for (const auto& [model, instructions] : costs) {
            if (model == "constant" || model == "one_minus_cos") { // the cosine alone, by a constant
                EXPECT_NEAR(instructions, 0.5, 1) << model << " " << compiler;
                continue;
            }
            EXPECT_GT(instructions, 0) << model << " " << compiler;
            EXPECT_LE(costs.at("schlick"), instructions + near) << model << " " << compiler;
            const bool exact = find_model<double>(model).kind == model_kind::exact;
            EXPECT_GE(instructions, exact ? 2 * costs.at("schlick") : 0) << model << " " << compiler;
        }
}

TEST(cost_table, reads_back_what_it_writes_and_names_the_line_of_what_it_cannot_read) {
    const std::vector<cost_row> rows = {
        {"schlick", "sm_86", "compute", "", 6.125, std::nan(""), 0, 12, "nvcc", "13"}};
    const std::string text = to_csv(rows);
    EXPECT_NE(text.find("schlick,sm_86,compute,,6.13,,0,12,nvcc,13\n"), std::string::npos) << text;
    EXPECT_EQ(to_csv(read_costs(text)), text);
    const auto message = [](const std::string& csv) -> std::string {
        try {
            read_costs(csv);
        } catch (const failure& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(message("# words\nschlick,navi21\n"), "cost table, line 2: has 2 cells, must have 10");
    EXPECT_EQ(message("a,b,c,,six,,,,d,e\n"), "cost table, line 1: 'six' is not a number");
}

// ---- the listings -----------------------------------------------------------------------------------------

TEST(cost_listings, have_the_slots_that_the_docs_say_and_are_all_named_there) {
    namespace fs = std::filesystem;
    const fs::path docs = fs::path(FRESNEL_SOURCE_DIR) / "docs";
    const std::string text = read_text(docs / "programs.md");
    const std::regex link(R"(\[(\d+)\]\(listings/(\S+)\))");
    std::set<std::string> named;
    for (std::sregex_iterator it(text.begin(), text.end(), link), end; it != end; ++it) {
        const std::string listing = read_text(docs / "listings" / (*it)[2].str());
        EXPECT_NE(listing.find(fmt::format("// approximately {} instruction slots", (*it)[1].str())),
                  std::string::npos)
            << (*it)[2];
        named.insert((*it)[2]);
    }
    std::set<std::string> present;
    for (const fs::directory_entry& file : fs::directory_iterator(docs / "listings"))
        present.insert(file.path().filename());
    EXPECT_EQ(named, present);
}

// ---- the targets ------------------------------------------------------------------------------------------

// The fewest instructions that the equations are known to take there, and what the accurate arrangements may add.
constexpr double dielectric_target = 16, conductor_target = 28.1, accurate = 1.4;

TEST(cost_targets, of_the_exact_equations_on_navi21) {
    EXPECT_LE(instructions_of("dielectric_fast"), dielectric_target);
    EXPECT_LE(instructions_of("conductor_fast"), conductor_target);
    EXPECT_LE(instructions_of("dielectric"), accurate * dielectric_target);
    EXPECT_LE(instructions_of("conductor"), accurate * conductor_target);
}

TEST(cost_targets, of_schlicks_approximation_and_of_what_replaces_it_on_navi21) {
    EXPECT_LE(instructions_of("schlick"), 7);
    EXPECT_LE(instructions_of("powers_4_8"), instructions_of("schlick") + 1);
    constexpr double constant = 1.0 / 16; // one is loaded once for the sixteen evaluations
    EXPECT_LE(instructions_of("powers_3_9"), instructions_of("schlick") + 1 + constant);
}

// ---- the method -------------------------------------------------------------------------------------------

TEST(cost_method, one_operation_more_costs_one_instruction_more) {
    const double plain = cost_of(schlick_with("")).instructions;
    EXPECT_EQ(plain, instructions_of("schlick"));
    EXPECT_EQ(cost_of(schlick_with("    F = max(F, c);\n")).instructions, plain + 1);
    EXPECT_EQ(cost_of(schlick_with("    F = max(F, c);\n    F = sqrt(F);\n")).instructions, plain + 2);
}

TEST(cost_method, nothing_costs_nothing) {
    const measured_cost cost = cost_of({"f", 1, "float f(float c) { return c; }\n"});
    EXPECT_EQ(cost.instructions, 0);
    EXPECT_EQ(cost.inverse_throughput, 0);
}

TEST(cost_method, is_linear_in_the_number_of_evaluations) {
    const std::array models = {"schlick", "dielectric", "conductor", "gulbrandsen", "lazanyi"};
    std::vector<cost_subject> subjects;
    for (const char* model : models)
        subjects.push_back(emit::subject_of(model));
    for (const shader_stage stage : {shader_stage::fragment, shader_stage::vertex, shader_stage::compute}) {
        const std::vector<measured_cost> costs = emit::measure_costs(subjects, "navi21", stage);
        for (std::size_t i = 0; i < costs.size(); ++i)
            EXPECT_NEAR(costs[i].instructions_8, costs[i].instructions, 0.5)
                << models[i] << " " << to_string(stage);
    }
}

TEST(cost_method, an_ambient_medium_costs_more_than_air) {
    EXPECT_GT(cost_of(emit::subject_of("dielectric", false)).instructions, instructions_of("dielectric"));
    EXPECT_EQ(emit::subject_of("dielectric", false).arguments, 3u);
    EXPECT_EQ(emit::subject_of("dielectric").arguments, 2u);
}

TEST(cost_method, a_text_that_does_not_compile_is_refused_with_the_compilers_message) {
    try {
        cost_of({"f", 1, "float f(float c) { return d; }\n"});
        FAIL() << "compiled";
    } catch (const failure& error) {
        EXPECT_NE(std::string(error.what()).find("'d' : undeclared identifier"), std::string::npos)
            << error.what();
    }
}

// ---- the command ------------------------------------------------------------------------------------------

class cost_command : public command_test {};

TEST_F(cost_command, prints_json_with_the_promised_keys) {
    const nlohmann::json rows = json("cost schlick dielectric --gpu navi21 --stage vertex,fragment --json");
    ASSERT_EQ(rows.size(), 6u); // n_i = 1 and n_i free for the second
    for (const nlohmann::json& row : rows)
        for (const char* key :
             {"model", "gpu", "stage", "instructions", "latency", "inverse_throughput", "registers"})
            EXPECT_TRUE(row.contains(key)) << key;
    EXPECT_EQ(rows[0]["model"], "schlick");
    EXPECT_EQ(rows[0]["stage"], "fragment");
    EXPECT_EQ(rows[0]["n_i"], nullptr);
    EXPECT_EQ(rows[2]["n_i"], "1");
    EXPECT_EQ(rows[4]["n_i"], "free");
}

TEST_F(cost_command, lists_the_instructions_of_one_evaluation) {
    const outcome result = run("cost dielectric_fast --isa");
    EXPECT_EQ(result.code, 0) << result.err;
    for (const char* piece :
         {"float dielectric_fast(float n_t, float cos_i)", "v_sqrt_f32", "s_endpgm", "navi21"})
        EXPECT_NE(result.out.find(piece), std::string::npos) << piece;
}

TEST_F(cost_command, measures_a_program_that_was_written_for_opengl) {
    write("a.vert", "#version 330\nin vec4 position;\nin vec3 normal;\nuniform mat4 view;\nout vec3 n;\n"
                    "void main() {\n    n = normal;\n    gl_Position = view * position;\n}\n");
    const std::string fragment =
        "#version 330\nin vec3 n;\nuniform samplerCube sky;\nuniform float f0;\nout vec4 "
        "color;\nvoid main() {\n    color = texture(sky, n)";
    write("a.frag", fragment + ";\n}\n");
    write("b.frag", fragment + " * (f0 + n.x * n.x);\n}\n");
    const auto cost = [&](const std::string& name) {
        return json("cost --program a.vert " + name +
                    " --gpu navi21 --stage fragment --json")[0]["instructions"];
    };
    EXPECT_GT(cost("a.frag"), 5);
    EXPECT_GT(cost("b.frag"), cost("a.frag"));
    expect_refused("cost --program a.vert missing.frag", {"--program 'missing.frag'", "cannot be read"});
    expect_refused("cost schlick --program a.vert a.frag", {"--program", "no MODEL"});
    write("c.frag", fragment + "\n}\n");
    const outcome broken = run("cost --program a.vert c.frag");
    EXPECT_EQ(broken.code, 1);
    EXPECT_NE(broken.err.find("fragment shader"), std::string::npos) << broken.err;
}

TEST_F(cost_command, measures_the_stages_of_a_technique_apart) {
    const auto cost = [&](const std::string& technique, const std::string& stage) {
        return json("cost schlick --technique " + technique + " --gpu polaris10 --stage " + stage +
                    " --json")[0]["instructions"]
            .get<double>();
    };
    EXPECT_GT(cost("per-pixel", "fragment"), cost("per-vertex", "fragment"));
    EXPECT_LT(cost("per-pixel", "vertex"), cost("per-vertex", "vertex"));
    expect_refused("cost schlick --technique per-texel", {"per-texel", "per-pixel"});
    expect_refused("cost --technique per-pixel", {"--technique", "name one or more models"});
}

TEST_F(cost_command, leaves_no_file_at_home) {
    EXPECT_EQ(run("cost schlick --gpu navi21", "HOME=$PWD XDG_CACHE_HOME= ").code, 0);
    EXPECT_TRUE(files().empty());
}

TEST_F(cost_command, prints_the_recorded_table) {
    const outcome result = run("cost --recorded --csv");
    EXPECT_EQ(result.code, 0) << result.err;
    EXPECT_EQ(result.out, to_csv(cost_table()));
    EXPECT_EQ(json("cost --recorded schlick --gpu navi21 --stage fragment --json").size(), 1u);
}

TEST_F(cost_command, refuses_what_it_does_not_know) {
    expect_refused("cost --gpu navi31",
                   {"--gpu 'navi31'", "polaris10, navi21, gfx1100", "did you mean 'navi21'"});
    expect_refused("cost schlick --gpu navi21,", {"--gpu ''", "polaris10"});
    expect_refused("cost --stage geometry", {"--stage 'geometry'", "fragment, vertex, compute"});
    expect_refused("cost schlik", {"'schlik'", "did you mean 'schlick'"});
    expect_refused("cost --isa", {"--isa", "name one or more models"});
    expect_refused("cost --json --csv", {"--json and --csv"});
    expect_refused("cost --recorded --gpu tahiti", {"--gpu 'tahiti'", "navi21"});
}

TEST_F(cost_command, says_what_is_missing_where_the_driver_is_not_installed) {
    const outcome result = run("cost schlick", "VK_ICD_FILENAMES=/nowhere/radeon_icd.json ");
    EXPECT_EQ(result.code, 1);
    EXPECT_NE(result.err.find("fresnel: cost: the Vulkan driver RADV is not installed"), std::string::npos)
        << result.err;
    EXPECT_NE(result.err.find("mesa-vulkan-drivers"), std::string::npos) << result.err;
}

} // namespace
} // namespace fresnel::test
