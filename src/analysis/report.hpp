#pragma once

#include "analysis/compare.hpp"

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace fresnel {

/// A material and what was found out about it; the material itself is needed for the surface over wavelength.
struct report_entry {
    material substance;
    comparison result;
};

/// report.json: {materials: [...]}.
nlohmann::json report_json(const std::vector<report_entry>& entries);

/// Makes the folder if it is not there and makes sure that files can be written into it.
/// Throws bad_input naming the folder where they cannot.
void require_writable_folder(const std::string& argument, const std::string& dir);

/// Writes dir/report.json, dir/figures/*.svg and *.png, and last dir/index.html, one file that needs no other.
/// Throws failure naming the file that could not be written.
void write_report(const std::vector<report_entry>& entries, const std::string& dir);

} // namespace fresnel
