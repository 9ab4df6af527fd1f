#include "sources/parts.hpp"

#include "analysis/curve.hpp"
#include "analysis/fit.hpp"
#include "analysis/graph.hpp"
#include "materials/catalog.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/shading.hpp>
#include <fresnel/slab.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

// The claims of the two Unity texts: the chapter on highlights and the article on Fresnel shading.

namespace fresnel {

namespace {

finding white_at_grazing() {
    double least = 1;
    for (const material_sample& m : metal_samples())
        least = std::min(least, exact_conductor(m.index.n, m.index.k)(0));
    return {judgement::holds,
            fmt::format(
                "the exact reflectance at 90° is {} for every built-in metal and wavelength, Schlick's is 1",
                least),
            "any material, any wavelength",
            {{"least", least}}};
}

finding opposite_at_grazing() {
    // the half vector is orthogonal to the view where the two directions are opposite: |v + l| = 2 cos
    const double angle = radians(179.9), cos_h = std::cos(angle / 2);
    return {
        judgement::holds,
        fmt::format("H·V is the cosine of half the angle between light and view: {:.4f} at 179.9°, 0 at 180°",
                    cos_h),
        "any geometry; H itself is 0 / 0 at exactly 180°",
        {{"cos_h", cos_h}}};
}

finding mix_is_cheaper() {
    // x (1 - w) + y w with y = 1, against f0 + (1 - f0) w
    std::size_t differing = 0, count = 0;
    double worst = 0;
    for (int i = 0; i <= 500; ++i)
        for (int j = 0; j <= 500; ++j) {
            const float f0 = static_cast<float>(i) / 500, w = static_cast<float>(j) / 500;
            const float a = f0 * (1 - w) + w, b = f0 + (1 - f0) * w;
            ++count, differing += a != b ? 1 : 0;
            worst = std::max(worst, static_cast<double>(std::abs(a - b)));
        }
    const double share = static_cast<double>(differing) / static_cast<double>(count);
    return {judgement::fails,
            fmt::format("the same count where a multiply–add is one operation, one product more where it is "
                        "not; {:.0f} % "
                        "of float32 values differ, by at most {:.0e}",
                        100 * share, worst),
            "f0 and weight over [0, 1]",
            {{"share", share}, {"worst", worst}}};
}

finding nonconducting_only() {
    const double d = schlick_error(1.5).size(), m = schlick_nk_error(1.5, 5).size();
    return {judgement::fails,
            fmt::format("the Fresnel factor holds for conductors as well, with a complex index; the "
                        "approximation errs by "
                        "{:.3f} on glass and by {:.3f} on a metal of n = 1.5, k = 5",
                        d, m),
            "",
            {{"glass", d}, {"metal", m}}};
}

finding defaults_show_it() {
    const double change = largest([](double c) { return schlick(1.0, c) - 1.0; }).size();
    return {judgement::fails,
            fmt::format("the shader's default specular color is 1, with which the factor is 1 at every angle "
                        "(it changes by "
                        "{})",
                        change),
            "specular colors below 1",
            {{"change", change}}};
}

finding opacity_is_fixed() {
    const double bad = opacity_attenuation(0.1, 0.2), good = opacity_attenuation(0.2, 0.04);
    return {
        judgement::holds_within,
        fmt::format(
            "total 0.2 and Fresnel 0.04 give an attenuation of {:.4f}; total 0.1 and Fresnel 0.2 would give "
            "{:.3f}, which no layer has",
            good, bad),
        "a total opacity of at least the Fresnel opacity",
        {{"good", good}, {"bad", bad}}};
}

finding opacity_rises_to_one() {
    const double at_90 = opacity_fresnel(0.2, 0.0), at_0 = opacity_fresnel(0.2, 1.0);
    return {judgement::holds,
            fmt::format("from 0.2 it rises from {} to {}, and the total with any attenuation to {}", at_0,
                        at_90, opacity_total(0.3, at_90)),
            "any value at normal view in [0, 1]",
            {{"at_0", at_0}, {"at_90", at_90}}};
}

finding power_exaggerates() {
    const double two = schlick_power(0.04, 1.0, 2.0, 0.5), five = schlick_power(0.04, 1.0, 5.0, 0.5),
                 ten = schlick_power(0.04, 1.0, 10.0, 0.5);
    return {judgement::holds,
            fmt::format("at 60° and F0 = 0.04, powers 2, 5 and 10 give {:.3f}, {:.3f} and {:.3f}", two, five,
                        ten),
            "powers above 0",
            {{"power_2", two}, {"power_5", five}, {"power_10", ten}}};
}

finding often_hidden() {
    return {judgement::opinion,
            "that a bright silhouette melts into a bright background is a matter of looks: it waits for the "
            "renderer",
            "",
            {}};
}

// ---- Halladay ---------------------------------------------------------------------------------------------

finding exact_not_feasible() {
    const int exact = count_operations("dielectric").cost(),
              fast = count_operations("dielectric_fast").cost(),
              metal = count_operations("conductor_fast").cost(), plain = count_operations("schlick").cost();
    return {judgement::fails,
            fmt::format("the exact dielectric takes {} operations in its cheapest form ({} in the robust "
                        "one) and the exact "
                        "conductor {}, against {} for Schlick: a few per pixel, not a few thousand",
                        fast, exact, metal, plain),
            "operations counted by running the models, s and p included",
            {{"dielectric_fast", fast}, {"conductor_fast", metal}, {"schlick", plain}}};
}

finding bias_out_is_safe() {
    double lowest = 1, highest = 0, with_bias = 0;
    for (const double scale : {0.0, 0.25, 0.5, 1.0})
        for (const double power : {0.5, 1.0, 2.0, 5.0, 20.0})
            for (double c = 0; c <= 1; c += 0.01) {
                const double rim = scale * std::pow(1 - c, power);
                lowest = std::min(lowest, rim), highest = std::max(highest, rim);
                with_bias = std::max(with_bias, 0.2 + rim);
            }
    return {judgement::holds,
            fmt::format("without bias and with scale in [0, 1] the unclamped value stays in [{}, {}]; a bias "
                        "of 0.2 takes it "
                        "to {:.1f}",
                        lowest, highest, with_bias),
            "scale in [0, 1], any power above 0",
            {{"lowest", lowest}, {"highest", highest}, {"with_bias", with_bias}}};
}

finding verbatim() {
    const double bias = 0.5, scale = 1, power = 5;
    const double formula = bias_scale_power(bias, scale, power, 0.0), listing = bias + scale;
    return {judgement::fails,
            fmt::format("the listing has no clamp: with bias 0.5 and scale 1 the formula gives {} at 90° and "
                        "the listing {}, "
                        "so that its lerp extrapolates; a back-facing normal makes it worse",
                        formula, listing),
            "bias ≥ 0, bias + scale ≤ 1, front faces",
            {{"formula", formula}, {"listing", listing}}};
}

finding control_costs_correctness() {
    const channel glass = channel_of({1.5, 0});
    const parameters p = fit("bias_scale_power", glass);
    double fitted = 0, plain = 0;
    for (std::size_t i = 0; i < glass.R.size(); ++i) {
        fitted += square(bias_scale_power(p[0], p[1], p[2], glass.cos_i[i]) - glass.R[i]);
        plain += square(schlick(0.04, glass.cos_i[i]) - glass.R[i]);
    }
    const double count = static_cast<double>(glass.R.size());
    fitted = std::sqrt(fitted / count), plain = std::sqrt(plain / count);
    return {judgement::holds_within,
            fmt::format("for arbitrary values; fitted to glass (bias {:.3f}, scale {:.3f}, power {:.2f}) it "
                        "errs by {:.4f} in "
                        "the mean over angles, less than Schlick's {:.4f}",
                        p[0], p[1], p[2], fitted, plain),
            "values chosen by eye",
            {{"fitted", fitted}, {"schlick", plain}}};
}

finding normal_by_model_matrix() {
    // a normal at 45 degrees under a scale of (1, 2, 1): the model matrix gives (1, 2), the inverse transpose (1, 1/2)
    const double wrong = std::atan2(2.0, 1.0), right = std::atan2(0.5, 1.0);
    const double off = degrees(wrong - right);
    return {judgement::fails,
            fmt::format("with a scale of 2 along one axis a normal at 45° is off by {:.1f}°", off),
            "right for rotations and uniform scales",
            {{"degrees", off}}};
}

finding window_is_a_mirror() {
    const double straight = window(1.0, 1.52, 1.0).reflectance(),
                 glance = window(1.0, 1.52, cosine_of_degrees(85)).reflectance();
    return {judgement::holds,
            fmt::format("a pane reflects {:.3f} straight on and {:.3f} at 85°", straight, glance),
            "n = 1.52, both faces",
            {{"straight", straight}, {"glance", glance}}};
}

finding everything_has_it() {
    return {judgement::opinion,
            "that towels and bricks show it is a matter of rough surfaces, which are not modelled here; any "
            "smooth "
            "boundary reaches 1 at 90°",
            "",
            {}};
}

} // namespace

std::vector<claim> highlight_claims() {
    const std::string d = "Kraus 2012, GLSL Programming/Unity, Fresnel highlights";
    const std::string part = "Schlick's approximation", transparent = "semitransparent surfaces";
    return {
        {"highlights-hidden", d, "introduction", "The effect is often hidden by a bright background.",
         "G7 G8", "highlights_hidden", often_hidden},
        {"highlights-nonconducting", d, part,
         "The Fresnel factor is the reflectance of nonconducting materials.", "G6",
         "highlights_nonconducting", nonconducting_only},
        {"highlights-white", d, part, "At H·V = 0 it is 1 for every wavelength: a perfect mirror.", "G4 G33",
         "highlights_white", white_at_grazing},
        {"highlights-opposite", d, part, "H·V = 0 means that light and viewer are opposite.", "G2 G4",
         "highlights_opposite", opposite_at_grazing},
        {"highlights-mix", d, part, "The form with mix might be slightly more efficient.", "G5",
         "highlights_mix", mix_is_cheaper},
        {"highlights-defaults", d, "complete shader", "The shader shows Fresnel highlights as it stands.",
         "G16 G29", "highlights_defaults", defaults_show_it},
        {"highlights-power", d, "artistic control", "Another power exaggerates or attenuates the effect.",
         "G21", "highlights_power", power_exaggerates},
        {"highlights-opacity", d, transparent, "Opacity by reflection rises from a user's value to 1.",
         "G22 G23 G32", "highlights_opacity", opacity_rises_to_one},
        {"highlights-constants", d, transparent,
         "Total and Fresnel opacity at normal view fix all constants.", "G25", "highlights_constants",
         opacity_is_fixed},
    };
}

std::vector<claim> halladay_claims() {
    const std::string d = "Halladay 2014, The Basics of Fresnel Shading";
    return {
        {"halladay-everything", d, "introduction",
         "Virtually everything shows the Fresnel effect, towels and bricks too.", "H4", "halladay_everything",
         everything_has_it},
        {"halladay-window", d, "what it is", "A window turns from clear to a mirror at a glancing angle.",
         "H5", "halladay_window", window_is_a_mirror},
        {"halladay-feasible", d, "implementation", "The exact equations are not feasible in real time.", "H6",
         "halladay_feasible", exact_not_feasible},
        {"halladay-control", d, "implementation", "The empirical formula trades correctness for control.",
         "H20", "halladay_control", control_costs_correctness},
        {"halladay-bias", d, "the shader", "Without the bias it is harder to produce wonky results.", "H10",
         "halladay_bias", bias_out_is_safe},
        {"halladay-verbatim", d, "the shader", "The listing is the formula pretty much verbatim.",
         "H8 H13 H22", "halladay_verbatim", verbatim},
        {"halladay-normal", d, "the shader", "The model matrix takes the normal to world space.", "H14",
         "halladay_normal", normal_by_model_matrix},
    };
}

} // namespace fresnel
