#include "commands.hpp"
#include "csv.hpp"
#include "parameter_options.hpp"

#include "analysis/curve.hpp"
#include "analysis/model_table.hpp"
#include "error.hpp"
#include "materials/catalog.hpp"

#include <fmt/format.h>

#include <optional>

namespace fresnel::cli {

namespace {

struct options {
    std::string model;
    parameter_texts parameters;
    std::optional<std::string> cos_i, theta;
    std::string material;
    double wavelength_nm = 550;
    std::string csv, out;
    std::string type = "double";
    bool json = false;
};

// Angles in degrees and their cosines.
struct angles {
    std::vector<double> theta, cos_i;
};

angles chosen_angles(const options& given) {
    if (given.cos_i && given.theta) throw bad_input("--cos-i, --theta: give one of them, not both");
    angles result;
    if (given.cos_i) {
        result.cos_i = parse_list("cos_i", *given.cos_i);
        for (const double c : result.cos_i)
            check_range(cosine, c), result.theta.push_back(degrees_of_cosine(c));
        return result;
    }
    result.theta = parse_list("theta", given.theta.value_or("0:90:10"));
    for (const double t : result.theta)
        check_range({"theta", "degree", 0, 90, 0}, t), result.cos_i.push_back(cosine_of_degrees(t));
    return result;
}

// What an index says of a parameter.
double from_index(const optical_index& index, const parameter& p) {
    if (p.name == "n_t" || p.name == "n" || p.name == "eta") return index.n;
    if (p.name == "k_t" || p.name == "k") return index.k;
    if (p.name == "f0" || p.name == "r") return normal_reflectance(1.0, index.n, index.k);
    return p.default_value;
}

std::vector<double> chosen_parameters(const options& given, const model_row<double>& model) {
    for (const auto& one : given.parameters) {
        const std::string &name = one.first, &text = one.second;
        const auto has = [&name](const parameter& p) { return p.name == name; };
        if (std::any_of(model.parameters.begin(), model.parameters.end(), has)) continue;
        std::vector<std::string> names;
        for (const parameter& p : model.parameters)
            names.emplace_back(p.name);
        throw bad_input(fmt::format("{} = {}: is no parameter of {}, which takes {}", name, text, model.name,
                                    names.empty() ? "none" : fmt::format("{}", fmt::join(names, ", "))));
    }
    std::optional<optical_index> index;
    if (!given.material.empty()) index = index_at(load_material(given.material), given.wavelength_nm);
    std::vector<double> values;
    for (const parameter& p : model.parameters) {
        const auto found = given.parameters.find(std::string(p.name));
        if (found != given.parameters.end())
            values.push_back(parse_number(p.name, found->second));
        else
            values.push_back(index ? from_index(*index, p) : p.default_value);
        check_range(p, values.back());
    }
    return values;
}

nlohmann::json to_json(const boundary<double>& b, bool polarised) {
    if (!polarised) return {{"R", b.R_s}};
    return {{"R", b.reflectance()},   {"Rs", b.R_s}, {"Rp", b.R_p},
            {"T", b.transmittance()}, {"Ts", b.T_s}, {"Tp", b.T_p}};
}

void print_result(const model_row<double>& model, const std::vector<double>& values, const angles& at,
                  bool json) {
    nlohmann::json parameters = nlohmann::json::object(), results = nlohmann::json::array();
    for (std::size_t i = 0; i < values.size(); ++i)
        parameters[std::string(model.parameters[i].name)] = values[i];
    if (!json) {
        fmt::print("{}", model.name);
        for (std::size_t i = 0; i < values.size(); ++i)
            fmt::print("  {} = {}", model.parameters[i].name, values[i]);
        fmt::print("\n{:>8} {:>22} {:>22}", "theta", "cos_i", "R");
        fmt::print("{}\n", model.polarised() ? fmt::format(" {:>22} {:>22} {:>22}", "Rs", "Rp", "T") : "");
    }
    for (std::size_t i = 0; i < at.cos_i.size(); ++i) {
        const boundary<double> b = model.evaluate(values.data(), at.cos_i[i]);
        if (json) {
            nlohmann::json one = to_json(b, model.polarised());
            one["cos_i"] = at.cos_i[i], one["theta"] = at.theta[i];
            results.push_back(std::move(one));
            continue;
        }
        fmt::print("{:>8.4g} {:>22} {:>22}", at.theta[i], at.cos_i[i],
                   model.polarised() ? b.reflectance() : b.R_s);
        fmt::print("{}\n", model.polarised()
                               ? fmt::format(" {:>22} {:>22} {:>22}", b.R_s, b.R_p, b.transmittance())
                               : "");
    }
    if (json) print_json({{"model", model.name}, {"parameters", parameters}, {"results", results}});
}

void evaluate_command(const options& given) {
    const model_row<double>& model = find_model<double>(given.model);
    if (given.csv.empty()) {
        if (!given.out.empty()) throw bad_input(fmt::format("--out '{}': goes with --csv only", given.out));
        if (given.type != "double")
            throw bad_input(fmt::format("--type {}: goes with --csv only", given.type));
        return print_result(model, chosen_parameters(given, model), chosen_angles(given), given.json);
    }
    if (!given.parameters.empty() || given.cos_i || given.theta || !given.material.empty())
        throw bad_input(fmt::format(
            "--csv '{}': takes every parameter from its columns; leave the others out", given.csv));
    evaluate_csv(given.model, given.csv, given.out, given.type);
}

} // namespace

void add_eval(CLI::App& app) {
    CLI::App* command =
        add_command(app, "eval", "Evaluate a model at angles, or on every row of a CSV file",
                    "  fresnel eval dielectric --n-t 1.5 --cos-i 0.5\n"
                    "  fresnel eval conductor --material copper --wavelength 650 --theta 0:90:19\n"
                    "  fresnel eval schlick --f0 0.04 --theta 0,60,85 --json\n"
                    "  fresnel eval conductor --csv rows.csv --out results.csv\n"
                    "  generate | fresnel eval dielectric --csv - --type float | consume");
    const auto given = std::make_shared<options>();
    command->add_option("MODEL", given->model, "registry name, see `fresnel models`")->required();
    command->add_option("--cos-i,--cos_i,--cos", given->cos_i, "cosines: A, A,B,C or FROM:TO:COUNT")
        ->type_name("LIST");
    command->add_option("--theta", given->theta, "angles in degrees, in the same form (default 0:90:10)")
        ->type_name("LIST");
    command->add_option("--material", given->material, "take n, k and f0 from this material")
        ->type_name("NAME");
    command->add_option("--wavelength", given->wavelength_nm, "of the material, in nm (default 550)")
        ->check([](const std::string& text) {
            const double nm = parse_number("wavelength", text);
            if (!(nm >= 1 && nm <= 1e9))
                throw bad_input(fmt::format("wavelength = {}: must be in [1, 1e9] nm", text));
            return std::string();
        });
    command->add_option("--csv", given->csv, "read parameters and cos_i from this file, - for standard input")
        ->type_name("FILE");
    command->add_option("--out", given->out, "write the rows of --csv to this file")->type_name("FILE");
    command->add_option("--type", given->type, "number type of --csv: float, double or 50 (digits)")
        ->check(CLI::IsMember({"float", "double", "50"}));
    command->add_flag("--json", given->json, "print JSON");
    add_parameters(*command, given->parameters);
    command->callback([given] { evaluate_command(*given); });
}

} // namespace fresnel::cli
