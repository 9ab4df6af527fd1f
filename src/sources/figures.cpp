#include "sources/parts.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <cmath>

namespace fresnel {

bool check::matched() const { return std::abs(difference()) <= tolerance; }

const std::vector<source_figure>& source_figures() {
    static const std::vector<source_figure> all = [] {
        std::vector<source_figure> result;
        for (const auto part : {wloka_figures, lagarde_figures, lagarde_tables, highlight_figures,
                                halladay_figures, rtr4_figures})
            for (source_figure& one : part())
                result.push_back(std::move(one));
        return result;
    }();
    return all;
}

const source_figure& find_source_figure(std::string_view id) {
    std::vector<std::string> ids;
    for (const source_figure& one : source_figures()) {
        if (one.id == id) return one;
        ids.push_back(one.id);
    }
    throw bad_input(fmt::format("figure '{}' is unknown{}; `fresnel figures --list` lists them", id,
                                did_you_mean(id, ids)));
}

nlohmann::json to_json(const source_figure& entry, const regenerated& made) {
    nlohmann::json result = to_json(made.drawing), checks = nlohmann::json::array();
    for (const check& c : made.checks)
        checks.push_back({{"what", c.what},
                          {"published", c.published},
                          {"computed", c.computed},
                          {"difference", c.difference()},
                          {"tolerance", c.tolerance},
                          {"matched", c.matched()},
                          {"why", c.why}});
    result["id"] = entry.id, result["source"] = entry.source, result["checks"] = checks;
    result["says"] = made.says, result["measured"] = made.measured, result["chosen"] = made.chosen;
    return result;
}

} // namespace fresnel
