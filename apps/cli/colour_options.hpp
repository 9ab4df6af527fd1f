#pragma once

#include <fresnel/color.hpp>

#include <CLI/CLI.hpp>

#include <string>

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

} // namespace fresnel::cli
