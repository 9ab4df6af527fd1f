#pragma once

#include <string>
#include <string_view>

namespace fresnel::conform {

/// Somebody's text, which may be a whole program, as a part of ours: without its byte order mark, its `main` called
/// otherwise, every line where it was. Of GLSL also without #version and the body of main, and what its stages hand on,
/// `in`, `out` and their like, as plain variables.
struct embedded {
    std::string
        extensions; ///< of GLSL, which stand before everything else: #extension lines with their numbers
    std::string text;
};

embedded embed(std::string_view language, std::string_view text);

/// Code in which `main` is called as `embed` calls it.
std::string without_main(std::string_view code);

} // namespace fresnel::conform
