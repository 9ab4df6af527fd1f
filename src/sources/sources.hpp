#pragma once

#include "figure/figure.hpp"

#include <nlohmann/json.hpp>

#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

// The five texts this library grew from, item by item: their figures and tables regenerated, their claims judged.
//
//   W  M. Wloka, "Fresnel Reflection", technical report, NVIDIA 2002
//   L  S. Lagarde, "Memo on Fresnel equations", 2013, version 1.4
//   G  M. Kraus, "GLSL Programming/Unity", chapter on the Fresnel factor for specular highlights, Wikibooks 2012
//   H  K. Halladay, "The Basics of Fresnel Shading", 2014
//   R  T. Akenine-Moeller et al., "Real-Time Rendering", 4th ed., 2018, section 9.5

namespace fresnel {

/// One published number beside ours.
///
/// tolerance   within which the two count as the same
/// why         for a number that does not match, the reason; may say something of one that does
struct check {
    std::string what;
    double published, computed, tolerance;
    std::string why = {};

    double difference() const { return computed - published; }
    bool matched() const;
};

/// A figure or table of one of the texts, made again.
///
/// says       what the text says about it, in our words
/// measured   what we measure beside it
/// chosen     parameters that the text leaves open, and what we chose
struct regenerated {
    figure drawing;
    std::string says, measured, chosen;
    std::vector<check> checks = {};
};

/// One entry of the set: `id` is also the file's name.
struct source_figure {
    std::string id, source, title;
    std::function<regenerated()> make;
};

/// All figures and tables, in the order of the texts.
const std::vector<source_figure>& source_figures();

/// The entry of that id; throws bad_input with the nearest id where there is none.
const source_figure& find_source_figure(std::string_view id);

/// {id, source, caption, says, measured, chosen, series, ..., checks: [{what, published, computed, difference,
/// matched, why}]}
nlohmann::json to_json(const source_figure& entry, const regenerated& made);

/// Writes DIR/ID.svg, ID.png and ID.json for each, and DIR/index.html, the set as a page to read.
void write_source_figures(const std::vector<const source_figure*>& wanted, const std::string& dir);

/// What measurement says of a claim.
enum class judgement { holds, holds_within, fails, opinion };
std::string_view to_string(judgement of); ///< true, true_within, false, opinion

/// A claim, measured.
///
/// measured   the measurement in words and numbers
/// domain     where the claim holds, or what it was measured over
/// values     the numbers behind the words, by name
struct finding {
    judgement is;
    std::string measured, domain;
    std::vector<std::pair<std::string, double>> values = {};

    double value(std::string_view name) const;
};

/// A claim of one of the texts, in our words.
///
/// items   the numbers of the text's items that it stands for, "W24"
/// test    of tests/claims_test.cpp, which measures it another way or against an independent number
struct claim {
    std::string id, document, place, text, items, test;
    std::function<finding()> measure;
};

/// All claims, in the order of the texts.
const std::vector<claim>& claims();

/// The claim of that id; throws bad_input with the nearest id where there is none.
const claim& find_claim(std::string_view id);

nlohmann::json to_json(const claim& one, const finding& found);

/// An item of a text and where it is found here.
///
/// where   "figure ID", "claim ID", "test FILE", "command ...", "code FILE", several separated by "; ", or for what is no mathematics
///         "picture", "listing" or "remark"
struct source_item {
    std::string_view id, what, where;
};

std::span<const source_item> source_items();

/// The ledger of claims and the table of items as Markdown: docs/claims.md and docs/sources.md.
std::string claims_markdown();
std::string sources_markdown();

} // namespace fresnel
