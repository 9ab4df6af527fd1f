#include "sources/parts.hpp"

#include "analysis/angles.hpp"
#include "analysis/curve.hpp"
#include "materials/catalog.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/slab.hpp>

#include <fmt/format.h>

namespace fresnel {

namespace {

using namespace draw;

constexpr double water = 4.0 / 3, crown_glass = 1.52, diamond = 2.417;

// ---- figure 1: the ray at the boundary --------------------------------------------------------------------

void add(panel& p, std::vector<series> curves) {
    for (series& s : curves)
        p.curves.push_back(std::move(s));
}

// An arc around the origin between two angles from the normal, in radians.
series arc(double radius, double from, double to, const std::string& color) {
    series s{"", {}, {}, color, stroke::solid, 1.4};
    for (int i = 0; i <= 40; ++i) {
        const double a = from + (to - from) * i / 40;
        s.x.push_back(radius * std::sin(a)), s.y.push_back(radius * std::cos(a));
    }
    return s;
}

regenerated figure_1() {
    const double theta = radians(50);
    const vector3<double> n{0, 1, 0}, l{-std::sin(theta), std::cos(theta), 0};
    const vector3<double> r = reflect(l, n), t = refract(l, n, crown_glass);

    panel p{axis_of("", -1.2 * diagram_aspect, 1.2 * diagram_aspect, 0), axis_of("", -1.2, 1.2), {}, {}};
    p.diagram = true;
    p.curves.push_back(line(-2.2, 0, 2.2, 0, gray, 2));
    p.curves.push_back(line(0, -1.1, 0, 1.1, gray, 1.2, stroke::dashed));
    add(p, arrow(l.x, l.y, 0, 0, blue, 2.4));
    add(p, arrow(0, 0, r.x, r.y, blue, 2.4));
    add(p, arrow(0, 0, t.x, t.y, orange, 2.4));
    p.curves.push_back(arc(0.35, -theta, 0, gray));
    p.curves.push_back(arc(0.42, 0, theta, gray));
    const double theta_t = std::acos(refracted_cosine(crown_glass, l.y));
    p.curves.push_back(arc(0.38, radians(180) - theta_t, radians(180), gray));
    p.notes = {{-1.35, 0.12, "material i, index n_i"},
               {-1.35, -0.12, "material t, index n_t > n_i"},
               {l.x - 0.06, l.y + 0.04, "light", note::side::right, blue},
               {r.x + 0.06, r.y + 0.04, "reflected: R", note::side::left, blue},
               {t.x + 0.08, t.y, "refracted: T = 1 − R", note::side::left, orange},
               {-0.2, 0.45, "θ"},
               {0.26, 0.52, "θ"},
               {0.16, -0.5, "θ_t"}};
    figure f{"", "", "A ray of light meets a denser material.", {p}, {}};
    return {f,
            "Light in the material i meets the denser material t; θ runs from 0, along the normal, to 90°.",
            fmt::format("Drawn by reflect and refract at θ = 50° from air into crown glass: θ_t = {:.2f}°, "
                        "R = {:.4f}, T = {:.4f}.",
                        degrees(theta_t), dielectric(1.0, crown_glass, l.y).reflectance(),
                        dielectric(1.0, crown_glass, l.y).transmittance()),
            "θ = 50°, n_t / n_i = 1.52"};
}

// ---- figures 2 to 4 ---------------------------------------------------------------------------------------

regenerated figure_2() {
    const auto at = [](double c) { return dielectric(1.0, crown_glass, c); };
    panel p{horizontal(against::theta), axis_of("reflectance", -0.1, 1, 0.2), {}, {}};
    p.curves = {curve(
                    "R_s (perpendicular)", [&](double c) { return at(c).R_s; }, green),
                curve(
                    "R", [&](double c) { return at(c).reflectance(); }, gray, stroke::solid, 2.6),
                curve("R_p (parallel)", [&](double c) { return at(c).R_p; }, blue)};
    const double brewster = degrees_of_cosine(brewster_cosine(crown_glass));
    p.notes = {{brewster, -0.05, fmt::format("Brewster, {:.2f}°", brewster), note::side::center, blue}};
    figure f{"", "", "Reflectance and its two polarised parts.", {p}, {}};
    return {f,
            "R is the mean of the two polarisations; the perpendicular one lies above it, the parallel one "
            "below.",
            fmt::format("R(0) = {:.5f}; the parallel part vanishes at {:.2f}°; R_s − R is at most {:.3f}.",
                        at(1).reflectance(), brewster, polarisation_gap(crown_glass).value),
            "n_t / n_i = 1.52, crown glass of table 1; the text gives none"};
}

regenerated figure_3() {
    const std::vector<double> etas = {1.1, water, crown_glass, 2, diamond, 3.5};
    panel p{horizontal(against::theta), axis_of("reflectance", 0, 1, 0.2), {}, {}};
    for (std::size_t i = 0; i < etas.size(); ++i)
        p.curves.push_back(
            curve(fmt::format("n = {:.4g}", etas[i]), exact_dielectric(etas[i]), ramp(i, etas.size())));
    figure f{"", "", "Reflectance for indices of refraction from 1.1 to 3.5.", {p}, {}};
    return {f, "A family of curves over the index of refraction.",
            fmt::format("R(0) rises from {:.4f} at n = 1.1 to {:.4f} at 3.5; every curve ends at 1.",
                        normal_reflectance(1.0, 1.1, 0.0), normal_reflectance(1.0, 3.5, 0.0)),
            "n = 1.1, 4/3 (water), 1.52 (crown glass), 2, 2.417 (diamond), 3.5; the text names none"};
}

regenerated figure_4() {
    panel p{horizontal(against::theta), axis_of("reflectance", 0, 1, 0.2), {}, {}};
    panel errors{horizontal(against::theta), axis_of("approximation − exact", -0.2, 0.7, 0.2), {}, {}};
    const auto add_one = [&](double eta, const std::string& name, const char* color) {
        const double f0 = normal_reflectance(1.0, eta, 0.0);
        const curve_function schlick_curve = [f0](double c) { return schlick(f0, c); };
        p.curves.push_back(curve(name + ", exact", exact_dielectric(eta), color, stroke::solid, 2.2));
        p.curves.push_back(curve(name + ", eq. 10", schlick_curve, color, stroke::dashed, 1.8));
        errors.curves.push_back(curve(
            name + ", eq. 10", [=](double c) { return schlick_curve(c) - exact_dielectric(eta)(c); }, color));
        errors.curves.push_back(curve(
            name + ", 1 − cos", [=](double c) { return one_minus_cos(c) - exact_dielectric(eta)(c); }, color,
            stroke::dotted));
    };
    add_one(water, "water", blue);
    add_one(diamond, "diamond", violet);
    p.curves.push_back(
        curve("1 − cos θ", [](double c) { return one_minus_cos(c); }, orange, stroke::dotted, 2));
    figure f{"", "", "Exact reflectance of water and diamond, and two approximations.", {p, errors}, {}};
    return {f, "Equation 10 gives good results, 1 − cos θ is visually unacceptable.",
            fmt::format("Equation 10 is off by at most {:.3f} for water (at {:.1f}°) and {:.3f} for diamond; "
                        "1 − cos θ by {:.3f} and {:.3f}.",
                        schlick_error(water).size(), schlick_error(water).theta_deg(),
                        schlick_error(diamond).size(), one_minus_cos_error(water).size(),
                        one_minus_cos_error(diamond).size()),
            "n = 4/3 and 2.417, as in table 1"};
}

// ---- what the text leaves out -----------------------------------------------------------------------------

regenerated windowpane() {
    const auto pane = [](double c) { return window(1.0, crown_glass, c); };
    panel p{horizontal(against::theta), axis_of("reflectance", 0, 1, 0.2), {}, {}};
    p.curves = {curve(
                    "pane", [&](double c) { return pane(c).reflectance(); }, blue, stroke::solid, 2.4),
                curve(
                    "pane, R_s", [&](double c) { return pane(c).R_s; }, green, stroke::solid, 1.4),
                curve(
                    "pane, R_p", [&](double c) { return pane(c).R_p; }, violet, stroke::solid, 1.4),
                curve("one boundary", exact_dielectric(crown_glass), gray, stroke::dashed, 1.8),
                curve(
                    "absorbing, τ = 0.5",
                    [](double c) { return window_absorbing(1.0, crown_glass, 0.5, c).reflectance(); }, orange,
                    stroke::dotted, 2)};
    figure f{"", "", "A windowpane: two boundaries, without interference.", {p}, {}};
    return {f,
            "Correct windowpanes require more work, since light crosses two boundaries; the text leaves them "
            "out.",
            fmt::format("A pane reflects {:.4f} straight on where one boundary reflects {:.4f}, and {:.3f} "
                        "against {:.3f} at 80°.",
                        pane(1).reflectance(), exact_dielectric(crown_glass)(1),
                        pane(cosine_of_degrees(80)).reflectance(),
                        exact_dielectric(crown_glass)(cosine_of_degrees(80))),
            "n = 1.52; incoherent: thicker than the light's coherence"};
}

regenerated lake() {
    panel p{horizontal(against::theta), axis_of("reflectance", 0, 1, 0.2), {}, {}};
    const auto f0 = normal_reflectance(1.0, water, 0.0);
    p.curves = {
        curve("from above, exact", exact_dielectric(water), blue, stroke::solid, 2.4),
        curve("from below, exact", exact_dielectric(1 / water), green, stroke::solid, 2.4),
        curve("eq. 10, either side", [=](double c) { return schlick(f0, c); }, orange, stroke::dashed)};
    const double critical = degrees_of_cosine(critical_cosine(1 / water));
    p.markers = {{critical, 0.5, fmt::format("critical, {:.2f}°", critical), green}};
    figure f{"", "", "A lake, seen from above and by a diver.", {p}, {}};
    return {f,
            "A lake is one boundary as long as the viewer is above it; from below the report no longer "
            "applies.",
            fmt::format("From below everything is reflected beyond {:.2f}°, where equation 10 errs by "
                        "{:.2f}; on average {:.4f} from above and {:.4f} from below.",
                        critical, largest([=](double c) {
                                      return schlick(f0, c) - exact_dielectric(1 / water)(c);
                                  }).size(),
                        hemispherical_average(1, water, 0), hemispherical_average(water, 1, 0)),
            "n = 4/3"};
}

// ---- table 1 ----------------------------------------------------------------------------------------------

struct index_row {
    std::string_view name, published, measured;
    double tolerance;
    std::string_view why = {};
};

// The measured material that each row can be held against, at the sodium line; none is known for the oils and for
// names that span many glasses.
constexpr index_row index_rows[] = {
    {"Vacuum", "vacuum", "", 0},
    {"Air", "air-wloka", "air", 2e-5, "standard air at 15 °C; 1.000293 is air at 0 °C"},
    {"Ice", "ice-wloka", "ice", 0.005},
    {"Water", "water-wloka", "water", 0.005, "4/3 is water at 589 nm to three digits, 1.333"},
    {"Ethyl alcohol", "ethanol-wloka", "ethanol", 0.005},
    {"Fluorite", "fluorite-wloka", "fluorite", 0.005},
    {"Poppy seed oil", "poppy-seed-oil", "", 0},
    {"Olive oil", "olive-oil", "", 0},
    {"Linseed oil", "linseed-oil", "", 0},
    {"Plexiglas", "plexiglas-wloka", "pmma", 0.005,
     "acrylic glass has 1.49 at 589 nm; 1.51 is too high by four times its spread over makers"},
    {"Immersion oil", "immersion-oil", "", 0},
    {"Crown glass", "crown-glass", "n-bk7", 0.005},
    {"Quartz", "quartz-wloka", "quartz", 0.005},
    {"Salt", "salt-wloka", "salt", 0.005},
    {"Light flint glass", "light-flint-glass", "", 0},
    {"Dense flint glass", "dense-flint-glass", "", 0},
    {"Tourmaline", "tourmaline", "", 0},
    {"Garnet", "garnet", "", 0},
    {"Zircon", "zircon", "", 0},
    {"Cubic zirconia", "cubic-zirconia-wloka", "cubic-zirconia", 0.035},
    {"Diamond", "diamond-wloka", "diamond-peter", 0.005},
    {"Rutile", "rutile-wloka", "rutile-e", 0.005},
    {"Gallium phosphide", "gallium-phosphide-wloka", "gallium-phosphide", 0.005,
     "3.5 is near its value at 550 nm; at 589 nm it is lower"},
};

regenerated table_1() {
    table t{{{"material", 1.5, false},
             {"n, printed", 1},
             {"n at 589.3 nm", 1},
             {"difference", 1},
             {"F0", 0.8},
             {"max |eq. 10 − exact|", 1.5},
             {"note", 0.5}},
            {},
            {}};
    regenerated result;
    for (const index_row& row : index_rows) {
        const material& printed = *find_material(row.published);
        const double n = index_at(printed, 589.3).n, f0 = normal_reflectance(1.0, n, 0.0);
        std::vector<table::cell> cells = {{std::string(row.name)},
                                          {has_range(printed)
                                               ? fmt::format("{}–{}", printed.index[0], printed.index[1])
                                               : fmt::format("{}", n)},
                                          {"–"},
                                          {"–"},
                                          {fmt::format("{:.4f}", f0)},
                                          {n > 1.01 ? fmt::format("{:.3f}", schlick_error(n).size()) : "–"},
                                          {""}};
        if (!row.measured.empty()) {
            const check c{fmt::format("n of {}, measured {}", row.name, row.measured), n,
                          index_at(*find_material(row.measured), 589.3).n, row.tolerance,
                          std::string(row.why)};
            cells[2].text = fmt::format("{:.6g}", c.computed),
            cells[3].text = fmt::format("{:+.5f}", c.difference());
            cells[3].remarkable = !c.matched();
            if (!row.why.empty()) {
                t.notes.push_back(fmt::format("{}: {}.", row.name, row.why));
                cells[6].text = fmt::format("{}", t.notes.size());
            }
            result.checks.push_back(c);
        }
        t.rows.push_back(std::move(cells));
    }
    result.drawing = {"", "", "Indices of refraction, beside measured materials at the sodium line.", {}, {}};
    result.drawing.cells = std::move(t);
    result.says = "Selected indices of refraction from 1.0, called the least, to 3.5, called the greatest.";
    result.measured =
        "Thirteen of the rows have a measured counterpart. Garnet and cubic zirconia are ranges, whose "
        "middle is used. Dense flint (1.66) stands before tourmaline (1.62), out of order.";
    result.chosen = "the sodium line, 589.3 nm; the table names no wavelength";
    return result;
}

} // namespace

std::vector<source_figure> wloka_figures() {
    const auto of = [](std::string_view place) {
        return fmt::format("Wloka 2002, Fresnel Reflection, {}", place);
    };
    return {{"wloka-1", of("fig. 1, p. 5"), "A ray at the boundary of two materials", figure_1},
            {"wloka-2", of("fig. 2, p. 6"), "Reflectance R and its polarised parts", figure_2},
            {"wloka-3", of("fig. 3, p. 7"), "Fresnel's formula for many indices", figure_3},
            {"wloka-4", of("fig. 4, p. 9"), "Water and diamond: exact, equation 10, 1 − cos θ", figure_4},
            {"wloka-windowpane", of("introduction, p. 4"), "A windowpane has two boundaries", windowpane},
            {"wloka-lake", of("introduction, p. 4"), "A lake from above and from below", lake},
            {"wloka-table-1", of("table 1, p. 16"), "Indices of refraction", table_1}};
}

} // namespace fresnel
