#include "sources/parts.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <stdexcept>

namespace fresnel {

std::string_view to_string(judgement of) {
    switch (of) {
    case judgement::holds:
        return "true";
    case judgement::holds_within:
        return "true_within";
    case judgement::fails:
        return "false";
    case judgement::opinion:
        break;
    }
    return "opinion";
}

double finding::value(std::string_view name) const {
    for (const auto& [key, number] : values)
        if (key == name) return number;
    throw std::invalid_argument(fmt::format("no value '{}' was measured", name));
}

const std::vector<claim>& claims() {
    static const std::vector<claim> all = [] {
        std::vector<claim> result;
        for (const auto part : {wloka_claims, lagarde_claims, highlight_claims, halladay_claims, rtr4_claims})
            for (claim& one : part())
                result.push_back(std::move(one));
        return result;
    }();
    return all;
}

const claim& find_claim(std::string_view id) {
    std::vector<std::string> ids;
    for (const claim& one : claims()) {
        if (one.id == id) return one;
        ids.push_back(one.id);
    }
    throw bad_input(
        fmt::format("claim '{}' is unknown{}; `fresnel claims` lists them", id, did_you_mean(id, ids)));
}

nlohmann::json to_json(const claim& one, const finding& found) {
    nlohmann::json values = nlohmann::json::object();
    for (const auto& [name, number] : found.values)
        values[name] = number;
    return {{"id", one.id},
            {"document", one.document},
            {"place", one.place},
            {"claim", one.text},
            {"verdict", to_string(found.is)},
            {"measured", found.measured},
            {"domain", found.domain},
            {"values", values},
            {"items", one.items},
            {"test", one.test}};
}

} // namespace fresnel
