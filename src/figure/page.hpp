#pragma once

#include <string>

namespace fresnel {

/// A self-contained page with the house's style, light or dark as the reader has it.
///
/// title   plain text
/// body    HTML
std::string html_page(const std::string& title, const std::string& body);

/// Makes the folder if it is not there and makes sure that files can be written into it.
/// Throws bad_input naming the folder where they cannot.
void require_writable_folder(const std::string& argument, const std::string& dir);

} // namespace fresnel
