#pragma once

#include "emit/language.hpp"
#include "emit/lut.hpp"

#include <string>

namespace fresnel::emit {

/// What stands in a table's text beside its numbers.
struct lut_names {
    std::string function = {}; ///< empty: the subject's name with _lut
    std::string made_by = {};  ///< the command, for the comment
    std::string file = {};     ///< that holds the table; empty: none was written
};

/// The function that reads the table, with a comment of what the table holds, how it must be bound, and its error.
/// `id` is a language's, or cg: HLSL with the samplers of shader models 2 and 3, and of Cg. C99 is `lut_header`'s and
/// refused here.
std::string sampler_text(std::string_view id, const lut& table, const lut_names& names);

/// A C99 header: the table as an array and the function that interpolates it.
std::string lut_header(const lut& table, const lut_names& names);

/// The table as a PNG of 8 or 16 bits (r8, r16), of one channel or three, or as an OpenEXR picture (r16f, rgba32f):
/// the first texel of the first row is cos_i = 0 and the low end of the second axis. Linear numbers, no colour
/// encoding; the caption and the error stand in the file as text.
std::string lut_image(const lut& table, const lut_names& names);

/// "max 0.0021 at cos_i = 0.13 (82.5 degrees), rms 0.0006".
std::string error_text(const lut& table);

} // namespace fresnel::emit
