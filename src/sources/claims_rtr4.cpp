#include "sources/parts.hpp"

#include "analysis/angles.hpp"
#include "analysis/compare.hpp"
#include "analysis/curve.hpp"
#include "analysis/fit.hpp"
#include "analysis/graph.hpp"
#include "analysis/metalness.hpp"
#include "materials/catalog.hpp"
#include "materials/observer.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <numbers>

namespace fresnel {

namespace {

rgb f0_of(std::string_view name, double ambient = 1) {
    return colour_at(*find_material(name), color_space::srgb, ambient, 1);
}

double luminance(const rgb& c) { return (default_recipe(color_space::srgb).to_xyz * c)[1]; }

/// Built-in spectral materials of a class; air is no material to look at.
std::vector<const material*> spectral(std::string_view category) {
    std::vector<const material*> found;
    for (const material& m : builtin_materials())
        if (m.kind == material_kind::spectral && m.category == category && m.name != "air")
            found.push_back(&m);
    return found;
}

finding air_is_1_003() {
    const double n = index_at(*find_material("air"), 550).n;
    return {judgement::fails,
            fmt::format("air has {:.6f} at 550 nm: the printed excess over 1 is ten times too large", n),
            "",
            {{"n", n}}};
}

finding flat_until_75() {
    const double c = cosine_of_degrees(75);
    const auto times = [c](double n) { return exact_dielectric(n)(c) / exact_dielectric(n)(1); };
    const optical_index cu = index_at(*find_material("copper"), 550),
                        al = index_at(*find_material("aluminium"), 550);
    const double copper = exact_conductor(cu.n, cu.k)(c) / exact_conductor(cu.n, cu.k)(1),
                 aluminium = exact_conductor(al.n, al.k)(c) / exact_conductor(al.n, al.k)(1);
    return {judgement::holds_within,
            fmt::format("at 75° water reflects {:.1f} times its F0, glass (1.5) {:.1f}, diamond {:.1f}; "
                        "copper {:.2f} and "
                        "aluminium {:.2f} at 550 nm",
                        times(4.0 / 3), times(1.5), times(2.417), copper, aluminium),
            "metals; false for dielectrics",
            {{"water", times(4.0 / 3)},
             {"glass", times(1.5)},
             {"diamond", times(2.417)},
             {"copper", copper},
             {"aluminium", aluminium}}};
}

finding mostly_monotonic() {
    std::size_t dips = 0, count = 0;
    double deepest = 0;
    for (const material_sample& m : metal_samples()) {
        const double c = least_reflectance_cosine(1, m.index.n, m.index.k);
        const double dip =
            exact_conductor(m.index.n, m.index.k)(1) - exact_conductor(m.index.n, m.index.k)(c);
        ++count, dips += dip > 0.01 ? 1 : 0;
        deepest = std::max(deepest, dip);
    }
    return {
        judgement::holds_within,
        fmt::format(
            "dielectrics only rise; {} of {} metals and wavelengths dip by more than 0.01, by up to {:.3f}",
            dips, count, deepest),
        "dielectrics; most metals dip",
        {{"dips", static_cast<double>(dips)}, {"count", static_cast<double>(count)}, {"deepest", deepest}}};
}

finding glass_coincides() {
    const double worst = channel_spread(*find_material("n-bk7"));
    return {judgement::holds,
            fmt::format("R, G and B of crown glass differ by at most {:.4f}", worst),
            "N-BK7",
            {{"spread", worst}}};
}

finding few_pixels() {
    const double area = square(cosine_of_degrees(75));
    return {judgement::holds,
            fmt::format("on a ball the part beyond 75° takes {:.1f} % of the disk", 100 * area),
            "a ball seen from far",
            {{"area", area}}};
}

finding errors_are_subtle() {
    std::vector<std::pair<std::string, double>> values;
    std::string text;
    for (const char* name : {"chromium", "iron", "zinc"}) {
        const curve_error e = schlick_error(*find_material(name), color_space::srgb);
        values.emplace_back(name, e.delta_e_max);
        text += fmt::format("{}{} {:.1f} (at {:.0f}°)", text.empty() ? "" : ", ", name, e.delta_e_max,
                            e.delta_e_theta);
    }
    return {judgement::fails,
            fmt::format("the worst colour difference (CIEDE2000; above 2 is seen) is {}. How it looks on a "
                        "shape waits for "
                        "the renderer",
                        text),
            "where grazing angles are few", values};
}

finding bottom_three_are_worst() {
    std::vector<std::pair<std::string, double>> values;
    for (const char* name : {"chromium", "iron", "zinc", "copper", "aluminium", "silver", "gold", "nickel",
                             "platinum", "titanium", "palladium", "mercury", "brass"})
        values.emplace_back(name, schlick_error(*find_material(name), color_space::acescg).worst());
    std::vector<std::pair<std::string, double>> sorted = values;
    std::sort(sorted.begin(), sorted.end(), [](const auto& a, const auto& b) { return a.second > b.second; });
    std::string text;
    for (std::size_t i = 0; i < 5; ++i)
        text += fmt::format("{}{} {:.3f}", i == 0 ? "" : ", ", sorted[i].first, sorted[i].second);
    const double least = std::min({values[0].second, values[1].second, values[2].second});
    return {judgement::holds_within,
            fmt::format("the worst of table 9.2's metals by Schlick's largest error: {}", text),
            fmt::format("chromium, iron and zinc err by {:.2f} and more; others come close", least), values};
}

struct spread {
    double worst, median;
};

spread over_metals(std::string_view model) {
    std::vector<double> errors;
    for (const material_sample& m : metal_samples()) {
        const channel one = channel_of(m.index);
        const std::vector<double> R = evaluate(model, fit(model, one), one.cos_i);
        double worst = 0;
        for (std::size_t i = 0; i < R.size(); ++i)
            worst = std::max(worst, std::abs(R[i] - one.R[i]));
        errors.push_back(worst);
    }
    std::sort(errors.begin(), errors.end());
    return {errors.back(), errors[errors.size() / 2]};
}

finding gulbrandsen_is_closer() {
    const spread g = over_metals("gulbrandsen"), s = over_metals("schlick");
    const int dear = count_operations("gulbrandsen").cost(), cheap = count_operations("schlick").cost();
    return {judgement::holds,
            fmt::format("with g fitted it is exact on a single wavelength ({}), Schlick errs by {:.3f} "
                        "(median {:.3f}); {} "
                        "operations against {}",
                        rounding(g.worst), s.worst, s.median, dear, cheap),
            "built-in metals at 450, 550 and 650 nm, g fitted to each",
            {{"gulbrandsen", g.worst}, {"schlick", s.worst}, {"cost", dear}, {"schlick_cost", cheap}}};
}

finding power_is_closer() {
    const spread p = over_metals("schlick_power"), s = over_metals("schlick"), h = over_metals("f82");
    return {
        judgement::holds,
        fmt::format(
            "the median of the largest error falls from {:.3f} to {:.3f} with the best power; f82 has {:.3f}",
            s.median, p.median, h.median),
        "built-in metals at 450, 550 and 650 nm, power fitted to each",
        {{"schlick", s.median}, {"power", p.median}, {"f82", h.median}}};
}

finding schlick_is_reasonable() {
    const spread s = over_metals("schlick");
    const double w = schlick_error(4.0 / 3).size(), d = schlick_error(2.417).size();
    return {judgement::holds_within,
            fmt::format("off by at most {:.3f} for n from 4/3 to 2.417 and by up to {:.3f} for metals",
                        std::max(w, d), s.worst),
            "dielectrics",
            {{"water", w}, {"diamond", d}, {"metals", s.worst}}};
}

finding spectrum_first() {
    const material& gold = *find_material("gold");
    const rgb dense = f0_of("gold");
    rgb sampled{};
    const std::array<double, 3> nm = {650, 550, 450};
    for (std::size_t i = 0; i < 3; ++i) {
        const optical_index m = index_at(gold, nm[i]);
        sampled[i] = normal_reflectance(1.0, m.n, m.k);
    }
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i)
        worst = std::max(worst, std::abs(sampled[i] - dense[i]));
    return {judgement::holds,
            fmt::format(
                "for gold, three wavelengths (650, 550, 450 nm) in place of the spectrum change F0 by {:.3f}",
                worst),
            "materials whose index varies",
            {{"gold", worst}}};
}

finding magnitude_of_complex() {
    double worst = 0;
    for (const material_sample& m : metal_samples()) {
        const complex<double> r =
            complex<double>{m.index.n - 1, m.index.k} / complex<double>{m.index.n + 1, m.index.k};
        worst = std::max(worst, std::abs(norm(r) - normal_reflectance(1.0, m.index.n, m.index.k)));
    }
    return {judgement::holds,
            fmt::format("squared magnitude and real formula agree, {}", rounding(worst)),
            "built-in metals",
            {{"difference", worst}}};
}

finding dielectric_f0_is_low() {
    std::size_t low = 0, count = 0;
    for (const material* m : spectral("dielectric"))
        ++count, low += luminance(f0_of(m->name)) <= 0.06 ? 1 : 0;
    const double share = static_cast<double>(low) / static_cast<double>(count);
    return {judgement::holds_within,
            fmt::format("{} of {} built-in dielectrics ({:.0f} %) have F0 ≤ 0.06", low, count, 100 * share),
            "everyday liquids, plastics and glass; not gems and heavy crystals",
            {{"share", share}, {"count", static_cast<double>(count)}}};
}

finding dielectrics_are_colorless() {
    double worst = 0, median_of = 0;
    std::string name;
    std::vector<double> spreads;
    for (const material* m : spectral("dielectric")) {
        const rgb f0 = f0_of(m->name);
        const double relative =
            (std::max({f0[0], f0[1], f0[2]}) - std::min({f0[0], f0[1], f0[2]})) / luminance(f0);
        spreads.push_back(relative);
        if (relative > worst) worst = relative, name = m->name;
    }
    std::sort(spreads.begin(), spreads.end());
    median_of = spreads[spreads.size() / 2];
    return {judgement::holds_within,
            fmt::format("the channels of F0 differ by {:.1f} % in the median and by {:.0f} % at most ({})",
                        100 * median_of, 100 * worst, name),
            "F0 below about 0.1; bright crystals are slightly blue",
            {{"median", median_of}, {"worst", worst}}};
}

finding default_is_004() {
    std::vector<double> f0;
    for (const material* m : spectral("dielectric"))
        if (luminance(f0_of(m->name)) <= 0.08) f0.push_back(luminance(f0_of(m->name)));
    std::sort(f0.begin(), f0.end());
    const double median = f0[f0.size() / 2];
    return {judgement::holds,
            fmt::format("the median F0 of {} built-in dielectrics below 0.08 is {:.3f}; 0.04 is n = {:.3f}",
                        f0.size(), median, eta_from_f0(0.04)),
            "no gems",
            {{"median", median}}};
}

finding metals_are_above_half() {
    std::size_t above = 0, every_channel = 0, count = 0;
    double lowest = 1;
    std::string name;
    for (const material* m : spectral("metal")) {
        const rgb f0 = f0_of(m->name);
        ++count, above += luminance(f0) >= 0.5 ? 1 : 0;
        every_channel += std::min({f0[0], f0[1], f0[2]}) >= 0.5 ? 1 : 0;
        if (luminance(f0) < lowest) lowest = luminance(f0), name = m->name;
    }
    const double share = static_cast<double>(above) / static_cast<double>(count);
    return {judgement::holds_within,
            fmt::format("{} of {} built-in metals, alloys and metallic compounds have a luminance of 0.5 or "
                        "above, {} of them in "
                        "every channel; the darkest is {} with {:.2f}",
                        above, count, every_channel, name, lowest),
            "pure metals in luminance; not for the blue of colored metals",
            {{"share", share}, {"lowest", lowest}}};
}

finding band_is_empty() {
    std::string text;
    std::vector<std::pair<std::string, double>> values;
    for (const char* name : {"rutile", "gallium-phosphide", "silicon", "germanium", "graphite"}) {
        const double Y = luminance(f0_of(name));
        values.emplace_back(name, Y);
        text += fmt::format("{}{} {:.3f}", text.empty() ? "" : ", ", name, Y);
    }
    return {judgement::holds_within, fmt::format("{} lie in or near it", text),
            "no metal and no everyday dielectric: semiconductors and rutile do lie there", values};
}

finding semiconductors_between() {
    const rgb si = f0_of("silicon"), diamond = f0_of("diamond"), ti = f0_of("titanium");
    return {judgement::holds,
            fmt::format("luminance of F0: diamond {:.3f}, silicon {:.3f}, titanium {:.3f}",
                        luminance(diamond), luminance(si), luminance(ti)),
            "silicon; rutile, a dielectric, is brighter than diamond",
            {{"diamond", luminance(diamond)}, {"silicon", luminance(si)}, {"titanium", luminance(ti)}}};
}

finding gold_is_outside() {
    const double red = f0_of("gold")[0], mcpeak = f0_of("gold-mcpeak")[0];
    return {judgement::holds,
            fmt::format("red is {:.3f} (Johnson and Christy) and {:.3f} (McPeak)", red, mcpeak),
            "linear sRGB; ACEScg holds it",
            {{"red", red}, {"red_mcpeak", mcpeak}}};
}

finding gold_alone_below_half() {
    const double gold = f0_of("gold-mcpeak")[2], brass = f0_of("brass")[2],
                 titanium = f0_of("titanium-mash")[2];
    return {judgement::holds_within,
            fmt::format(
                "gold's blue is {:.3f} (McPeak); brass has {:.3f} and the printed titanium 0.449 ({:.3f} in "
                "the nearest open page)",
                gold, brass, titanium),
            "two others lie below 0.5, less far",
            {{"gold", gold}, {"brass", brass}}};
}

finding relative_index() {
    const double f0 = normal_reflectance(1.0, 1.5, 0.0), f0_inverse = normal_reflectance(1.0, 1 / 1.5, 0.0);
    const double apart = std::abs(exact_dielectric(1.5)(0.7) - exact_dielectric(1 / 1.5)(0.7));
    return {judgement::holds_within,
            fmt::format("n1/n2 and n2/n1 give the same F0 ({:.4f} and {:.4f}), but at cos θ = 0.7 "
                        "reflectances {:.2f} apart",
                        f0, f0_inverse, apart),
            "normal incidence",
            {{"f0", f0}, {"f0_inverse", f0_inverse}, {"apart", apart}}};
}

finding water_changes_dielectrics() {
    const auto left = [](const char* name) { return luminance(f0_of(name, 1.33)) / luminance(f0_of(name)); };
    return {judgement::holds,
            fmt::format("under water crown glass keeps {:.1f} % of its F0, diamond {:.1f} %, iron {:.1f} % "
                        "(Querry: {:.1f} %), silver {:.1f} %",
                        100 * left("n-bk7"), 100 * left("diamond"), 100 * left("iron"),
                        100 * left("iron-querry"), 100 * left("silver")),
            "n = 1.33",
            {{"glass", left("n-bk7")},
             {"diamond", left("diamond")},
             {"iron", left("iron")},
             {"silver", left("silver")}}};
}

finding none_below_002() {
    const double ice = luminance(f0_of("ice")), water = luminance(f0_of("water"));
    return {judgement::fails,
            fmt::format("ice has {:.4f}, water {:.4f}", ice, water),
            "in air, but for ice and gases; under water most dielectrics are below",
            {{"ice", ice}, {"water", water}}};
}

finding critical_from_f0() {
    double worst = 0;
    for (double n = 1.05; n < 3; n += 0.05)
        worst = std::max(worst, std::abs(sin_critical(normal_reflectance(1.0, n, 0.0)) - 1 / n));
    return {judgement::holds,
            fmt::format("n2/n1 and (1 − √F0)/(1 + √F0) agree, {}", rounding(worst)),
            "n from 1.05 to 3",
            {{"difference", worst}}};
}

finding symmetric() {
    double worst = 0;
    for (const double n : {1.1, 1.5, 2.417})
        for (double c = 0.05; c <= 1; c += 0.05)
            worst = std::max(
                worst, std::abs(exact_dielectric(n)(c) - exact_dielectric(1 / n)(refracted_cosine(n, c))));
    return {judgement::holds,
            fmt::format("along one ray both ways the reflectances agree, {}; F0 is the same, and "
                        "inside 1 is reached at "
                        "θ_c",
                        rounding(worst)),
            "transparent media",
            {{"difference", worst}}};
}

finding internal_is_higher() {
    const double outside = hemispherical_average(1, 1.5, 0), inside = hemispherical_average(1.5, 1, 0);
    return {judgement::holds,
            fmt::format("averages {:.4f} outside and {:.4f} inside for n = 1.5", outside, inside),
            "hemispherical, cosine-weighted",
            {{"outside", outside}, {"inside", inside}}};
}

finding bubbles_are_silvery() {
    const double bubble = hemispherical_average(4.0 / 3, 1, 0), drop = hemispherical_average(1, 4.0 / 3, 0);
    return {
        judgement::holds,
        fmt::format("water to air reflects {:.3f} on average, air to water {:.3f}; everything beyond {:.1f}°",
                    bubble, drop, *angles_of(4.0 / 3, 1, 0).critical),
        "the numbers; the look waits for the renderer",
        {{"bubble", bubble}, {"drop", drop}}};
}

finding only_in_dielectrics() {
    double deepest = 0;
    for (const material_sample& m : metal_samples())
        deepest = std::max(deepest, m.wavelength_nm / (4 * std::numbers::pi * m.index.k));
    const optical_index si = index_at(*find_material("silicon"), 650);
    const double silicon = 650 / (4 * std::numbers::pi * si.k);
    return {judgement::holds_within,
            fmt::format("light falls to 1/e within {:.0f} nm in every built-in metal, but only within {:.0f} "
                        "nm in silicon at "
                        "650 nm",
                        deepest, silicon),
            "metals; semiconductors are transparent below their band gap",
            {{"metals_nm", deepest}, {"silicon_nm", silicon}}};
}

finding schlick_with_theta_t() {
    const double n15 = schlick_internal_error(1 / 1.5).size();
    return {judgement::holds_within,
            fmt::format("with θ_t it errs inside by {:.3f} (n = 1.5), the same as outside", n15),
            "transparent media",
            {{"error", n15}}};
}

finding index_not_available() {
    double worst = 0;
    for (double f0 = 0.01; f0 < 0.9; f0 += 0.01)
        worst = std::max(worst, largest([=](double c) {
                                    return internal_reflection(f0, c).reflectance() -
                                           exact_dielectric(1 / eta_from_f0(f0))(c);
                                }).size());
    const int cost = count_operations("schlick_internal").cost();
    return {judgement::fails,
            fmt::format("F0 alone gives the index: η = (1 − √F0)/(1 + √F0) inside ({}); Schlick with "
                        "θ_t then costs {} "
                        "operations",
                        rounding(worst), cost),
            "transparent media",
            {{"difference", worst}, {"cost", cost}}};
}

finding tinted_is_not_expressible() {
    const surface_colors coated{{0.02, 0.04, 0.08}, {0.5, 0.5, 0.5}};
    double least = 1, gltf = 0;
    for (const metalness_law& law : metalness_laws()) {
        const double residual = from_surface(law, coated).residual;
        least = std::min(least, residual);
        if (law.name == "gltf") gltf = residual;
    }
    return {judgement::holds,
            fmt::format("for F0 (0.02, 0.04, 0.08) over a gray of 0.5 the nearest parameters of six engines' "
                        "laws are off by "
                        "{:.3f} or more; glTF's specular color, a further parameter, can",
                        least),
            "base color, metalness and one number for the dielectric",
            {{"least", least}, {"gltf", gltf}}};
}

finding borders_have_artifacts() {
    const metalness_law& law = find_metalness_law("unreal");
    const rgb paint = {0.05, 0.1, 0.4}, metal = apply_gamut(f0_of("gold"), gamut::clamp);
    double f0 = 0, albedo = 0;
    for (int i = 0; i <= 100; ++i) {
        const surface_colors e = metalness_border_error(law, paint, metal, i / 100.0);
        for (std::size_t c = 0; c < 3; ++c)
            f0 = std::max(f0, std::abs(e.f0[c])), albedo = std::max(albedo, std::abs(e.albedo[c]));
    }
    return {judgement::holds,
            fmt::format("between gold and a blue paint, blending the parameters is off by up to {:.3f} in F0 "
                        "and {:.3f} in "
                        "albedo: m (1 − m) of the difference of the base colors",
                        f0, albedo),
            "filtered textures; none where the base colors are equal",
            {{"f0", f0}, {"albedo", albedo}}};
}

finding picks_f0_well() {
    const double lowest = luminance(f0_of("ice"));
    double highest = 0;
    std::size_t outside = 0;
    std::string name;
    for (const material* m : spectral("metal")) {
        const rgb f0 = f0_of(m->name);
        const double top = std::max({f0[0], f0[1], f0[2]});
        outside += top > 1 ? 1 : 0;
        if (top > highest) highest = top, name = m->name;
    }
    return {judgement::holds_within,
            fmt::format("measured F0 run from {:.3f} (ice) to {:.3f} (red of {}) in sRGB; {} of the built-in "
                        "metals and alloys "
                        "leave [0, 1]",
                        lowest, highest, name, outside),
            "a working space that holds gold",
            {{"lowest", lowest}, {"highest", highest}}};
}

constexpr const char* book = "Real-Time Rendering, 4th ed. (2018)";

std::vector<claim> external_reflection() {
    const std::string d = book, outer = "sec. 9.5.1";
    return {
        {"rtr4-air", d, outer, "The index of air is about 1.003.", "R4", "rtr4_air", air_is_1_003},
        {"rtr4-flat", d, outer, "The curves barely change until about 75°.", "R6", "rtr4_flat",
         flat_until_75},
        {"rtr4-monotonic", d, outer, "The rise to 1 is mostly monotonic, with a slight dip for some.",
         "R5 R7", "rtr4_monotonic", mostly_monotonic},
        {"rtr4-glass", d, "fig. 9.20", "The color curves of glass coincide.", "R12", "rtr4_glass",
         glass_coincides},
        {"rtr4-pixels", d, outer, "The strongest rise takes few pixels.", "R13 R14", "rtr4_pixels",
         few_pixels},
        {"rtr4-reasonable", d, outer, "Schlick is reasonably accurate.", "R17", "rtr4_reasonable",
         schlick_is_reasonable},
        {"rtr4-worst-three", d, "fig. 9.22", "Chromium, iron and zinc diverge from Schlick especially.",
         "R19", "rtr4_worst_three", bottom_three_are_worst},
        {"rtr4-subtle", d, outer, "Even for them the errors are quite subtle.", "R19", "rtr4_subtle",
         errors_are_subtle},
        {"rtr4-gulbrandsen", d, outer, "Gulbrandsen's approximation is closer for metals, and dearer.", "R20",
         "rtr4_gulbrandsen", gulbrandsen_is_closer},
        {"rtr4-power", d, outer, "A power other than 5 can match closer.", "R21 R24", "rtr4_power",
         power_is_closer},
        {"rtr4-range", d, outer, "F0 has a well-defined range of valid values in [0, 1].", "R22",
         "rtr4_range", picks_f0_well},
        {"rtr4-magnitude", d, outer, "F0 from n works for a complex index by its magnitude.", "R22",
         "rtr4_magnitude", magnitude_of_complex},
        {"rtr4-spectrum", d, outer, "An accurate RGB F0 needs a dense spectrum first.", "R16 R23 R59",
         "rtr4_spectrum", spectrum_first},
    };
}

std::vector<claim> typical_values() {
    const std::string d = book, typical = "sec. 9.5.2";
    return {
        {"rtr4-low", d, typical, "Dielectrics have an F0 of usually 0.06 or lower.", "R27", "rtr4_low",
         dielectric_f0_is_low},
        {"rtr4-colorless", d, typical, "The reflectance of dielectrics is colorless.", "R27 R32",
         "rtr4_colorless", dielectrics_are_colorless},
        {"rtr4-default", d, typical, "0.04 is a reasonable default.", "R27 R29", "rtr4_default",
         default_is_004},
        {"rtr4-half", d, typical, "Metals almost always have an F0 of 0.5 or above.", "R28", "rtr4_half",
         metals_are_above_half},
        {"rtr4-gold", d, typical, "Gold's red lies slightly outside sRGB.", "R34", "rtr4_gold",
         gold_is_outside},
        {"rtr4-gold-blue", d, typical, "Gold's blue is the only value significantly below 0.5.", "R33 R34",
         "rtr4_gold_blue", gold_alone_below_half},
        {"rtr4-semiconductors", d, typical, "Semiconductors lie between bright dielectrics and dark metals.",
         "R26 R36", "rtr4_semiconductors", semiconductors_between},
        {"rtr4-band", d, typical, "F0 between 0.2 and 0.45 should be avoided.", "R28", "rtr4_band",
         band_is_empty},
        {"rtr4-relative", d, typical, "The relative index n1/n2 stands for n in water.", "R38",
         "rtr4_relative", relative_index},
        {"rtr4-water", d, "table 9.4", "Dielectrics near water's index change most, metals barely.",
         "R37 R39", "rtr4_water", water_changes_dielectrics},
        {"rtr4-no-002", d, typical, "No material has an F0 below 0.02, but for special coatings.", "R47",
         "rtr4_no_002", none_below_002},
        {"rtr4-tinted", d, typical, "Metalness cannot express coated dielectrics with a tinted F0.", "R44",
         "rtr4_tinted", tinted_is_not_expressible},
        {"rtr4-border", d, typical, "Artifacts can occur at borders of metal and dielectric.", "R45",
         "rtr4_border", borders_have_artifacts},
    };
}

std::vector<claim> inside_reflection() {
    const std::string d = book, inner = "sec. 9.5.3";
    return {
        {"rtr4-symmetric", d, inner, "Reflectance is the same with the directions swapped, and so is F0.",
         "R50 R51", "rtr4_symmetric", symmetric},
        {"rtr4-higher", d, inner, "On average, internal reflectance is higher.", "R48 R53", "rtr4_higher",
         internal_is_higher},
        {"rtr4-bubbles", d, inner, "Air bubbles under water are highly reflective.", "R54", "rtr4_bubbles",
         bubbles_are_silvery},
        {"rtr4-dielectrics-only", d, inner, "Internal reflection occurs only in dielectrics.", "R55",
         "rtr4_dielectrics_only", only_in_dielectrics},
        {"rtr4-critical", d, inner, "sin θ_c = n2/n1 = (1 − √F0)/(1 + √F0).", "R49 R56", "rtr4_critical",
         critical_from_f0},
        {"rtr4-theta-t", d, inner, "Schlick holds inside with θ_t in place of θ_i.", "R57", "rtr4_theta_t",
         schlick_with_theta_t},
        {"rtr4-index", d, inner, "θ_t requires the index, which may not be available.", "R58", "rtr4_index",
         index_not_available},
    };
}

} // namespace

std::vector<claim> rtr4_claims() {
    std::vector<claim> all;
    for (const auto part : {external_reflection, typical_values, inside_reflection})
        for (claim& one : part())
            all.push_back(std::move(one));
    return all;
}

} // namespace fresnel
