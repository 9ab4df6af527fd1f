#pragma once

#include <algorithm>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fresnel {

/// A message with what would end it, the zero bytes of a file that is no text, written out.
inline std::string whole_message(std::string message) {
    for (std::size_t i = 0; (i = message.find('\0', i)) != std::string::npos;)
        message.replace(i, 1, "\\x00");
    return message;
}

/// What the user gave cannot be used: the message names the argument, its value and what is allowed.
/// The command prints it as one line, "fresnel: ...", and exits with 2.
struct bad_input : std::runtime_error {
    explicit bad_input(std::string message) : std::runtime_error(whole_message(std::move(message))) {}
};

/// Something that should have worked did not (an unwritable folder, a missing program).
/// The command prints it as one line, "fresnel: ...", and exits with 1.
struct failure : std::runtime_error {
    explicit failure(std::string message) : std::runtime_error(whole_message(std::move(message))) {}
};

/// Number of single-character edits that turn one word into another (Levenshtein distance).
inline std::size_t edit_distance(std::string_view from, std::string_view to) {
    std::vector<std::size_t> row(to.size() + 1);
    for (std::size_t j = 0; j <= to.size(); ++j)
        row[j] = j;
    for (std::size_t i = 1; i <= from.size(); ++i) {
        std::size_t diagonal = row[0];
        row[0] = i;
        for (std::size_t j = 1; j <= to.size(); ++j) {
            const std::size_t above = row[j];
            row[j] = std::min({row[j - 1] + 1, above + 1, diagonal + (from[i - 1] == to[j - 1] ? 0 : 1)});
            diagonal = above;
        }
    }
    return row[to.size()];
}

/// " (did you mean 'copper'?)" where a candidate is close to the word, otherwise "".
inline std::string did_you_mean(std::string_view word, std::span<const std::string> candidates) {
    std::size_t best = std::min(word.size() / 2, word.size() / 3 + 1) + 1;
    std::string_view nearest;
    for (const std::string& candidate : candidates) {
        const bool extends = word.size() >= 3 && candidate.starts_with(word);
        const std::size_t distance = extends ? 1 : edit_distance(word, candidate);
        if (distance < best) best = distance, nearest = candidate;
    }
    return nearest.empty() ? "" : " (did you mean '" + std::string(nearest) + "'?)";
}

} // namespace fresnel
