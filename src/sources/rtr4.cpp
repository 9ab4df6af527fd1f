#include "sources/parts.hpp"

#include "analysis/angles.hpp"
#include "analysis/compare.hpp"
#include "analysis/curve.hpp"
#include "analysis/drawing.hpp"
#include "analysis/fit.hpp"
#include "analysis/metalness.hpp"
#include "materials/catalog.hpp"
#include "materials/observer.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>

#include <fmt/format.h>

namespace fresnel {

namespace {

using namespace draw;

// The substances of figures 9.20 and 9.22 and the pages we take for them; the book names no data.
struct substance {
    const char *id, *name, *material;
};
constexpr substance glass{"glass", "glass", "n-bk7"}, copper{"copper", "copper", "copper"},
    aluminium{"aluminium", "aluminium", "aluminium"}, chromium{"chromium", "chromium", "chromium"},
    iron{"iron", "iron", "iron"}, zinc{"zinc", "zinc", "zinc"};

constexpr color_space screen = color_space::srgb;

std::string page_of(const material& m) { return fmt::format("{}, {}", m.name, m.page); }

// Angles whose sines are evenly spread, for the strips.
std::vector<double> cosines_by_sine() {
    std::vector<double> cosines;
    for (int i = 0; i <= 300; ++i)
        cosines.push_back(std::sqrt((1 - i / 300.0) * (1 + i / 300.0)));
    return cosines;
}

std::vector<double> sines(const std::vector<double>& cos_i) {
    std::vector<double> s;
    for (const double c : cos_i)
        s.push_back(std::sqrt((1 - c) * (1 + c)));
    return s;
}

std::vector<rgb> schlick_colours(const rgb& f0, const std::vector<double>& cos_i) {
    std::vector<rgb> colours;
    for (const double c : cos_i)
        colours.push_back({schlick(f0[0], c), schlick(f0[1], c), schlick(f0[2], c)});
    return colours;
}

void add_channels(panel& p, const std::vector<rgb>& values, const std::vector<double>& x, stroke style) {
    constexpr std::array<const char*, 3> letters = {"R", "G", "B"};
    for (std::size_t c = 0; c < 3; ++c) {
        series s = channel_series(values, x, c);
        s.style = style, s.width = style == stroke::solid ? 2.2 : 1.8;
        s.label = fmt::format("{}{}", letters[c], style == stroke::solid ? "" : ", Schlick");
        p.curves.push_back(std::move(s));
    }
}

axis reflectance(const panel& p) { return reflectance_axis("reflectance (linear sRGB)", p.curves); }

std::string colour_text(const rgb& c) { return fmt::format("({:.3f}, {:.3f}, {:.3f})", c[0], c[1], c[2]); }

// ---- figure 9.20 ------------------------------------------------------------------------------------------

regenerated figure_9_20(const substance& what) {
    const material& m = *find_material(what.material);
    const rgb_curve by_angle = exact_curve(m, screen, 1);
    const std::vector<double> cosines = cosines_by_sine();
    const std::vector<rgb> by_sine = exact_colours(m, screen, 1, cosines);
    figure f{"",
             "",
             "Reflectance over wavelength and angle; as colours against the angle, and against its sine; "
             "the colours themselves.",
             {},
             {horizontal(against::sine), {color_strip("color", by_sine, screen, 1)}}};
    f.surface = spectral_height_field(m, 1);
    f.panels.push_back({horizontal(against::theta), {}, {}, {}});
    add_channels(f.panels.back(), by_angle.value, by_angle.theta_deg, stroke::solid);
    f.panels.back().y = reflectance(f.panels.back());
    f.panels.push_back({horizontal(against::sine), {}, {}, {}});
    add_channels(f.panels.back(), by_sine, sines(cosines), stroke::solid);
    f.panels.back().y = reflectance(f.panels.back());

    const auto at_75 = static_cast<std::size_t>(
        std::lower_bound(by_angle.theta_deg.begin(), by_angle.theta_deg.end(), 75.0) -
        by_angle.theta_deg.begin());
    std::size_t lowest = 0;
    for (std::size_t a = 0; a < by_angle.value.size(); ++a)
        if (by_angle.value[a][1] < by_angle.value[lowest][1]) lowest = a;
    const rgb &f0 = by_angle.value[0], &v75 = by_angle.value[at_75];
    return {f,
            "The curves barely change until about 75° and then go to 1 quickly, mostly monotonically; "
            "aluminum has "
            "a slight dip. Those of glass coincide.",
            fmt::format("F0 is {}, at 75° it is {}: {:.2f} times as much in green. {}", colour_text(f0),
                        colour_text(v75), v75[1] / f0[1],
                        lowest == 0 ? std::string("Green only rises.")
                                    : fmt::format("Green is least at {:.1f}°, {:.3f}.",
                                                  by_angle.theta_deg[lowest], by_angle.value[lowest][1])),
            fmt::format("{}; the book names no data. {}", page_of(m), default_recipe(screen).text)};
}

regenerated figure_9_21() {
    panel p{axis_of("", -1.15 * diagram_aspect, 1.15 * diagram_aspect, 0), axis_of("", -0.9, 1.4), {}, {}};
    p.diagram = true;
    series circle{"", {}, {}, gray, stroke::solid, 2};
    for (int i = 0; i <= 180; ++i) {
        const double a = radians(i - 90);
        circle.x.push_back(std::sin(a)), circle.y.push_back(std::cos(a));
    }
    p.curves.push_back(circle);
    p.curves.push_back(line(-1.25, -0.35, 1.25, -0.35, gray, 1.2));
    for (int i = 0; i <= 6; ++i) {
        const double a = radians(15 * i), x = std::sin(a), y = std::cos(a);
        const std::string color = ramp(static_cast<std::size_t>(i), 7);
        p.curves.push_back(line(x, y, x, -0.35, color, 1.4, stroke::dashed));
        p.curves.push_back(line(x, y, 1.22 * x, 1.22 * y, color, 2));
        if (i > 0) p.curves.push_back(line(std::sin(a - radians(15)), -0.35, x, -0.35, color, 5));
        p.notes.push_back({1.31 * x + 0.02, 1.29 * y, fmt::format("{}°", 15 * i), note::side::left, color});
        if (i % 2 == 0 && i != 4)
            p.notes.push_back({x, -0.48, fmt::format("{:.2f}", x), note::side::center, color});
    }
    p.notes.push_back({-1.3, -0.35, "screen", note::side::right});
    p.notes.push_back({0, -0.68, "distance from the middle: sin θ"});
    p.notes.push_back({-1.5, 1.2, "eye far above", note::side::right});
    figure f{
        "", "", "A ball seen from far above: equal steps of θ take ever less room on the screen.", {p}, {}};
    return {f,
            "Tilted surfaces are foreshortened by the sine of the angle between view and normal, so that sin "
            "θ is "
            "the axis that shows each part as large as it is seen.",
            fmt::format(
                "On a ball, the part beyond 75° is {:.1f} % of the disk's width and {:.1f} % of its area.",
                100 * (1 - std::sin(radians(75))), 100 * square(std::cos(radians(75)))),
            "steps of 15°"};
}

// ---- figure 9.22 ------------------------------------------------------------------------------------------

regenerated figure_9_22(const substance& what) {
    const material& m = *find_material(what.material);
    const std::vector<double> cosines = cosines_by_sine();
    const std::vector<rgb> exact = exact_colours(m, screen, 1, cosines);
    const std::vector<rgb> approximate = schlick_colours(exact.front(), cosines);
    panel p{horizontal(against::sine), {}, {}, {}};
    add_channels(p, exact, sines(cosines), stroke::solid);
    add_channels(p, approximate, sines(cosines), stroke::dotted);
    p.y = reflectance(p);
    figure f{"",
             "",
             "Solid: exact. Dotted: Schlick. The strips show the two as colours.",
             {p},
             {horizontal(against::sine),
              {color_strip("exact", exact, screen, 1), color_strip("Schlick", approximate, screen, 1)}}};
    const curve_error error = schlick_error(m, screen);
    const std::size_t worst = error.worst_channel();
    return {f,
            "Six substances; the last three are chosen for diverging from Schlick most. Even their errors "
            "are called "
            "quite subtle.",
            fmt::format(
                "Schlick is off by {:.3f} at {:.1f}°; the colour differs by at most ΔE {:.1f} (CIEDE2000), "
                "at {:.1f}°.",
                error.max[worst], error.max_theta[worst], error.delta_e_max, error.delta_e_theta),
            fmt::format("{}; the book names no data", page_of(m))};
}

// ---- figure 9.24 and the parameters -----------------------------------------------------------------------

regenerated figure_9_24() {
    const double glass_index = 1.5;
    panel p{horizontal(against::theta), axis_of("reflectance", 0, 1, 0.2), {}, {}};
    p.curves = {curve("external", exact_dielectric(glass_index), blue, stroke::solid, 2.4),
                curve("internal", exact_dielectric(1 / glass_index), green, stroke::solid, 2.4),
                curve(
                    "Schlick with θ_t", [=](double c) { return schlick_internal(1 / glass_index, c); }, gray,
                    stroke::dashed)};
    const double critical = degrees_of_cosine(critical_cosine(1 / glass_index));
    p.markers = {{critical, 0.5, fmt::format("θ_c = {:.2f}°", critical), green}};
    figure f{"", "", "Glass and air, from outside and from inside.", {p}, {}};
    return {
        f,
        "The internal curve looks like the external one compressed: the same F0, and 1 at the critical angle "
        "instead of 90°; on average it is higher. sin θ_c = (1 − √F0) / (1 + √F0).",
        fmt::format(
            "Both begin at {:.4f}; θ_c = {:.4f}° from the indices and {:.4f}° from F0; the averages are "
            "{:.4f} and {:.4f}.",
            normal_reflectance(1.0, glass_index, 0.0), critical,
            degrees(std::asin(sin_critical(normal_reflectance(1.0, glass_index, 0.0)))),
            hemispherical_average(1, glass_index, 0), hemispherical_average(glass_index, 1, 0)),
        "n = 1.5; the book names none"};
}

regenerated gulbrandsen_parameters() {
    const auto family = [](const std::string& name, const std::vector<double>& values, auto model) {
        panel p{horizontal(against::theta), axis_of("reflectance", 0, 1, 0.2), {}, {}};
        for (std::size_t i = 0; i < values.size(); ++i)
            p.curves.push_back(curve(
                fmt::format("{} = {}", name, values[i]), [=](double c) { return model(values[i], c); },
                ramp(i, values.size())));
        return p;
    };
    figure f{
        "",
        "",
        "Above: reflectance r at g = 0.5. Below: edge tint g at r = 0.6.",
        {family("r", {0.1, 0.3, 0.5, 0.7, 0.9}, [](double r, double c) { return gulbrandsen(r, 0.5, c); }),
         family("g", {0, 0.25, 0.5, 0.75, 1}, [](double g, double c) { return gulbrandsen(0.6, g, c); })},
        {}};
    return {f, "Gulbrandsen's approximation can match metals closely, at a higher cost than Schlick's.",
            fmt::format(
                "r is the reflectance at normal incidence, g bends the rest: at cos θ = 1/7 and r = 0.6 the "
                "reflectance runs from {:.3f} (g = 0) to {:.3f} (g = 1).",
                gulbrandsen(0.6, 0.0, ratio<double, 1, 7>()), gulbrandsen(0.6, 1.0, ratio<double, 1, 7>())),
            "r = 0.1 to 0.9, g = 0 to 1; the book shows none"};
}

regenerated f90_and_power() {
    panel edges{horizontal(against::theta), axis_of("reflectance", 0, 1, 0.2), {}, {}};
    const std::vector<double> f90s = {0, 0.25, 0.5, 0.75, 1};
    for (std::size_t i = 0; i < f90s.size(); ++i)
        edges.curves.push_back(curve(
            fmt::format("F90 = {}", f90s[i]), [=](double c) { return schlick_f90(0.04, f90s[i], c); },
            ramp(i, f90s.size())));
    const material& m = *find_material("chromium");
    const optical_index index = index_at(m, 550);
    const double f0 = normal_reflectance(1.0, index.n, index.k);
    const double best = fit("schlick_power", channel_of(index))[2];
    const auto with = [=](double power) {
        return [=](double c) { return schlick_power(f0, 1.0, power, c); };
    };
    panel sharpness{horizontal(against::theta), axis_of("reflectance", 0.4, 1, 0.1), {}, {}};
    sharpness.curves = {
        curve("chromium, 550 nm", exact_conductor(index.n, index.k), gray, stroke::solid, 2.6)};
    const std::vector<double> powers = {3, 5, 8, best};
    for (std::size_t i = 0; i < powers.size(); ++i)
        sharpness.curves.push_back(curve(fmt::format("power {:.3g}", powers[i]), with(powers[i]),
                                         ramp(i, powers.size()), stroke::dashed, 1.8));
    const auto off = [&](double power) {
        return largest([&](double c) { return with(power)(c) - exact_conductor(index.n, index.k)(c); })
            .size();
    };
    figure f{
        "", "", "Above: F90 at F0 = 0.04. Below: the power 1/p, beside chromium.", {edges, sharpness}, {}};
    return {
        f,
        "The general form of Schlick's approximation has the reflectance at 90° and the power as parameters, "
        "mostly for artistic control; another power can match some materials better.",
        fmt::format("For chromium at 550 nm a power of {:.2f} errs by {:.3f}, where 5 errs by {:.3f}.", best,
                    off(best), off(5)),
        "F0 = 0.04, F90 = 0 to 1; powers 3, 5, 8 and the least-squares one; the book shows none"};
}

regenerated metalness() {
    const metalness_law& law = find_metalness_law("unreal");
    const rgb gold = colour_at(*find_material("gold"), screen, 1, 1);
    const rgb metal = apply_gamut(gold, gamut::clamp), paint = {0.05, 0.1, 0.4};
    const auto at = [&](const rgb& base, double m) { return to_surface(law, {base, m, 0.5}); };

    constexpr std::array<const char*, 3> letters = {"R", "G", "B"};
    panel blend{
        axis_of("metalness of one base color", 0, 1, 0.2), axis_of("F0 and albedo", 0, 1, 0.2), {}, {}};
    panel border{axis_of("place between paint and gold, as a texture blends", 0, 1, 0.2),
                 axis_of("error of F0 and albedo", -0.3, 0.3, 0.1),
                 {},
                 {}};
    for (std::size_t c = 0; c < 3; ++c) {
        blend.curves.push_back(sampled(
            fmt::format("F0, {}", letters[c]), [&](double m) { return at(metal, m).f0[c]; }, 0, 1,
            channel_colors[c]));
        blend.curves.push_back(sampled(
            fmt::format("albedo, {}", letters[c]), [&](double m) { return at(metal, m).albedo[c]; }, 0, 1,
            channel_colors[c], stroke::dashed));
        const auto f0_error = [&, c](double t) { return metalness_border_error(law, paint, metal, t).f0[c]; };
        const auto albedo_error = [&, c](double t) {
            return metalness_border_error(law, paint, metal, t).albedo[c];
        };
        border.curves.push_back(
            sampled(fmt::format("F0, {}", letters[c]), f0_error, 0, 1, channel_colors[c]));
        border.curves.push_back(sampled(fmt::format("albedo, {}", letters[c]), albedo_error, 0, 1,
                                        channel_colors[c], stroke::dashed));
    }
    figure f{"",
             "",
             "Above: F0 and albedo of gold's color against metalness. Below: what blending the parameters "
             "across a "
             "border gets wrong against blending the surfaces.",
             {blend, border},
             {}};
    double worst = 0;
    for (int i = 0; i <= 100; ++i)
        for (const double e : metalness_border_error(law, paint, metal, i / 100.0).f0)
            worst = std::max(worst, std::abs(e));
    return {f,
            "Metal has F0 = surface color and no diffuse, a dielectric a fixed F0 and the color as diffuse; "
            "artifacts can "
            "occur at borders between the two.",
            fmt::format("Between blue paint and gold, F0 is off by up to {:.3f}: the blend takes m (1 − m) "
                        "of the difference of "
                        "the two base colors.",
                        worst),
            "Unreal's law with specular 0.5; gold (clamped to sRGB) and a paint of (0.05, 0.1, 0.4)"};
}

} // namespace

std::vector<source_figure> rtr4_figures() {
    const auto of = [](std::string_view place) {
        return fmt::format("Real-Time Rendering, 4th ed., {}", place);
    };
    std::vector<source_figure> all;
    for (const substance& s : {glass, copper, aluminium})
        all.push_back({fmt::format("rtr4-9-20-{}", s.id), of("fig. 9.20"),
                       fmt::format("Fresnel reflectance of {}, four ways", s.name),
                       [s] { return figure_9_20(s); }});
    all.push_back({"rtr4-9-21", of("fig. 9.21"), "Foreshortening and the sine axis", figure_9_21});
    for (const substance& s : {glass, copper, aluminium, chromium, iron, zinc})
        all.push_back({fmt::format("rtr4-9-22-{}", s.id), of("fig. 9.22"),
                       fmt::format("Schlick against exact: {}", s.name), [s] { return figure_9_22(s); }});
    all.push_back({"rtr4-gulbrandsen", of("sec. 9.5.1"), "Gulbrandsen's r and g", gulbrandsen_parameters});
    all.push_back({"rtr4-f90-power", of("eq. 9.18"), "F90 and the power", f90_and_power});
    for (source_figure& one : rtr4_tables())
        all.push_back(std::move(one));
    all.push_back({"rtr4-metalness", of("sec. 9.5.2"), "Metalness, and the border of a metal", metalness});
    all.push_back({"rtr4-9-24", of("fig. 9.24"), "Internal and external reflection", figure_9_24});
    return all;
}

} // namespace fresnel
