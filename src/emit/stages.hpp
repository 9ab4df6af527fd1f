#pragma once

#include "emit/library.hpp"
#include "emit/program.hpp"

#include <string>
#include <string_view>

namespace fresnel::emit {

/// A model as a program calls it.
struct reflectance {
    sole_function f;
    shape type;
};

/// What the programs may use, of which each text holds what its stages did use.
void declare_inputs(program& p);
void declare_textures(program& p);
void declare_functions(program& p);

/// The model with its free parameters as uniforms.
reflectance declare_model(program& p, const model_request& wanted);

/// The vertex and the fragment stage of each technique (techniques()); `how` is none, one-minus-cos or per-pixel.
void at_pixels(program& p, const reflectance& model, std::string_view how);
void at_vertices(program& p, const reflectance& model);
/// `rows` is the parameter that the rows of the table stand for, if any; `type` is scalar for a table of one channel.
void from_a_table(program& p, const std::string& rows, shape type);
void highlights(program& p, const reflectance& model);
void semitransparent(program& p, const reflectance& model);

} // namespace fresnel::emit
