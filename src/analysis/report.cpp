#include "analysis/report.hpp"

#include "analysis/cost_table.hpp"
#include "analysis/drawing.hpp"
#include "analysis/pareto.hpp"
#include "figure/figure.hpp"
#include "figure/leftover.hpp"
#include "figure/page.hpp"
#include "materials/observer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>

namespace fresnel {

namespace {

// ---- figures ----------------------------------------------------------------------------------------------

// Exact curves, the recommended model and Schlick's, with the recommended model's worst angle.
figure curves_figure(const report_entry& entry, const std::string& name) {
    const comparison& r = entry.result;
    const model_fit& best = r.best_choice();
    figure f{name + "-curves",
             entry.substance.name + ": exact reflectance and " + best.name,
             "Solid: exact. Dashed: the recommended model. Dotted: Schlick's.",
             {},
             {},
             {}};
    panel p{theta_axis, {}, {}, {}};
    const auto add = [&](const std::vector<rgb>& values, const std::string& label, stroke style,
                         double width) {
        for (std::size_t c = 0; c < 3; ++c) {
            p.curves.push_back(channel_series(values, r.exact.theta_deg, c));
            series& s = p.curves.back();
            if (style == stroke::solid || c == 0)
                s.label = style == stroke::solid
                              ? fmt::format("{} {}", label, channel_letters(r.exact.space)[c])
                              : label;
            s.style = style, s.width = width;
        }
    };
    add(r.exact.value, "exact", stroke::solid, 2.2);
    if (const model_fit* schlick = r.find("schlick"); schlick != nullptr && schlick != &best)
        add(schlick->curve, "schlick", stroke::dotted, 1.6);
    add(best.curve, best.name, stroke::dashed, 1.8);
    p.y = reflectance_axis(fmt::format("reflectance ({})", space_title(r.exact.space)), p.curves);

    const std::size_t c = best.error.worst_channel();
    const auto at = static_cast<std::size_t>(
        std::lower_bound(r.exact.theta_deg.begin(), r.exact.theta_deg.end(), best.error.max_theta[c]) -
        r.exact.theta_deg.begin());
    // a rising curve leaves room above it, a flat one below
    const bool flat = best.curve[at][c] - best.curve[0][c] < 0.1 * (p.y.hi - p.y.lo);
    p.markers.push_back({best.error.max_theta[c], best.curve[at][c],
                         fmt::format("worst: {:.3f} at {:.0f}°", best.error.max[c], best.error.max_theta[c]),
                         channel_colors[c], flat});
    f.panels.push_back(std::move(p));
    return f;
}

// Signed errors of the best models, the recommended one and Schlick's, each in its worst channel.
figure errors_figure(const report_entry& entry, const std::string& name) {
    const comparison& r = entry.result;
    std::vector<const model_fit*> chosen = {&r.best_choice()};
    if (const model_fit* schlick = r.find("schlick"); schlick != nullptr && schlick != chosen[0])
        chosen.push_back(schlick);
    for (const model_fit& m : r.models)
        if (chosen.size() < model_colors.size() &&
            std::find(chosen.begin(), chosen.end(), &m) == chosen.end())
            chosen.push_back(&m);

    panel p{theta_axis, {}, {}, {}};
    for (std::size_t i = 0; i < chosen.size(); ++i) {
        const model_fit& m = *chosen[i];
        const std::size_t c = m.error.worst_channel();
        series s{m.name,
                 r.exact.theta_deg,
                 {},
                 model_colors[i],
                 i == 0 ? stroke::solid : stroke::dashed,
                 i == 0 ? 2.4 : 1.8};
        for (std::size_t a = 0; a < m.curve.size(); ++a) {
            s.y.push_back(m.curve[a][c] - r.exact.value[a][c]);
            if (i < 2 && r.exact.theta_deg[a] == m.error.max_theta[c])
                p.markers.push_back({r.exact.theta_deg[a], s.y.back(),
                                     fmt::format("{:.3f} at {:.0f}°", m.error.max[c], m.error.max_theta[c]),
                                     s.color, i == 0});
        }
        p.curves.push_back(std::move(s));
    }
    p.y = error_axis("model − exact, worst channel", p.curves);
    return {name + "-errors",
            entry.substance.name + ": error of the models",
            "Solid: the recommended model.",
            {p},
            {},
            {}};
}

figure strips_figure(const report_entry& entry, const std::string& name) {
    const comparison& r = entry.result;
    strips all{theta_axis, {color_strip("exact", r.exact.value, r.exact.space)}};
    for (const model_fit& m : r.models)
        all.rows.push_back(color_strip(m.name, m.curve, r.exact.space));
    return {name + "-strips",
            entry.substance.name + ": colour against angle, models by rank",
            "The reflected colour of white light, in sRGB.",
            {},
            all,
            {}};
}

figure surface_figure(const report_entry& entry, const std::string& name) {
    return {name + "-surface",
            entry.substance.name + ": reflectance over wavelength and angle",
            "Exact, unpolarised.",
            {},
            {},
            spectral_height_field(entry.substance, entry.result.colour.ambient)};
}

// A name for the files of each entry: that of the material, numbered where two files of a folder each have one.
std::vector<std::string> slugs_of(const std::vector<report_entry>& entries) {
    std::vector<std::string> slugs;
    for (const report_entry& entry : entries) {
        const std::string plain = slug(entry.substance.name);
        std::string one = plain;
        for (int i = 2; std::ranges::find(slugs, one) != slugs.end(); ++i)
            one = fmt::format("{}-{}", plain, i);
        slugs.push_back(one);
    }
    return slugs;
}

std::vector<figure> figures_of(const report_entry& entry, const std::string& name) {
    return {curves_figure(entry, name), errors_figure(entry, name),
            pareto_figure(entry.result, name + "-cost", entry.substance.name + ": error against cost"),
            strips_figure(entry, name), surface_figure(entry, name)};
}

// ---- the page ---------------------------------------------------------------------------------------------

// The exact colours from 0 to 90 degrees as a bar.
std::string swatch(const comparison& r) {
    std::string stops;
    for (std::size_t a = 0; a < r.exact.value.size(); a += 20)
        stops += fmt::format(", {}", to_hex(encode_srgb8(to_srgb(r.exact.value[a], r.exact.space))));
    return fmt::format("<span class=\"swatch\" role=\"img\" aria-label=\"colour from 0 to 90 degrees\" "
                       "style=\"background:linear-gradient(to right{})\"></span>",
                       stops);
}

std::string three(const std::array<double, 3>& v, int digits) {
    return fmt::format("{:.{}f} {:.{}f} {:.{}f}", v[0], digits, v[1], digits, v[2], digits);
}

std::string parameter_text(const model_fit& m) {
    std::string text;
    const auto wanted = find_model<double>(m.name).parameters;
    for (std::size_t p = 0; p < wanted.size(); ++p) {
        const bool same = m.values[0][p] == m.values[1][p] && m.values[1][p] == m.values[2][p];
        text += fmt::format(
            "{}{} = {}", p == 0 ? "" : "; ", wanted[p].name,
            same ? fmt::format("{:.5g}", m.values[0][p])
                 : fmt::format("{:.5g} {:.5g} {:.5g}", m.values[0][p], m.values[1][p], m.values[2][p]));
    }
    return text;
}

std::string instructions_text(const model_fit& m) {
    const cost_row* cost = find_cost(m.name);
    return cost == nullptr ? "–" : fmt::format("{:.0f}", cost->instructions);
}

std::string model_table_html(const comparison& r) {
    std::string rows;
    for (const model_fit& m : r.models)
        rows += fmt::format("<tr{}><td>{}</td><td "
                            "class=\"left\">{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td>"
                            "<td>{:.2f}</td><td class=\"wrap\">{}</td></tr>\n",
                            &m == &r.best_choice() ? " class=\"chosen\"" : "", m.rank, m.name, m.cost,
                            instructions_text(m), three(m.error.max, 4), three(m.error.rms, 4),
                            three(m.error.cosine, 4), m.error.delta_e_max, markup_text(parameter_text(m)));
    return fmt::format(
        "<div class=\"scroll\"><table><tr><th>rank</th><th "
        "class=\"left\">model</th><th>operations</th><th>instructions</th><th>max error, {0}</th>"
        "<th>RMS over θ</th><th>cosine-weighted</th><th>worst ΔE₀₀</th><th class=\"left\">fitted "
        "parameters, {0}</th></tr>\n{1}</table></div>\n",
        fmt::join(channel_letters(r.colour.space), " "), rows);
}

std::string provenance(const report_entry& entry) {
    const material& m = entry.substance;
    std::string text = markup_text(m.citation);
    if (!m.page.empty()) text += fmt::format(" — refractiveindex.info, page {}", markup_text(m.page));
    if (has_range(m)) text += ". Known only as a range; its middle is used";
    return fmt::format("{}. {}", text, markup_text(m.quality));
}

std::string section(const report_entry& entry, const std::string& name, const std::vector<figure>& figures,
                    const std::string& dir) {
    const comparison& r = entry.result;
    const rgb8 codes = encode_srgb8(to_srgb(r.colour.f0, r.colour.space));
    std::string html = fmt::format("<section id=\"{}\"><h2>{}</h2>\n<p class=\"verdict\">{}</p>\n", name,
                                   markup_text(entry.substance.name), markup_text(verdict(r)));
    html +=
        fmt::format("<p>{} F0 = {}, F82 = {}, {}{}</p>\n<p class=\"soft\">{}. Ambient index {}. {}</p>\n",
                    swatch(r), three(r.colour.f0, 4), three(r.colour.f82, 4), to_hex(codes),
                    in_gamut(to_srgb(r.colour.f0, r.colour.space)) ? "" : " (clamped: F0 lies outside sRGB)",
                    markup_text(r.colour.recipe), r.colour.ambient, provenance(entry));
    for (const figure& f : figures)
        html += fmt::format("<figure>{}<figcaption>{}</figcaption></figure>\n", inline_svg(f, dir),
                            markup_text(f.caption));
    return html + model_table_html(r) + "</section>\n";
}

std::string page(const std::vector<report_entry>& entries, const std::vector<std::string>& slugs,
                 const std::vector<std::vector<figure>>& figures, const std::string& dir) {
    std::string summary, sections;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        const std::string name = markup_text(entries[i].substance.name);
        summary += fmt::format("<tr><td class=\"left\"><a href=\"#{}\">{}</a></td><td>{}</td><td "
                               "class=\"left\"><b>{}</b></td><td class=\"wrap\">{}</td></tr>\n",
                               slugs[i], name, swatch(entries[i].result),
                               entries[i].result.best_choice().name, markup_text(verdict(entries[i].result)));
        sections += section(entries[i], slugs[i], figures[i], dir);
    }
    return html_page(
        "Which Fresnel may I use?",
        "<h1>Which Fresnel may I use, and what do I lose?</h1>\n"
        "<p>Every approximation that suits a material, fitted to its exact reflectance and compared with "
        "it over all angles. "
        "The exact curve is integrated over the measured spectrum first and turned into a colour "
        "after.</p>\n"
        "<p class=\"soft\">Recommended is the cheapest model whose worst colour difference (CIEDE2000, "
        "over all angles) is at most 1, "
        "which is not seen; if there is none, at most 2; if none, the least. Rank goes by the largest "
        "error of any channel. "
        "Operations are counted for three channels; instructions are of one channel, by AMD's compiler for "
        "navi21.</p>\n"
        "<div class=\"scroll\"><table><tr><th class=\"left\">material</th><th class=\"left\">0° to "
        "90°</th><th class=\"left\">use</th><th class=\"left\">because</th></tr>\n" +
            summary + "</table></div>\n" + sections);
}

} // namespace

nlohmann::json report_json(const std::vector<report_entry>& entries) {
    nlohmann::json materials = nlohmann::json::array();
    for (const report_entry& entry : entries)
        materials.push_back(to_json(entry.result));
    return {{"materials", materials}};
}

void write_report(const std::vector<report_entry>& entries, const std::string& dir) {
    require_writable_folder("--out", (std::filesystem::path(dir) / "figures").string());
    const staged_folder staged(dir);
    const std::string figure_dir = (staged.path / "figures").string();
    std::filesystem::create_directory(figure_dir);
    std::vector<std::vector<figure>> per_entry;
    std::vector<figure> all;
    const std::vector<std::string> slugs = slugs_of(entries);
    for (std::size_t i = 0; i < entries.size(); ++i) {
        per_entry.push_back(figures_of(entries[i], slugs[i]));
        all.insert(all.end(), per_entry.back().begin(), per_entry.back().end());
    }
    write_figures(all, figure_dir, {format::svg, format::png});
    write_file((staged.path / "report.json").string(), json_text(report_json(entries)));
    write_file((staged.path / "index.html").string(), page(entries, slugs, per_entry, figure_dir));
    staged.finish();
}

} // namespace fresnel
