#pragma once

#include "emit/function.hpp"

#include <CLI/CLI.hpp>

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::cli {

/// The model parameters that were given, by registry name, as text until a model takes them.
using parameter_texts = std::map<std::string, std::string>;

/// An option for every parameter of the registry: --n-t X or --n_t X, and so on.
void add_parameters(CLI::App& command, parameter_texts& given);

/// "A", "A,B,C" or "FROM:TO:COUNT", both ends included. Throws bad_input naming the argument.
std::vector<double> parse_list(std::string_view argument, std::string_view text);

/// A constant of --fix, "f0=0.04", or "f0=1,0.78,0.34" for a value per channel, put among the others. Throws bad_input.
void add_fixed(const std::string& text, emit::fixed_values& fixed);

} // namespace fresnel::cli
