#include "colour_options.hpp"
#include "commands.hpp"

#include "analysis/identify.hpp"
#include "analysis/model_table.hpp"
#include "error.hpp"
#include "materials/catalog.hpp"
#include "materials/observer.hpp"

#include <fmt/format.h>

#include <cmath>
#include <optional>

namespace fresnel::cli {

namespace {

struct options {
    std::vector<std::string> values;
    std::optional<std::string> ior;
    std::string count = "5";
    colour_options colour;
    bool json = false;
};

struct given_f0 {
    rgb linear;
    f0_source source;
};

// Codes begin with # or have six digits; everything else is a number.
std::optional<rgb8> as_hex(std::string_view text) {
    return text.starts_with('#') || text.size() == 6 ? parse_hex(text) : std::nullopt;
}

// An F0 of the user's: a little beyond [0, 1], where saturated metals are, but no 8-bit code.
double component(std::string_view text) {
    const double value = parse_number("F0", text);
    if (value >= -0.2 && value <= 1.2) return value;
    throw bad_input(fmt::format("F0 = {}: must be in [-0.2, 1.2], linear; 8-bit codes are written as HEX "
                                "(fresnel identify '#ffdea3')",
                                text));
}

given_f0 from_index(const options& given, color_space space, double ambient) {
    if (!given.values.empty())
        throw bad_input(fmt::format("--ior {}, '{}': give one of them, not both", *given.ior,
                                    fmt::join(given.values, " ")));
    const double n = parse_number("--ior", *given.ior);
    check_range({"--ior", "1", row::n_t.min, row::n_t.max, 1}, n);
    return {grey(normal_reflectance(ambient, n, 0.0), space), f0_source::index};
}

given_f0 chosen_f0(const options& given, color_space space, double ambient) {
    if (given.ior) return from_index(given, space, ambient);
    const std::vector<std::string>& v = given.values;
    if (v.size() == 3) return {{component(v[0]), component(v[1]), component(v[2])}, f0_source::numbers};
    if (v.size() != 1)
        throw bad_input(
            fmt::format("F0: {} values given; give R G B, one F0, a HEX code in quotes ('#ffdea3'), "
                        "or --ior N",
                        v.size()));
    if (const auto codes = as_hex(v[0])) return {from_srgb(decode_srgb8(*codes), space), f0_source::hex};
    if (v[0].starts_with('#'))
        throw bad_input(fmt::format("F0 = '{}': a HEX code has three or six digits 0-9, a-f", v[0]));
    return {grey(component(v[0]), space), f0_source::numbers};
}

std::size_t chosen_count(const options& given) {
    const double count = parse_number("--count", given.count);
    const auto most = static_cast<double>(builtin_materials().size());
    if (count >= 1 && count <= most && count == std::floor(count)) return static_cast<std::size_t>(count);
    throw bad_input(fmt::format("--count = {}: must be a whole number in [1, {}]", given.count, most));
}

nlohmann::json to_json(const neighbour& n) {
    const material& m = *n.substance;
    nlohmann::json page;
    if (!m.page.empty()) page = m.page;
    return {{"material", m.name},     {"delta_e", n.delta_e},  {"f0", n.f0},
            {"class", m.category},    {"range", has_range(m)}, {"page", page},
            {"citation", m.citation}, {"quality", m.quality}};
}

nlohmann::json to_json(const identification& found) {
    nlohmann::json nearest = nlohmann::json::array();
    for (const neighbour& n : found.nearest)
        nearest.push_back(to_json(n));
    const screen_color shown = to_screen(found.f0, found.space);
    return {{"f0", found.f0},
            {"space", to_string(found.space)},
            {"ambient", found.ambient},
            {"recipe", recipe_text(found.space)},
            {"luminance", found.luminance},
            {"class", found.surface},
            {"hex", to_hex(shown.codes)},
            {"hex_clamped", !shown.in_gamut},
            {"nearest", nearest},
            {"warnings", found.warnings}};
}

std::string dataset(const material& m) {
    return m.page.empty() ? fmt::format("{} table", name_of(m.kind)) : m.page;
}

std::string swatch(const rgb& f0, color_space space) {
    const rgb8 codes = to_screen(f0, space).codes;
    return colours_wanted() ? fmt::format("\033[48;2;{};{};{}m    \033[0m ", codes[0], codes[1], codes[2])
                            : "";
}

void print(const identification& found) {
    const auto three = [](const rgb& v) { return fmt::format("{:.4f} {:.4f} {:.4f}", v[0], v[1], v[2]); };
    fmt::print("{}F0 {}  {}  {}: luminance {:.4f}\n\n", swatch(found.f0, found.space), three(found.f0),
               to_hex(to_screen(found.f0, found.space)), found.surface, found.luminance);
    fmt::print("{:>6}  {:<24} {:<14} {:<22} {}\n", "ΔE", "nearest material", "class", "F0", "dataset");
    for (const neighbour& n : found.nearest)
        print_row("{:>6.2f}  {:<24} {:<14} {:<22} {}{}", n.delta_e, n.substance->name, n.substance->category,
                  three(n.f0), swatch(n.f0, found.space), dataset(*n.substance));
    fmt::print("\n");
    for (const std::string& warning : found.warnings)
        fmt::print("warning: {}\n", warning);
    fmt::print("{}, ambient {}\n", recipe_text(found.space), found.ambient);
}

} // namespace

void add_identify(CLI::App& app) {
    CLI::App* command = add_command(
        app, "identify", "What an F0 could be: its class, the nearest materials, what is suspicious",
        "  fresnel identify 0.04\n"
        "  fresnel identify 1.04 0.73 0.36\n"
        "  fresnel identify '#ffdea3'                HEX is sRGB-encoded, numbers are linear\n"
        "  fresnel identify --ior 2.417 --json\n"
        "  fresnel identify --ior 1.5 --ambient 1.333   under water\n\n"
        "The distance is CIEDE2000 beside a white of F0 = 1; 1 is just visible.");
    const auto given = std::make_shared<options>();
    command->add_option("F0", given->values, "R G B, one F0 (linear), or an sRGB code '#rrggbb'");
    command->add_option("--ior", given->ior, "take F0 from an index of refraction")->type_name("N");
    command->add_option("--count", given->count, "how many materials (default 5)")->type_name("N");
    add_colour_options(*command, given->colour);
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] {
        const color_space space = chosen_space(given->colour);
        const double ambient = chosen_ambient(given->colour);
        const std::size_t count = chosen_count(*given);
        const given_f0 asked = chosen_f0(*given, space, ambient);
        const identification found = identify(asked.linear, space, ambient, asked.source, count);
        if (given->json) return print_json(to_json(found));
        print(found);
    });
}

} // namespace fresnel::cli
