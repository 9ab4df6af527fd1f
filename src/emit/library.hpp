#pragma once

#include "emit/printer.hpp"

#include <span>
#include <string>
#include <string_view>

namespace fresnel::emit {

/// What `fresnel shader MODEL` prints of a model.
struct model_request {
    std::string model;
    fixed_values fixed = {}; ///< parameters that are constants
    std::string name = {};   ///< of the function; the model's own if empty
    std::string error = {};  ///< said above it in place of the registry's error
    std::string about = {};  ///< where the constants are from
};

/// A model in one language, ready to be pasted: the scalar function, the same for three channels that share the
/// angle, both with two directions in place of cos_i, and of an exact model the reflectances and transmittances of
/// both polarisations. Throws bad_input as `record` does.
std::string model_text(const language& l, const model_request& wanted, const style& how = {});

/// The model's function of one width alone, with what it calls, and how it is called.
struct sole_function {
    std::string text, name;
    std::vector<argument> arguments; ///< without cos_i
    int width;                       ///< of its result
};

/// For `width` 3 with RGB parameters, if the model has any that are not fixed; fixed colours give three in any case.
sole_function sole_text(const language& l, const model_request& wanted, int width);

/// Everything that the model_text of these models needs before it: what the text is and its conventions, the cosine of
/// two directions, and boundary_type and twofold_text where a model needs them. Several texts may be pasted into one
/// file, which reads these once, but in WGSL, which has no preprocessor: one module, one text.
std::string preamble(const language& l, std::string_view made_by, std::span<const model_request> models,
                     const style& how = {});

/// The functions of record_twofold, and their type where the language has none of two numbers.
std::string twofold_text(const language& l, const style& how = {});

/// The same where the model calls them, otherwise nothing.
std::string twofold_text_for(const language& l, const model_request& wanted, const style& how = {});

/// The library file of a language: every model of the registry, and the geometry around them.
std::string library_text(const language& l);

/// The model's function for one number, alone but for what it calls: the text that is compared with the model bit by bit.
std::string scalar_text(const language& l, const model_request& wanted, const style& how = {});

/// The same for three channels, alone; some of them call the scalar function, which must stand before. Empty where no
/// parameter has channels.
std::string channels_text(const language& l, const model_request& wanted, const style& how = {});

/// Of an exact model the function of R_s, R_p, T_s and T_p, alone, and the type that it returns.
std::string boundary_text(const language& l, const model_request& wanted, const style& how = {});
std::string boundary_type(const language& l);

} // namespace fresnel::emit
