#include "sources/parts.hpp"

#include "analysis/curve.hpp"
#include "analysis/graph.hpp"
#include "analysis/multi.hpp"
#include "materials/catalog.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>

#include <fmt/format.h>

#include <algorithm>

namespace fresnel {

namespace {

constexpr double water = 4.0 / 3, crown_glass = 1.52, diamond = 2.417;

// Equations 2 to 4 of the report: sines and tangents of the two angles.
real50 by_angles(const real50& n, const real50& theta) {
    const real50 theta_t = asin(sin(theta) / n);
    const real50 s = sin(theta - theta_t) / sin(theta + theta_t),
                 t = tan(theta - theta_t) / tan(theta + theta_t);
    return (s * s + t * t) / 2;
}

// Equation 6: cosines instead of tangents.
real50 by_cosines(const real50& n, const real50& theta) {
    const real50 theta_t = asin(sin(theta) / n);
    const real50 s = sin(theta - theta_t) / sin(theta + theta_t),
                 q = cos(theta + theta_t) / cos(theta - theta_t);
    return s * s * (1 + q * q) / 2;
}

// Equations 7 to 9, with c = cos(theta) n_i / n_t.
real50 by_g_and_c(const real50& n, const real50& theta) {
    const real50 c = cos(theta) / n, v = 1 / (n * n), g = sqrt(1 + c * c - v);
    const real50 a = (g - c) / (g + c), b = (c * (g + c) - v) / (c * (g - c) + v);
    return a * a * (1 + b * b) / 2;
}

finding equations_agree() {
    real50 worst = 0;
    for (const double n : {1.01, 1.31, 1.5, 2.417, 3.5})
        for (int degree = 1; degree < 90; ++degree) {
            const real50 theta = real50(degree) * acos(real50(-1)) / 180;
            const real50 ours = dielectric(real50(1), real50(n), real50(cos(theta))).reflectance();
            for (const real50& theirs : {by_angles(n, theta), by_cosines(n, theta), by_g_and_c(n, theta)})
                worst = std::max<real50>(worst, abs(theirs - ours));
        }
    const double difference = static_cast<double>(worst);
    return {judgement::holds,
            fmt::format("at 60 digits the three forms and our arrangement agree, {}", rounding(difference)),
            "n_t / n_i from 1.01 to 3.5, 1° to 89°; equations 3 and 4 are 0 / 0 at 0°, as the report says",
            {{"difference", difference}}};
}

finding polarisation_is_small() {
    const double w = polarisation_gap(water).size(), g = polarisation_gap(crown_glass).size(),
                 d = polarisation_gap(diamond).size();
    return {judgement::fails,
            fmt::format(
                "R_s − R reaches {:.3f} for water, {:.3f} for crown glass and {:.3f} for diamond, more than "
                "Schlick's approximation errs by",
                w, g, d),
            "light fully polarised across the plane of incidence",
            {{"water", w}, {"crown_glass", g}, {"diamond", d}}};
}

finding schlick_below_polarisation() {
    const double from =
        root_of(1.1, 1.5, [](double n) { return schlick_error(n).size() - polarisation_gap(n).size(); });
    const auto at_every_angle = [](double n) {
        const double f0 = normal_reflectance(1.0, n, 0.0);
        double excess = -1;
        for (int i = 1; i < 900; ++i) {
            const double c = cosine_of_degrees(0.1 * i);
            const boundary<double> b = dielectric(1.0, n, c);
            excess = std::max(excess, std::abs(schlick(f0, c) - b.reflectance()) - (b.R_s - b.reflectance()));
        }
        return excess;
    };
    const double everywhere = root_of(1.2, 1.5, at_every_angle);
    return {judgement::holds_within,
            fmt::format(
                "in its largest error from n = {:.4f}, at every angle from about {:.2f}; below, Schlick errs "
                "more",
                from, everywhere),
            fmt::format("n_t / n_i ≥ {:.4f}", from),
            {{"from", from}, {"everywhere_from", everywhere}}};
}

finding wavelength_is_small() {
    const double w = channel_spread(*find_material("water")), g = channel_spread(*find_material("n-bk7")),
                 d = channel_spread(*find_material("diamond")), c = channel_spread(*find_material("copper"));
    return {judgement::holds_within,
            fmt::format(
                "R, G and B differ by at most {:.4f} for water, {:.4f} for crown glass, {:.4f} for diamond, "
                "but by {:.2f} for copper",
                w, g, d, c),
            "dielectrics; not metals",
            {{"water", w}, {"crown_glass", g}, {"diamond", d}, {"copper", c}}};
}

finding one_minus_cos_unacceptable() {
    const double w = one_minus_cos_error(water).size(), d = one_minus_cos_error(diamond).size();
    return {
        judgement::opinion,
        fmt::format(
            "off by {:.3f} for water and {:.3f} for diamond, {:.0f} and {:.0f} times Schlick's error; how "
            "it looks waits for the renderer",
            w, d, w / schlick_error(water).size(), d / schlick_error(diamond).size()),
        "all angles",
        {{"water", w}, {"diamond", d}}};
}

finding better_for_free() {
    const int simplest = count_operations("one_minus_cos").cost(),
              schlick_cost = count_operations("schlick").cost(),
              better = count_operations("powers_4_8").cost();
    return {judgement::holds_within,
            fmt::format(
                "Schlick takes {} operations where 1 − cos takes {}; powers_4_8, which halves its error, {}",
                schlick_cost, simplest, better),
            "operations counted by running the model; a processor without free multiply–adds",
            {{"one_minus_cos", simplest}, {"schlick", schlick_cost}, {"powers_4_8", better}}};
}

finding texture_most_accurate() {
    const auto fine = table_error(exact_dielectric(water), 256, 0).size();
    const auto coarse = table_error(exact_dielectric(water), 16, 0).size();
    const auto bytes = table_error(exact_dielectric(water), 256, 8).size();
    int texels = 2;
    while (table_error(exact_dielectric(water), texels, 8).size() > schlick_error(water).size())
        ++texels;
    return {
        judgement::holds_within,
        fmt::format(
            "for water a table over cos θ errs by {:.4f} with 16 texels, {:.5f} with 256, {:.4f} with 256 of "
            "8 bits; Schlick by {:.3f}",
            coarse, fine, bytes, schlick_error(water).size()),
        fmt::format(
            "{} texels of 8 bits or more, linear filter, from the thinner side; resolution and storage both "
            "limit it",
            texels),
        {{"texels", texels}, {"error_256", fine}, {"error_16", coarse}, {"error_256_8bit", bytes}}};
}

finding two_ways_look_alike() {
    const double difference = schlick_error(water).size();
    return {judgement::opinion,
            fmt::format(
                "the two differ by Schlick's error, at most {:.3f} for water and {:.3f} for crown glass; how "
                "that looks waits for the renderer",
                difference, schlick_error(crown_glass).size()),
            "all angles",
            {{"water", difference}}};
}

finding interpolation_is_enough() {
    const double f0 = normal_reflectance(1.0, water, 0.0);
    const auto error = [f0](int sides) {
        return vertex_interpolation_error([f0](double c) { return schlick(f0, c); }, sides);
    };
    int sides = 8;
    while (error(sides) > schlick_error(water).size() && sides < 4096)
        sides *= 2;
    return {judgement::holds_within,
            fmt::format(
                "on a round silhouette of 16, 32, 64 and 128 vertices, interpolation errs by {:.3f}, {:.3f}, "
                "{:.3f} and {:.4f}",
                error(16), error(32), error(64), error(128)),
            fmt::format("{} vertices around or more: only then below Schlick's own error", sides),
            {{"error_16", error(16)}, {"error_32", error(32)}, {"error_128", error(128)}, {"sides", sides}}};
}

finding looks(std::string_view what) {
    return {
        judgement::opinion, fmt::format("{} is a matter of looks: it waits for the renderer", what), "", {}};
}

finding exact_too_many_instructions() {
    const int exact = count_operations("dielectric_fast").cost(),
              approximate = count_operations("schlick").cost();
    return {judgement::holds_within,
            fmt::format(
                "{} operations against {} for equation 10, {:.1f} times as many, divisions and square roots "
                "counted as four",
                exact, approximate, static_cast<double>(exact) / approximate),
            "the hardware of 2002; no processor of today runs out of instructions on it",
            {{"exact", exact}, {"schlick", approximate}}};
}

finding table_is_bounded() {
    double highest = 0;
    std::string name;
    for (const material& m : builtin_materials()) {
        const bool counts = m.kind == material_kind::spectral &&
                            (m.category == "dielectric" || m.category == "semiconductor");
        const double n = counts ? index_at(m, 550).n : 0;
        if (n > highest) highest = n, name = m.name;
    }
    return {judgement::fails,
            fmt::format("{} has n = {:.2f} at 550 nm; gallium phosphide itself {:.3f}", name, highest,
                        index_at(*find_material("gallium-phosphide"), 550).n),
            "built-in dielectrics and semiconductors",
            {{"highest", highest}}};
}

finding air_index() {
    const double n = index_at(*find_material("air"), 589.3).n;
    return {judgement::holds_within,
            fmt::format("standard air at 15 °C has {:.6f} at 589.3 nm; 1.000293 is that of 0 °C", n),
            "0 °C and 1013 hPa",
            {{"n", n}}};
}

finding does_not_apply_below() {
    const double eta = 1 / water, f0 = normal_reflectance(1.0, water, 0.0);
    const double wrong = largest([=](double c) { return schlick(f0, c) - exact_dielectric(eta)(c); }).size();
    return {
        judgement::holds_within,
        fmt::format(
            "equation 10 errs by {:.2f} from below; equation 9 stays exact up to the critical angle, where "
            "its g becomes imaginary and R is 1",
            wrong),
        "equation 10; equation 9 with R = 1 beyond 48.6°",
        {{"schlick_inside", wrong}}};
}

finding skylight_is_polarised() {
    const boundary<double> b = dielectric(1.0, water, brewster_cosine(water));
    return {judgement::opinion,
            fmt::format(
                "that skylight is polarised is not measured here; where it is, a lake at Brewster's angle "
                "reflects between {:.3f} and {:.3f} instead of {:.3f}",
                b.R_p, b.R_s, b.reflectance()),
            "its consequence only",
            {{"R_s", b.R_s}, {"R_p", b.R_p}}};
}

} // namespace

std::vector<claim> wloka_claims() {
    const std::string d = "Wloka 2002, Fresnel Reflection";
    return {
        {"wloka-equations", d, "eq. 1–9, p. 5–7", "The sine, tangent, cosine and g, c forms are one formula.",
         "W13 W14 W15 W19 W20", "wloka_equations", equations_agree},
        {"wloka-polarisation", d, "p. 8", "Treating light as unpolarised has a small effect.", "W24",
         "wloka_polarisation", polarisation_is_small},
        {"wloka-wavelength", d, "p. 8", "Treating light as of one wavelength has a small effect.", "W25",
         "wloka_wavelength", wavelength_is_small},
        {"wloka-skylight", d, "p. 8", "Skylight is strongly polarised.", "W26", "wloka_skylight",
         skylight_is_polarised},
        {"wloka-schlick", d, "p. 8", "Equation 10 errs less than ignoring polarisation does.", "W29",
         "wloka_schlick", schlick_below_polarisation},
        {"wloka-instructions", d, "p. 8", "Equation 9 in a vertex shader needs too many instructions.", "W27",
         "wloka_instructions", exact_too_many_instructions},
        {"wloka-per-pixel", d, "p. 8",
         "Per-pixel evaluation is only insignificantly more accurate than interpolating.", "W21 W22",
         "wloka_per_pixel", interpolation_is_enough},
        {"wloka-texture", d, "p. 11", "A texture is the most accurate way; only its resolution errs.",
         "W39 W42", "wloka_texture", texture_most_accurate},
        {"wloka-two-ways", d, "p. 11", "The two per-pixel ways look alike.", "W43", "wloka_two_ways",
         two_ways_look_alike},
        {"wloka-detail", d, "p. 14", "Fresnel reflection adds important visual detail.", "W48", "wloka_looks",
         [] { return looks("Important detail"); }},
        {"wloka-one-minus-cos", d, "p. 14", "1 − cos θ is visually unacceptable.", "W49",
         "wloka_one_minus_cos", one_minus_cos_unacceptable},
        {"wloka-free", d, "p. 14", "Better approximations cost little or nothing more.", "W50", "wloka_free",
         better_for_free},
        {"wloka-a-b", d, "p. 14", "Per vertex and per pixel can be told apart only side by side.", "W51",
         "wloka_looks", [] { return looks("Telling two pictures apart"); }},
        {"wloka-underwater", d, "p. 4", "For a viewer under water the report no longer applies.", "W5 W8",
         "wloka_underwater", does_not_apply_below},
        {"wloka-air", d, "table 1, p. 16", "The index of air is 1.000293.", "W55", "wloka_air", air_index},
        {"wloka-maximum", d, "table 1, p. 16", "The greatest index of refraction is 3.5.", "W54",
         "wloka_maximum", table_is_bounded},
    };
}

} // namespace fresnel
