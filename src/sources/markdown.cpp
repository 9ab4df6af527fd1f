#include "sources/sources.hpp"

#include <fmt/format.h>

#include <map>

namespace fresnel {

namespace {

// "figure wloka-2; claim wloka-schlick" with each piece as code, and claims as links into the ledger.
std::string places(std::string_view where) {
    std::string text;
    for (std::size_t begin = 0; begin <= where.size();) {
        const std::size_t end = std::min(where.find("; ", begin), where.size());
        const std::string_view piece = where.substr(begin, end - begin);
        const std::size_t space = piece.find(' ');
        if (!text.empty()) text += ", ";
        if (space == std::string_view::npos)
            text += piece;
        else if (piece.starts_with("claim "))
            text += fmt::format("claim [{0}](claims.md#{0})", piece.substr(space + 1));
        else
            text += fmt::format("{} `{}`", piece.substr(0, space), piece.substr(space + 1));
        begin = end + 2;
    }
    return text;
}

constexpr std::pair<char, std::string_view> texts[] = {
    {'W', "M. Wloka, “Fresnel Reflection”, technical report, NVIDIA 2002"},
    {'L', "S. Lagarde, “Memo on Fresnel equations”, 2013, version 1.4"},
    {'G', "M. Kraus, “GLSL Programming/Unity”, Fresnel highlights, Wikibooks 2012"},
    {'H', "K. Halladay, “The Basics of Fresnel Shading”, 2014"},
    {'R', "T. Akenine-Möller et al., “Real-Time Rendering”, 4th ed., 2018, section 9.5"}};

} // namespace

std::string claims_markdown() {
    std::map<std::string_view, int> count;
    std::string body, document;
    for (const claim& one : claims()) {
        const finding found = one.measure();
        ++count[to_string(found.is)];
        if (one.document != document) body += fmt::format("\n## {}\n", document = one.document);
        body += fmt::format("\n### {}\n\n*{}.* {}\n\n- verdict: **{}**\n- measured: {}\n", one.id, one.place,
                            one.text, to_string(found.is), found.measured);
        if (!found.domain.empty()) body += fmt::format("- domain: {}\n", found.domain);
        body += fmt::format("- items {}; test `claims.{}`\n", one.items, one.test);
    }
    std::string text = fmt::format("# Claims, measured\n\nWhat five texts say about Fresnel reflectance, in "
                                   "our words, and what measurement says of it. "
                                   "Printed by `fresnel claims --markdown`; every number is computed by the "
                                   "functions the figures and commands "
                                   "use, and tested.\n\n{} claims:",
                                   claims().size());
    for (const auto& [verdict, number] : count)
        text += fmt::format(" {} {},", number, verdict);
    text.back() = '.';
    return text +
           " `true_within` holds in the domain that is named; an `opinion` is about looks and waits for the "
           "renderer.\n" +
           body;
}

std::string sources_markdown() {
    std::string text = "# The sources, item by item\n\nEvery equation, number, figure, table and claim of "
                       "the five texts this library grew "
                       "from, and where it is found here: a figure or table (`fresnel figures ID`), a claim "
                       "in [claims.md](claims.md), a "
                       "test suite in `tests/`, a command, or code in `include/fresnel/`. Items that are "
                       "shader listings, pictures of "
                       "rendered scenes or remarks without anything to measure are marked so. Printed by "
                       "`fresnel claims --sources`.\n";
    for (const auto& [letter, name] : texts) {
        text += fmt::format("\n## {}: {}\n\n| item | what | where |\n|---|---|---|\n", letter, name);
        for (const source_item& item : source_items())
            if (item.id.front() == letter)
                text += fmt::format("| {} | {} | {} |\n", item.id, item.what, places(item.where));
    }
    return text;
}

} // namespace fresnel
