#include "commands.hpp"

#include "analysis/prove.hpp"

#include "analysis/model_table.hpp"
#include "materials/catalog.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <unistd.h>

namespace fresnel::cli {

namespace {

struct options {
    std::vector<std::string> models, materials;
    bool json = false;
};

nlohmann::json pair(const certified& value) { return {value.lo, value.hi}; }

nlohmann::json to_json(const certificate& c) {
    nlohmann::json at = object(c.at), materials = nlohmann::json::array();
    if (!c.material.empty()) at["material"] = c.material;
    for (const certified_material& m : c.materials)
        materials.push_back({{"material", m.name},
                             {"wavelength_nm", m.wavelength_nm},
                             {"absolute", pair(m.absolute)},
                             {"at", object(m.at)}});
    return {{"model", c.model},
            {"domain", c.domain},
            {"absolute", pair(c.absolute)},
            {"relative", c.relative ? pair(*c.relative) : nlohmann::json()},
            {"relative_as_eta_goes_to_1",
             c.unbounded_near_match ? nlohmann::json("unbounded") : nlohmann::json()},
            {"at", at},
            {"materials", c.materials.empty() ? nlohmann::json() : materials},
            {"rounding_float32", c.rounding_bound.value_or(c.rounding_found)},
            {"rounding_found", c.rounding_found},
            {"rounding_at", object(c.rounding_at)},
            {"rounding_bound", c.rounding_bound ? nlohmann::json(*c.rounding_bound) : nlohmann::json()},
            {"proved", c.proved}};
}

// "[0.082392, 0.082396]", or "[0, 3.2e-14]" where those digits would be zeros
std::string bounds(const certified& c, int digits) {
    if (c.hi > 0 && c.hi < 1e-6) return fmt::format("[{:.2g}, {:.2g}]", c.lo, c.hi);
    return fmt::format("[{0:.{2}f}, {1:.{2}f}]", c.lo, c.hi, digits);
}

void print(const certificate& c) {
    std::string at;
    for (const auto& [name, value] : c.at)
        at += fmt::format("{}{} = {:.4f}", at.empty() ? "" : ", ", name, value);
    if (!c.material.empty()) at += ", " + c.material;
    const std::string rounding = c.rounding_bound
                                     ? fmt::format("[{:.1e}, {:.1e}]", c.rounding_found, *c.rounding_bound)
                                     : fmt::format("≥ {:.1e}", c.rounding_found);
    if (c.proved)
        print_row("{:<20} {:<21} {:<20} {:<19} {}", c.model, bounds(c.absolute, 6), bounds(*c.relative, 4),
                  rounding, at);
    else
        fmt::print("{:<20} {:<21} {:<20} {:<19} measured, not proved\n", c.model,
                   fmt::format("{:.3g}", c.absolute.hi), "–", rounding);
}

std::vector<std::string> each_once(const std::vector<std::string>& names) {
    std::vector<std::string> once;
    for (const std::string& name : names)
        if (std::ranges::find(once, name) == once.end()) once.push_back(name);
    return once;
}

std::vector<certificate> certify(const options& given) {
    for (const std::string& name : given.models)
        find_model<double>(name);
    if (given.models.empty() && isatty(STDERR_FILENO) != 0) say("prove: every model, about ten seconds\n");
    if (given.models.empty() && given.materials.empty()) return prove_all();
    std::vector<material> materials;
    for (const std::string& name : each_once(given.materials))
        materials.push_back(load_material(name));
    std::vector<certificate> all;
    for (const model_row<double>& row : model_table<double>())
        if (given.models.empty() && can_fit(row.name)) all.push_back(prove(row.name, materials));
    for (const std::string& name : each_once(given.models))
        all.push_back(materials.empty() ? prove(name) : prove(name, materials));
    return all;
}

void run(const options& given) {
    const std::vector<certificate> all = certify(given);
    if (!given.json)
        fmt::print("{:<20} {:<21} {:<20} {:<19} {}\n", "model", "absolute error in", "relative error in",
                   "float32 rounding in", "largest at");
    nlohmann::json list = nlohmann::json::array();
    for (const certificate& c : all)
        if (given.json)
            list.push_back(to_json(c));
        else
            print(c);
    if (given.json) return print_json(list);

    std::string unbounded;
    for (const certificate& c : all)
        if (c.unbounded_near_match) unbounded += (unbounded.empty() ? "" : ", ") + c.model;
    if (!unbounded.empty())
        fmt::print("\nAs eta goes to 1 the relative error is unbounded of: {}.\n", unbounded);
}

} // namespace

void add_prove(CLI::App& app) {
    CLI::App* command =
        add_command(app, "prove", "The largest error of a model, certified with intervals",
                    "  fresnel prove schlick\n"
                    "  fresnel prove f82 powers_4_12 --json\n"
                    "  fresnel prove                              every model\n"
                    "  fresnel prove f82 --material silicon       fitted to that material\n\n"
                    "The largest error certainly lies in the interval; domains as in `fresnel models`.\n"
                    "Relative errors hold on the domain that `fresnel models` names; which of them are\n"
                    "unbounded as eta goes to 1 stands below the table.\n"
                    "Rounding is of float32 against real arithmetic, for parameters up to 10; after ≥\n"
                    "it is the largest that a search found, as far from critical angles as the domain\n"
                    "says. --json also has the inputs where it was found, and each material by itself.");
    const auto given = std::make_shared<options>();
    command->add_option("MODEL", given->models, "registry names; all if none is given");
    command
        ->add_option(
            "--material", given->materials,
            "approximations fitted to this material (a name, .yml page or .csv table) at 450, 550 and "
            "650 nm instead; may be repeated")
        ->type_name("NAME")
        ->allow_extra_args(false);
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
