#include "commands.hpp"

#include "error.hpp"
#include "materials/catalog.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fresnel::cli {

namespace {

nlohmann::json to_json(const material& m) {
    nlohmann::json page, index, f0;
    if (!m.page.empty()) page = m.page;
    if (m.kind == material_kind::index) index = m.index;
    if (m.kind == material_kind::f0) f0 = m.f0;
    return {{"name", m.name},
            {"aliases", m.aliases},
            {"class", m.category},
            {"kind", name_of(m.kind)},
            {"page", page},
            {"index", index},
            {"f0", f0},
            {"range_nm", m.range_nm},
            {"citation", m.citation},
            {"doi", m.doi},
            {"licence", m.licence},
            {"quality", m.quality}};
}

std::string value_of(const material& m) {
    const auto range = [](const std::array<double, 2>& r) {
        return r[0] == r[1] ? fmt::format("{}", r[0]) : fmt::format("{}–{}", r[0], r[1]);
    };
    if (m.kind == material_kind::index) return "n = " + range(m.index);
    if (m.kind == material_kind::f0) return "F0 = " + range(m.f0);
    return m.page;
}

void print_list(const std::vector<material>& chosen) {
    fmt::print("{:<26} {:<14} {:<9} {:<44} {}\n", "material", "class", "kind", "page or value", "aliases");
    for (const material& m : chosen)
        print_row("{:<26} {:<14} {:<9} {:<44} {}", m.name, m.category, name_of(m.kind), value_of(m),
                  fmt::join(m.aliases, ", "));
    fmt::print("{} materials; `fresnel materials show NAME` prints one\n", chosen.size());
}

// n and k every 10 nm over the visible: what the colour of a material is made from.
std::vector<double> visible() {
    std::vector<double> wavelengths;
    for (int nm = 380; nm <= 780; nm += 10)
        wavelengths.push_back(nm);
    return wavelengths;
}

void print_one(const material& m) {
    fmt::print("{}  ({}, {})\n", m.name, m.category, name_of(m.kind));
    const auto line = [](std::string_view name, const std::string& text) {
        if (!text.empty()) fmt::print("  {:<9} {}\n", name, text);
    };
    line("aliases", fmt::format("{}", fmt::join(m.aliases, ", ")));
    line(m.kind == material_kind::spectral ? "page" : "value", value_of(m));
    if (m.kind == material_kind::spectral)
        line("range", fmt::format("{}–{} nm", m.range_nm[0], m.range_nm[1]));
    line("source", m.citation);
    line("doi", m.doi);
    line("licence", m.licence);
    line("quality", m.quality);
    if (m.kind != material_kind::spectral) return;
    fmt::print("\n  {:>5} {:>10} {:>12}\n", "nm", "n", "k");
    for (const double nm : visible()) {
        const optical_index index = index_at(m, nm);
        fmt::print("  {:>5} {:>10.6g} {:>12.6g}\n", nm, index.n, index.k);
    }
}

nlohmann::json show_json(const material& m) {
    nlohmann::json result = to_json(m);
    nlohmann::json rows = nlohmann::json::array();
    for (const double nm : visible()) {
        const optical_index index = index_at(m, nm);
        rows.push_back({{"wavelength_nm", nm}, {"n", index.n}, {"k", index.k}});
    }
    result["nk"] = rows;
    return result;
}

struct options {
    std::string category, kind, name;
    bool json = false, show_json = false;
};

std::vector<material> filtered(const options& given) {
    std::vector<std::string> classes, kinds = {"spectral", "index", "f0"};
    std::vector<material> chosen;
    for (const material& m : builtin_materials()) {
        if (std::find(classes.begin(), classes.end(), m.category) == classes.end())
            classes.push_back(m.category);
        if ((given.category.empty() || m.category == given.category) &&
            (given.kind.empty() || name_of(m.kind) == given.kind))
            chosen.push_back(m);
    }
    if (!given.category.empty() && std::find(classes.begin(), classes.end(), given.category) == classes.end())
        throw bad_input(
            fmt::format("--class '{}': must be one of {}", given.category, fmt::join(classes, ", ")));
    if (!given.kind.empty() && std::find(kinds.begin(), kinds.end(), given.kind) == kinds.end())
        throw bad_input(fmt::format("--kind '{}': must be one of {}", given.kind, fmt::join(kinds, ", ")));
    return chosen;
}

void list(const options& given) {
    const std::vector<material> chosen = filtered(given);
    if (!given.json) return print_list(chosen);
    nlohmann::json all = nlohmann::json::array();
    for (const material& m : chosen)
        all.push_back(to_json(m));
    print_json(all);
}

} // namespace

void add_materials(CLI::App& app) {
    CLI::App* command =
        add_command(app, "materials", "The built-in materials; `materials show NAME` prints one",
                    "  fresnel materials\n"
                    "  fresnel materials --class metal\n"
                    "  fresnel materials show copper\n"
                    "  fresnel materials --json | jq '.[] | select(.kind == \"f0\")'");
    const auto given = std::make_shared<options>();
    command->add_option("--class", given->category, "only this class: metal, dielectric, semiconductor …")
        ->type_name("C");
    command->add_option("--kind", given->kind, "only this kind: spectral, index or f0")->type_name("K");
    command->add_flag("--json", given->json, "print JSON");
    command->require_subcommand(0, 1);

    CLI::App* show = add_command(*command, "show", "One material: source, quality, n and k over the visible",
                                 "  fresnel materials show copper\n"
                                 "  fresnel materials show main/Cu/nk/Johnson --json");
    show->add_option("NAME", given->name, "material name, alias, page, or a .yml or .csv file")->required();
    show->add_flag("--json", given->show_json, "print JSON");
    command->callback([given, show] {
        if (!show->parsed()) return list(*given);
        const material substance = load_material(given->name);
        if (given->json || given->show_json) return print_json(show_json(substance));
        print_one(substance);
    });
}

} // namespace fresnel::cli
