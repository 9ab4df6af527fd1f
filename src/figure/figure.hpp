#pragma once

#include <nlohmann/json.hpp>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

// A figure is data; the writers turn it into SVG, PNG, PDF, CSV and JSON. Text is plain: nothing in a label is
// interpreted.

namespace fresnel {

/// Eleven colours of the perceptually even ramp viridis (van der Walt and Smith 2015), as #rrggbb.
inline constexpr std::array<std::string_view, 11> viridis_stops = {"#440154", "#482475", "#414487", "#355f8d",
                                                                   "#2a788e", "#21918c", "#22a884", "#44bf70",
                                                                   "#7ad151", "#bddf26", "#fde725"};

enum class stroke { solid, dashed, dotted, points };

/// One curve. A NaN in y is a gap. An empty label keeps it out of the legend.
struct series {
    std::string label;
    std::vector<double> x, y;
    std::string color = "#3b7dd8"; ///< #rrggbb
    stroke style = stroke::solid;
    double width = 2;
    std::string name = ""; ///< what the data are called where there is no legend; empty: as the label
};

/// A point worth pointing at, with a thin line down to the axis.
struct marker {
    double x, y;
    std::string label;
    std::string color = "#808080";
    bool at_foot = false; ///< the label stands at the foot of the line instead of beside the point
};

/// label carries the unit: "angle of incidence θ (degrees)".
struct axis {
    std::string label;
    double lo = 0, hi = 1;
    double tick = 0; ///< distance of the ticks, or their ratio; 0 lets the writer choose
    bool logarithmic = false;
};

/// Words in a panel, at a point of its axes.
struct note {
    enum class side { left, center, right };

    double x, y;
    std::string text;
    side align = side::center;     ///< which side of the text stands at the point
    std::string color = "#808080"; ///< #rrggbb
};

/// Curves over one pair of axes; a diagram has the axes' ranges, but no frame, ticks or legend.
struct panel {
    axis x, y;
    std::vector<series> curves;
    std::vector<marker> markers;
    std::vector<note> notes = {};
    bool diagram = false;
};

/// Width by height of a diagram's panel: ranges in this ratio show right angles as such.
inline constexpr double diagram_aspect = 744.0 / 330;

/// A row of colours along the x axis of `strips`: 8-bit sRGB, the first at x.lo and the last at x.hi.
struct strip {
    std::string label;
    std::vector<std::array<std::uint8_t, 3>> pixels;
};

struct strips {
    axis x;
    std::vector<strip> rows;
};

/// z[i][j] over x[i] and y[j], drawn in perspective.
struct height_field {
    axis x_axis, y_axis, z_axis;
    std::vector<double> x, y;
    std::vector<std::vector<double>> z;
};

/// Text in rows and columns; a cell with a colour is a swatch.
struct table {
    struct column {
        std::string title;
        double width = 1; ///< relative to the other columns
        bool numeric = true;
    };
    struct cell {
        std::string text;
        std::optional<std::array<std::uint8_t, 3>> swatch = {}; ///< 8-bit sRGB
        bool remarkable = false;                                ///< printed in an accent colour
    };

    std::vector<column> columns;
    std::vector<std::vector<cell>> rows;
    std::vector<std::string> notes; ///< sentences below, numbered from 1
};

/// What is drawn, top to bottom: a surface, the panels, the strips, a table.
struct figure {
    std::string id; ///< file name without its ending: letters, digits, - and _
    std::string title, caption;
    std::vector<panel> panels;
    strips colors;
    std::optional<height_field> surface = {};
    std::optional<table> cells = {};
};

enum class format { svg, png, pdf };

/// Writes dir/ID.svg and so on for every figure, all by one gnuplot process. Each file appears complete or not at
/// all. The SVG has a transparent background and text that follows the reader's light or dark scheme.
/// Throws failure naming the file, or the package to install where gnuplot is missing; std::invalid_argument for a
/// figure whose series or strips do not fit together.
void write_figures(const std::vector<figure>& figures, const std::string& dir,
                   const std::vector<format>& formats);

/// The SVG text of a figure in dir, made to stand inside an HTML page: no XML header, no style of its own, ids
/// that are unique to the figure; it takes its text colour from the page.
std::string inline_svg(const figure& what, const std::string& dir);

/// The whole figure, enough to draw it again: {id, title, caption, series: [{label, panel, x, y, color, style,
/// width, x_axis, y_axis}], markers, notes, strips, surface, table}. A NaN becomes null.
nlohmann::json to_json(const figure& what);

/// The series as columns. Series over the same x share one column of it, which comes first; otherwise x and y of
/// each stand side by side, with empty cells where a series is shorter. A surface is rows of x, y and z.
std::string to_csv(const figure& what);

/// The content of the file that `write_figures` would write.
std::string drawn(const figure& what, format kind);

/// A plain picture of the rows, without axes, one pixel column per colour and `height` pixels per row.
void write_strip_png(const std::string& path, const std::vector<strip>& rows, int height);

/// Text as it must stand in SVG and HTML, in an element or a quoted attribute.
std::string markup_text(std::string_view text);

/// JSON as commands print and write it: two spaces deep, a line end at its end, numbers in the fewest digits that read
/// back as the same double. The name of a file, which stands for a user's table, need not be UTF-8: what is not becomes
/// U+FFFD.
std::string json_text(const nlohmann::json& value);

/// Writes text to a file beside the wanted one and renames it. Throws failure naming the path.
void write_file(const std::string& path, const std::string& text);

} // namespace fresnel
