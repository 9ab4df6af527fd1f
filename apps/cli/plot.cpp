#include "colour_options.hpp"
#include "commands.hpp"
#include "figure_files.hpp"
#include "parameter_options.hpp"

#include "analysis/drawing.hpp"
#include "analysis/plot.hpp"
#include "error.hpp"
#include "materials/catalog.hpp"

#include <fmt/format.h>

#include <filesystem>

namespace fresnel::cli {

namespace {

struct options {
    std::vector<std::string> names, out;
    std::string against = "theta", polarization = "r", family, fit, wavelength, title;
    std::optional<std::string> error; // "" for the first name
    parameter_texts parameters;
    colour_options colour;
    bool strip = false, surface = false, json = false;
};

// ---- the request --------------------------------------------------------------------------------------------

abscissa chosen_abscissa(const options& given) {
    if (given.against == "theta") return abscissa::theta;
    if (given.against == "cos") return abscissa::cos_theta;
    if (given.against == "sin") return abscissa::sin_theta;
    throw bad_input(fmt::format("--against '{}': must be theta, cos or sin", given.against));
}

std::vector<polarization> chosen_polarizations(const options& given) {
    std::vector<polarization> chosen;
    for (const std::string& name : CLI::detail::split(given.polarization, ',')) {
        if (name != "r" && name != "s" && name != "p")
            throw bad_input(fmt::format("--polarization '{}': must be r, s, p or several of them with commas",
                                        given.polarization));
        chosen.push_back(name == "s" ? polarization::s : name == "p" ? polarization::p : polarization::mean);
        if (std::count(chosen.begin(), chosen.end(), chosen.back()) > 1)
            throw bad_input(fmt::format("--polarization '{}': has {} twice", given.polarization, name));
    }
    return chosen;
}

plot_family chosen_family(const options& given) {
    const std::size_t equals = given.family.find('=');
    if (equals == std::string::npos || equals == 0)
        throw bad_input(
            fmt::format("--family '{}': must be PARAM=LIST, for instance n_t=1.1:2.5:8", given.family));
    std::string name = given.family.substr(0, equals);
    std::replace(name.begin(), name.end(), '-', '_');
    return {name, parse_list(name, given.family.substr(equals + 1))};
}

double chosen_wavelength(const options& given) {
    const double nm = parse_number("--wavelength", given.wavelength);
    if (nm >= 1 && nm <= 1e9) return nm;
    throw bad_input(fmt::format("--wavelength = {}: must be in [1, 1e9] nm", given.wavelength));
}

// The reference named, or the first subject, which then is not plotted itself.
void choose_reference(const options& given, plot_request& asked) {
    if (!given.error) return;
    if (!given.error->empty()) {
        asked.reference = find_subject(*given.error);
        return;
    }
    asked.reference = asked.subjects.front();
    asked.subjects.erase(asked.subjects.begin());
}

// Whether a material is plotted, fitted to, or what the others are compared with.
bool has_material(const plot_request& asked) {
    const auto is_material = [](const plot_subject& s) { return s.substance.has_value(); };
    return asked.fitted_to || (asked.reference && is_material(*asked.reference)) ||
           std::any_of(asked.subjects.begin(), asked.subjects.end(), is_material);
}

// Whether a model takes the index in front, which is the ambient one unless it is given.
bool takes_n_i(const plot_request& asked) {
    const auto takes = [](const plot_subject& s) {
        return s.model != nullptr && std::any_of(s.model->parameters.begin(), s.model->parameters.end(),
                                                 [](const parameter& p) { return p.name == "n_i"; });
    };
    return (asked.reference && takes(*asked.reference)) ||
           std::any_of(asked.subjects.begin(), asked.subjects.end(), takes);
}

// Colours that nothing plotted depends on.
void check_colours(const options& given, const plot_request& asked) {
    const bool has_space = given.colour.space != colour_options().space;
    if (has_space && (asked.wavelength_nm || asked.surface))
        throw bad_input(fmt::format("--space {}: single wavelengths have no colours; leave it or {} out",
                                    given.colour.space, asked.surface ? "--surface" : "--wavelength"));
    if (has_material(asked)) return;
    if (has_space)
        throw bad_input(fmt::format("--space {}: is of a material; name one, or --fit the models to it",
                                    given.colour.space));
    if (given.colour.ambient != colour_options().ambient && !takes_n_i(asked))
        throw bad_input(fmt::format("--ambient {}: is of a material or of a model with n_i; name one",
                                    given.colour.ambient));
}

plot_request request_of(const options& given) {
    plot_request asked;
    asked.id = given.out.empty() ? "plot" : slug(std::filesystem::path(given.out.front()).stem().string());
    asked.title = given.title;
    for (const std::string& name : given.names)
        asked.subjects.push_back(find_subject(name));
    for (const auto& [name, text] : given.parameters)
        asked.given[name] = parse_number(name, text);
    if (!given.family.empty()) asked.family = chosen_family(given);
    choose_reference(given, asked);
    if (!given.fit.empty()) asked.fitted_to = load_material(given.fit);
    asked.polarizations = chosen_polarizations(given);
    asked.against = chosen_abscissa(given);
    if (!given.wavelength.empty()) asked.wavelength_nm = chosen_wavelength(given);
    asked.space = chosen_space(given.colour), asked.ambient = chosen_ambient(given.colour);
    asked.strips = given.strip, asked.surface = given.surface;
    check_colours(given, asked);
    return asked;
}

// ---- the files ----------------------------------------------------------------------------------------------

// The legend stands beside the panel and holds so many entries.
void require_room(const figure& what, const std::string& path) {
    constexpr std::ptrdiff_t most = 13;
    if (path.ends_with(".csv") || path.ends_with(".json")) return;
    for (const panel& p : what.panels) {
        const auto entries =
            std::count_if(p.curves.begin(), p.curves.end(), [](const series& s) { return !s.label.empty(); });
        if (entries > most)
            throw bad_input(fmt::format("--out '{}': the legend has {} entries, must have at most {}; plot "
                                        "fewer, or write .csv or .json",
                                        path, entries, most));
    }
}

// All of them are made before the first is written.
void write_all(const figure& what, const std::vector<std::string>& paths) {
    std::vector<std::string> contents;
    for (const std::string& path : paths)
        require_room(what, path);
    for (const std::string& path : paths)
        contents.push_back(writer_of("--out", path)(what));
    for (std::size_t i = 0; i < paths.size(); ++i)
        write_file(paths[i], contents[i]);
}

void run(const options& given) {
    for (const std::string& path : given.out)
        writer_of("--out", path), require_writable("--out", path);
    const figure result = make_plot(request_of(given));
    write_all(result, given.out);
    if (given.json) return print_json(to_json(result));
    if (given.out.empty()) fmt::print("{}", to_csv(result));
    for (const std::string& path : given.out)
        fmt::print("wrote {}\n", path);
}

void add_what(CLI::App& command, options& given) {
    command.add_option("WHAT", given.names, "models, see `fresnel models`, and materials")->required();
    command
        .add_option("--out", given.out,
                    "write .svg, .png, .pdf, .csv or .json; may be repeated (default: CSV)")
        ->type_name("FILE")
        ->allow_extra_args(false);
    command.add_option("--against", given.against, "x axis: theta, cos or sin (default theta)")
        ->type_name("X");
    command
        .add_option("--polarization", given.polarization,
                    "r (unpolarised), s, p, or several: s,p,r (default r); exact models and materials")
        ->type_name("LIST");
    command
        .add_option_function<std::vector<std::string>>(
            "--error",
            [&given](const std::vector<std::string>& names) { given.error = names.empty() ? "" : names[0]; },
            "plot model - REF, a material or exact model (default: the first WHAT)")
        ->expected(0, 1)
        ->type_name("REF");
}

void add_curves(CLI::App& command, options& given) {
    command.add_option("--family", given.family, "one curve for each value: A,B,C or FROM:TO:COUNT")
        ->type_name("PARAM=LIST");
    command.add_option("--fit", given.fit, "fit the parameters that are not given to this material")
        ->type_name("NAME");
    command.add_option("--wavelength", given.wavelength, "one wavelength in nm instead of colour channels")
        ->type_name("NM");
    add_colour_options(command, given.colour);
    command.add_flag("--strip", given.strip, "add a strip of colours for each curve");
    command.add_flag("--surface", given.surface, "one material over wavelength and angle");
    command.add_option("--title", given.title, "title of the figure")->type_name("T");
    command.add_flag("--json", given.json, "print the figure as JSON");
    add_parameters(command, given.parameters);
}

} // namespace

void add_plot(CLI::App& app) {
    CLI::App* command = add_command(
        app, "plot", "Draw models and materials against angle, or their errors",
        "  fresnel plot copper schlick f82 --out copper.svg      models are fitted to the material\n"
        "  fresnel plot n-bk7 --polarization s,p,r --out glass.png\n"
        "  fresnel plot dielectric schlick powers_3_6_9 --n-t 2.4 --error --out errors.pdf\n"
        "  fresnel plot dielectric --family n_t=1.1:2.5:8 --out family.svg --out family.csv\n"
        "  fresnel plot gold --surface --out gold.png\n"
        "  fresnel plot gold schlick --strip --against cos --out strips.png\n"
        "  fresnel plot schlick --f0 0.04 --json");
    const auto given = std::make_shared<options>();
    add_what(*command, *given);
    add_curves(*command, *given);
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
