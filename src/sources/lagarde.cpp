#include "sources/parts.hpp"

#include "analysis/angles.hpp"
#include "analysis/curve.hpp"
#include "analysis/fit.hpp"
#include "materials/catalog.hpp"

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>

#include <fmt/format.h>

namespace fresnel {

namespace {

using namespace draw;

// The memo's metal, "the author's case" of Lazanyi and Szirmay-Kalos.
constexpr double metal_n = 1.5, metal_k = 5;

axis reflectance(double lo = 0) { return axis_of("reflectance", lo, 1, lo > 0.4 ? 0.1 : 0.2); }

// ---- exact forms ------------------------------------------------------------------------------------------

regenerated conductor_approximation() {
    const std::vector<double> ks = {0, 0.5, 1, 2, 5};
    panel p{horizontal(against::theta), reflectance(), {}, {}};
    panel errors{horizontal(against::theta), axis_of("approximation − exact", -0.02, 0.12, 0.02), {}, {}};
    std::string worst;
    for (std::size_t i = 0; i < ks.size(); ++i) {
        const double k = ks[i];
        const curve_function exact = exact_conductor(metal_n, k);
        const curve_function fast = [k](double c) { return air_conductor(metal_n, k, c); };
        const std::string color = ramp(i, ks.size()), label = fmt::format("k = {}", k);
        p.curves.push_back(curve(label + ", exact", exact, color));
        p.curves.push_back(curve("", fast, color, stroke::dashed, 1.6));
        errors.curves.push_back(curve(label, [=](double c) { return fast(c) - exact(c); }, color));
        worst +=
            fmt::format("{}{:.4f} at k = {}", i == 0 ? "" : ", ", air_conductor_error(metal_n, k).size(), k);
    }
    figure f{"",
             "",
             "Exact (solid) and the cheaper form for a conductor in air (dashed), n = 1.5.",
             {p, errors},
             {}};
    return {f, "For k = 0 the approximation is not good; for other k it is great.",
            fmt::format("The largest error is {}: great from about k = 1.", worst),
            "n = 1.5, k = 0, 0.5, 1, 2, 5; the memo names none but k = 0"};
}

regenerated dielectric_forms() {
    panel p{horizontal(against::theta), reflectance(), {}, {}};
    panel differences{horizontal(against::theta), axis_of("difference / 1e-16", -6, 6, 2), {}, {}};
    for (const auto& [index, color] : {std::pair{1.5, blue}, {1 / 1.5, green}}) {
        const double eta = index;
        const std::string label = eta > 1 ? "air to glass" : "glass to air";
        const curve_function robust = exact_dielectric(eta);
        const curve_function fast = [eta](double c) { return dielectric_fast(1.0, eta, c).reflectance(); };
        p.curves.push_back(curve(label, robust, color));
        p.curves.push_back(curve(label + ", g and c", fast, color, stroke::dashed, 3));
        differences.curves.push_back(
            curve(label, [=](double c) { return (fast(c) - robust(c)) * 1e16; }, color, stroke::points));
    }
    figure f{"", "", "Two arrangements of the dielectric equations are one function.", {p, differences}, {}};
    return {
        f,
        "The equations for a dielectric in two arrangements: by Snell's law and by g² = η² + c² − 1, with "
        "an imaginary g meaning total internal reflection.",
        fmt::format("In double they agree from outside ({}) and from inside ({}).",
                    rounding(largest([](double c) {
                                 return dielectric_fast(1.0, 1.5, c).reflectance() - exact_dielectric(1.5)(c);
                             }).size()),
                    rounding(largest([](double c) {
                                 return dielectric_fast(1.5, 1.0, c).reflectance() -
                                        exact_dielectric(1 / 1.5)(c);
                             }).size())),
        "n = 1.5"};
}

regenerated polarised() {
    const auto part = [](const std::string& what, double n, double k) {
        panel p{axis_of(what, 0, 90, 15), axis_of("reflectance", -0.1, 1, 0.2), {}, {}};
        const auto at = [=](double c) { return conductor(1.0, n, k, c); };
        p.curves = {curve(
                        "R_s", [=](double c) { return at(c).R_s; }, orange),
                    curve(
                        "R_p", [=](double c) { return at(c).R_p; }, red),
                    curve("R", [=](double c) { return at(c).reflectance(); }, gray, stroke::dashed)};
        const double c = pseudo_brewster_cosine(1.0, n, k);
        p.markers = {{degrees_of_cosine(c), at(c).R_p, "", red}};
        p.notes = {{degrees_of_cosine(c), at(c).R_p - 0.06,
                    fmt::format("{}, {:.2f}°", k == 0 ? "Brewster" : "pseudo-Brewster", degrees_of_cosine(c)),
                    k == 0 ? note::side::center : note::side::right, red}};
        return p;
    };
    figure f{
        "",
        "",
        "The two polarisations, above for a dielectric (n = 1.5), below for a conductor (n = 1.5, k = 5).",
        {part("air to dielectric: θ (degrees)", 1.5, 0),
         part("air to conductor: θ (degrees)", metal_n, metal_k)},
        {}};
    return {f,
            "The dip of a metal comes from the perpendicular curve, which for a dielectric reaches 0 at "
            "Brewster's angle; the metal's pseudo-Brewster angle has no simple solution.",
            fmt::format("It is the parallel curve, R_p. Its least angle follows from a cubic with one root: "
                        "{:.4f}° here; the unpolarised curve is least at {:.4f}°.",
                        *angles_of(1, metal_n, metal_k).pseudo_brewster,
                        *angles_of(1, metal_n, metal_k).least),
            "n = 1.5 with k = 0 and 5"};
}

// ---- Schlick ----------------------------------------------------------------------------------------------

regenerated schlick_range() {
    const std::vector<double> etas = {1.2, 1.4, 1.8, 2.2, 3};
    panel p{horizontal(against::theta), reflectance(), {}, {}};
    for (std::size_t i = 0; i < etas.size(); ++i) {
        const double f0 = normal_reflectance(1.0, etas[i], 0.0);
        p.curves.push_back(
            curve(fmt::format("n = {}, exact", etas[i]), exact_dielectric(etas[i]), ramp(i, etas.size())));
        p.curves.push_back(
            curve("", [f0](double c) { return schlick(f0, c); }, ramp(i, etas.size()), stroke::dashed, 1.6));
    }
    panel errors{axis_of("index of refraction n", 1, 4, 0.5), axis_of("largest error", 0, 0.6, 0.1), {}, {}};
    errors.curves = {sampled(
                         "absolute", [](double n) { return schlick_error(n).size(); }, 1.01, 4, blue,
                         stroke::solid, 2.2, 120),
                     sampled(
                         "relative", [](double n) { return schlick_relative_error(n).size(); }, 1.15, 4,
                         orange, stroke::dashed, 2, 115),
                     line(1.4, 0, 1.4, 0.6), line(2.2, 0, 2.2, 0.6)};
    figure f{"",
             "",
             "Above: exact (solid) and Schlick (dashed). Below: Schlick's largest error over all angles; "
             "the vertical lines are the memo's 1.4 and 2.2.",
             {p, errors},
             {}};
    const double limit = schlick_error(2.2).size();
    const double from = root_of(1.2, 1.6, [=](double n) { return schlick_error(n).size() - limit; });
    return {
        f,
        "Schlick is only accurate for 1.4 < n < 2.2; outside, the relative error grows; water is still ok.",
        fmt::format("The absolute error stays below {:.4f} for {:.3f} ≤ n ≤ 2.2 (water {:.4f}); the relative "
                    "error is {:.3f} at 1.4, {:.3f} at 2.2 and only {:.3f} at 2.9.",
                    limit, from, schlick_error(4.0 / 3).size(), schlick_relative_error(1.4).size(),
                    schlick_relative_error(2.2).size(), schlick_relative_error(2.9).size()),
        "n = 1.2, 1.4, 1.8, 2.2, 3 above, 1.01 to 4 below"};
}

regenerated metal_dip_figure() {
    panel p{horizontal(against::theta), axis_of("reflectance", 0.4, 1, 0.1), {}, {}};
    const auto add = [&](const std::string& name, double n, double k, const char* color) {
        p.curves.push_back(curve(name + ", exact", exact_conductor(n, k), color));
        p.curves.push_back(curve(
            name + ", Schlick", [=](double c) { return schlick_nk(n, k, c); }, color, stroke::dashed, 1.6));
    };
    add("n 1.5, k 5", metal_n, metal_k, blue);
    for (const auto& [name, color] : {std::pair{"aluminium", green}, {"chromium", orange}}) {
        const optical_index m = index_at(*find_material(name), 550);
        add(name, m.n, m.k, color);
    }
    const optical_index cr = index_at(*find_material("chromium"), 550);
    const extremum e = schlick_nk_error(metal_n, metal_k);
    p.markers = {{e.theta_deg(), exact_conductor(metal_n, metal_k)(e.cos_i),
                  fmt::format("off by {:.3f} at {:.1f}°", e.size(), e.theta_deg()), blue, true}};
    figure f{"", "", "Metals at 550 nm: exact (solid) has a dip that Schlick (dashed) does not.", {p}, {}};
    return {f, "Schlick does not match a conductor; several metals have a noticeable dip just before white.",
            fmt::format("Schlick is off by {:.4f} for n = 1.5, k = 5 and by {:.4f} for chromium at 550 nm.",
                        e.size(), schlick_nk_error(cr.n, cr.k).size()),
            "n = 1.5, k = 5, and two measured metals at 550 nm"};
}

// ---- Lazanyi ----------------------------------------------------------------------------------------------

regenerated lazanyi_error_term() {
    const curve_function error = [](double c) {
        return schlick_nk(metal_n, metal_k, c) - exact_conductor(metal_n, metal_k)(c);
    };
    const auto term = [](double a, double exponent) {
        return [=](double c) { return a * c * std::pow(1 - c, exponent); };
    };
    const double alpha = find_metal_dip(metal_n, metal_k).alpha;
    panel p{horizontal(against::cosine), axis_of("Schlick − exact", -0.02, 0.16, 0.02), {}, {}};
    p.curves = {curve("error of Schlick", error, blue, stroke::solid, 2.4, against::cosine),
                curve("a = 3, α = 7", term(3, 7), red, stroke::dashed, 2, against::cosine),
                curve(fmt::format("a = 3, α = {:.3f}", alpha), term(3, alpha), orange, stroke::dotted, 2.2,
                      against::cosine)};
    const metal_dip dip = find_metal_dip(metal_n, metal_k);
    p.markers = {{dip.cos_i, -dip.error, "", blue}};
    p.notes = {{0.22, 0.145, fmt::format("{:.4f} at cos θ = {:.4f}", -dip.error, dip.cos_i), note::side::left,
                blue}};
    figure f{"",
             "",
             "The error of Schlick's approximation and the term a cos θ (1 − cos θ)^α that makes up for it.",
             {p},
             {}};
    return {
        f,
        "The error term with its rational fit, a = 3 and α = 7; the minimum of the error lies between 0.1 "
        "and 0.15 for most metals.",
        fmt::format("Exact − Schlick is least at cos θ = {:.4f}, where it is {:.4f}; matching it there gives "
                    "α = {:.4f}.",
                    dip.cos_i, dip.error, dip.alpha),
        "n = 1.5, k = 5, a = 2 n = 3, α = 7 and the solver's, as in the memo",
        {{"α of the solver, n = 1.5, k = 5", 7.7, dip.alpha, 0.05, "printed with one decimal"}}};
}

regenerated lazanyi_result() {
    const double alpha = find_metal_dip(metal_n, metal_k).alpha;
    const parameters least_squares = fit("lazanyi", channel_of({metal_n, metal_k}));
    const auto with = [](double a, double exponent) {
        return [=](double c) { return lazanyi(metal_n, metal_k, a, exponent, c); };
    };
    const double f0 = normal_reflectance(1.0, metal_n, metal_k),
                 at_82 = exact_conductor(metal_n, metal_k)(ratio<double, 1, 7>());
    const curve_function f82_curve = [=](double c) { return f82(f0, at_82, c); };
    panel p{horizontal(against::theta), reflectance(0.7), {}, {}};
    panel errors{horizontal(against::theta), axis_of("model − exact", -0.03, 0.14, 0.02), {}, {}};
    const auto add = [&](const std::string& label, const curve_function& f, const char* color) {
        p.curves.push_back(curve(label, f, color, stroke::dashed, 1.8));
        errors.curves.push_back(
            curve(label, [=](double c) { return f(c) - exact_conductor(metal_n, metal_k)(c); }, color));
    };
    p.curves.push_back(curve("exact", exact_conductor(metal_n, metal_k), gray, stroke::solid, 2.4));
    add("Schlick", [](double c) { return schlick_nk(metal_n, metal_k, c); }, orange);
    add("α = 7", with(3, 7), red);
    add(fmt::format("α = {:.3f}", alpha), with(3, alpha), blue);
    add("least squares", with(least_squares[2], least_squares[3]), green);
    add("f82", f82_curve, violet);
    figure f{"",
             "",
             "Lazanyi and Szirmay-Kalos' correction with three choices of its exponent, and f82.",
             {p, errors},
             {}};
    const auto size = [](const curve_function& g) {
        return largest([&](double c) { return g(c) - exact_conductor(metal_n, metal_k)(c); }).size();
    };
    return {
        f, "The result is good and cheap, but works for one case only and must be tuned for each value.",
        fmt::format(
            "Largest errors: Schlick {:.4f}, α = 7 {:.4f}, the solver's α {:.4f}, least squares (a = {:.3f}, "
            "α = {:.3f}) {:.4f}, and f82 with no tuning {:.4f}.",
            schlick_nk_error(metal_n, metal_k).size(), size(with(3, 7)), size(with(3, alpha)),
            least_squares[2], least_squares[3], size(with(least_squares[2], least_squares[3])),
            size(f82_curve)),
        "n = 1.5, k = 5, a = 2 n, α = 7 and 7.7 as in the memo; least squares and f82 beside them"};
}

regenerated internal() {
    const double eta = 1 / 1.33, f0 = normal_reflectance(1.33, 1.0, 0.0);
    panel p{horizontal(against::theta), reflectance(), {}, {}};
    p.curves = {
        curve("exact", exact_dielectric(eta), gray, stroke::solid, 2.6),
        curve(
            "Schlick with cos θ_t", [=](double c) { return schlick_internal(eta, c); }, blue, stroke::dashed),
        curve("Schlick", [=](double c) { return schlick(f0, c); }, orange, stroke::dotted)};
    const double critical = degrees_of_cosine(critical_cosine(eta));
    p.markers = {{critical, 0.5, fmt::format("critical, {:.2f}°", critical), gray}};
    figure f{"", "", "From water into air.", {p}, {}};
    return {f,
            "Schlick does not handle total internal reflection; taking cos θ_t instead of cos θ_i mends it.",
            fmt::format("With cos θ_t the largest error is {:.4f}, without {:.4f}.",
                        schlick_internal_error(eta).size(),
                        largest([=](double c) { return schlick(f0, c) - exact_dielectric(eta)(c); }).size()),
            "n_i = 1.33, n_t = 1, as in the memo"};
}

} // namespace

std::vector<source_figure> lagarde_figures() {
    const auto of = [](std::string_view place) {
        return fmt::format("Lagarde 2013, Memo on Fresnel equations, {}", place);
    };
    return {
        {"lagarde-conductor", of("dielectric–conductor interface"), "A cheaper form for conductors in air",
         conductor_approximation},
        {"lagarde-dielectric", of("dielectric–dielectric interface"), "Two forms of the dielectric equations",
         dielectric_forms},
        {"lagarde-polarised", of("after Lazanyi's term"), "s and p, dielectric and conductor", polarised},
        {"lagarde-range", of("Schlick's approximation"), "Schlick's accuracy against the index",
         schlick_range},
        {"lagarde-dip", of("Schlick's approximation"), "The dip of a metal", metal_dip_figure},
        {"lagarde-error-term", of("Lazanyi's term"), "The error of Schlick and Lazanyi's fit",
         lazanyi_error_term},
        {"lagarde-result", of("Lazanyi's term"), "Schlick with Lazanyi's correction", lazanyi_result},
        {"lagarde-internal", of("total internal reflection"), "Schlick from inside, water to air", internal}};
}

} // namespace fresnel
