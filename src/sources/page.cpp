#include "sources/sources.hpp"

#include "figure/leftover.hpp"
#include "figure/page.hpp"

#include <fresnel/color.hpp>

#include <fmt/format.h>

#include <filesystem>

namespace fresnel {

namespace {

// The texts in the order of the page: the first word of an id, and the heading.
constexpr std::pair<std::string_view, std::string_view> texts[] = {
    {"wloka", "M. Wloka, Fresnel Reflection (2002)"},
    {"lagarde", "S. Lagarde, Memo on Fresnel equations (2013)"},
    {"highlights", "GLSL Programming in Unity: Fresnel highlights (2012)"},
    {"halladay", "K. Halladay, The Basics of Fresnel Shading (2014)"},
    {"rtr4", "Real-Time Rendering, 4th ed., section 9.5 (2018)"}};

bool belongs(const std::string& id, std::string_view text) { return id.substr(0, id.find('-')) == text; }

std::string cell_html(const table::cell& c, bool numeric) {
    if (c.swatch)
        return fmt::format("<td><span class=\"swatch\" style=\"width:4rem;background:{}\"></span></td>",
                           to_hex(*c.swatch));
    return fmt::format("<td class=\"{}{}\">{}</td>", numeric ? "" : "left", c.remarkable ? " bad" : "",
                       markup_text(c.text));
}

std::string table_html(const table& t) {
    std::string html = "<div class=\"scroll\"><table><tr>";
    for (const table::column& c : t.columns)
        html += fmt::format("<th{}>{}</th>", c.numeric ? "" : " class=\"left\"", markup_text(c.title));
    html += "</tr>\n";
    for (const auto& row : t.rows) {
        html += "<tr>";
        for (std::size_t c = 0; c < row.size(); ++c)
            html += cell_html(row[c], t.columns[c].numeric);
        html += "</tr>\n";
    }
    html += "</table></div>\n";
    if (t.notes.empty()) return html;
    html += "<ol class=\"soft\">";
    for (const std::string& note : t.notes)
        html += fmt::format("<li>{}</li>", markup_text(note));
    return html + "</ol>\n";
}

std::string paragraph(std::string_view label, const std::string& text) {
    return text.empty()
               ? ""
               : fmt::format("<p><span class=\"label\">{}</span> {}</p>\n", label, markup_text(text));
}

// How many of the published numbers match, and the ones that do not.
std::string checks_html(const std::vector<check>& checks) {
    if (checks.empty()) return "";
    std::size_t matched = 0;
    std::string rows;
    for (const check& c : checks) {
        matched += c.matched() ? 1 : 0;
        if (!c.matched())
            rows +=
                fmt::format("<tr><td class=\"left\">{}</td><td>{:.6g}</td><td>{:.6g}</td>"
                            "<td class=\"bad\">{:+.4g}</td><td class=\"wrap\">{}</td></tr>\n",
                            markup_text(c.what), c.published, c.computed, c.difference(), markup_text(c.why));
    }
    const std::string head =
        paragraph("Checked:", fmt::format("{} of {} published numbers are matched.", matched, checks.size()));
    if (rows.empty()) return head;
    return head +
           "<div class=\"scroll\"><table><tr><th class=\"left\">not matched</th><th>published</th>"
           "<th>computed</th><th>difference</th><th class=\"left\">why</th></tr>\n" +
           rows + "</table></div>\n";
}

std::string section(const source_figure& entry, const regenerated& made, const std::string& dir) {
    std::string html = fmt::format("<section id=\"{}\"><h3>{}</h3>\n<p class=\"soft\">{} — <code>fresnel "
                                   "figures {}</code></p>\n",
                                   entry.id, markup_text(entry.title), markup_text(entry.source), entry.id);
    if (made.drawing.cells)
        html += table_html(*made.drawing.cells);
    else
        html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", inline_svg(made.drawing, dir),
                            markup_text(made.drawing.caption));
    return html + paragraph("The text:", made.says) + paragraph("Measured:", made.measured) +
           paragraph("Parameters:", made.chosen) + checks_html(made.checks) + "</section>\n";
}

std::string index_page(const std::vector<const source_figure*>& wanted, const std::vector<regenerated>& made,
                       const std::string& dir) {
    std::string contents, body;
    for (const auto& [prefix, heading] : texts) {
        std::string sections;
        for (std::size_t i = 0; i < wanted.size(); ++i)
            if (belongs(wanted[i]->id, prefix)) {
                contents += fmt::format("<li><a href=\"#{}\">{}</a></li>\n", wanted[i]->id,
                                        markup_text(wanted[i]->title));
                sections += section(*wanted[i], made[i], dir);
            }
        if (!sections.empty()) body += fmt::format("<h2>{}</h2>\n{}", markup_text(heading), sections);
    }
    return html_page(
        "Figures and tables, regenerated",
        "<h1>Figures and tables, regenerated</h1>\n"
        "<p>Every figure and table with mathematics in it of five texts on Fresnel reflectance, made "
        "again by the functions they describe, with what the text says beside what we "
        "measure.</p>\n<nav><ol>" +
            contents + "</ol></nav>\n" + body);
}

} // namespace

void write_source_figures(const std::vector<const source_figure*>& wanted, const std::string& dir) {
    require_writable_folder("--out", dir);
    std::vector<regenerated> made;
    std::vector<figure> drawings;
    for (const source_figure* entry : wanted) {
        made.push_back(entry->make());
        made.back().drawing.id = entry->id, made.back().drawing.title = entry->title;
        drawings.push_back(made.back().drawing);
    }
    const staged_folder staged(dir);
    const std::filesystem::path& folder = staged.path;
    write_figures(drawings, folder.string(), {format::svg, format::png});
    for (std::size_t i = 0; i < wanted.size(); ++i)
        write_file((folder / (wanted[i]->id + ".json")).string(), json_text(to_json(*wanted[i], made[i])));
    write_file((folder / "index.html").string(), index_page(wanted, made, folder.string()));
    staged.finish();
}

} // namespace fresnel
