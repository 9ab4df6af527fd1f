#pragma once

#include <fresnel/material.hpp>

#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

/// One entry of a page's DATA, as written.
///
/// type     "tabulated nk", "tabulated n", "tabulated k" or "formula 1" ... "formula 9"
/// text     the rows, wavelengths in micrometres, or the coefficients
/// range    the two ends of a formula's range in micrometres; empty for a table
/// line     where it begins in the file, counted from 1
struct page_block {
    std::string type, text, range;
    int line = 0;
};

/// A page of the refractiveindex.info database.
///
/// references, comments     plain text: HTML and Markdown marks taken away
/// doi                      of the first reference that has one
/// conditions, properties   key to text; entries that are not plain text are left out
/// n, k                     absent where the page gives none
/// diagnostics              what a careful reader should know: repeated wavelengths (averaged), rows out of
///                          order (sorted), negative n or k, poles inside a formula's range, an n or k that
///                          is given twice (the first counts)
struct page {
    std::string references, comments, doi;
    std::map<std::string, std::string> conditions, properties;
    std::vector<page_block> blocks;
    std::optional<spectrum> n, k;
    std::vector<std::string> diagnostics;
};

/// Reads the text of a page.
///
/// file     what errors call it
/// throws   bad_input "FILE:LINE: ..." for anything that is not a page: text that is not YAML, no DATA, a block
///          of an unknown type, a row with a wrong number of columns, a cell that is not a number ...
page read_page(std::string_view text, const std::string& file);

/// Reads a page from its file; throws bad_input, as above and for what cannot be read.
page read_page_file(const std::string& path);

/// The page as a material named after its file.
///
/// path     its path; the part after "data/" without ".yml" becomes `page`
/// throws   bad_input where the page has no n
material material_of(const page& source, const std::string& path);

/// A length in micrometres as nanometres, digit for digit: "0.1879" gives "187.9". The text must be a number.
std::string nanometres(std::string_view micrometres);

/// HTML and Markdown to plain text on one line: tags and emphasis marks go, links keep their text, entities
/// become characters, white space becomes single spaces.
std::string plain_text(std::string_view marked);

} // namespace fresnel
