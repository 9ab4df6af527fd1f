#include "analysis/cost_table.hpp"

#include "error.hpp"
#include "materials/embedded.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <limits>

namespace fresnel {

namespace {

constexpr std::string_view header =
    "model,gpu,stage,n_i,instructions,latency,inverse_throughput,registers,tool,version";

std::vector<std::string> cells_of(std::string_view line) {
    std::vector<std::string> cells;
    for (std::size_t from = 0; from <= line.size();) {
        const std::size_t comma = std::min(line.find(',', from), line.size());
        cells.emplace_back(line.substr(from, comma - from));
        from = comma + 1;
    }
    return cells;
}

double number_of(const std::string& cell, std::size_t line) {
    if (cell.empty()) return std::numeric_limits<double>::quiet_NaN();
    double value = 0;
    const auto [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), value);
    if (error != std::errc{} || end != cell.data() + cell.size())
        throw failure(fmt::format("cost table, line {}: '{}' is not a number", line, cell));
    return value;
}

// Hundredths; nothing for a number that is not known.
std::string cell_of(double value) {
    return std::isnan(value) ? "" : fmt::format("{:g}", std::round(100 * value) / 100 + 0.0);
}

} // namespace

std::vector<cost_row> read_costs(std::string_view csv) {
    std::vector<cost_row> rows;
    std::size_t line = 0;
    while (!csv.empty()) {
        const std::size_t end = std::min(csv.find('\n'), csv.size());
        const std::string_view text = csv.substr(0, end);
        csv.remove_prefix(std::min(end + 1, csv.size()));
        ++line;
        if (text.empty() || text.front() == '#' || text == header) continue;
        const std::vector<std::string> c = cells_of(text);
        if (c.size() != 10)
            throw failure(fmt::format("cost table, line {}: has {} cells, must have 10", line, c.size()));
        rows.push_back({c[0], c[1], c[2], c[3], number_of(c[4], line), number_of(c[5], line),
                        number_of(c[6], line), number_of(c[7], line), c[8], c[9]});
    }
    return rows;
}

std::string to_csv(std::span<const cost_row> rows) {
    std::string text = fmt::format("{}\n", header);
    for (const cost_row& r : rows)
        text += fmt::format("{},{},{},{},{},{},{},{},{},{}\n", r.model, r.gpu, r.stage, r.n_i,
                            cell_of(r.instructions), cell_of(r.latency), cell_of(r.inverse_throughput),
                            cell_of(r.registers), r.tool, r.version);
    return text;
}

const std::vector<cost_row>& cost_table() {
    static const std::vector<cost_row> rows = read_costs(embedded_data("cost.csv"));
    return rows;
}

const cost_row* find_cost(std::string_view model, std::string_view gpu, std::string_view stage) {
    for (const cost_row& row : cost_table())
        if (row.model == model && row.gpu == gpu && row.stage == stage && row.n_i != "free") return &row;
    return nullptr;
}

} // namespace fresnel
