#pragma once

#include "analysis/model_table.hpp"

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// Each command adds itself to the application: its options, its help with examples, and what it does when
// chosen. A command throws bad_input or failure (error.hpp); main prints them.

namespace fresnel::cli {

void add_models(CLI::App& app);
void add_eval(CLI::App& app);
void add_materials(CLI::App& app);
void add_f0(CLI::App& app);
void add_compare(CLI::App& app);
void add_angles(CLI::App& app);
void add_figures(CLI::App& app);
void add_claims(CLI::App& app);
void add_convert(CLI::App& app);
void add_prove(CLI::App& app);
void add_identify(CLI::App& app);
void add_plot(CLI::App& app);
void add_shader(CLI::App& app);
void add_lut(CLI::App& app);
void add_conform(CLI::App& app);
void add_cost(CLI::App& app);

/// A command with its one-line description and the examples that end its help.
CLI::App* add_command(CLI::App& app, const std::string& name, const std::string& description,
                      const std::string& examples);

/// Says something on standard error. What does not arrive there changes nothing else.
template <class... T>
void say(fmt::format_string<T...> text, T&&... values) {
    const std::string message = fmt::format(text, std::forward<T>(values)...);
    std::fwrite(message.data(), 1, message.size(), stderr);
}

/// Prints JSON, two spaces deep, numbers in the fewest digits that read back as the same double.
void print_json(const nlohmann::json& value);

/// Names and their values as a JSON object.
nlohmann::json object(const std::vector<std::pair<std::string, double>>& values);

/// A number, null where there is none.
inline nlohmann::json or_null(const std::optional<double>& value) {
    return value ? nlohmann::json(*value) : nlohmann::json();
}

/// Prints a line without the blanks at its end.
void print_trimmed(std::string line);

/// Prints a row of a table, as fmt::print does but without the blanks behind its last cell, and ends the line.
template <class... T>
void print_row(fmt::format_string<T...> row, T&&... cells) {
    print_trimmed(fmt::format(row, std::forward<T>(cells)...));
}

/// Whether standard output is a terminal that wants colours (NO_COLOR is unset).
bool colours_wanted();

/// Decimal text to float or double, beyond their ranges infinity and 0. False for what is no number.
template <class T>
bool read_number(std::string_view text, T& value) {
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error == std::errc::result_out_of_range)
        value = static_cast<T>(std::strtod(std::string(text).c_str(), nullptr));
    return error != std::errc::invalid_argument && end == text.data() + text.size();
}

/// A number of the user's: decimal text to double. Throws bad_input naming the argument.
double parse_number(std::string_view argument, std::string_view text);

/// The same within the limits of a parameter, by its name.
double parse_parameter(const parameter& p, std::string_view text);

/// An argument as it is typed in a shell: as it is, or in quotes.
std::string shell_word(std::string_view text);

} // namespace fresnel::cli
