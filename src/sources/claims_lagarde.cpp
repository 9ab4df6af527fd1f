#include "sources/parts.hpp"

#include "analysis/angles.hpp"
#include "analysis/compare.hpp"
#include "analysis/curve.hpp"
#include "analysis/fit.hpp"
#include "analysis/graph.hpp"
#include "materials/catalog.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <complex>

namespace fresnel {

namespace {

constexpr double metal_n = 1.5, metal_k = 5;

using wave = std::complex<double>;

// The memo's amplitudes with a complex index in place of n_t.
double by_amplitudes(double n_i, wave n_t, double c) {
    const wave cos_t = std::sqrt(1.0 - n_i * n_i / (n_t * n_t) * (1 - c * c));
    const wave r_s = (n_i * c - n_t * cos_t) / (n_i * c + n_t * cos_t),
               r_p = (n_t * c - n_i * cos_t) / (n_t * c + n_i * cos_t);
    return (std::norm(r_s) + std::norm(r_p)) / 2;
}

finding complex_index_anywhere() {
    double worst = 0;
    for (const material_sample& m : metal_samples())
        for (double c = 0.02; c <= 1; c += 0.02)
            worst = std::max(worst, std::abs(by_amplitudes(1.0, {m.index.n, -m.index.k}, c) -
                                             exact_conductor(m.index.n, m.index.k)(c)));
    return {judgement::holds,
            fmt::format("the dielectric amplitudes with n − ik give the conductor's reflectance, {}",
                        rounding(worst)),
            "every built-in metal, all angles",
            {{"difference", worst}}};
}

finding sides_may_be_swapped() {
    double worst = 0;
    for (const double n : {1.1, 4.0 / 3, 1.5, 2.417})
        for (double c = 0.02; c <= 1; c += 0.02)
            worst = std::max(worst, std::abs(dielectric(1.0, n, c).reflectance() -
                                             dielectric(n, 1.0, refracted_cosine(n, c)).reflectance()));
    return {
        judgement::holds,
        fmt::format("from either side at the angles of one ray the reflectances agree, {}", rounding(worst)),
        "n_t / n_i from 1.1 to 2.417; swapping without changing the angle is another matter",
        {{"difference", worst}}};
}

finding dielectric_is_k_0() {
    double worst = 0;
    for (const double eta : {0.6, 0.9, 1.1, 1.5, 3.0})
        worst =
            std::max(worst, largest([=](double c) {
                                return conductor(1.0, eta, 0.0, c).reflectance() - exact_dielectric(eta)(c);
                            }).size());
    return {judgement::holds,
            fmt::format("the two agree, {}", rounding(worst)),
            "n_t / n_i from 0.6 to 3",
            {{"difference", worst}}};
}

finding root_lacks_index() {
    const double n_i = 1.5;
    const wave m{2, -3};
    const wave root = std::sqrt(m * m - n_i * n_i * 0.25); // sin^2 = 1/4
    const normal_wave<double> ours = refract_complex(n_i, m.real(), -m.imag(), std::sqrt(0.75));
    const double ratio = root.real() / ours.a;
    return {judgement::fails,
            fmt::format(
                "a − ib as printed is {:.4g} times the a and b of the memo's own a² and b² for n_i = {}; the "
                "factor is n_i",
                ratio, n_i),
            "right for n_i = 1",
            {{"ratio", ratio}, {"n_i", n_i}}};
}

finding conductor_form_is_great() {
    std::vector<std::pair<std::string, double>> values;
    for (const double k : {0.0, 0.5, 1.0, 2.0, 5.0})
        values.emplace_back(fmt::format("k_{}", k), air_conductor_error(metal_n, k).size());
    double metals = 0;
    for (const material_sample& m : metal_samples())
        metals = std::max(metals, air_conductor_error(m.index.n, m.index.k).size());
    values.emplace_back("metals", metals);
    return {judgement::holds_within,
            fmt::format("for n = 1.5 it errs by {:.3f} at k = 0, {:.3f} at 0.5, {:.4f} at 1, {:.4f} at 2; by "
                        "at most {:.3f} "
                        "on the built-in metals",
                        values[0].second, values[1].second, values[2].second, values[3].second, metals),
            "k ≥ 1", values};
}

finding not_for_dielectrics() {
    const double w = air_conductor_error(4.0 / 3, 0).size(), g = air_conductor_error(1.5, 0).size();
    return {
        judgement::holds,
        fmt::format("it errs by {:.3f} for water and {:.3f} for glass, more than Schlick ({:.3f} and {:.3f})",
                    w, g, schlick_error(4.0 / 3).size(), schlick_error(1.5).size()),
        "k = 0",
        {{"water", w}, {"glass", g}}};
}

finding schlick_range() {
    const double limit = schlick_error(2.2).size(), relative = schlick_relative_error(1.4).size();
    const double from = root_of(1.2, 1.6, [=](double n) { return schlick_error(n).size() - limit; });
    const double until =
        root_of(2.3, 4, [=](double n) { return schlick_relative_error(n).size() - relative; });
    return {judgement::holds_within,
            fmt::format("as largest absolute error, at most {:.4f} for {:.3f} ≤ n ≤ 2.2; the relative error "
                        "does not grow "
                        "outside: it is {:.3f} at 1.4 and again only at n = {:.2f}",
                        limit, from, relative, until),
            fmt::format("absolute error, {:.3f} ≤ n ≤ 2.2", from),
            {{"limit", limit}, {"from", from}, {"relative", relative}, {"relative_until", until}}};
}

finding water_is_ok() {
    const double w = schlick_error(1.33).size(), edge = schlick_error(2.2).size();
    return {judgement::holds,
            fmt::format("{:.4f} at n = 1.33, against {:.4f} at the edge of the range", w, edge),
            "n = 1.33",
            {{"water", w}, {"edge", edge}}};
}

finding index_from_color() {
    double worst = 0;
    for (double n = 1.01; n < 4; n += 0.01)
        worst = std::max(worst, std::abs(eta_from_f0(normal_reflectance(1.0, n, 0.0)) - n) / n);
    return {judgement::holds_within,
            fmt::format("n comes back, {}; 1 / n has the same color", rounding(worst)),
            "transparent media, and the side must be known",
            {{"difference", worst}}};
}

finding nk_not_recoverable() {
    const auto k_of = [](double n) { return k_from_f0(0.56, n); };
    const auto edge = [&](double n) { return exact_conductor(n, k_of(n))(ratio<double, 1, 7>()); };
    return {
        judgement::holds,
        fmt::format(
            "F0 = 0.56 has n = 0.5, k = {:.2f} and n = 3, k = {:.2f}, whose reflectances at cos = 1/7 are "
            "{:.3f} and {:.3f}; a second number, F82, tells them apart",
            k_of(0.5), k_of(3), edge(0.5), edge(3)),
        "conductors",
        {{"f82_of_n_0.5", edge(0.5)}, {"f82_of_n_3", edge(3)}}};
}

finding another_specular_color() {
    const double air = normal_reflectance(1.0, 1.5, 0.0), under = normal_reflectance(1.333, 1.5, 0.0);
    return {judgement::holds,
            fmt::format("glass has F0 = {:.4f} in air and {:.5f} in water", air, under),
            "any boundary whose outside is not air",
            {{"air", air}, {"water", under}}};
}

finding dip_is_perpendicular() {
    const double brewster = brewster_cosine(1.5);
    const boundary<double> glass = dielectric(1.0, 1.5, brewster);
    double least_s = 1;
    for (int i = 0; i <= 900; ++i)
        least_s = std::min(least_s, dielectric(1.0, 1.5, cosine_of_degrees(0.1 * i)).R_s);
    return {judgement::fails,
            fmt::format("it is the parallel curve: at Brewster's angle R_p is 0 ({}) and R_s {:.3f}; R_s "
                        "only rises, from "
                        "{:.3f}",
                        rounding(glass.R_p), glass.R_s, least_s),
            "n = 1.5",
            {{"R_p", glass.R_p}, {"R_s", glass.R_s}, {"least_R_s", least_s}}};
}

finding no_simple_pseudo_brewster() {
    double worst = 0;
    for (const material_sample& m : metal_samples()) {
        const auto R_p = [&](double c) { return conductor(1.0, m.index.n, m.index.k, c).R_p; };
        const double c = pseudo_brewster_cosine(1.0, m.index.n, m.index.k),
                     slope = (R_p(c + 1e-5) - R_p(c - 1e-5)) / 2e-5;
        worst = std::max(worst, std::abs(slope));
    }
    return {
        judgement::fails,
        fmt::format(
            "a cubic with one root in [0, 1] gives it, in seven Newton steps to all digits; the slope of R_p "
            "there is 0 on the built-in metals, {}",
            rounding(worst)),
        "any n and k",
        {{"slope", worst}}};
}

// The dips of the built-in metals that have one worth speaking of.
std::vector<metal_dip> dips() {
    std::vector<metal_dip> found;
    for (const material_sample& m : metal_samples())
        if (const metal_dip dip = find_metal_dip(m.index.n, m.index.k); dip.error < -0.01)
            found.push_back(dip);
    return found;
}

finding minimum_near_tenth() {
    double lowest = 1, highest = 0;
    std::size_t hits = 0;
    const std::vector<metal_dip> all = dips();
    for (const metal_dip& dip : all) {
        lowest = std::min(lowest, dip.cos_i), highest = std::max(highest, dip.cos_i);
        hits += dip.cos_i >= 0.1 && dip.cos_i <= 0.15 ? 1 : 0;
    }
    const double share = static_cast<double>(hits) / static_cast<double>(all.size());
    return {share > 0.5 ? judgement::holds_within : judgement::fails,
            fmt::format("of {} metals and wavelengths with an error above 0.01, {:.0f} % lie there; the "
                        "range is {:.3f} to "
                        "{:.3f}",
                        all.size(), 100 * share, lowest, highest),
            "transition metals; not copper, silver and gold",
            {{"share", share}, {"lowest", lowest}, {"highest", highest}}};
}

finding alpha_is_7_7() {
    const metal_dip dip = find_metal_dip(metal_n, metal_k);
    return {judgement::holds,
            fmt::format("the solver gives α = {:.4f}, at cos θ = {:.4f} where the error is {:.4f}", dip.alpha,
                        dip.cos_i, dip.error),
            "n = 1.5, k = 5, a = 2 n",
            {{"alpha", dip.alpha}, {"cos_i", dip.cos_i}, {"error", dip.error}}};
}

finding alpha_not_optimal() {
    const double solver = lazanyi_error(metal_n, metal_k, 3, find_metal_dip(metal_n, metal_k).alpha).size(),
                 seven = lazanyi_error(metal_n, metal_k, 3, 7).size();
    return {judgement::holds,
            fmt::format("α = 7 errs by {:.4f}, the solver's α by {:.4f}", seven, solver),
            "n = 1.5, k = 5, a = 3",
            {{"solver", solver}, {"seven", seven}}};
}

finding tuned_for_each() {
    double lowest = 1000, highest = 0;
    for (const metal_dip& dip : dips())
        lowest = std::min(lowest, dip.alpha), highest = std::max(highest, dip.alpha);
    return {
        judgement::holds,
        fmt::format("the solver's α runs from {:.1f} to {:.1f} over the built-in metals", lowest, highest),
        "450, 550 and 650 nm, a = 2 n, errors above 0.01",
        {{"lowest", lowest}, {"highest", highest}}};
}

finding dip_is_negligible() {
    std::size_t seen = 0, count = 0;
    double worst = 0, weighted = 0;
    std::string name;
    for (const material& m : builtin_materials()) {
        if (!is_sample_metal(m)) continue;
        const curve_error e = schlick_error(m, color_space::acescg);
        ++count, seen += e.delta_e_max > slight ? 1 : 0;
        weighted = std::max(weighted, *std::max_element(e.cosine.begin(), e.cosine.end()));
        if (e.delta_e_max > worst) worst = e.delta_e_max, name = m.name;
    }
    return {judgement::fails,
            fmt::format("Schlick's worst colour difference is above 2 (CIEDE2000), which is seen, for {} of "
                        "{} metals, up to "
                        "{:.1f} ({}); it is at grazing angles, so that weighted by the cosine the error is "
                        "at most {:.3f}. "
                        "How it looks on a shape waits for the renderer",
                        seen, count, worst, name, weighted),
            "holds where grazing angles are few",
            {{"seen", static_cast<double>(seen)},
             {"metals", static_cast<double>(count)},
             {"worst_delta_e", worst},
             {"cosine_weighted", weighted}}};
}

finding schlick_tir_mended() {
    const double w = schlick_internal_error(1 / 1.33).size(), g = schlick_internal_error(1 / 1.5).size(),
                 d = schlick_internal_error(1 / 2.417).size();
    return {
        judgement::holds_within,
        fmt::format(
            "with cos θ_t it errs by {:.3f} (water), {:.3f} (glass) and {:.3f} (diamond), exactly as much as "
            "Schlick from outside",
            w, g, d),
        "from the denser side",
        {{"water", w}, {"glass", g}, {"diamond", d}}};
}

finding schlick_without_tir() {
    const auto off = [](double n) {
        const double f0 = normal_reflectance(1.0, n, 0.0);
        return largest([=](double c) { return schlick(f0, c) - exact_dielectric(1 / n)(c); }).size();
    };
    return {
        judgement::holds,
        fmt::format(
            "with cos θ_i it errs by {:.2f} for water, {:.2f} for glass and {:.2f} for diamond from inside",
            off(1.33), off(1.5), off(2.417)),
        "from the denser side",
        {{"water", off(1.33)}, {"diamond", off(2.417)}}};
}

finding interest_decreases() {
    const int inside = count_operations("schlick_internal").cost(),
              exact = count_operations("dielectric").cost(),
              fast = count_operations("dielectric_fast").cost(), plain = count_operations("schlick").cost();
    return {
        judgement::holds,
        fmt::format(
            "{} operations, against {} for plain Schlick and {} for the exact equations in their cheapest "
            "form ({} in the robust one)",
            inside, plain, fast, exact),
        "operations counted by running the models",
        {{"schlick_internal", inside}, {"dielectric_fast", fast}, {"schlick", plain}}};
}

finding gaussian_is_schlick() {
    const double d = largest([](double c) { return spherical_gaussian(0.0, c) - schlick(0.0, c); }).size();
    return {judgement::holds,
            fmt::format("the two differ by at most {:.4f} (1 − f0); it costs {} operations to Schlick's {}",
                        d, count_operations("spherical_gaussian").cost(), count_operations("schlick").cost()),
            "any f0; cheaper only where exp2 is one instruction",
            {{"difference", d}}};
}

finding form_one_inside() {
    const double eta = 1 / 1.5, c = 0.5, inner = 1 - (1 - c * c) / (eta * eta);
    return {judgement::fails,
            fmt::format(
                "beyond the critical angle its root is of {:.2f}: not a number; the form with g is guarded",
                inner),
            "holds for n_t ≥ n_i",
            {{"under_root", inner}}};
}

finding good_and_cheap() {
    const double l = lazanyi_error(metal_n, metal_k, 3, 7.7).size(),
                 s = schlick_nk_error(metal_n, metal_k).size();
    const double f0 = normal_reflectance(1.0, metal_n, metal_k),
                 at = exact_conductor(metal_n, metal_k)(ratio<double, 1, 7>());
    const double h =
        largest([=](double c) { return f82(f0, at, c) - exact_conductor(metal_n, metal_k)(c); }).size();
    return {
        judgement::holds_within,
        fmt::format("it errs by {:.4f} where Schlick errs by {:.4f}; f82, which needs no tuning, by {:.4f}",
                    l, s, h),
        "n = 1.5, k = 5, α = 7.7",
        {{"lazanyi", l}, {"schlick", s}, {"f82", h}}};
}

} // namespace

std::vector<claim> lagarde_claims() {
    const std::string d = "Lagarde 2013, Memo on Fresnel equations";
    const std::string basis = "equation basis", conductor_part = "dielectric–conductor interface",
                      dielectric_part = "dielectric–dielectric interface", part = "Schlick's approximation",
                      lazanyi_part = "Lazanyi's term", internal_part = "total internal reflection";
    return {
        {"lagarde-complex", d, basis, "Any of the equations holds with n − ik in place of n.", "L1 L2 L3 L7",
         "lagarde_complex", complex_index_anywhere},
        {"lagarde-swap", d, basis, "i and t may be swapped, because the expressions are squared.", "L4",
         "lagarde_swap", sides_may_be_swapped},
        {"lagarde-k-0", d, basis, "The dielectric formulas are the conductor's with k = 0.", "L5 L14 L15",
         "lagarde_k_0", dielectric_is_k_0},
        {"lagarde-root", d, conductor_part, "a − ib is the root of (n − ik)² − n_i² sin²θ.", "L8 L9",
         "lagarde_root", root_lacks_index},
        {"lagarde-approximation", d, conductor_part, "But for k = 0 the cheaper form is great.", "L11 L12",
         "lagarde_approximation", conductor_form_is_great},
        {"lagarde-not-dielectric", d, conductor_part, "The cheaper form should not be used for dielectrics.",
         "L13", "lagarde_not_dielectric", not_for_dielectrics},
        {"lagarde-form-1", d, dielectric_part, "The first listing computes the dielectric equations.", "L14",
         "lagarde_form_1", form_one_inside},
        {"lagarde-range", d, part,
         "Schlick is only accurate for 1.4 < n < 2.2; outside the relative error grows.", "L22",
         "lagarde_range", schlick_range},
        {"lagarde-water", d, part, "Water at 1.33 is still ok.", "L23", "lagarde_water", water_is_ok},
        {"lagarde-index", d, part, "The index can be retrieved from the specular color.", "L18 L20",
         "lagarde_index", index_from_color},
        {"lagarde-nk", d, part, "n and k of a conductor cannot be retrieved from R(0).", "L21", "lagarde_nk",
         nk_not_recoverable},
        {"lagarde-water-glass", d, part, "A water–dielectric boundary needs another specular color.", "L19",
         "lagarde_water_glass", another_specular_color},
        {"lagarde-gaussian", d, "end of Schlick's approximation",
         "A spherical Gaussian is an optimised Schlick.", "L39", "lagarde_gaussian", gaussian_is_schlick},
        {"lagarde-perpendicular", d, lazanyi_part,
         "The dip comes from the perpendicular curve, which crosses 0 at Brewster's angle.", "L28 L29",
         "lagarde_perpendicular", dip_is_perpendicular},
        {"lagarde-pseudo-brewster", d, lazanyi_part,
         "There is no simple solution for the pseudo-Brewster angle.", "L30", "lagarde_pseudo_brewster",
         no_simple_pseudo_brewster},
        {"lagarde-minimum", d, lazanyi_part, "The error's minimum lies between 0.1 and 0.15 for most metals.",
         "L31", "lagarde_minimum", minimum_near_tenth},
        {"lagarde-alpha", d, lazanyi_part, "For n = 1.5 and k = 5 the solver finds α = 7.7.", "L32",
         "lagarde_alpha", alpha_is_7_7},
        {"lagarde-optimal", d, lazanyi_part, "The solver's value is not the optimal one.", "L32",
         "lagarde_optimal", alpha_not_optimal},
        {"lagarde-good", d, lazanyi_part, "The result is good and the equation cheap.", "L26 L33",
         "lagarde_good", good_and_cheap},
        {"lagarde-tuning", d, lazanyi_part,
         "It must be tuned for each value, three times for three channels.", "L34", "lagarde_tuning",
         tuned_for_each},
        {"lagarde-negligible", d, lazanyi_part, "The visual impact of the dip is negligible.", "L25 L34",
         "lagarde_negligible", dip_is_negligible},
        {"lagarde-no-tir", d, internal_part, "Schlick does not handle total internal reflection.", "L35",
         "lagarde_no_tir", schlick_without_tir},
        {"lagarde-cos-t", d, internal_part, "Taking cos θ_t when n_i > n_t mends it.", "L36", "lagarde_cos_t",
         schlick_tir_mended},
        {"lagarde-interest", d, internal_part, "With so many instructions the interest of Schlick decreases.",
         "L38", "lagarde_interest", interest_decreases},
    };
}

} // namespace fresnel
