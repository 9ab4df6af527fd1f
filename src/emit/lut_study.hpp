#pragma once

#include "emit/lut.hpp"
#include "figure/figure.hpp"

#include <string>
#include <vector>

namespace fresnel::emit {

/// The largest error of one map in one format, for tables of several sizes.
struct lut_study_row {
    const lut_map* map;
    texel_format format;
    std::vector<lut_error> error; ///< of each size
};

/// 16, 32, 64 and, with one axis, 256 texels.
std::vector<std::size_t> studied_sizes(const lut_subject& subject);

/// Every map and every texture format at those sizes; a table with a second axis has as many rows as columns. Beyond
/// a critical angle sqrt-cos counts from there, and cos is what it would be.
std::vector<lut_study_row> study_lut(const lut_subject& subject, const std::vector<std::size_t>& sizes);

/// The same for the usual sizes as text, a line for each map and format.
std::string study_text(const lut_subject& subject);

/// The largest error against the number of texels, a curve for each map. For tables of one row.
figure lut_figure(const lut_subject& subject, const std::string& id);

} // namespace fresnel::emit
