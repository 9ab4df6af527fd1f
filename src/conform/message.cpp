#include "conform/message.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <optional>

namespace fresnel::conform {

namespace {

struct remark {
    int line;
    std::string text;
};

std::string_view trimmed(std::string_view text) {
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front())) != 0)
        text.remove_prefix(1);
    while (!text.empty() && std::isspace(static_cast<unsigned char>(text.back())) != 0)
        text.remove_suffix(1);
    return text;
}

std::optional<int> number_at(std::string_view text, std::size_t at) {
    int value = 0;
    const auto [end, error] =
        std::from_chars(text.data() + std::min(at, text.size()), text.data() + text.size(), value);
    return error == std::errc{} && end != text.data() ? std::optional(value) : std::nullopt;
}

// "0:3(12): error: `foo' undeclared"
std::optional<remark> by_mesa(std::string_view line) {
    const std::size_t error = line.find("): error: ");
    if (!line.starts_with("0:") || error == std::string_view::npos) return std::nullopt;
    const auto number = number_at(line, 2);
    if (!number) return std::nullopt;
    std::string text(trimmed(line.substr(error + 10)));
    std::replace(text.begin(), text.end(), '`', '\'');
    return remark{*number, text};
}

// "ERROR: shader.hlsl:3: 'foo' : unknown variable", "ERROR: 0:3: ..."
std::optional<remark> by_glslang(std::string_view line) {
    if (!line.starts_with("ERROR: ")) return std::nullopt;
    const std::size_t colon = line.find(':', 7);
    if (colon == std::string_view::npos) return std::nullopt;
    const auto number = number_at(line, colon + 1);
    const std::size_t end = line.find(": ", colon + 1);
    if (!number || end == std::string_view::npos) return std::nullopt;
    return remark{*number, std::string(trimmed(line.substr(end + 2)))};
}

// "error: no definition in scope for identifier: `foo`" and, on a later line, "wgsl:3:12" or "shader.wgsl:3:12"; its
// validator adds why, on lines that begin with "=".
std::optional<remark> by_naga(std::string_view said) {
    const std::size_t error = said.find("error: "), place = said.find("wgsl:");
    if (error == std::string_view::npos || place == std::string_view::npos) return std::nullopt;
    const auto number = number_at(said, place + 5);
    if (!number) return std::nullopt;
    const std::string_view rest = said.substr(error + 7);
    std::string text(trimmed(rest.substr(0, rest.find('\n'))));
    for (std::size_t why = rest.find("\n  = "); why != std::string_view::npos;
         why = rest.find("\n  = ", why + 1))
        text += fmt::format(": {}", trimmed(rest.substr(why + 5, rest.find('\n', why + 1) - why - 5)));
    return remark{*number, text};
}

std::optional<remark> first_remark(std::string_view said) {
    for (std::string_view rest = said; !rest.empty();) {
        const std::size_t end = std::min(rest.find('\n'), rest.size());
        const std::string_view line = trimmed(rest.substr(0, end));
        if (auto found = by_mesa(line)) return found;
        if (auto found = by_glslang(line)) return found;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return by_naga(said);
}

} // namespace

std::string compiler_message(std::string_view file, std::string_view text, std::string_view said) {
    const auto found = first_remark(said);
    if (!found) {
        const std::string_view first = trimmed(said);
        return fmt::format("{}: its compiler refuses it: {}", file, first.substr(0, first.find('\n')));
    }
    const auto lines = 1 + std::count(text.begin(), text.end(), '\n');
    if (found->line > lines)
        return fmt::format("{}: its end, or the call of its function: {}", file, found->text);
    return fmt::format("{}:{}: {}", file, found->line, found->text);
}

} // namespace fresnel::conform
