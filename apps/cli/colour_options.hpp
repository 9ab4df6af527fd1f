#pragma once

#include <fresnel/color.hpp>

#include <CLI/CLI.hpp>

#include <string>
#include <string_view>

namespace fresnel::cli {

/// The options of commands that make colours, as text until `chosen_...` checks them.
struct colour_options {
    std::string space = "srgb";
    std::string ambient = "1";
};

void add_colour_options(CLI::App& command, colour_options& given);

/// Throws bad_input naming the value and what is allowed.
color_space chosen_space(const colour_options& given);
double chosen_ambient(const colour_options& given);

/// The options that are not the usual ones, as they are typed: " --space acescg --ambient 1.333".
std::string colour_arguments(const colour_options& given);

/// Throws bad_input naming the option that is not the usual one: there is no material to take it.
///
/// of   what takes it: "a --material", "a material"
void refuse_colours(const colour_options& given, std::string_view of);

} // namespace fresnel::cli
