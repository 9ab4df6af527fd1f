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

/// Writes dir/report.json, dir/figures/*.svg and *.png, and dir/index.html, one file that needs no other.
/// Throws failure naming the file that could not be written.
void write_report(const std::vector<report_entry>& entries, const std::string& dir);

} // namespace fresnel
