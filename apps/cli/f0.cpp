#include "colour_options.hpp"
#include "commands.hpp"

#include "analysis/curve.hpp"
#include "analysis/model_table.hpp"
#include "error.hpp"
#include "materials/observer.hpp"

#include <fmt/format.h>

namespace fresnel::cli {

namespace {

struct options {
    std::string name;
    colour_options colour;
    std::string gamut = "none";
    bool json = false;
};

gamut chosen_gamut(const options& given) {
    if (const auto policy = parse_gamut(given.gamut)) return *policy;
    throw bad_input(
        fmt::format("--gamut '{}': must be one of {}", given.gamut, fmt::join(gamut_names, ", ")));
}

nlohmann::json page_of(const material& substance) {
    return substance.page.empty() ? nlohmann::json() : nlohmann::json(substance.page);
}

// The two ends of a table row that is a range; nothing for the others.
std::vector<normal_colour> ends(const material& substance, color_space space, double ambient, gamut policy) {
    const std::array<double, 2>& range =
        substance.kind == material_kind::index ? substance.index : substance.f0;
    if (substance.kind == material_kind::spectral || range[0] == range[1]) return {};
    return {colour_at_normal(low_end(substance), space, ambient, policy),
            colour_at_normal(high_end(substance), space, ambient, policy)};
}

// Where n and k are from; every built-in material that has them has a page.
std::string origin(const material& substance) {
    if (!substance.page.empty()) return substance.page;
    return substance.kind == material_kind::spectral ? "(your table)" : "(no n, k page)";
}

void print(const normal_colour& c, const material& substance, gamut policy) {
    const auto line = [](std::string_view name, const rgb& v) {
        fmt::print("  {:<14} {:>8.4f} {:>8.4f} {:>8.4f}\n", name, v[0], v[1], v[2]);
    };
    const screen_color shown = to_screen(c.f0, c.space);
    fmt::print("{}  {}\n", c.material, origin(substance));
    line("F0", c.f0);
    line("F82", c.f82);
    line("F82 tint", c.f82_tint);
    line("Gulbrandsen r", c.gulbrandsen_r);
    line("Gulbrandsen g", c.gulbrandsen_g);
    line("average", c.average);
    const std::vector<normal_colour> range = ends(substance, c.space, c.ambient, policy);
    if (!range.empty()) line("F0 from", range[0].f0), line("F0 to", range[1].f0);
    fmt::print("  {:<14} {}", "sRGB", to_hex(shown.codes));
    if (colours_wanted())
        fmt::print("  \033[48;2;{};{};{}m      \033[0m", shown.codes[0], shown.codes[1], shown.codes[2]);
    fmt::print("{}\n", shown.in_gamut ? "" : "  (clamped: F0 lies outside sRGB)");
    if (!c.in_gamut && policy == gamut::none)
        fmt::print(
            "  {:<14} F0 lies outside {}; --gamut clamp or divide limits it, --space acescg holds it\n",
            "note", to_string(c.space));
    fmt::print("  {:<14} {}, gamut {}, ambient {}\n", "recipe", c.recipe, to_string(policy), c.ambient);
    fmt::print("  {:<14} {}\n  {:<14} {}\n", "source", substance.citation, "quality", substance.quality);
}

nlohmann::json to_json(const normal_colour& c, const material& substance, gamut policy) {
    const screen_color shown = to_screen(c.f0, c.space);
    nlohmann::json result = {{"material", c.material},
                             {"page", page_of(substance)},
                             {"space", to_string(c.space)},
                             {"ambient", c.ambient},
                             {"recipe", c.recipe},
                             {"gamut", to_string(policy)},
                             {"f0", c.f0},
                             {"f82", c.f82},
                             {"f82_tint", c.f82_tint},
                             {"gulbrandsen", {{"r", c.gulbrandsen_r}, {"g", c.gulbrandsen_g}}},
                             {"average", c.average},
                             {"srgb8", shown.codes},
                             {"hex", to_hex(shown.codes)},
                             {"in_gamut", c.in_gamut},
                             {"hex_clamped", !shown.in_gamut},
                             {"citation", substance.citation},
                             {"quality", substance.quality}};
    const std::vector<normal_colour> range = ends(substance, c.space, c.ambient, policy);
    if (!range.empty()) result["f0_range"] = {range[0].f0, range[1].f0};
    return result;
}

} // namespace

void add_f0(CLI::App& app) {
    CLI::App* command =
        add_command(app, "f0", "F0, F82, edge tint, average and hex of a material, with their recipe",
                    "  fresnel f0 copper\n"
                    "  fresnel f0 gold --space acescg --json\n"
                    "  fresnel f0 gold --gamut clamp\n"
                    "  fresnel f0 n-bk7 --ambient 1.333          under water\n"
                    "  fresnel f0 my-measurement.csv             columns wavelength_nm,n,k");
    const auto given = std::make_shared<options>();
    command
        ->add_option("NAME", given->name, "material, see `fresnel materials`; or a .yml page or .csv table")
        ->required();
    add_colour_options(*command, given->colour);
    command
        ->add_option("--gamut", given->gamut,
                     "components outside [0, 1]: none, clamp or divide (default none)")
        ->type_name("G");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] {
        const gamut policy = chosen_gamut(*given);
        const color_space space = chosen_space(given->colour);
        const double ambient = chosen_ambient(given->colour);
        const material substance = load_material(given->name);
        const normal_colour colour = colour_at_normal(substance, space, ambient, policy);
        if (given->json) return print_json(to_json(colour, substance, policy));
        print(colour, substance, policy);
    });
}

} // namespace fresnel::cli
