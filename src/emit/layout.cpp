#include "emit/layout.hpp"

#include <fmt/format.h>

#include <cctype>

namespace fresnel::emit {

namespace {

// Where a line that is too long is broken: behind a comma or a sign, as few brackets deep as can be, as late as fits.
std::size_t line_break(std::string_view line, std::size_t from, std::size_t longest) {
    std::size_t best = std::string_view::npos;
    int depth = 0, best_depth = 0;
    for (std::size_t i = 0; i + 2 < std::min(line.size(), longest); ++i) {
        if (line[i] == '(' || line[i] == '{') ++depth;
        if (line[i] == ')' || line[i] == '}') --depth;
        if (i < from || line[i + 1] != ' ') continue;
        const bool sign =
            line[i - 1] == ' ' && std::string_view("+-?:=").find(line[i]) != std::string_view::npos;
        if (line[i] != ',' && !sign) continue;
        if (best == std::string_view::npos || depth <= best_depth) best = i + 2, best_depth = depth;
    }
    return best;
}

std::string wrapped(std::string line) {
    const std::size_t indent = line.find_first_not_of(' ');
    std::string text;
    while (line.size() > longest_line) {
        const std::size_t at = line_break(line, indent + 24, longest_line);
        if (at == std::string::npos) break;
        text += line.substr(0, at - 1) + "\n";
        line = std::string(indent + 8, ' ') + line.substr(at);
    }
    return text + line;
}

// Where what a line says begins: behind the word in front of it, "data    gold", or behind its indentation.
std::size_t text_column(std::string_view line) {
    const std::size_t word = line.find_first_not_of(' ');
    const std::size_t gap = line.find("  ", word);
    return gap > 12 ? word : line.find_first_not_of(' ', gap);
}

// One line, which ends where it ends: names of files may hold ends of lines, and a backslash would go on with the next.
std::string comment_line(std::string line) {
    for (char& c : line)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';
    if (line.ends_with('\\')) line += '.';
    return line.empty() ? "//\n" : fmt::format("// {}\n", line);
}

// A long line on several, below each other. A command stays on one, to be copied.
std::string comment(std::string line) {
    constexpr std::size_t longest = 120 - std::string_view("// ").size();
    std::string text;
    while (line.size() > longest && line.find('`') == std::string::npos) {
        const std::size_t column = text_column(line), at = line.rfind(' ', longest);
        if (at == std::string::npos || at < column) break;
        text += comment_line(line.substr(0, at));
        line = std::string(column, ' ') + line.substr(at + 1);
    }
    return text + comment_line(std::move(line));
}

} // namespace

std::string comment_block(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += comment(line);
    return text;
}

std::string wrapped_lines(const std::string& text) {
    std::string result;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::string line = text.substr(from, end - from);
        const bool whole = line.starts_with("#") || line.find("//") != std::string::npos;
        result += (whole ? line : wrapped(line)) + "\n";
        from = end + 1;
    }
    return result;
}

std::string rule(std::string_view title) {
    return fmt::format("// ---- {} {}\n\n", title, std::string(104 - title.size(), '-'));
}

std::string guarded(std::string name, const std::string& text) {
    for (char& c : name)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    return fmt::format("#ifndef {0}\n#define {0}\n\n{1}\n#endif\n", name, text);
}

} // namespace fresnel::emit
