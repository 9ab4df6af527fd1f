#pragma once

#include "emit/function.hpp"
#include "emit/language.hpp"
#include "emit/layout.hpp"

#include <string>

namespace fresnel::emit {

/// How a function is printed beside its language.
struct style {
    bool precise = false; ///< GLSL 4 and HLSL 5: forbid the compiler to rearrange, for comparisons bit by bit
    bool comment = true;
};

/// The shortest decimal that reads back as the same float, as a literal of the language; never an integer.
std::string literal(const language& l, float value);

/// A function's head: qualifier, type, name and arguments, up to the brace.
std::string signature(const language& l, const function& f, const std::string& name);

/// Its comment, head and body. Nodes that `let` named and nodes used more than once become local variables, in the order
/// of the model; the rest is written where it is used, with the parentheses it needs and no others.
std::string print(const language& l, const function& f, const style& how = {});

/// A call of a function with the given texts as arguments.
std::string call(const std::string& name, const std::vector<std::string>& arguments);

/// The function's name under which it is printed in that language: its own, made legal, with a suffix where names
/// cannot be shared.
std::string printed_name(const language& l, const std::string& name, int width, bool directions);

/// The name of one of its arguments in the text: its own, made legal, and never the function's.
std::string argument_name(const language& l, const function& f, std::string_view name);

/// How component i of a triple is written.
std::string component(const language& l, std::string_view name, int i);

/// Two texts as a pair, and three as a triple.
std::string pair_of(const language& l, const std::string& x, const std::string& y);
std::string triple_of(const language& l, const std::vector<std::string>& three, bool direction = false);

} // namespace fresnel::emit
