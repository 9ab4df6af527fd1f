#include "figure/figure.hpp"

#include "error.hpp"
#include "figure/tool.hpp"
#include "files.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <stdexcept>

namespace fresnel {

namespace {

// Sizes in the pixels of the SVG; PNG and PDF are scaled.
constexpr double width = 860, left = 90, right_with_legend = 226, right = 26;
constexpr double title_height = 44, panel_height = 330, panel_foot = 74, strip_height = 30,
                 surface_height = 520, row_height = 25, note_height = 18;
constexpr std::size_t note_columns = 118; // characters of a note's line

// Text in single quotes, where gnuplot interprets nothing but the quote itself. A line end would end the command.
std::string quoted(const std::string& text) {
    std::string result = "'";
    for (const char c : text)
        result += c == '\'' ? std::string("''") : c == '\n' ? std::string(" ") : std::string(1, c);
    return result + "'";
}

bool is_color(const std::string& text) {
    return text.size() == 7 && text[0] == '#' &&
           text.find_first_not_of("0123456789abcdefABCDEF", 1) == std::string::npos;
}

void require(bool holds, const figure& f, const char* what) {
    if (!holds) throw std::invalid_argument(fmt::format("figure '{}': {}", f.id, what));
}

// What the script takes on trust; everything else is quoted.
void check(const figure& f) {
    const auto plain = [](char c) {
        return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '-' || c == '_';
    };
    require(!f.id.empty() && std::all_of(f.id.begin(), f.id.end(), plain), f,
            "id must be letters, digits, - and _");
    for (const panel& p : f.panels) {
        for (const series& s : p.curves)
            require(s.x.size() == s.y.size() && is_color(s.color), f, "a series is malformed");
        for (const marker& m : p.markers)
            require(is_color(m.color), f, "a marker's colour must be #rrggbb");
        for (const note& n : p.notes)
            require(is_color(n.color), f, "a note's colour must be #rrggbb");
    }
    if (f.cells)
        for (const auto& row : f.cells->rows)
            require(row.size() == f.cells->columns.size(), f,
                    "a table's rows must have a cell for each column");
    for (const strip& s : f.colors.rows)
        require(s.pixels.size() == f.colors.rows.front().pixels.size(), f, "strips must be equally long");
    if (!f.surface) return;
    require(f.surface->z.size() == f.surface->x.size(), f, "the surface needs a row for each x");
    for (const auto& row : f.surface->z)
        require(row.size() == f.surface->y.size(), f, "the surface needs a z for each y");
}

bool has_legend(const figure& f) {
    for (const panel& p : f.panels)
        for (const series& s : p.curves)
            if (!s.label.empty() && !p.diagram) return true;
    return false;
}

// A sentence in lines of at most so many bytes, broken between words.
std::vector<std::string> wrapped(const std::string& text, std::size_t limit) {
    std::vector<std::string> lines(1);
    std::istringstream words(text);
    for (std::string word; words >> word;) {
        if (lines.back().size() + 1 + word.size() > limit) lines.emplace_back();
        lines.back() += (lines.back().empty() ? "" : " ") + word;
    }
    return lines;
}

// The notes of a table as lines, each note beginning with its number.
std::vector<std::string> note_lines(const table& t) {
    std::vector<std::string> lines;
    for (std::size_t i = 0; i < t.notes.size(); ++i)
        for (const std::string& line : wrapped(fmt::format("{}  {}", i + 1, t.notes[i]), note_columns))
            lines.push_back(line);
    return lines;
}

double height_of(const table& t) {
    return static_cast<double>(t.rows.size() + 1) * row_height + 16 +
           static_cast<double>(note_lines(t).size()) * note_height;
}

double height_of(const panel& p) { return panel_height + (p.diagram ? 20 : panel_foot); }

double height_of(const figure& f) {
    double height = title_height;
    for (const panel& p : f.panels)
        height += height_of(p);
    if (f.cells) height += height_of(*f.cells);
    if (!f.colors.rows.empty())
        height += static_cast<double>(f.colors.rows.size()) * strip_height + panel_foot;
    return f.surface ? height + surface_height : height;
}

// Strips carry their names at the left, which needs more room than the numbers of an axis.
double left_of(const figure& f) {
    std::size_t longest = 0;
    for (const strip& s : f.colors.rows)
        longest = std::max(longest, s.label.size());
    return std::max(left, 24 + 8.2 * static_cast<double>(longest));
}

class script {
public:
    explicit script(const figure& f) : figure_(f), height_(height_of(f)) { build(); }

    std::string text() const { return data_ + commands_; }
    double height() const { return height_; }

private:
    template <class... Arguments>
    void command(fmt::format_string<Arguments...> form, Arguments&&... arguments) {
        commands_ += fmt::format(form, std::forward<Arguments>(arguments)...) + "\n";
    }

    // A named block of inline data; gnuplot reads it where it is defined, so all of them come first.
    std::string block(const std::string& rows) {
        const std::string name = fmt::format("$d{}", blocks_++);
        data_ += name + " << EOD\n" + rows + "EOD\n";
        return name;
    }

    void place(double top, double height) {
        const double r = has_legend(figure_) ? right_with_legend : right;
        command("set lmargin at screen {}\nset rmargin at screen {}", left_of(figure_) / width,
                1 - r / width);
        command("set tmargin at screen {}\nset bmargin at screen {}", 1 - top / height_,
                1 - (top + height) / height_);
    }

    void axes(const axis& x, const axis& y) {
        command("set xrange [{}:{}]\nset yrange [{}:{}]", x.lo, x.hi, y.lo, y.hi);
        command("set xlabel {} offset 0,0.3 norotate\nset ylabel {} offset 0.6,0 rotate by 90",
                quoted(x.label), quoted(y.label));
        command("set xtics {} out nomirror\nset ytics {} out nomirror", ticks(x), ticks(y));
        scale('x', x), scale('y', y);
    }

    // Between ticks that double there are no smaller ones.
    void scale(char name, const axis& a) {
        command("{} logscale {}", a.logarithmic ? "set" : "unset", name);
        command("set m{}tics {}", name, a.logarithmic && a.tick == 2 ? "1" : "default");
    }

    static std::string ticks(const axis& a) { return a.tick > 0 ? fmt::format("{}", a.tick) : "autofreq"; }

    // Ranges without a frame.
    void bare(const axis& x, const axis& y) {
        command("set xrange [{}:{}]\nset yrange [{}:{}]", x.lo, x.hi, y.lo, y.hi);
        command("unset border\nunset xtics\nunset ytics\nunset xlabel\nunset ylabel\nunset grid\nunset key");
    }

    void frame(const panel& p) {
        axes(p.x, p.y);
        command("set border 3 lc rgb '#808080' lw 0.8\nset grid lc rgb '#808080' lw 0.35 dt 1");
        command("set key at graph 1.03,1.0 left top Left reverse samplen 2.2 spacing 1.15 width -2");
    }

    void draw(const panel& p) {
        if (p.diagram)
            bare(p.x, p.y);
        else
            frame(p);
        std::string plots;
        for (const series& s : p.curves)
            plots += plot(s);
        int label = 0;
        for (const marker& m : p.markers) {
            command("set arrow from {0},{1} to {0},{2} nohead lc rgb '{3}' lw 0.9 dt 3", m.x, p.y.lo, m.y,
                    m.color);
            const bool at_left = m.x > (p.x.lo + p.x.hi) / 2;
            command("set object circle at {},{} size screen 0.004 fs solid noborder fc rgb '{}' front", m.x,
                    m.y, m.color);
            command("set label {} {} at {},{} {} offset {},0.6 front", ++label, quoted(m.label), m.x,
                    m.at_foot ? p.y.lo : m.y, at_left ? "right" : "left", at_left ? -0.8 : 0.8);
        }
        for (const note& n : p.notes)
            command("set label {} {} at {},{} {} tc rgb '{}' front", ++label, quoted(n.text), n.x, n.y,
                    n.align == note::side::left    ? "left"
                    : n.align == note::side::right ? "right"
                                                   : "center",
                    n.color);
        command("plot {}", plots.empty() ? "NaN notitle" : plots.substr(0, plots.size() - 2));
        command("unset arrow\nunset label\nunset object\nunset logscale");
    }

    std::string plot(const series& s) {
        std::string rows;
        for (std::size_t i = 0; i < s.x.size(); ++i)
            rows += std::isfinite(s.y[i]) ? fmt::format("{} {}\n", s.x[i], s.y[i]) : "\n";
        if (rows.empty()) return "";
        const std::string title = s.label.empty() ? "notitle" : "title " + quoted(s.label);
        if (s.style == stroke::points)
            return fmt::format("{} using 1:2 with points pt 7 ps {} lc rgb '{}' {}, ", block(rows),
                               s.width / 4, s.color, title);
        const std::string_view dash = s.style == stroke::solid    ? "1"
                                      : s.style == stroke::dashed ? "(9,5)"
                                                                  : "(2.5,4)";
        return fmt::format("{} using 1:2 with lines lc rgb '{}' lw {} dt {} {}, ", block(rows), s.color,
                           s.width, dash, title);
    }

    // Rows of an image: pixel centres from x.lo to x.hi, so that the first colour stands at the first tick.
    void draw(const strips& all) {
        const std::size_t count = all.rows.front().pixels.size();
        const double step = (all.x.hi - all.x.lo) / static_cast<double>(std::max<std::size_t>(count - 1, 1));
        std::string labels;
        for (std::size_t r = 0; r < all.rows.size(); ++r)
            labels += fmt::format("{}{} {}", r == 0 ? "" : ", ", quoted(all.rows[r].label),
                                  -static_cast<double>(r));
        command("set xrange [{}:{}]\nset yrange [{}:0.5]", all.x.lo - step / 2, all.x.hi + step / 2,
                0.5 - static_cast<double>(all.rows.size()));
        command("set xlabel {} offset 0,0.3 norotate\nunset ylabel\nunset grid\nset border 0\nunset key",
                quoted(all.x.label));
        command("set xtics {} out nomirror\nset ytics ({}) scale 0", ticks(all.x), labels);
        std::string plots;
        for (std::size_t r = 0; r < all.rows.size(); ++r) {
            std::string rows;
            for (std::size_t copy = 0; copy < 2; ++copy) // two rows of pixels, a gap between strips
                for (std::size_t i = 0; i < count; ++i) {
                    const auto& c = all.rows[r].pixels[i];
                    rows += fmt::format("{} {} {} {} {}\n", all.x.lo + step * static_cast<double>(i),
                                        -static_cast<double>(r) - 0.2 + 0.42 * static_cast<double>(copy),
                                        c[0], c[1], c[2]);
                }
            plots += fmt::format("{} using 1:2:3:4:5 with rgbimage notitle, ", block(rows));
        }
        command("plot {}", plots.substr(0, plots.size() - 2));
    }

    void draw(const height_field& s) {
        std::string rows;
        for (std::size_t i = 0; i < s.x.size(); ++i) {
            for (std::size_t j = 0; j < s.y.size(); ++j)
                rows += fmt::format("{} {} {}\n", s.x[i], s.y[j], s.z[i][j]);
            rows += "\n";
        }
        command("unset lmargin\nunset rmargin\nunset tmargin\nunset bmargin\nunset key\nunset grid");
        command("set size 1,{}\nset origin 0,{}", surface_height / height_,
                1 - (title_height + surface_height) / height_);
        command("set xrange [{}:{}]\nset yrange [{}:{}]\nset zrange [{}:{}]\nset cbrange [{}:{}]",
                s.x_axis.lo, s.x_axis.hi, s.y_axis.lo, s.y_axis.hi, s.z_axis.lo, s.z_axis.hi, s.z_axis.lo,
                s.z_axis.hi);
        command("set xlabel {} rotate parallel offset 0,-0.6\nset ylabel {} rotate parallel offset 0,-0.6",
                quoted(s.x_axis.label), quoted(s.y_axis.label));
        command("set zlabel {} rotate by 90 offset -1,0", quoted(s.z_axis.label));
        command("set xtics {}\nset ytics {} offset 0,-0.35\nset ztics {} offset 0,0.45\nset border 31 lc rgb "
                "'#808080' lw 0.8",
                ticks(s.x_axis), ticks(s.y_axis), ticks(s.z_axis));
        command("set xyplane at {}\nset view 62,312,1.0,0.95\nunset colorbox", s.z_axis.lo);
        std::string palette;
        for (std::size_t i = 0; i < viridis_stops.size(); ++i)
            palette += fmt::format("{}{} '{}'", i == 0 ? "" : ", ", i, viridis_stops[i]);
        command("set palette defined ({})", palette);
        command("set pm3d depthorder border lc rgb '#40ffffff' lw 0.3");
        command("splot {} using 1:2:3 with pm3d notitle", block(rows));
        command("unset label\nset size 1,1\nset origin 0,0");
    }

    // Drawn in pixels, y downward from the table's top.
    void draw(const table& t, double top) {
        const double table_left = 24, table_width = width - 2 * table_left, height = height_of(t);
        command("set lmargin at screen 0\nset rmargin at screen 1\nset tmargin at screen {}\nset bmargin at "
                "screen {}",
                1 - top / height_, 1 - (top + height) / height_);
        bare({"", 0, width, 0}, {"", -height, 0, 0});
        double total = 0;
        for (const table::column& c : t.columns)
            total += c.width;
        double x = table_left;
        for (std::size_t c = 0; c < t.columns.size(); ++c) {
            const double w = table_width * t.columns[c].width / total;
            draw_cell({t.columns[c].title}, t.columns[c].numeric, x, w, 0);
            for (std::size_t r = 0; r < t.rows.size(); ++r)
                draw_cell(t.rows[r][c], t.columns[c].numeric, x, w, static_cast<double>(r + 1) * row_height);
            x += w;
        }
        for (std::size_t r = 0; r <= t.rows.size(); ++r) {
            const double y = static_cast<double>(r + 1) * row_height;
            command("set arrow from {0},{2} to {1},{2} nohead lc rgb '#808080' lw {3}", table_left,
                    width - table_left, -y, r == 0 ? 0.9 : 0.3);
        }
        double y = static_cast<double>(t.rows.size() + 1) * row_height + 14;
        for (const std::string& line : note_lines(t)) {
            command("set label {} at {},{} left font ',12' tc rgb '#808080'", quoted(line), table_left, -y);
            y += note_height;
        }
        command("plot NaN notitle\nunset arrow\nunset label\nunset object");
    }

    void draw_cell(const table::cell& c, bool numeric, double x, double w, double y) {
        const double middle = -y - row_height / 2;
        if (c.swatch)
            command("set object rectangle from {},{} to {},{} fs solid noborder fc rgb '#{:02x}{:02x}{:02x}'",
                    x + 12, middle - 9, x + w, middle + 9, (*c.swatch)[0], (*c.swatch)[1], (*c.swatch)[2]);
        else if (!c.text.empty())
            command("set label {} at {},{} {} font ',13' {}", quoted(c.text),
                    numeric  ? x + w
                    : x < 30 ? x
                             : x + 12,
                    middle, numeric ? "right" : "left", c.remarkable ? "tc rgb '#c0392b'" : "");
    }

    void build() {
        command("set multiplot\nset tics textcolor rgb 'black'\nset format '%h'");
        command("set label 1000 {} at screen 0.5,{} center front font ',17'", quoted(figure_.title),
                1 - 0.55 * title_height / height_);
        double top = title_height;
        if (figure_.surface) {
            draw(*figure_.surface);
            top += surface_height;
        }
        for (const panel& p : figure_.panels) {
            place(top, panel_height);
            draw(p);
            top += height_of(p);
        }
        if (!figure_.colors.rows.empty()) {
            const double height = static_cast<double>(figure_.colors.rows.size()) * strip_height;
            place(top, height);
            draw(figure_.colors);
            top += height + panel_foot;
        }
        if (figure_.cells) draw(*figure_.cells, top);
        command("unset multiplot\nunset label\nreset");
    }

    const figure& figure_;
    double height_;
    std::string data_, commands_;
    int blocks_ = 0;
};

std::string_view ending(format f) { return f == format::svg ? "svg" : f == format::png ? "png" : "pdf"; }

std::string terminal(format f, double height) {
    switch (f) {
    case format::svg:
        return fmt::format(
            "svg size {},{} dynamic noenhanced font 'DejaVu Sans,Arial,sans-serif,14' linewidth 1", width,
            height);
    case format::png:
        return fmt::format("pngcairo size {},{} noenhanced font 'DejaVu Sans,13.5' fontscale 1.55 linewidth "
                           "2 background '#ffffff'",
                           2 * width, 2 * height);
    case format::pdf:
        break;
    }
    return fmt::format("pdfcairo size {}in,{}in noenhanced font 'DejaVu Sans,10' linewidth 1", width / 100,
                       height / 100);
}

void replace_all(std::string& text, std::string_view from, std::string_view to) {
    for (std::size_t at = text.find(from); at != std::string::npos; at = text.find(from, at + to.size()))
        text.replace(at, from.size(), to);
}

void replace_element(std::string& text, const std::string& name, const std::string& content) {
    const std::size_t begin = text.find("<" + name + ">"), end = text.find("</" + name + ">");
    if (begin != std::string::npos && end != std::string::npos)
        text.replace(begin, end - begin, "<" + name + ">" + markup_text(content));
}

// gnuplot's SVG with a title for screen readers, ids of its own, and black turned into the reader's text colour.
std::string themed(std::string svg, const figure& f) {
    replace_element(svg, "title", f.title);
    replace_element(svg, "desc", f.caption);
    for (const char* quote : {"'", "\""}) {
        for (const char* name : {"gp", "gnuplot", "textbox", "greybox"})
            replace_all(svg, fmt::format("id={}{}", quote, name),
                        fmt::format("id={}{}-{}", quote, f.id, name));
        replace_all(svg, fmt::format("href={}#gp", quote), fmt::format("href={}#{}-gp", quote, f.id));
    }
    for (const char* name : {"gp", "textbox", "greybox"})
        replace_all(svg, fmt::format("url(#{}", name), fmt::format("url(#{}-{}", f.id, name));
    // groups that set color themselves would hide the reader's from currentColor
    for (const char* fixed : {" color=\"black\"", " color=\"white\""})
        replace_all(svg, fixed, "");
    for (const char* black : {"black", "rgb(0,0,0)", "rgb(  0,   0,   0)"})
        for (const char* use : {"fill", "stroke"}) {
            replace_all(svg, fmt::format("{}=\"{}\"", use, black), fmt::format("{}=\"currentColor\"", use));
            replace_all(svg, fmt::format("{}='{}'", use, black), fmt::format("{}='currentColor'", use));
        }
    replace_all(svg, "<svg ", "<svg role=\"img\" class=\"fresnel-figure\" ");
    const std::size_t end = svg.find("</desc>");
    if (end != std::string::npos)
        svg.insert(end + 7, "\n<style>svg:root{color:#1b1f24} image{image-rendering:pixelated} "
                            "@media (prefers-color-scheme:dark){svg:root{color:#e3e6ea}}</style>");
    return svg;
}

void run_gnuplot(const std::filesystem::path& script) {
    if (!has_tool("gnuplot")) throw failure("gnuplot: is not there; install the package gnuplot-nox");
    const tool_end end = run_tool({"gnuplot", "-d", script.string()}); // -d: no .gnuplotrc
    if (end.status != 0)
        throw failure(fmt::format("gnuplot: failed: {}", end.said.substr(0, end.said.find('\n'))));
}

} // namespace

void write_figures(const std::vector<figure>& figures, const std::string& dir,
                   const std::vector<format>& formats) {
    for (const figure& f : figures)
        check(f);
    const scratch_folder scratch;
    std::string all;
    for (const figure& f : figures) {
        const script drawing(f);
        for (const format kind : formats)
            all += fmt::format(
                "set terminal {}\nset output {}\n{}set output\n", terminal(kind, drawing.height()),
                quoted((scratch.path / (f.id + "." + std::string(ending(kind)))).string()), drawing.text());
    }
    write_file((scratch.path / "script").string(), all);
    run_gnuplot(scratch.path / "script");
    for (const figure& f : figures)
        for (const format kind : formats) {
            const std::string name = f.id + "." + std::string(ending(kind));
            std::string text = file_content(scratch.path / name).value_or("");
            if (text.empty()) throw failure(fmt::format("gnuplot: made no {}", name));
            write_file((std::filesystem::path(dir) / name).string(),
                       kind == format::svg ? themed(std::move(text), f) : text);
        }
}

std::string drawn(const figure& what, format kind) {
    const scratch_folder scratch;
    write_figures({what}, scratch.path.string(), {kind});
    return file_content(scratch.path / (what.id + "." + std::string(ending(kind)))).value_or("");
}

std::string inline_svg(const figure& what, const std::string& dir) {
    const std::string svg = file_content(std::filesystem::path(dir) / (what.id + ".svg")).value_or("");
    const std::size_t begin = svg.find("<svg "), style = svg.find("<style>"), end = svg.find("</style>");
    if (begin == std::string::npos || style == std::string::npos)
        throw failure(fmt::format("{}/{}.svg: cannot be read", dir, what.id));
    return svg.substr(begin, style - begin) + svg.substr(end + 8);
}

} // namespace fresnel
