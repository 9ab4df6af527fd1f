#include "commands.hpp"
#include "parameter_options.hpp"

#include "analysis/angles.hpp"
#include "analysis/curve.hpp"
#include "analysis/model_table.hpp"
#include "error.hpp"
#include "materials/catalog.hpp"

#include <fresnel/geometry.hpp>

#include <fmt/format.h>

#include <optional>

namespace fresnel::cli {

namespace {

struct options {
    std::string n_i = "1", n_t, material;
    std::optional<std::string> k_t, wavelength, theta;
    bool json = false;
};

struct media {
    double n_i, n_t, k_t;
};

media chosen_media(const options& given) {
    const double n_i = parse_parameter(row::n_i, given.n_i);
    if (given.material.empty() == given.n_t.empty()) throw bad_input("--n-t, --material: give one of them");
    if (given.material.empty() && given.wavelength)
        throw bad_input(fmt::format("--wavelength {}: goes with --material only", *given.wavelength));
    if (!given.material.empty() && given.k_t)
        throw bad_input(fmt::format("--k-t {}: is what --material '{}' gives; leave one of them out",
                                    *given.k_t, given.material));
    if (given.material.empty())
        return {n_i, parse_parameter(row::n_t, given.n_t),
                parse_parameter(row::k_t, given.k_t.value_or("0"))};
    const double nm = parse_parameter({"--wavelength", "nm", 1, 1e9, 550}, given.wavelength.value_or("550"));
    const optical_index index = used_index(load_material(given.material), nm);
    check_range(row::n_t, index.n), check_range(row::k_t, index.k);
    return {n_i, index.n, index.k};
}

// The refracted ray; inside an absorbing medium, the direction in which its phase moves.
std::optional<double> refracted_degrees(const media& m, double cos_i) {
    const double eta = m.n_t / m.n_i;
    if (m.k_t == 0 && cos_i < critical_cosine(eta)) return {};
    return degrees_of_cosine(m.k_t == 0 ? refracted_cosine(eta, cos_i)
                                        : phase_cosine(m.n_i, m.n_t, m.k_t, cos_i));
}

nlohmann::json ray_json(const media& m, double theta) {
    const double c = cosine_of_degrees(theta);
    const complex<double> cos_t = complex_refracted_cosine(m.n_i, m.n_t, m.k_t, c);
    return {{"theta_i", theta},
            {"theta_t", or_null(refracted_degrees(m, c))},
            {"cos_t", {cos_t.re, cos_t.im}},
            {"R", conductor(m.n_i, m.n_t, m.k_t, c).reflectance()}};
}

nlohmann::json to_json(const media& m, const boundary_angles& a) {
    return {{"n_i", m.n_i},
            {"n_t", m.n_t},
            {"k_t", m.k_t},
            {"f0", a.f0},
            {"f82", a.f82},
            {"brewster", or_null(a.brewster)},
            {"pseudo_brewster", or_null(a.pseudo_brewster)},
            {"critical", or_null(a.critical)},
            {"least", or_null(a.least)},
            {"least_reflectance", or_null(a.least_reflectance)},
            {"average", a.average},
            {"average_inside", or_null(a.average_inside)}};
}

void print(const media& m, const boundary_angles& a) {
    const auto line = [](std::string_view name, const std::optional<double>& value, std::string_view unit,
                         std::string_view what) {
        if (value)
            print_row("  {:<16} {:>10.6f} {:<4}{}", name, *value, unit, what);
        else
            print_row("  {:<16} {:>10} {:<4}{}", name, "none", "", what);
    };
    fmt::print("from n = {} to n = {} + {} i\n", m.n_i, m.n_t, m.k_t);
    line("F0", a.f0, "", "reflectance at normal incidence");
    line("F82", a.f82, "", "reflectance at cos = 1/7, 81.79°");
    line("Brewster", a.brewster, "°", "R_p = 0");
    line("pseudo-Brewster", a.pseudo_brewster, "°", "R_p is least");
    line("critical", a.critical, "°", "total internal reflection beyond it");
    line("least", a.least, "°",
         a.least ? fmt::format("unpolarised R is least, {:.6f}", *a.least_reflectance)
                 : "unpolarised R only rises");
    line("average", a.average, "", "hemispherical, from this side");
    line("average inside", a.average_inside, "", "hemispherical, from the other side");
}

void print_ray(const media& m, double theta) {
    const std::optional<double> theta_t = refracted_degrees(m, cosine_of_degrees(theta));
    fmt::print("  {:>9.4f}° -> {}\n", theta,
               theta_t ? fmt::format("{:.4f}°", *theta_t) : "totally reflected");
}

void run(const options& given) {
    const media m = chosen_media(given);
    const boundary_angles angles = angles_of(m.n_i, m.n_t, m.k_t);
    const std::vector<double> thetas =
        given.theta ? parse_list("theta", *given.theta) : std::vector<double>();
    for (const double theta : thetas)
        check_range({"theta", "degree", 0, 90, 0}, theta);
    if (!given.json) {
        print(m, angles);
        if (!thetas.empty()) fmt::print("refracted rays\n");
        for (const double theta : thetas)
            print_ray(m, theta);
        return;
    }
    nlohmann::json result = to_json(m, angles);
    for (const double theta : thetas)
        result["rays"].push_back(ray_json(m, theta));
    print_json(result);
}

} // namespace

void add_angles(CLI::App& app) {
    CLI::App* command =
        add_command(app, "angles", "Brewster, critical and other angles of a boundary, its F0 and averages",
                    "  fresnel angles --n-t 1.5\n"
                    "  fresnel angles --n-i 1.333 --n-t 1              a diver looking up\n"
                    "  fresnel angles --n-i 1 --n-t 1.5 --k-t 5 --json\n"
                    "  fresnel angles --material chromium --wavelength 650\n"
                    "  fresnel angles --n-t 1.5 --theta 30,60          and where those rays go");
    const auto given = std::make_shared<options>();
    command->add_option("--n-i,--n_i", given->n_i, "index of the medium outside (default 1)")->type_name("N");
    command->add_option("--n-t,--n_t", given->n_t, "index of the medium behind")->type_name("N");
    command->add_option("--k-t,--k_t", given->k_t, "its imaginary part (default 0)")->type_name("K");
    command->add_option("--material", given->material, "take n and k from this material instead")
        ->type_name("NAME");
    command->add_option("--wavelength", given->wavelength, "of the material, in nm (default 550)")
        ->type_name("NM");
    command
        ->add_option("--theta", given->theta,
                     "refract rays at these angles in degrees: A, A,B,C or FROM:TO:COUNT")
        ->type_name("LIST");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
