#pragma once

#include <fresnel/material.hpp>

#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

// The readers of plain text: a user's CSV table, and the files of data/materials. Every error is a bad_input
// that begins with "FILE:LINE: " or "FILE:LINE:COLUMN: ".

/// The number that the whole text spells in decimal, with or without an exponent; nothing for any other text,
/// nor for one that is infinite or not a number.
std::optional<double> parse_number(std::string_view text);

/// Whether a text begins with a byte order mark of UTF-16.
bool begins_utf_16(std::string_view text);

/// What an index may be in a table, wider than what a model takes: published n of films and metamaterials are
/// below 0 and beyond 1000.
inline constexpr double largest_index = 1e4;

/// The text without white space at its ends.
std::string_view trimmed(std::string_view text);

/// The text in its pieces between white space.
std::vector<std::string_view> words(std::string_view text);

/// Calls `use(line, number)` for each line, numbered from 1, without its line ending.
void for_each_line(std::string_view text, const std::function<void(std::string_view, int)>& use);

/// The whole of a file as text.
///
/// throws bad_input where there is no such file, it is a folder or cannot be read, or it is above 16 MiB
std::string read_text_file(const std::string& path);

/// A table in increasing order of wavelength: rows out of order are sorted, rows of one wavelength averaged,
/// and each of the two is reported once in `diagnostics` under the name `what`.
samples sorted_samples(samples rows, std::string_view what, std::vector<std::string>& diagnostics);

/// A user's table: a header naming `wavelength_nm`, `n` and, if known, `k`, in any order, then numbers.
/// Lines that are empty or begin with # are skipped; rows may come in any order of wavelength.
///
/// file      what errors call the text
/// returns   a spectral material named `file`, its class guessed from n and k
/// throws    bad_input for a bad header, number, cell count, a repeated wavelength, n or k outside [0, 10000]
material read_csv_material(std::string_view csv, const std::string& file);

/// Where n and k are both known; where n is, if k is absent or known only elsewhere. The material has an n.
std::array<double, 2> known_range(const material& what);

/// The class that n and k at 550 nm suggest: metal (k > 1), semiconductor (n > 3), otherwise dielectric.
std::string guessed_class(const material& what);

/// A file of data/materials (its format: docs/materials.md).
///
/// throws bad_input for anything out of form
material read_material(std::string_view text, const std::string& file);

/// The rows of data/materials/index.csv or f0.csv: `name,aliases,class,lo,hi,licence,citation,quality`,
/// aliases separated by semicolons, a cell with a comma in double quotes.
///
/// kind     index or f0
/// throws   bad_input for anything out of form
std::vector<material> read_material_rows(std::string_view csv, material_kind kind, const std::string& file);

} // namespace fresnel
