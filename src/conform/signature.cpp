#include "conform/signature.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace fresnel::conform {

namespace {

constexpr std::array scalars = {"float", "half", "real", "fixed", "min16float", "min10float", "f32"};
constexpr std::array triples = {"vec3",        "float3", "half3",     "real3",      "fixed3",
                                "min16float3", "vec3f",  "vec3<f32>", "min10float3"};
constexpr std::array qualifiers = {"in",     "const",  "highp",   "mediump",         "lowp",
                                   "static", "inline", "precise", "nointerpolation", "uniform"};

int width_of(std::string_view type) { return holds(scalars, type) ? 1 : holds(triples, type) ? 3 : 0; }

bool is_space(char c) { return std::isspace(static_cast<unsigned char>(c)) != 0; }

std::string trimmed(std::string_view text) {
    while (!text.empty() && is_space(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && is_space(text.back()))
        text.remove_suffix(1);
    return std::string(text);
}

std::string without_spaces(std::string_view text) {
    std::string result;
    for (const char c : text)
        if (!is_space(c)) result += c;
    return result;
}

std::vector<std::string> split(std::string_view list) {
    std::vector<std::string> parts;
    int depth = 0;
    std::size_t from = 0;
    for (std::size_t i = 0; i <= list.size(); ++i) {
        if (i < list.size() && (list[i] == '<' || list[i] == '(')) ++depth;
        if (i < list.size() && (list[i] == '>' || list[i] == ')')) --depth;
        if (i < list.size() && (list[i] != ',' || depth > 0)) continue;
        if (const std::string part = trimmed(list.substr(from, i - from)); !part.empty())
            parts.push_back(part);
        from = i + 1;
    }
    return parts;
}

std::vector<std::string> words_of(std::string_view text) {
    std::vector<std::string> words;
    for (std::size_t i = 0; i < text.size();) {
        std::size_t end = i;
        while (end < text.size() && !is_space(text[end]))
            ++end;
        if (end > i) words.emplace_back(text.substr(i, end - i));
        i = end + 1;
    }
    return words;
}

// "in vec3 f0", "float3 f0 : TEXCOORD", "half u = 1"
signature::argument c_argument(std::string_view text) {
    signature::argument a{"", "", 0, false};
    for (const std::string& word : words_of(text.substr(0, text.find_first_of(":=")))) {
        if (word == "out" || word == "inout") a.out = true;
        if (word == "out" || word == "inout" || holds(qualifiers, word)) continue;
        (a.type.empty() ? a.type : a.name) = word;
    }
    a.width = width_of(a.type);
    return a;
}

signature::argument wgsl_argument(std::string_view text) {
    const std::size_t colon = std::min(text.find(':'), text.size());
    const std::string type = without_spaces(text.substr(std::min(colon + 1, text.size())));
    return {type, trimmed(text.substr(0, colon)), width_of(type), type.starts_with("ptr")};
}

// Calls found(name, type of the result, list of arguments, place of the name).
template <class Found>
void for_each_definition(std::string_view language, const std::string& text, Found&& found) {
    for (std::size_t open = text.find('('); open != std::string::npos; open = text.find('(', open + 1)) {
        std::size_t end = open;
        while (end > 0 && is_space(text[end - 1]))
            --end;
        std::size_t begin = end;
        while (begin > 0 && is_word(text[begin - 1]))
            --begin;
        std::size_t word_end = begin;
        while (word_end > 0 && is_space(text[word_end - 1]))
            --word_end;
        std::size_t word = word_end;
        while (word > 0 && is_word(text[word - 1]))
            --word;
        const std::size_t close = text.find(')', open);
        if (begin == end || word == word_end || close == std::string::npos) continue;
        const std::string before = text.substr(word, word_end - word);
        const std::size_t body = text.find_first_of("{;", close);
        if (body == std::string::npos || text[body] != '{' || before == "return" || before == "else")
            continue;
        const std::string between = trimmed(std::string_view(text).substr(close + 1, body - close - 1));
        const bool definition = language == "wgsl" ? before == "fn" && between.starts_with("->")
                                                   : between.empty() || between.front() == ':';
        if (!definition) continue;
        found(text.substr(begin, end - begin),
              language == "wgsl" ? without_spaces(between.substr(2)) : before,
              std::string_view(text).substr(open + 1, close - open - 1), begin);
    }
}

} // namespace

std::string bare_code(std::string_view text) {
    std::string result(text);
    char inside = 0; // '/' a line comment, '*' a block comment, '#' a directive
    bool fresh = true;
    for (std::size_t i = 0; i < result.size(); ++i) {
        const std::string_view two = text.substr(i, 2);
        if (inside == 0 && (two == "//" || two == "/*")) inside = two[1];
        if (inside == 0 && fresh && text[i] == '#') inside = '#';
        if (text[i] == '\n') {
            if ((inside == '/' || inside == '#') && (i == 0 || text[i - 1] != '\\')) inside = 0;
            fresh = true;
            continue;
        }
        if (!is_space(text[i])) fresh = false;
        if (inside == 0) continue;
        result[i] = ' ';
        if (inside == '*' && two == "*/") result[++i] = ' ', inside = 0;
    }
    return result;
}

std::string signature::text(std::string_view language, std::string_view name) const {
    const bool wgsl = language == "wgsl";
    std::vector<std::string> list;
    for (const argument& a : arguments)
        list.push_back(wgsl ? fmt::format("{}: {}", a.name, a.type) : fmt::format("{} {}", a.type, a.name));
    if (wgsl) return fmt::format("fn {}({}) -> {}", name, fmt::join(list, ", "), result);
    return fmt::format("{} {}({})", result, name, fmt::join(list, ", "));
}

std::vector<signature> find_functions(std::string_view language, std::string_view text,
                                      std::string_view name) {
    const std::string code = bare_code(text);
    std::vector<signature> all;
    for_each_definition(
        language, code,
        [&](const std::string& found, const std::string& result, std::string_view list, std::size_t at) {
            if (found != name) return;
            signature s{result, width_of(result), {}, 0};
            for (const std::string& part : split(list))
                if (part != "void")
                    s.arguments.push_back(language == "wgsl" ? wgsl_argument(part) : c_argument(part));
            s.line = 1 + static_cast<int>(
                             std::count(code.begin(), code.begin() + static_cast<std::ptrdiff_t>(at), '\n'));
            all.push_back(s);
        });
    return all;
}

std::vector<std::string> function_names(std::string_view language, std::string_view text) {
    std::vector<std::string> names;
    for_each_definition(language, bare_code(text),
                        [&](const std::string& found, const std::string&, std::string_view, std::size_t) {
                            if (!holds(names, found)) names.push_back(found);
                        });
    return names;
}

} // namespace fresnel::conform
