#include "figure/figure.hpp"

#include "error.hpp"
#include "figure/leftover.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <unistd.h>

namespace fresnel {

namespace {

std::string csv_cell(const std::string& text) {
    if (text.find_first_of(",\"\n") == std::string::npos) return text;
    std::string quoted = "\"";
    for (const char c : text)
        quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + "\"";
}

const std::string& name_of(const series& s) { return s.name.empty() ? s.label : s.name; }

std::string cell(double value) { return std::isfinite(value) ? fmt::format("{}", value) : ""; }

bool share_x(const std::vector<const series*>& all) {
    return std::all_of(all.begin(), all.end(), [&](const series* s) { return s->x == all[0]->x; });
}

std::string table_csv(const std::string& x_label, const std::vector<const series*>& all) {
    std::string text = csv_cell(x_label);
    for (const series* s : all)
        text += ',' + csv_cell(name_of(*s));
    text += '\n';
    for (std::size_t i = 0; i < all[0]->x.size(); ++i) {
        text += fmt::format("{}", all[0]->x[i]);
        for (const series* s : all)
            text += ',' + cell(s->y[i]);
        text += '\n';
    }
    return text;
}

std::string columns_csv(const std::vector<const series*>& all) {
    std::string text;
    std::size_t length = 0;
    for (const series* s : all) {
        text += fmt::format("{}{},{}", s == all[0] ? "" : ",", csv_cell("x of " + name_of(*s)),
                            csv_cell(name_of(*s)));
        length = std::max(length, s->x.size());
    }
    text += '\n';
    for (std::size_t i = 0; i < length; ++i) {
        for (const series* s : all) {
            if (s != all[0]) text += ',';
            text += i < s->x.size() ? fmt::format("{},{}", s->x[i], cell(s->y[i])) : ",";
        }
        text += '\n';
    }
    return text;
}

std::string surface_csv(const height_field& f) {
    std::string text = fmt::format("{},{},{}\n", csv_cell(f.x_axis.label), csv_cell(f.y_axis.label),
                                   csv_cell(f.z_axis.label));
    for (std::size_t i = 0; i < f.x.size(); ++i)
        for (std::size_t j = 0; j < f.y.size(); ++j)
            text += fmt::format("{},{},{}\n", f.x[i], f.y[j], cell(f.z[i][j]));
    return text;
}

} // namespace

std::string markup_text(std::string_view text) {
    std::string result;
    for (const char c : text)
        result += c == '&'   ? "&amp;"
                  : c == '<' ? "&lt;"
                  : c == '>' ? "&gt;"
                  : c == '"' ? "&quot;"
                             : std::string(1, c);
    return result;
}

std::string json_text(const nlohmann::json& value) {
    return value.dump(2, ' ', false, nlohmann::json::error_handler_t::replace) + "\n";
}

void write_file(const std::string& path, const std::string& text) {
    const staged_file staged(path);
    file_handle file = staged.open();
    const bool written = file && std::fwrite(text.data(), 1, text.size(), file.get()) == text.size() &&
                         std::fclose(file.release()) == 0;
    if (!written || !staged.finish()) throw failure(fmt::format("{}: cannot be written", final_path(path)));
}

namespace {

nlohmann::json to_json(const table& what) {
    nlohmann::json columns = nlohmann::json::array(), rows = columns;
    for (const table::column& c : what.columns)
        columns.push_back(c.title);
    for (const auto& row : what.rows) {
        nlohmann::json& cells = rows.emplace_back(nlohmann::json::array());
        for (const table::cell& c : row)
            cells.push_back(c.swatch ? nlohmann::json(*c.swatch) : nlohmann::json(c.text));
    }
    return {{"columns", columns}, {"rows", rows}, {"notes", what.notes}};
}

} // namespace

nlohmann::json to_json(const figure& what) {
    const auto axis_json = [](const axis& a) {
        return nlohmann::json{
            {"label", a.label}, {"lo", a.lo}, {"hi", a.hi}, {"tick", a.tick}, {"logarithmic", a.logarithmic}};
    };
    constexpr std::array<const char*, 4> styles = {"solid", "dashed", "dotted", "points"};
    nlohmann::json curves = nlohmann::json::array(), markers = curves, notes = curves, rows = curves, surface;
    for (std::size_t i = 0; i < what.panels.size(); ++i) {
        const panel& p = what.panels[i];
        for (const series& s : p.curves)
            curves.push_back({{"label", s.label},
                              {"name", name_of(s)},
                              {"panel", i},
                              {"x", s.x},
                              {"y", s.y},
                              {"color", s.color},
                              {"style", styles[static_cast<std::size_t>(s.style)]},
                              {"width", s.width},
                              {"x_axis", axis_json(p.x)},
                              {"y_axis", axis_json(p.y)}});
        for (const note& n : p.notes)
            notes.push_back({{"panel", i}, {"x", n.x}, {"y", n.y}, {"text", n.text}, {"color", n.color}});
        for (const marker& m : p.markers)
            markers.push_back({{"panel", i}, {"x", m.x}, {"y", m.y}, {"label", m.label}, {"color", m.color}});
    }
    for (const strip& s : what.colors.rows)
        rows.push_back({{"label", s.label}, {"srgb8", s.pixels}, {"x_axis", axis_json(what.colors.x)}});
    if (what.surface)
        surface = {{"x", what.surface->x},
                   {"y", what.surface->y},
                   {"z", what.surface->z},
                   {"x_axis", axis_json(what.surface->x_axis)},
                   {"y_axis", axis_json(what.surface->y_axis)},
                   {"z_axis", axis_json(what.surface->z_axis)}};
    return {
        {"id", what.id},    {"title", what.title}, {"caption", what.caption},
        {"series", curves}, {"markers", markers},  {"notes", notes},
        {"strips", rows},   {"surface", surface},  {"table", what.cells ? to_json(*what.cells) : nullptr}};
}

std::string to_csv(const figure& what) {
    if (what.surface) return surface_csv(*what.surface);
    std::vector<const series*> all;
    for (const panel& p : what.panels)
        for (const series& s : p.curves)
            all.push_back(&s);
    if (all.empty()) return "";
    return share_x(all) ? table_csv(what.panels.front().x.label, all) : columns_csv(all);
}

} // namespace fresnel
