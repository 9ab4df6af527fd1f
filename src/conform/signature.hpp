#pragma once

#include <algorithm>
#include <cctype>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::conform {

/// Whether a name may hold it.
inline bool is_word(char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; }

template <class List>
bool holds(const List& list, std::string_view word) {
    return std::ranges::find(list, word) != std::ranges::end(list);
}

/// The text with comments and preprocessor lines as spaces, every character else where it was.
std::string bare_code(std::string_view text);

/// A function as somebody's text declares it.
struct signature {
    struct argument {
        std::string type, name;
        int width; ///< 1 of a float, 3 of a vec3, 0 of anything else
        bool out;  ///< written by the function
    };
    std::string result; ///< type
    int width;          ///< of the result, as above
    std::vector<argument> arguments;
    int line; ///< of its name

    std::string text(std::string_view language, std::string_view name) const;
};

/// Every definition of that name, overloads included, in the order of the text. `language` is glsl, hlsl or wgsl.
std::vector<signature> find_functions(std::string_view language, std::string_view text,
                                      std::string_view name);

/// The names of all functions that the text defines.
std::vector<std::string> function_names(std::string_view language, std::string_view text);

} // namespace fresnel::conform
