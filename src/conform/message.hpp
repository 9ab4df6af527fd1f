#pragma once

#include <string>
#include <string_view>

namespace fresnel::conform {

/// The first thing a compiler says of somebody's text, as one line: "fresnel.glsl:3: 'foo' undeclared". Of Mesa, glslang
/// or naga; lines are those of the text. What concerns lines behind its end is our call of it, and said so.
std::string compiler_message(std::string_view file, std::string_view text, std::string_view said);

} // namespace fresnel::conform
