#pragma once

#include "figure/figure.hpp"

#include <string>
#include <string_view>

namespace fresnel::cli {

using figure_writer = std::string (*)(const figure&);

/// What turns a figure into a file of that ending: .svg, .png, .pdf, .csv or .json. Throws bad_input naming the
/// argument.
figure_writer writer_of(std::string_view argument, const std::string& path);

/// Throws bad_input where a file cannot be written at that path, before anything is computed for it.
void require_writable(std::string_view argument, const std::string& path);

} // namespace fresnel::cli
