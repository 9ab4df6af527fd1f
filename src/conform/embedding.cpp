#include "conform/embedding.hpp"

#include "conform/signature.hpp"
#include "materials/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

namespace fresnel::conform {

namespace {

/// What is handed on between stages, and what may stand beside it.
constexpr std::array handed_on = {"in", "out", "varying", "attribute"};
constexpr std::array beside = {"layout", "flat",  "smooth",   "noperspective",
                               "sample", "patch", "centroid", "invariant"};

std::size_t word_end(std::string_view code, std::size_t at) {
    while (at < code.size() && is_word(code[at]))
        ++at;
    return at;
}

// Behind the bracket that closes the first one from there on; the end of the code where there is none.
std::size_t behind_brackets(std::string_view code, std::size_t at) {
    int depth = 0;
    for (at = std::min(code.find_first_of("([{", at), code.size()); at < code.size(); ++at) {
        const bool opens = code[at] == '(' || code[at] == '[' || code[at] == '{';
        const bool closes = code[at] == ')' || code[at] == ']' || code[at] == '}';
        depth += opens ? 1 : closes ? -1 : 0;
        if (depth == 0) return at + 1;
    }
    return code.size();
}

void blank(std::string& text, std::size_t from, std::size_t to) {
    for (; from < std::min(to, text.size()); ++from)
        if (text[from] != '\n') text[from] = ' ';
}

// Blanks #version, for ours counts, and #extension; gives the latter, each with the number of its line.
std::string take_directives(std::string& text) {
    std::string extensions;
    std::size_t begin = 0;
    for (int number = 1; begin < text.size(); ++number) {
        const std::size_t end = std::min(text.find('\n', begin), text.size());
        const std::string_view line = trimmed(std::string_view(text).substr(begin, end - begin));
        const std::string directive(line.starts_with('#') ? trimmed(line.substr(1)) : "");
        if (directive.starts_with("extension"))
            extensions += fmt::format("#line {}\n#{}\n", number, directive);
        if (directive.starts_with("extension") || directive.starts_with("version")) blank(text, begin, end);
        begin = end + 1;
    }
    return extensions;
}

void blank_body_of_main(std::string& text) {
    const std::string code = bare_code(text);
    for (std::size_t at = 0; at < code.size(); ++at) {
        const std::size_t end = word_end(code, at);
        if (code.compare(at, end - at, "main") == 0) {
            const std::size_t body =
                std::min(code.find_first_of("{;", behind_brackets(code, end)), code.size());
            if (body < code.size() && code[body] == '{')
                blank(text, body + 1, behind_brackets(code, body) - 1);
        }
        at = std::max(at, end);
    }
}

// Declarations as "layout(location = 0) flat in vec3 a;" lose all before the type; blocks of them go.
void make_plain(std::string& text) {
    struct range {
        std::size_t begin, end;
    };
    const std::string code = bare_code(text);
    std::vector<range> qualifiers; // of the declaration so far
    bool wanted = false;
    for (std::size_t at = 0; at < code.size(); ++at) {
        if (is_word(code[at])) {
            const std::size_t end = word_end(code, at);
            const std::string_view word = std::string_view(code).substr(at, end - at);
            wanted = wanted || holds(handed_on, word);
            if (word == "layout")
                qualifiers.push_back({at, behind_brackets(code, end)});
            else if (holds(handed_on, word) || holds(beside, word))
                qualifiers.push_back({at, end});
            at = (word == "layout" ? qualifiers.back().end : end) - 1;
        } else if (code[at] == ';' || code[at] == '(' || code[at] == '{') {
            const std::size_t end = code[at] == ';' ? at + 1 : behind_brackets(code, at);
            if (wanted && code[at] == '{')
                qualifiers.push_back({qualifiers[0].begin, code.find(';', end) + 1});
            for (const range& q : qualifiers)
                if (wanted) blank(text, q.begin, q.end);
            qualifiers.clear(), wanted = false;
            at = end - 1;
        }
    }
}

} // namespace

embedded embed(std::string_view language, std::string_view text) {
    embedded result{"", std::string(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text)};
    if (language == "glsl") {
        result.extensions = take_directives(result.text);
        blank_body_of_main(result.text);
        make_plain(result.text);
    }
    result.text = without_main(result.text);
    return result;
}

std::string without_main(std::string_view code) {
    const std::string words = bare_code(code);
    std::string result;
    for (std::size_t at = 0; at < code.size();) {
        const std::size_t end = std::max(word_end(words, at), at + 1);
        const bool is_main = words.compare(at, end - at, "main") == 0;
        result += is_main ? "fresnel_their_main" : code.substr(at, end - at);
        at = end;
    }
    return result;
}

} // namespace fresnel::conform
