#pragma once

#include <string_view>
#include <vector>

namespace fresnel {

/// The text of a file that the build embedded, or an empty view if there is no such file.
///
/// `path` is relative to the repository's `data/` folder, with forward slashes: "cie/d65.csv". The
/// text is byte for byte that of the file and lives as long as the programme.
std::string_view embedded_data(std::string_view path);

/// The paths of all embedded files that begin with `prefix`, sorted; every path for an empty prefix.
std::vector<std::string_view> embedded_names(std::string_view prefix);

} // namespace fresnel
