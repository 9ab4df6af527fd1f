#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

/// What one more evaluation of a model costs on a graphics processor, as a compiler for it reckons. Parameters and
/// cos_i differ from evaluation to evaluation. A number that the tool does not give is NaN.
struct cost_row {
    std::string model;
    std::string gpu;   ///< as its compiler calls it: navi21, sm_86, ps_3_0
    std::string stage; ///< vertex, fragment or compute
    std::string n_i;   ///< "1", or "free" where it is a parameter like the others; empty: the model has none
    double instructions;       ///< more in the program
    double latency;            ///< cycles from the inputs to the result
    double inverse_throughput; ///< cycles that a unit is busy
    double registers;          ///< vector registers alive at once, of a program that evaluates once
    std::string tool, version;
};

/// The measured table, data/cost.csv; made by scripts/cost.
const std::vector<cost_row>& cost_table();

/// The row of a model with n_i = 1, or nullptr.
const cost_row* find_cost(std::string_view model, std::string_view gpu = "navi21",
                          std::string_view stage = "fragment");

/// Rows of CSV text with the header of data/cost.csv. Throws failure naming the line that has another shape.
std::vector<cost_row> read_costs(std::string_view csv);

/// The CSV text of rows, numbers rounded to hundredths as they are in data/cost.csv.
std::string to_csv(std::span<const cost_row> rows);

} // namespace fresnel
