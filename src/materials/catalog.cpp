#include "materials/catalog.hpp"

#include "error.hpp"
#include "materials/embedded.hpp"
#include "materials/page.hpp"
#include "materials/table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <unordered_map>

namespace fresnel {
namespace {

std::string lower_case(std::string_view text) {
    std::string lower(text);
    std::ranges::transform(lower, lower.begin(),
                           [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return lower;
}

void append_sorted(std::vector<material>& all, std::vector<material> more) {
    std::ranges::sort(more, {}, &material::name);
    std::ranges::move(more, std::back_inserter(all));
}

std::vector<material> rows_of(const std::string& file, material_kind kind) {
    return read_material_rows(embedded_data(file), kind, file);
}

std::vector<material> read_builtin() {
    std::vector<material> spectral, all;
    for (const std::string_view file : embedded_names("materials/"))
        if (file.ends_with(".txt")) spectral.push_back(read_material(embedded_data(file), std::string(file)));
    append_sorted(all, std::move(spectral));
    append_sorted(all, rows_of("materials/index.csv", material_kind::index));
    append_sorted(all, rows_of("materials/f0.csv", material_kind::f0));
    return all;
}

using name_index = std::unordered_map<std::string, const material*>;

/// Names before aliases before pages: what comes first keeps a word that two would share.
name_index index_names() {
    name_index index;
    const std::vector<material>& all = builtin_materials();
    for (const material& m : all)
        index.emplace(lower_case(m.name), &m);
    for (const material& m : all)
        for (const std::string& alias : m.aliases)
            index.emplace(lower_case(alias), &m);
    for (const material& m : all)
        if (!m.page.empty()) index.emplace(lower_case(m.page), &m);
    return index;
}

std::vector<std::string> names_and_aliases() {
    std::vector<std::string> words;
    for (const material& m : builtin_materials()) {
        words.push_back(m.name);
        words.insert(words.end(), m.aliases.begin(), m.aliases.end());
    }
    return words;
}

} // namespace

const std::vector<material>& builtin_materials() {
    static const std::vector<material> all = read_builtin();
    return all;
}

const material* find_material(std::string_view name) {
    static const name_index index = index_names();
    const auto found = index.find(lower_case(name));
    return found == index.end() ? nullptr : found->second;
}

material load_material(const std::string& name_or_path) {
    if (const material* found = find_material(name_or_path)) return *found;
    if (name_or_path.ends_with(".yml")) return material_of(read_page_file(name_or_path), name_or_path);
    if (name_or_path.ends_with(".csv")) return read_csv_material(read_text_file(name_or_path), name_or_path);
    throw bad_input(fmt::format("material '{:.80}' is unknown{}; `fresnel materials` lists them",
                                name_or_path, did_you_mean(lower_case(name_or_path), names_and_aliases())));
}

std::string_view name_of(material_kind kind) {
    switch (kind) {
    case material_kind::index:
        return "index";
    case material_kind::f0:
        return "f0";
    default:
        return "spectral";
    }
}

} // namespace fresnel
