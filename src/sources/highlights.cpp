#include "sources/parts.hpp"

#include "analysis/curve.hpp"

#include <fresnel/shading.hpp>

#include <fmt/format.h>

namespace fresnel {

namespace {

using namespace draw;

constexpr double seen = 0.2, reflected = 0.04;

regenerated opacity() {
    const double attenuation = opacity_attenuation(seen, reflected);
    panel p{horizontal(against::theta), axis_of("opacity", 0, 1, 0.2), {}, {}};
    const auto fresnel_part = [](double c) { return opacity_fresnel(reflected, c); };
    const auto silhouette = [=](double c) { return opacity_silhouette(attenuation, c); };
    const auto layer = [=](double c) {
        return opacity_slab(-std::log(1 - attenuation), refracted_cosine(1.5, c));
    };
    p.curves = {curve("by reflection, α_F", fresnel_part, blue),
                curve("α_att = a / cos θ", silhouette, green),
                curve(
                    "total", [=](double c) { return opacity_total(silhouette(c), fresnel_part(c)); }, gray,
                    stroke::solid, 2.6),
                curve("α_att of a slab", layer, green, stroke::dotted),
                curve(
                    "total of the slab", [=](double c) { return opacity_total(layer(c), fresnel_part(c)); },
                    gray, stroke::dotted)};
    figure f{"", "", "Opacity of a thin semitransparent layer against the viewing angle.", {p}, {}};
    return {
        f,
        "Opacity by reflection rises from a user's value to 1; the opacity by attenuation combines with it "
        "as 1 − (1 − α_att)(1 − α_F); total and Fresnel opacity at normal view fix the constant.",
        fmt::format("Total {} and Fresnel {} at normal view give an attenuation of {:.6f}. A total below the "
                    "Fresnel opacity has no solution: 0.1 and 0.2 would give {:.3f}.",
                    seen, reflected, attenuation, opacity_attenuation(0.1, 0.2)),
        "total opacity 0.2, Fresnel opacity 0.04 at normal view; the chapter gives none. Its silhouette law "
        "a / cos θ takes the layer's slant without refraction; the slab bends the ray (n = 1.5)"};
}

regenerated highlight_weight() {
    panel weight{axis_of("angle between half vector and view (degrees)", 0, 90, 15),
                 axis_of("mix weight and reflectance", 0, 1, 0.2),
                 {},
                 {}};
    weight.curves = {
        curve(
            "weight (1 − H·V)^5", [](double c) { return schlick(0.0, c); }, gray, stroke::solid, 2.4),
        curve(
            "F, specular color 0.04", [](double c) { return schlick(0.04, c); }, blue),
        curve(
            "F, specular color 0.5", [](double c) { return schlick(0.5, c); }, green),
        curve("F, specular color 1", [](double c) { return schlick(1.0, c); }, orange, stroke::dashed)};

    // light and eye in one plane on either side of the normal, the eye in the mirror direction but 10 degrees
    const double off = radians(10), shininess = 10;
    const auto lobe = [=](double f0) {
        return [=](double theta_l) {
            const double t = radians(theta_l);
            return fresnel_highlight(f0, std::cos(t - off / 2), std::cos(off), shininess, std::cos(t));
        };
    };
    panel p{axis_of("angle of the light (degrees)", 0, 90, 15), axis_of("specular term", 0, 1, 0.2), {}, {}};
    p.curves = {sampled("specular color 0.04", lobe(0.04), 0, 90, blue),
                sampled(
                    "0.04 without Fresnel",
                    [=](double) { return 0.04 * phong_lobe(std::cos(off), shininess); }, 0, 90, blue,
                    stroke::dotted),
                sampled("specular color 0.5", lobe(0.5), 0, 90, green),
                sampled("specular color 1", lobe(1), 0, 90, orange, stroke::dashed)};
    figure f{
        "",
        "",
        "Above: Schlick on the half vector. Below: the Phong highlight it weighs, shininess 10, seen 10° "
        "off the mirror direction.",
        {weight, p},
        {}};
    return {
        f,
        "The specular material color is replaced by Schlick's approximation with the half vector; it becomes "
        "white where light and viewer are opposite.",
        fmt::format(
            "With the shader's default specular color of 1 the Fresnel factor is 1 everywhere and changes "
            "nothing; with 0.04 a highlight at 85° is {:.1f} times as strong as at 0°.",
            lobe(0.04)(85) / lobe(0.04)(0)),
        "specular colors 0.04, 0.5 and 1; shininess 10 is the shader's default; 10° off the mirror "
        "direction"};
}

} // namespace

std::vector<source_figure> highlight_figures() {
    const std::string of = "Kraus 2012, GLSL Programming/Unity, Fresnel highlights, ";
    return {{"highlights-weight", of + "implementation", "The highlight's Fresnel weight", highlight_weight},
            {"highlights-opacity", of + "semitransparent surfaces", "Opacity by reflection and attenuation",
             opacity}};
}

} // namespace fresnel
