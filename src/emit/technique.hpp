#pragma once

#include "emit/library.hpp"
#include "emit/program.hpp"

#include <span>
#include <string>
#include <string_view>

namespace fresnel::emit {

/// A way in which a program applies a reflectance.
struct technique {
    std::string_view name;
    std::string_view summary;
};

/// none, one-minus-cos, per-vertex, per-pixel and lut, which lerp a lit base and a mirrored environment; highlights
/// and semitransparent, which light a surface by Phong's lobe.
std::span<const technique> techniques();

/// Throws bad_input naming the techniques.
const technique& find_technique(std::string_view name);

/// The stage "vertex" or "fragment", both for an empty name; throws bad_input.
stage find_stage(std::string_view name);

/// The name that the function of a model gets in a program: the wanted one as far as the language and what the program
/// declares allow, empty where none is wanted and the model's is free.
std::string name_in_program(const dialect& d, const model_request& wanted);

/// A complete vertex and fragment program that uses a model by a technique: head, declarations, the functions needed
/// and both entry points. GLSL has a text for each stage, one after the other under a rule; the others have one.
///
/// The parameters of the model that are not fixed are uniforms, RGB where the model is not of dielectrics alone.
///
/// made_by   the command, for the head
/// throws    bad_input as `record` does
std::string technique_text(const dialect& d, const technique& how, const model_request& wanted, stage stages,
                           std::string_view made_by);

} // namespace fresnel::emit
