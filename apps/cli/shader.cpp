#include "colour_options.hpp"
#include "commands.hpp"
#include "figure_files.hpp"
#include "parameter_options.hpp"
#include "verify_options.hpp"

#include "analysis/compare.hpp"
#include "analysis/drawing.hpp"
#include "emit/library.hpp"
#include "emit/pack.hpp"
#include "emit/technique.hpp"
#include "error.hpp"
#include "figure/figure.hpp"
#include "figure/page.hpp"
#include "materials/catalog.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fresnel::cli {

namespace {

struct options {
    std::vector<std::string> models;
    std::string language = "glsl";
    std::vector<std::string> fixed;
    std::string material, name, technique, stage, out, write, check;
    colour_options colour;
    bool all = false;
    verify_options verify;
};

// The material and what its parameters were fitted to: "gold, fitted in linear ACEScg, ambient 1.333; Johnson ...".
std::string source_of(const options& given, const material& substance) {
    const double ambient = chosen_ambient(given.colour);
    const color_space space = chosen_space(given.colour);
    return fmt::format("{}, fitted in {}{}; {}", given.material,
                       space == color_space::xyz ? "parts of XYZ's white" : space_title(space),
                       ambient == 1 ? "" : fmt::format(", ambient {}", ambient), substance.citation);
}

// A fit gives every parameter of the model.
void refuse_fitted(const options& given, const model_row<double>& row) {
    for (const std::string& fixed : given.fixed)
        for (const parameter& p : row.parameters)
            if (fixed.substr(0, fixed.find('=')) == p.name)
                throw bad_input(
                    fmt::format("--fix '{}': is what --material '{}' gives; leave one of them out", fixed,
                                given.material));
}

void add_material(const options& given, const std::string& model, emit::model_request& request) {
    const model_row<double>& row = find_model<double>(model);
    if (row.kind == model_kind::exact)
        throw bad_input(
            fmt::format("--material with {}: n and k have no RGB values; gulbrandsen has an RGB index "
                        "through the exact colours",
                        model));
    refuse_fitted(given, row);
    const material substance = load_material(given.material);
    const comparison all = compare(substance, chosen_space(given.colour), chosen_ambient(given.colour));
    const model_fit* found = all.find(model);
    if (found == nullptr)
        throw bad_input(
            fmt::format("--material {} with {}: the model does not suit it", given.material, model));
    request.error = fmt::format("at most {:.3g} in a channel, CIEDE2000 {:.2g}, against the exact colours",
                                found->error.worst(), found->error.delta_e_max);
    request.about = source_of(given, substance);
    for (std::size_t i = 0; i < row.parameters.size(); ++i)
        request.fixed[std::string(row.parameters[i].name)] = {found->values[0][i], found->values[1][i],
                                                              found->values[2][i]};
}

std::string made_by(const options& given) {
    std::string line = "fresnel shader";
    for (const std::string& model : given.models)
        line += " " + model;
    line += " --lang " + given.language;
    for (const std::string& fixed : given.fixed)
        line += " --fix " + shell_word(fixed);
    if (!given.material.empty())
        line += " --material " + shell_word(given.material) + colour_arguments(given.colour);
    if (!given.name.empty()) line += " --name " + shell_word(given.name);
    if (!given.technique.empty()) line += " --technique " + given.technique;
    if (!given.stage.empty()) line += " --stage " + given.stage;
    return line;
}

// A library holds the models as they are.
void refuse_own_options(const options& given) {
    const std::pair<std::string_view, std::string> own[] = {
        {"--fix", given.fixed.empty() ? "" : given.fixed.front()}, {"--material", given.material}};
    for (const auto& [option, value] : own)
        if (!value.empty())
            throw bad_input(
                fmt::format("{} '{}': --all takes no constants; name a MODEL instead of it", option, value));
}

void refuse_repeated(const std::vector<std::string>& models) {
    for (auto model = models.begin(); model != models.end(); ++model)
        if (std::find(models.begin(), model, *model) != model)
            throw bad_input(fmt::format("MODEL '{}': is given twice", *model));
}

void check(const options& given) {
    if (given.all == !given.models.empty())
        throw bad_input(given.all ? "--all: takes no MODEL" : "MODEL: name one or more, or give --all");
    if (given.all) refuse_own_options(given);
    if (given.material.empty()) refuse_colours(given.colour, "a --material");
    if (!given.name.empty() && given.models.size() != 1)
        throw bad_input(fmt::format("--name '{}': names one function, but {} models are given", given.name,
                                    given.models.size()));
    if (!given.technique.empty() && given.models.size() != 1)
        throw bad_input(fmt::format("--technique '{}': needs one MODEL, {} are given", given.technique,
                                    given.models.size()));
    if (!given.stage.empty() && given.technique.empty())
        throw bad_input(fmt::format("--stage '{}': is part of a --technique", given.stage));
}

void note_renaming(const emit::language& l, const std::string& wanted, const std::string& given) {
    if (!wanted.empty() && given != wanted)
        say("shader: '{}' cannot be a name of ours in {}; the function is called {}\n", wanted, l.title,
            given);
}

emit::model_request request_of(const options& given, const std::string& model) {
    emit::model_request request{model, {}, given.name};
    for (const std::string& fixed : given.fixed)
        add_fixed(fixed, request.fixed);
    if (!given.material.empty()) add_material(given, model, request);
    return request;
}

std::string program_of(const options& given) {
    const emit::technique& how = emit::find_technique(given.technique);
    const emit::stage stages = emit::find_stage(given.stage);
    const emit::dialect& d = emit::find_dialect(given.language);
    const emit::model_request request = request_of(given, given.models.front());
    note_renaming(d.own(), given.name, emit::name_in_program(d, request));
    return emit::technique_text(d, how, request, stages, made_by(given));
}

std::string text_of(const options& given) {
    if (!given.technique.empty()) return program_of(given);
    const emit::language& l = emit::find_language(given.language);
    if (given.all) return emit::library_text(l);
    std::vector<emit::model_request> requests;
    for (const std::string& model : given.models)
        requests.push_back(request_of(given, model));
    std::string text = emit::preamble(l, made_by(given), requests);
    for (const emit::model_request& request : requests)
        text += "\n" + emit::model_text(l, request);
    note_renaming(l, given.name, emit::function_name(l, given.name));
    return text;
}

void check_folder(const std::string& folder) {
    const std::vector<std::string> differences = emit::check_packs(folder);
    for (const std::string& difference : differences)
        fmt::print("{}\n", difference);
    if (differences.empty()) return;
    throw failure(
        fmt::format("--check {}: {} of the files are not what --write makes", folder, differences.size()));
}

void run(const options& given) {
    refuse_repeated(given.models);
    if (given.verify.wanted) return run_verify(given.verify, given.models);
    if (!given.write.empty()) {
        require_writable_folder("--write", given.write);
        emit::write_packs(given.write);
        fmt::print("{}\n", given.write);
        return;
    }
    if (!given.check.empty()) {
        check_folder(given.check);
        return;
    }
    check(given);
    if (!given.out.empty()) require_writable("--out", given.out);
    const std::string text = text_of(given);
    if (given.out.empty()) {
        fmt::print("{}", text);
        return;
    }
    write_file(given.out, text);
    fmt::print("{}\n", given.out);
}

} // namespace

void add_shader(CLI::App& app) {
    CLI::App* command =
        add_command(app, "shader", "A model as shader text, ready to be pasted",
                    "  fresnel shader schlick --lang hlsl\n"
                    "  fresnel shader conductor --lang wgsl --fix n_i=1.333\n"
                    "  fresnel shader gulbrandsen --material gold --space acescg --name gold\n"
                    "  fresnel shader --all --lang glsl --out fresnel.glsl\n"
                    "  fresnel shader schlick --technique per-pixel --lang glsl --stage fragment\n"
                    "  fresnel shader --write shaders              every library and engine pack\n"
                    "  fresnel shader --check shaders              whether they are what --write makes\n"
                    "  fresnel shader --verify schlick conductor   the text against the model, bit by bit");
    const auto given = std::make_shared<options>();
    command->add_option("MODEL", given->models, "registry names");
    command
        ->add_option(
            "--lang", given->language,
            "glsl, essl, hlsl, msl, wgsl, osl, cuda, c or slang (default glsl); cg is hlsl, and with "
            "--technique that of shader models 2 and 3")
        ->type_name("L");
    command->add_option("--fix", given->fixed, "a parameter that is a constant, for all channels or R,G,B")
        ->type_name("PARAM=VALUE")
        ->allow_extra_args(false);
    command->add_option("--material", given->material, "parameters fitted to that material, as constants")
        ->type_name("NAME");
    command->add_option("--name", given->name, "name of the function")->type_name("N");
    command
        ->add_option("--technique", given->technique,
                     "a complete vertex and fragment program of one MODEL: none, one-minus-cos, per-vertex, "
                     "per-pixel, lut, highlights or semitransparent")
        ->type_name("T");
    command->add_option("--stage", given->stage, "of a program that stage alone: vertex or fragment")
        ->type_name("S");
    command->add_option("--out", given->out, "write this file")->type_name("FILE");
    command->add_flag("--all", given->all, "every model and the geometry around them");
    command->add_option("--write", given->write, "write every generated file under this folder")
        ->type_name("DIR");
    command
        ->add_option("--check", given->check, "compare this folder with what --write makes; 1 if they differ")
        ->type_name("DIR");
    add_colour_options(*command, given->colour);
    for (const char* folder : {"--write", "--check"})
        for (const char* other : {"MODEL", "--lang", "--fix", "--material", "--name", "--out", "--all",
                                  "--technique", "--stage", "--space", "--ambient"})
            command->get_option(folder)->excludes(command->get_option(other));
    command->get_option("--write")->excludes(command->get_option("--check"));
    add_verify_options(*command, given->verify);
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
