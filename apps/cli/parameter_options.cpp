#include "parameter_options.hpp"

#include "commands.hpp"

#include "analysis/model_table.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fresnel::cli {

void add_parameters(CLI::App& command, parameter_texts& given) {
    for (const model_row<double>& row : model_table<double>())
        for (const parameter& p : row.parameters) {
            const std::string name(p.name);
            std::string dashed = name;
            std::replace(dashed.begin(), dashed.end(), '_', '-');
            if (command.get_option_no_throw("--" + dashed) != nullptr) continue; // of an earlier model
            const std::string flags = dashed == name ? "--" + name : "--" + dashed + ",--" + name;
            command
                .add_option_function<std::string>(
                    flags, [&given, name](const std::string& text) { given[name] = text; },
                    fmt::format("in [{}, {}]", p.min, p.max))
                ->type_name("X")
                ->group("Parameters (see `fresnel models`)");
        }
}

std::vector<double> parse_list(std::string_view argument, std::string_view text) {
    std::vector<double> values;
    const auto pieces = [&](char separator) {
        std::vector<double> numbers;
        for (std::size_t begin = 0; begin <= text.size();) {
            const std::size_t end = std::min(text.find(separator, begin), text.size());
            numbers.push_back(parse_number(argument, text.substr(begin, end - begin)));
            begin = end + 1;
        }
        return numbers;
    };
    if (text.find(':') == std::string_view::npos) return pieces(',');
    const std::vector<double> range = pieces(':');
    if (range.size() != 3 || !(range[2] >= 2 && range[2] <= 1e7) || range[2] != std::floor(range[2]))
        throw bad_input(fmt::format(
            "{} = '{}': must be FROM:TO:COUNT with COUNT a whole number in [2, 10000000]", argument, text));
    const auto count = static_cast<std::size_t>(range[2]);
    for (std::size_t i = 0; i < count; ++i) {
        const double t = static_cast<double>(i) / static_cast<double>(count - 1);
        const auto [least, most] = std::minmax(range[0], range[1]);
        values.push_back(std::clamp(range[0] * (1 - t) + range[1] * t, least, most)); // rounding stays inside
    }
    return values;
}

void add_fixed(const std::string& text, emit::fixed_values& fixed) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw bad_input(fmt::format("--fix '{}': must be PARAMETER=VALUE or PARAMETER=R,G,B", text));
    const std::string name = text.substr(0, equals);
    if (fixed.contains(name)) throw bad_input(fmt::format("--fix '{}': {} is fixed already", text, name));
    std::vector<double> values;
    for (std::size_t from = equals + 1; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        values.push_back(
            parse_number(fmt::format("--fix {}", name), std::string_view(text).substr(from, comma - from)));
        from = comma + 1;
    }
    if (values.size() != 1 && values.size() != 3)
        throw bad_input(fmt::format("--fix '{}': has {} values, must have 1 or 3", text, values.size()));
    fixed[name] = values.size() == 1 ? std::array{values[0], values[0], values[0]}
                                     : std::array{values[0], values[1], values[2]};
}

} // namespace fresnel::cli
