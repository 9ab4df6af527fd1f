#include "commands.hpp"
#include "parameter_options.hpp"

#include "analysis/angles.hpp"
#include "analysis/curve.hpp"
#include "analysis/metalness.hpp"
#include "analysis/model_table.hpp"
#include "error.hpp"

#include <fresnel/geometry.hpp>
#include <fresnel/shading.hpp>

#include <fmt/format.h>

#include <optional>

namespace fresnel::cli {

namespace {

using words = std::vector<std::string>;

// Three linear numbers, one number for a gray, or a HEX of sRGB codes. A measured F0 may lie a little outside sRGB.
rgb colour(std::string_view argument, const words& given, double most = 1) {
    if (given.size() == 1 && (given[0].starts_with('#') || given[0].size() == 6))
        if (const auto codes = parse_hex(given[0])) return decode_srgb8(*codes);
    if (given.size() != 1 && given.size() != 3)
        throw bad_input(fmt::format("{} '{}': must be one number, three, or a HEX like #ffe29b", argument,
                                    fmt::join(given, " ")));
    rgb c{};
    for (std::size_t i = 0; i < 3; ++i) {
        const std::string& text = given[given.size() == 3 ? i : 0];
        c[i] = parse_number(argument, text);
        if (!(c[i] >= 0 && c[i] <= most))
            throw bad_input(fmt::format(
                "{} = {}: must be in [0, {}], linear; 8-bit codes are written as a HEX like #ffe29b",
                argument, text, most));
    }
    return c;
}

nlohmann::json number_if(bool there, double value) {
    return there ? nlohmann::json(value) : nlohmann::json();
}

std::string three(const rgb& c) { return fmt::format("{:.6g} {:.6g} {:.6g}", c[0], c[1], c[2]); }

void line(std::string_view name, const std::string& value, std::string_view what = "") {
    print_row("  {:<16} {:<28} {}", name, value, what);
}

std::string number_or_dash(const nlohmann::json& value) {
    return value.is_null() ? "–" : fmt::format("{:.6g}", value.get<double>());
}

// ---- ior --------------------------------------------------------------------------------------------------

struct ior_options {
    std::string n, k = "0", ambient = "1";
    bool json = false;
};

nlohmann::json from_index(double n, double k, double ambient) {
    const double f0 = normal_reflectance(ambient, n, k);
    const boundary_angles outer = angles_of(ambient, n, k);
    const bool clear = k == 0;
    return {{"n", n},
            {"k", k},
            {"ambient", ambient},
            {"f0", f0},
            {"srgb8", encode_srgb8({f0, f0, f0})[0]},
            {"other_n", number_if(clear, ambient * ambient / n)},
            {"brewster", or_null(outer.brewster)},
            {"critical_inside",
             number_if(clear && n > ambient, degrees_of_cosine(critical_cosine(std::min(ambient / n, 1.0))))},
            {"disney_specular", number_if(disney_specular(f0) <= 1, disney_specular(f0))},
            {"frostbite_reflectance", number_if(frostbite_reflectance(f0) <= 1, frostbite_reflectance(f0))},
            {"gltf_ior", number_if(clear && n >= ambient, n / ambient)},
            {"openpbr_specular_weight", openpbr_specular_weight(f0, 1.5)},
            {"residual", 0}};
}

void run_ior(const ior_options& given) {
    const nlohmann::json result =
        from_index(parse_parameter(row::n, given.n), parse_parameter(row::k, given.k),
                   parse_parameter({"--ambient", "1", row::n_i.min, row::n_i.max, 1}, given.ambient));
    if (given.json) return print_json(result);
    line("F0", number_or_dash(result["f0"]), fmt::format("sRGB code {}", result["srgb8"].get<int>()));
    line("same F0 from", number_or_dash(result["other_n"]), "the other index with this F0");
    line("Brewster", number_or_dash(result["brewster"]), "degrees");
    line("critical inside", number_or_dash(result["critical_inside"]), "degrees, from the dense side");
    line("Disney, Unreal", number_or_dash(result["disney_specular"]), "specular, f0 = 0.08 specular");
    line("Frostbite", number_or_dash(result["frostbite_reflectance"]), "reflectance, f0 = 0.16 reflectance²");
    line("OpenPBR", number_or_dash(result["openpbr_specular_weight"]), "specular_weight at specular_ior 1.5");
}

// ---- f0 ---------------------------------------------------------------------------------------------------

struct f0_options {
    words f0;
    std::string ambient = "1";
    bool json = false;
};

void run_f0(const f0_options& given) {
    const rgb f0 = colour("F0", given.f0);
    const double ambient = parse_parameter({"--ambient", "1", row::n_i.min, row::n_i.max, 1}, given.ambient);
    nlohmann::json outer = nlohmann::json::array(), inner = outer;
    double residual = 0;
    for (const double x : f0) {
        const double n = ambient * eta_from_f0(x);
        outer.push_back(number_if(x < 1, n)),
            inner.push_back(number_if(x < 1, ambient * inner_eta_from_f0(x)));
        if (x < 1) residual = std::max(residual, std::abs(normal_reflectance(ambient, n, 0.0) - x));
    }
    if (given.json)
        return print_json(
            {{"f0", f0}, {"ambient", ambient}, {"n", outer}, {"n_below", inner}, {"residual", residual}});
    const auto list = [](const nlohmann::json& v) {
        return fmt::format("{} {} {}", number_or_dash(v[0]), number_or_dash(v[1]), number_or_dash(v[2]));
    };
    line("F0", three(f0));
    line("n above", list(outer), "of a transparent material in that ambient medium");
    line("n below", list(inner), "the other one with the same F0");
    fmt::print("  n and k of a metal cannot be had from F0: many pairs share it\n");
}

// ---- metalness --------------------------------------------------------------------------------------------

struct metalness_options {
    std::string law;
    words base, f0, albedo;
    std::optional<std::string> metalness, specular, ior;
    bool json = false;
};

// Asked for every law at once, those without the number keep to themselves.
double specular_of(const metalness_law& law, const metalness_options& given) {
    if (!given.specular) return law.specular_default;
    if (law.specular_name.empty() && given.law.empty()) return law.specular_default;
    if (law.specular_name.empty())
        throw bad_input(
            fmt::format("--specular {}: {} has no specular; leave it out", *given.specular, law.name));
    return parse_parameter({"--specular", "1", 0, law.specular_max, 0}, *given.specular);
}

double ior_of(const metalness_law& law, const metalness_options& given) {
    if (given.ior && !law.has_ior && !given.law.empty())
        throw bad_input(fmt::format("--ior {}: {} has no ior; leave it out", *given.ior, law.name));
    return parse_parameter({"--ior", "1", 1, 100, 1.5}, given.ior.value_or("1.5"));
}

nlohmann::json surface_json(const surface_colors& s) { return {{"f0", s.f0}, {"albedo", s.albedo}}; }

nlohmann::json values_json(const metalness_law& law, const metalness_values& v) {
    nlohmann::json result = {{"law", law.name}, {"base", v.base}, {"metalness", v.metalness}};
    result["specular"] = number_if(!law.specular_name.empty(), v.specular);
    if (law.has_ior) result["ior"] = v.ior;
    return result;
}

nlohmann::json forwards(const metalness_law& law, const metalness_options& given) {
    const metalness_values v{colour("--base", given.base),
                             parse_parameter({"--metalness", "1", 0, 1, 0}, given.metalness.value_or("0")),
                             specular_of(law, given), ior_of(law, given)};
    const surface_colors s = to_surface(law, v);
    nlohmann::json result = values_json(law, v);
    result.update(surface_json(s));
    result["cavity_f90"] = {cavity_f90(s.f0[0]), cavity_f90(s.f0[1]), cavity_f90(s.f0[2])};
    result["residual"] = 0;
    return result;
}

nlohmann::json backwards(const metalness_law& law, const surface_colors& wanted, double ior) {
    const metalness_fit fit = from_surface(law, wanted, ior);
    nlohmann::json result = values_json(law, fit.values);
    result.update(surface_json(fit.reproduced));
    result["residual"] = fit.residual;
    return result;
}

void print_metalness(const nlohmann::json& r) {
    fmt::print("{}\n", r["law"].get<std::string>());
    line("base", three(r["base"].get<rgb>()));
    line("metalness", number_or_dash(r["metalness"]));
    line("specular", number_or_dash(r["specular"]));
    line("F0", three(r["f0"].get<rgb>()));
    line("albedo", three(r["albedo"].get<rgb>()));
    line("residual", fmt::format("{:.2g}", r["residual"].get<double>()),
         "largest difference of F0 and albedo");
}

void run_metalness(const metalness_options& given) {
    const bool back = !given.f0.empty() || !given.albedo.empty();
    if (back == !given.base.empty())
        throw bad_input("--base, --f0: give --base and --metalness, or --f0 and --albedo");
    if (back && (given.f0.empty() || given.albedo.empty()))
        throw bad_input("--f0, --albedo: both are needed to find the parameters");
    if (back && (given.metalness || given.specular))
        throw bad_input("--metalness, --specular: are what --f0 and --albedo find; leave them out");
    surface_colors wanted{};
    if (back) wanted = {colour("--f0", given.f0, 1.2), colour("--albedo", given.albedo)};

    std::vector<nlohmann::json> results;
    for (const metalness_law& law : metalness_laws())
        if (given.law.empty() || law.name == find_metalness_law(given.law).name)
            results.push_back(back ? backwards(law, wanted, ior_of(law, given)) : forwards(law, given));
    if (given.json)
        return print_json(given.law.empty() ? nlohmann::json{{"laws", results}} : results.front());
    for (const nlohmann::json& r : results)
        print_metalness(r);
}

// ---- opacity ----------------------------------------------------------------------------------------------

struct opacity_options {
    std::optional<std::string> total, attenuation;
    std::string fresnel;
    std::optional<std::string> theta;
    bool json = false;
};

void run_opacity(const opacity_options& given) {
    if (given.total.has_value() == given.attenuation.has_value())
        throw bad_input("--total, --attenuation: give one of them; the other is found");
    const double fresnel = parse_parameter({"--fresnel", "1", 0, 1, 0}, given.fresnel);
    double attenuation, total;
    if (given.total) {
        total = parse_parameter({"--total", "1", 0, 1, 0}, *given.total);
        if (fresnel > total)
            throw bad_input(
                fmt::format("--fresnel = {}: must be in [0, {}], the total opacity; no layer is less opaque "
                            "than its surface reflects",
                            fresnel, total));
        attenuation = fresnel == 1 ? 0 : opacity_attenuation(total, fresnel);
    } else {
        attenuation = parse_parameter({"--attenuation", "1", 0, 1, 0}, *given.attenuation);
        total = opacity_total(attenuation, fresnel);
    }
    nlohmann::json rows = nlohmann::json::array();
    for (const double theta : given.theta ? parse_list("theta", *given.theta) : std::vector<double>()) {
        check_range({"theta", "degree", 0, 90, 0}, theta);
        const double c = cosine_of_degrees(theta);
        const double silhouette = opacity_silhouette(attenuation, c), reflected = opacity_fresnel(fresnel, c);
        rows.push_back({{"theta", theta},
                        {"attenuation", silhouette},
                        {"fresnel", reflected},
                        {"total", opacity_total(silhouette, reflected)}});
    }
    if (given.json)
        return print_json({{"total", total},
                           {"fresnel", fresnel},
                           {"attenuation", attenuation},
                           {"angles", rows},
                           {"residual", std::abs(opacity_total(attenuation, fresnel) - total)}});
    line("attenuation", fmt::format("{:.6g}", attenuation), "opacity of the layer, at normal view");
    line("fresnel", fmt::format("{:.6g}", fresnel), "opacity by reflection");
    line("total", fmt::format("{:.6g}", total));
    if (!rows.empty())
        fmt::print("  {:>8} {:>12} {:>12} {:>12}\n", "theta", "attenuation", "fresnel", "total");
    for (const nlohmann::json& r : rows)
        fmt::print("  {:>8.4g} {:>12.6g} {:>12.6g} {:>12.6g}\n", r["theta"].get<double>(),
                   r["attenuation"].get<double>(), r["fresnel"].get<double>(), r["total"].get<double>());
}

// ---- the commands -----------------------------------------------------------------------------------------

void add_ior(CLI::App& app) {
    CLI::App* command = add_command(app, "ior", "An index of refraction as F0 and as engines' sliders",
                                    "  fresnel convert ior 1.5\n"
                                    "  fresnel convert ior 1.5 --ambient 1.333 --json\n"
                                    "  fresnel convert ior 0.18 --k 3.07");
    const auto given = std::make_shared<ior_options>();
    command->add_option("N", given->n, "index of refraction")->required();
    command->add_option("--k", given->k, "its imaginary part (default 0)")->type_name("K");
    command->add_option("--ambient", given->ambient, "index of the medium outside (default 1)")
        ->type_name("N");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run_ior(*given); });
}

void add_from_f0(CLI::App& app) {
    CLI::App* command = add_command(app, "f0", "F0 as the two indices of refraction that have it",
                                    "  fresnel convert f0 0.04\n"
                                    "  fresnel convert f0 '#383838' --json\n"
                                    "  fresnel convert f0 0.171 0.172 0.176");
    const auto given = std::make_shared<f0_options>();
    command->add_option("F0", given->f0, "one linear number, three, or a HEX of sRGB codes")
        ->required()
        ->expected(1, 3);
    command->add_option("--ambient", given->ambient, "index of the medium outside (default 1)")
        ->type_name("N");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run_f0(*given); });
}

void add_metalness(CLI::App& app) {
    CLI::App* command =
        add_command(app, "metalness", "Base color, metalness and specular to F0 and albedo, and back",
                    "  fresnel convert metalness --base 1 .77 .34 --metalness 1 --law unreal\n"
                    "  fresnel convert metalness --base '#b87333' --metalness .5 --specular .5\n"
                    "  fresnel convert metalness --f0 .95 .64 .54 --albedo 0 --law gltf --json");
    const auto given = std::make_shared<metalness_options>();
    command
        ->add_option("--law", given->law, "disney, unreal, frostbite, unity, gltf or openpbr (default all)")
        ->type_name("LAW");
    command->add_option("--base", given->base, "base color: three linear numbers, one, or a HEX")
        ->type_name("C")
        ->expected(1, 3);
    command->add_option("--metalness", given->metalness, "in [0, 1] (default 0)")->type_name("M");
    command->add_option("--specular", given->specular, "the law's number for dielectrics, in [0, 1]")
        ->type_name("S");
    command->add_option("--ior", given->ior, "index of the dielectric, gltf and openpbr (default 1.5)")
        ->type_name("N");
    command->add_option("--f0", given->f0, "find the parameters of this F0 ...")
        ->type_name("C")
        ->expected(1, 3);
    command->add_option("--albedo", given->albedo, "... and this diffuse color")
        ->type_name("C")
        ->expected(1, 3);
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run_metalness(*given); });
}

void add_opacity(CLI::App& app) {
    CLI::App* command =
        add_command(app, "opacity", "Opacity of a layer by attenuation and by reflection",
                    "  fresnel convert opacity --total 0.2 --fresnel 0.04\n"
                    "  fresnel convert opacity --attenuation 0.1667 --fresnel 0.04 --theta 0,60,80 --json");
    const auto given = std::make_shared<opacity_options>();
    command->add_option("--total", given->total, "total opacity at normal view, in [0, 1]")->type_name("A");
    command->add_option("--attenuation", given->attenuation, "opacity of the layer at normal view, in [0, 1]")
        ->type_name("A");
    command->add_option("--fresnel", given->fresnel, "opacity by reflection at normal view, in [0, 1]")
        ->type_name("A")
        ->required();
    command->add_option("--theta", given->theta, "also at these angles in degrees: A, A,B,C or FROM:TO:COUNT")
        ->type_name("LIST");
    command->add_flag("--json", given->json, "print JSON");
    command->callback([given] { run_opacity(*given); });
}

} // namespace

void add_convert(CLI::App& app) {
    CLI::App* command = add_command(app, "convert", "Index, F0, metalness and opacity, from one to the other",
                                    "  fresnel convert ior 1.5\n"
                                    "  fresnel convert f0 0.04\n"
                                    "  fresnel convert metalness --base 1 .77 .34 --metalness 1\n"
                                    "  fresnel convert opacity --total 0.2 --fresnel 0.04");
    command->require_subcommand(0, 1);
    command->callback([command] {
        if (command->get_subcommands().empty())
            throw bad_input("convert: must be followed by ior, f0, metalness or opacity");
    });
    add_ior(*command);
    add_from_f0(*command);
    add_metalness(*command);
    add_opacity(*command);
}

} // namespace fresnel::cli
