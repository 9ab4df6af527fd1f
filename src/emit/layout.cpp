#include "emit/layout.hpp"

#include <fmt/format.h>

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

} // namespace

std::string comment_block(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line.empty() ? "//\n" : fmt::format("// {}\n", line);
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

} // namespace fresnel::emit
