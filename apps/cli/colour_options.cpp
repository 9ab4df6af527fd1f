#include "colour_options.hpp"

#include "commands.hpp"

#include "analysis/model_table.hpp"
#include "error.hpp"

#include <fmt/format.h>

namespace fresnel::cli {

void add_colour_options(CLI::App& command, colour_options& given) {
    command.add_option("--space", given.space, "srgb, p3, rec2020, acescg or xyz (default srgb)")
        ->type_name("S");
    command.add_option("--ambient", given.ambient, "index of the medium outside (default 1, air)")
        ->type_name("N");
}

color_space chosen_space(const colour_options& given) {
    if (const auto space = parse_color_space(given.space)) return *space;
    throw bad_input(
        fmt::format("--space '{}': must be one of {}", given.space, fmt::join(color_space_names, ", ")));
}

double chosen_ambient(const colour_options& given) {
    const double ambient = parse_number("--ambient", given.ambient);
    check_range({"--ambient", "1", row::n_i.min, row::n_i.max, 1}, ambient);
    return ambient;
}

std::string colour_arguments(const colour_options& given) {
    const colour_options usual;
    std::string text;
    if (given.space != usual.space) text += " --space " + given.space;
    if (given.ambient != usual.ambient) text += " --ambient " + given.ambient;
    return text;
}

void refuse_colours(const colour_options& given, std::string_view of) {
    const colour_options usual;
    if (given.ambient != usual.ambient)
        throw bad_input(
            fmt::format("--ambient {0}: is of {1}; a model takes the index in front as --fix n_i={0}",
                        given.ambient, of));
    if (given.space != usual.space)
        throw bad_input(
            fmt::format("--space {}: is of {}; a model takes numbers of any linear space, as --fix "
                        "PARAM=R,G,B",
                        given.space, of));
}

} // namespace fresnel::cli
