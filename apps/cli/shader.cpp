#include "colour_options.hpp"
#include "commands.hpp"

#include "analysis/compare.hpp"
#include "emit/library.hpp"
#include "error.hpp"
#include "figure/figure.hpp"
#include "materials/catalog.hpp"

#include <fmt/format.h>

namespace fresnel::cli {

namespace {

struct options {
    std::vector<std::string> models;
    std::string language = "glsl";
    std::vector<std::string> fixed;
    std::string material, name, out;
    colour_options colour;
    bool all = false;
};

// "f0=0.04", or "f0=1,0.78,0.34" for a value per channel
void add_fixed(const std::string& text, std::map<std::string, std::array<float, 3>>& fixed) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos || equals == 0)
        throw bad_input(fmt::format("--fix '{}': must be PARAMETER=VALUE or PARAMETER=R,G,B", text));
    const std::string name = text.substr(0, equals);
    std::vector<float> values;
    for (std::size_t from = equals + 1; from <= text.size();) {
        const std::size_t comma = std::min(text.find(',', from), text.size());
        values.push_back(static_cast<float>(
            parse_number(fmt::format("--fix {}", name), std::string_view(text).substr(from, comma - from))));
        from = comma + 1;
    }
    if (values.size() != 1 && values.size() != 3)
        throw bad_input(fmt::format("--fix '{}': has {} values, must have 1 or 3", text, values.size()));
    fixed[name] = values.size() == 1 ? std::array{values[0], values[0], values[0]}
                                     : std::array{values[0], values[1], values[2]};
}

void add_material(const options& given, const std::string& model, emit::model_request& request) {
    if (find_model<double>(model).kind == model_kind::exact)
        throw bad_input(
            fmt::format("--material with {}: n and k have no RGB values; gulbrandsen has an RGB index "
                        "through the exact colours",
                        model));
    const material substance = load_material(given.material);
    const comparison all = compare(substance, chosen_space(given.colour), chosen_ambient(given.colour));
    const model_fit* found = all.find(model);
    if (found == nullptr)
        throw bad_input(
            fmt::format("--material {} with {}: the model does not suit it", given.material, model));
    const auto& parameters = find_model<double>(model).parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        request.fixed.try_emplace(std::string(parameters[i].name),
                                  std::array{static_cast<float>(found->values[0][i]),
                                             static_cast<float>(found->values[1][i]),
                                             static_cast<float>(found->values[2][i])});
}

std::string made_by(const options& given) {
    std::string line = "fresnel shader";
    for (const std::string& model : given.models)
        line += " " + model;
    line += " --lang " + given.language;
    for (const std::string& fixed : given.fixed)
        line += " --fix " + fixed;
    if (!given.material.empty()) line += " --material " + given.material;
    if (!given.name.empty()) line += " --name " + given.name;
    return line;
}

void check(const options& given) {
    if (given.all == !given.models.empty())
        throw bad_input(given.all ? "--all: takes no MODEL" : "MODEL: name one or more, or give --all");
    if (!given.name.empty() && given.models.size() != 1)
        throw bad_input(fmt::format("--name '{}': names one function, but {} models are given", given.name,
                                    given.models.size()));
}

void note_renaming(const emit::language& l, const std::string& name) {
    const std::string legal = emit::function_name(l, name);
    if (!name.empty() && legal != name)
        fmt::print(stderr, "shader: '{}' cannot be a name of ours in {}; the function is called {}\n", name,
                   l.title, legal);
}

std::string text_of(const options& given) {
    const emit::language& l = emit::find_language(given.language);
    if (given.all) return emit::library_text(l);
    std::string text = emit::preamble(l, made_by(given));
    for (const std::string& model : given.models) {
        emit::model_request request{model, {}, given.name};
        for (const std::string& fixed : given.fixed)
            add_fixed(fixed, request.fixed);
        if (!given.material.empty()) add_material(given, model, request);
        text += "\n" + emit::model_text(l, request);
    }
    note_renaming(l, given.name);
    return text + emit::postamble(l);
}

void run(const options& given) {
    check(given);
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
                    "  fresnel shader --all --lang glsl --out fresnel.glsl");
    const auto given = std::make_shared<options>();
    command->add_option("MODEL", given->models, "registry names");
    command
        ->add_option("--lang", given->language,
                     "glsl, essl, hlsl, msl, wgsl, osl, cuda, c or slang (default glsl)")
        ->type_name("L");
    command->add_option("--fix", given->fixed, "a parameter that is a constant, for all channels or R,G,B")
        ->type_name("PARAM=VALUE")
        ->allow_extra_args(false);
    command->add_option("--material", given->material, "parameters fitted to that material, as constants")
        ->type_name("NAME");
    command->add_option("--name", given->name, "name of the function")->type_name("N");
    command->add_option("--out", given->out, "write this file")->type_name("FILE");
    command->add_flag("--all", given->all, "every model and the geometry around them");
    add_colour_options(*command, given->colour);
    command->callback([given] { run(*given); });
}

} // namespace fresnel::cli
