#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace fresnel::emit {

inline constexpr std::size_t longest_line = 110;

/// The same text with long lines broken, but for directives and lines with a comment.
std::string wrapped_lines(const std::string& text);

/// Lines as comments.
std::string comment_block(const std::vector<std::string>& lines);

} // namespace fresnel::emit
