#include "commands.hpp"
#include "csv.hpp"
#include "parameter_options.hpp"

#include "analysis/curve.hpp"
#include "analysis/fit.hpp"
#include "analysis/model_table.hpp"
#include "error.hpp"
#include "materials/catalog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

namespace fresnel::cli {

namespace {

struct options {
    std::string model;
    parameter_texts parameters;
    std::optional<std::string> cos_i, theta;
    std::string material;
    std::optional<std::string> wavelength, csv, out;
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

// The g of gulbrandsen, which mixes n from the two that are its ends at that r.
double edge_tint_of(const optical_index& index) {
    const double r = normal_reflectance(1.0, index.n, index.k);
    const double most = gulbrandsen_index(r, 0.0).re, least = gulbrandsen_index(r, 1.0).re;
    const double g = r == 0 ? 0 : (most - index.n) / (most - least);
    if (g <= 1 + 1e-12) return std::clamp(g, 0.0, 1.0);
    throw bad_input(
        fmt::format("--material: n = {:.4g}, k = {:.4g} has no g, which needs n^2 + k^2 >= 1; give --g",
                    index.n, index.k));
}

// What an index says of a parameter, the medium outside being air.
double from_index(const optical_index& index, const parameter& p) {
    const auto reflectance = [&](double c) { return conductor(1.0, index.n, index.k, c).reflectance(); };
    constexpr double c82 = ratio<double, 1, 7>();
    if (p.name == "n_t" || p.name == "n" || p.name == "eta") return index.n;
    if (p.name == "k_t" || p.name == "k") return index.k;
    if (p.name == "f0" || p.name == "r") return normal_reflectance(1.0, index.n, index.k);
    if (p.name == "g") return edge_tint_of(index);
    if (p.name == "f82") return reflectance(c82);
    if (p.name == "tint")
        return std::min(tint_of_f82(normal_reflectance(1.0, index.n, index.k), reflectance(c82)), 1.0);
    return p.default_value;
}

// No index says these: they are those that come closest to its reflectance at every angle.
bool is_fitted(const parameter& p) {
    constexpr std::array names = {"f90", "power", "a", "alpha", "bias", "scale"};
    return std::ranges::find(names, p.name) != names.end();
}

double chosen_wavelength(const options& given) {
    if (!given.wavelength) return 550;
    if (given.material.empty())
        throw bad_input(fmt::format("--wavelength {}: goes with --material only", *given.wavelength));
    const double nm = parse_number("wavelength", *given.wavelength);
    check_range({"wavelength", "nm", 1, 1e9, 550}, nm);
    return nm;
}

// A model of n alone would leave out what makes a metal.
void require_no_absorption(const optical_index& index, const options& given, const model_row<double>& model) {
    const auto takes = [&](std::string_view name) {
        return std::ranges::find(model.parameters, name, &parameter::name) != model.parameters.end();
    };
    const bool index_alone = (takes("n_t") && !takes("k_t")) || takes("eta");
    if (index_alone && index.k > 0.1)
        throw bad_input(fmt::format("--material '{}': absorbs, k = {:.4g}, and {} has no k; take conductor",
                                    given.material, index.k, model.name));
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
    const double nm = chosen_wavelength(given);
    if (!given.material.empty()) {
        index = used_index(load_material(given.material), nm);
        require_no_absorption(*index, given, model);
    }
    std::vector<double> values, fitted;
    if (index && std::ranges::any_of(model.parameters, is_fitted))
        fitted = fit(model.name, channel_of(*index));
    for (std::size_t i = 0; i < model.parameters.size(); ++i) {
        const parameter& p = model.parameters[i];
        const auto found = given.parameters.find(std::string(p.name));
        if (found != given.parameters.end())
            values.push_back(parse_number(p.name, found->second));
        else if (index)
            values.push_back(is_fitted(p) ? fitted[i] : from_index(*index, p));
        else
            values.push_back(p.default_value);
        check_range(p, values.back());
    }
    return values;
}

nlohmann::json to_json(const boundary<double>& b, bool polarised) {
    if (!polarised) return {{"R", b.R_s}};
    return {{"R", b.reflectance()},   {"Rs", b.R_s}, {"Rp", b.R_p},
            {"T", b.transmittance()}, {"Ts", b.T_s}, {"Tp", b.T_p}};
}

nlohmann::json parameters_json(const model_row<double>& model, const std::vector<double>& values) {
    nlohmann::json parameters = nlohmann::json::object();
    for (std::size_t i = 0; i < values.size(); ++i)
        parameters[std::string(model.parameters[i].name)] = values[i];
    return parameters;
}

// Indented as every other JSON here, but row by row: a sweep of millions is not kept in memory.
std::string indented(const nlohmann::json& value, int depth) {
    const std::string space(static_cast<std::size_t>(depth), ' ');
    std::string text = space;
    for (const char c : value.dump(2))
        text += c == '\n' ? "\n" + space : std::string(1, c);
    return text;
}

void print_json_result(const model_row<double>& model, const std::vector<double>& values, const angles& at) {
    fmt::print("{{\n  \"model\": \"{}\",\n  \"parameters\": {},\n  \"results\": [", model.name,
               indented(parameters_json(model, values), 2).substr(2));
    for (std::size_t i = 0; i < at.cos_i.size(); ++i) {
        nlohmann::json one = to_json(model.evaluate(values.data(), at.cos_i[i]), model.polarised());
        one["cos_i"] = at.cos_i[i], one["theta"] = at.theta[i];
        fmt::print("{}\n{}", i == 0 ? "" : ",", indented(one, 4));
    }
    fmt::print("\n  ]\n}}\n");
}

void print_result(const model_row<double>& model, const std::vector<double>& values, const angles& at) {
    fmt::print("{}", model.name);
    for (std::size_t i = 0; i < values.size(); ++i)
        fmt::print("  {} = {}", model.parameters[i].name, values[i]);
    fmt::print("\n{:>8} {:>22} {:>22}", "theta", "cos_i", "R");
    fmt::print("{}\n", model.polarised() ? fmt::format(" {:>22} {:>22} {:>22}", "Rs", "Rp", "T") : "");
    for (std::size_t i = 0; i < at.cos_i.size(); ++i) {
        const boundary<double> b = model.evaluate(values.data(), at.cos_i[i]);
        fmt::print("{:>8.4g} {:>22} {:>22}", at.theta[i], at.cos_i[i],
                   model.polarised() ? b.reflectance() : b.R_s);
        fmt::print("{}\n", model.polarised()
                               ? fmt::format(" {:>22} {:>22} {:>22}", b.R_s, b.R_p, b.transmittance())
                               : "");
    }
}

void evaluate_command(const options& given) {
    const model_row<double>& model = find_model<double>(given.model);
    if (!given.csv) {
        if (given.out) throw bad_input(fmt::format("--out '{}': goes with --csv only", *given.out));
        if (given.type != "double")
            throw bad_input(fmt::format("--type {}: goes with --csv only", given.type));
        const auto print = given.json ? print_json_result : print_result;
        return print(model, chosen_parameters(given, model), chosen_angles(given));
    }
    if (!given.parameters.empty() || given.cos_i || given.theta || !given.material.empty() ||
        given.wavelength)
        throw bad_input(fmt::format(
            "--csv '{}': takes every parameter from its columns; leave the others out", *given.csv));
    if (given.json)
        throw bad_input(fmt::format("--json, --csv '{}': rows are CSV; leave --json out", *given.csv));
    evaluate_csv(given.model, *given.csv, given.out.value_or(""), given.type);
}

} // namespace

void add_eval(CLI::App& app) {
    CLI::App* command = add_command(
        app, "eval", "Evaluate a model at angles, or on every row of a CSV file",
        "  fresnel eval dielectric --n-t 1.5 --cos-i 0.5\n"
        "  fresnel eval conductor --material copper --wavelength 650 --theta 0:90:19\n"
        "  fresnel eval schlick --f0 0.04 --theta 0,60,85 --json\n"
        "  fresnel eval conductor --csv rows.csv --out results.csv\n"
        "  generate | fresnel eval dielectric --csv - --type float | consume\n\n"
        "Rows of --csv are decimals between commas, spaces around them allowed; blank lines, quotes\n"
        "and + signs are refused.");
    const auto given = std::make_shared<options>();
    command->add_option("MODEL", given->model, "registry name, see `fresnel models`")->required();
    command->add_option("--cos-i,--cos_i,--cos", given->cos_i, "cosines: A, A,B,C or FROM:TO:COUNT")
        ->type_name("LIST");
    command->add_option("--theta", given->theta, "angles in degrees, in the same form (default 0:90:10)")
        ->type_name("LIST");
    command
        ->add_option("--material", given->material,
                     "take n, k, f0, f82, tint, r and g from this material (f90, power, a, alpha, bias and "
                     "scale are fitted to it)")
        ->type_name("NAME");
    command->add_option("--wavelength", given->wavelength, "of the material, in nm (default 550)")
        ->type_name("NM");
    command->add_option("--csv", given->csv, "read parameters and cos_i from this file, - for standard input")
        ->type_name("FILE");
    command->add_option("--out", given->out, "write the rows of --csv to this file, - for standard output")
        ->type_name("FILE");
    command->add_option("--type", given->type, "number type of --csv: float, double or 50 (digits)")
        ->check(CLI::IsMember({"float", "double", "50"}));
    command->add_flag("--json", given->json, "print JSON");
    add_parameters(*command, given->parameters);
    command->callback([given] { evaluate_command(*given); });
}

} // namespace fresnel::cli
