#pragma once

#include <fresnel/types/sym.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::emit {

/// How a language writes the choice between two values.
enum class choice_style {
    ternary, ///< m ? a : b
    select   ///< select(b, a, m)
};

/// How a language makes a struct.
enum class struct_style {
    constructor, ///< return fresnel_boundary(R_s, ...);
    initializer, ///< fresnel_boundary b = {R_s, ...}; return b;
    members      ///< fresnel_boundary b; b.R_s = R_s; ... return b;
};

/// What a printer must know of a language. Text that is empty is not there in the language.
struct language {
    std::string_view id;        ///< as `--lang` takes it
    std::string_view title;     ///< as a reader knows it
    std::string_view extension; ///< of a library file, without the dot
    std::string_view scalar;    ///< its float
    std::string_view triple;    ///< its RGB value
    std::string_view vector;    ///< its direction; often the same type
    std::string_view pair;      ///< two numbers, x and y
    std::string_view mask;      ///< three truth values; none: a choice is made component by component
    std::string_view qualifier; ///< before a function
    std::string_view literal_suffix;
    choice_style choice;
    struct_style structs;
    bool overloads;           ///< functions may share a name
    bool arithmetic;          ///< + - * / work on three values at once
    bool typed_names;         ///< name: type, as in WGSL
    bool has_saturate;        ///< saturate(x) limits to [0, 1]
    std::string_view swizzle; ///< how the components of three values are reached: "xyz", or "[]"

    /// The function of an operation: "sqrt", "fmaxf" ...
    std::string_view name_of(operation op) const;
    /// Whether - works on two numbers at once.
    bool pair_arithmetic() const { return arithmetic && !pair.starts_with("fresnel"); }
    /// The declared type of a value.
    std::string_view type(int width, bool direction = false) const {
        return width == 1 ? scalar : width == 2 ? pair : direction ? vector : triple;
    }
};

/// GLSL, GLSL ES, HLSL, MSL, WGSL, OSL, CUDA and HIP, C99 and Slang.
std::span<const language> languages();

/// The language of that id, or Godot's "gdshader", which has an engine pack in place of a library file; throws bad_input
/// with the nearest one where there is none.
const language& find_language(std::string_view id);

/// The words that legal_name changes in that language.
std::vector<std::string> reserved_words(const language& l);

/// A name that the language accepts, as near to the one given as can be: reserved words and the names of built-in
/// functions get a trailing underscore, what no identifier may hold is dropped.
std::string legal_name(const language& l, std::string_view name);

/// The same for a function that a user names: not one of the names that the text around it declares either.
std::string function_name(const language& l, std::string_view name);

} // namespace fresnel::emit
