#include "commands.hpp"

#include "analysis/cost_table.hpp"
#include "analysis/graph.hpp"
#include "analysis/prove.hpp"

#include <fmt/format.h>

namespace fresnel::cli {

namespace {

nlohmann::json costs_json(std::string_view model) {
    nlohmann::json costs = nlohmann::json::array();
    for (const cost_row& row : cost_table())
        if (row.model == model && row.n_i != "free" && row.stage == "fragment")
            costs.push_back({{"gpu", row.gpu}, {"instructions", row.instructions}, {"tool", row.tool}});
    return costs;
}

nlohmann::json to_json(const model_row<double>& row) {
    nlohmann::json parameters = nlohmann::json::array();
    for (const parameter& p : row.parameters)
        parameters.push_back({{"name", p.name},
                              {"unit", p.unit},
                              {"min", p.min},
                              {"max", p.max},
                              {"default", p.default_value}});
    const operation_count count = count_operations(row.name);
    return {{"name", row.name},
            {"kind", to_string(row.kind)},
            {"equation", row.equation},
            {"parameters", parameters},
            {"citation", row.citation},
            {"domain", row.domain},
            {"error",
             {{"max", row.error.max},
              {"over", row.error.over},
              {"basis", can_prove(row.error.over) ? "certified" : "measured"}}},
            {"operations", count.cost()},
            {"cost", costs_json(row.name)}};
}

std::string parameter_names(const model_row<double>& row) {
    std::string names;
    for (const parameter& p : row.parameters)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", p.name);
    return names;
}

// "; 6 instructions on navi21, 6 on gfx1100" where it was measured
std::string measured_cost(std::string_view model) {
    std::string text;
    for (const char* gpu : {"navi21", "gfx1100", "polaris10"})
        if (const cost_row* cost = find_cost(model, gpu))
            text += fmt::format("{} {:.0f}{} on {}", text.empty() ? ";" : ",", cost->instructions,
                                text.empty() ? " instructions" : "", gpu);
    return text;
}

void print_one(const model_row<double>& row) {
    fmt::print("{}  ({})\n\n  {}\n\n", row.name, to_string(row.kind), row.equation);
    for (const parameter& p : row.parameters)
        fmt::print("  {:<7} in [{}, {}], default {}\n", p.name, p.min, p.max, p.default_value);
    fmt::print("  {:<7} in [0, 1]\n\n", "cos_i");
    fmt::print("  error   {:.3g}, {} ({})\n", row.error.max, row.error.over,
               can_prove(row.error.over) ? "certified by `fresnel prove`" : "measured");
    fmt::print("  domain  {}\n", row.domain);
    fmt::print("  cost    {} operations{}\n", count_operations(row.name).cost(), measured_cost(row.name));
    fmt::print("  source  {}\n", row.citation);
}

void print_all(const std::vector<model_row<double>>& rows) {
    fmt::print("{:<19} {:<14} {:<20} {:>9} {:>5}  {}\n", "model", "kind", "parameters", "max error", "cost",
               "over");
    for (const model_row<double>& row : rows)
        fmt::print("{:<19} {:<14} {:<20} {:>9.3g} {:>5}  {}\n", row.name, to_string(row.kind),
                   parameter_names(row), row.error.max, count_operations(row.name).cost(), row.error.over);
}

} // namespace

void add_models(CLI::App& app) {
    CLI::App* command = add_command(app, "models", "Every model: name, equation, parameters, error, source",
                                    "  fresnel models\n"
                                    "  fresnel models gulbrandsen\n"
                                    "  fresnel models --json | jq '.[] | {name, error}'");
    struct options {
        std::vector<std::string> names;
        bool json = false;
    };
    const auto given = std::make_shared<options>();
    command->add_option("NAME", given->names, "only these models");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] {
        std::vector<model_row<double>> rows;
        for (const std::string& name : given->names)
            rows.push_back(find_model<double>(name));
        if (given->names.empty()) rows = model_table<double>();
        if (given->json) {
            nlohmann::json all = nlohmann::json::array();
            for (const model_row<double>& row : rows)
                all.push_back(to_json(row));
            return print_json(all);
        }
        if (given->names.empty()) return print_all(rows);
        for (std::size_t i = 0; i < rows.size(); ++i)
            fmt::print("{}", i == 0 ? "" : "\n"), print_one(rows[i]);
    });
}

} // namespace fresnel::cli
