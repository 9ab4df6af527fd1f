#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::emit {

inline constexpr std::size_t longest_line = 110;

/// The same text with long lines broken, but for directives and lines with a comment.
std::string wrapped_lines(const std::string& text);

/// Lines as comments, those that are too long broken at spaces.
std::string comment_block(const std::vector<std::string>& lines);

/// A line across the page with the title of what follows, and an empty one.
std::string rule(std::string_view title);

/// The same text between `#ifndef` and `#endif`, so that a file that holds it twice reads it once.
///
/// name   of the guard; letters become capitals
std::string guarded(std::string name, const std::string& text);

} // namespace fresnel::emit
