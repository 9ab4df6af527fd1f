#pragma once

#include <fresnel/material.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

/// Every built-in material: the spectral ones, then the table rows. Read from the embedded data on the first
/// call (a few milliseconds), in alphabetical order of name within each kind. Safe to call from any thread.
const std::vector<material>& builtin_materials();

/// The built-in material of that name, alias or refractiveindex.info page, whatever the case; nullptr if
/// there is none. The pointer stays valid.
const material* find_material(std::string_view name);

/// A built-in material, or one read from a file: a path ending in .yml is a refractiveindex.info page, one
/// ending in .csv a table `wavelength_nm,n,k`.
///
/// throws bad_input where there is no such material (with the nearest name) or the file cannot be used
material load_material(const std::string& name_or_path);

/// The name of a kind: "spectral", "index" or "f0".
std::string_view name_of(material_kind kind);

} // namespace fresnel
