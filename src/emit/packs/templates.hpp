#pragma once

#include "emit/pack.hpp"

#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

/// The text of a file that the build embedded, by its path from the root of the source tree; empty if there is none.
std::string_view embedded_template(std::string_view path);

/// The paths of those that begin with `prefix`, sorted.
std::vector<std::string_view> embedded_template_names(std::string_view prefix);

} // namespace fresnel

namespace fresnel::emit {

/// What stands for {{name}} in a template.
using placeholders = std::map<std::string, std::string>;

/// A text with its placeholders filled. Throws failure where a {{name}} has no value.
std::string filled(std::string_view text, const placeholders& values);

/// One template of src/emit/packs/templates, by its path under shaders/. Throws failure if there is none.
pack_file filled_template(std::string_view path, const placeholders& values);

/// Every template under a folder of src/emit/packs/templates, "unity/".
std::vector<pack_file> filled_templates(std::string_view folder, const placeholders& values);

/// The version of the packs and the text of the licence: what every template may use.
placeholders common_placeholders();

} // namespace fresnel::emit
