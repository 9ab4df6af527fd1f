#include "emit/technique.hpp"

#include "emit/lut.hpp"
#include "emit/stages.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fresnel::emit {

namespace {

constexpr std::array all = {
    technique{"none", "that of normal incidence at every angle, to see what is missing"},
    technique{"one-minus-cos", "1 - cos_i in place of the model, to see what is wrong with it"},
    technique{"per-vertex", "the model at the vertices, for meshes whose normals are known there alone"},
    technique{"per-pixel", "the model at each pixel, with the normal of a map"},
    technique{"lut", "a texture of the model, read at each pixel"},
    technique{"highlights", "a light and its highlight, the model at the half vector"},
    technique{"semitransparent", "a thin layer, more opaque towards its silhouette, and its highlight"},
};

// Names that the programs declare beside those of the model.
constexpr std::array ours = {"main",
                             "color",
                             "vertex_main",
                             "fragment_main",
                             "vertex_input",
                             "fragment_input",
                             "program_uniforms",
                             "u",
                             "input",
                             "output",
                             "world",
                             "along",
                             "view",
                             "cos_i",
                             "F",
                             "mirrored",
                             "reflection",
                             "reflectance",
                             "base",
                             "lit",
                             "normal",
                             "bitangent",
                             "texel",
                             "to_light",
                             "attenuation",
                             "light",
                             "cos_l",
                             "cos_h",
                             "lobe",
                             "diffuse",
                             "specular",
                             "alpha",
                             "alpha_F",
                             "alpha_att",
                             "position",
                             "tangent",
                             "texcoord",
                             "one_minus_cos"};

// ---- the table of a program -----------------------------------------------------------------------------------

// Numbers with the digits of a float, which tell whether a command gives three channels.
fixed_values short_numbers(fixed_values fixed) {
    for (auto& [name, values] : fixed)
        for (double& x : values)
            x = std::stod(fmt::format("{}", static_cast<float>(x)));
    return fixed;
}

// The command that bakes it.
std::string baking(const std::string& model, const fixed_values& fixed, const std::string& rows) {
    std::string command = "fresnel lut " + model;
    for (const auto& [name, v] : fixed)
        command += v[0] == v[1] && v[1] == v[2] ? fmt::format(" --fix {}={}", name, v[0])
                                                : fmt::format(" --fix {}={}", name, fmt::join(v, ","));
    return command + (rows.empty() ? "" : " --by " + rows);
}

// Of a program that reads a table by cos_i alone.
[[noreturn]] void refuse_critical_angle(const std::string& what, const std::string& command) {
    throw bad_input(fmt::format("--technique lut: {} has a critical angle, where reflectance ends like a "
                                "square root, which a table even in cos_i does not follow; `{}` prints a "
                                "function that does",
                                what, command));
}

// Only approximations have the constants of a material.
[[noreturn]] void refuse_open(const std::string& model, const std::vector<std::string_view>& left) {
    const bool fitted = find_model<double>(model).kind == model_kind::approximation;
    throw bad_input(fmt::format("--technique lut: {} leaves {} open, and the rows of a table stand for f0 or "
                                "n_t alone: fix {} by --fix {}=VALUE{}",
                                model, fmt::join(left, " and "), left.size() == 1 ? "it" : "them",
                                fmt::join(left, "=VALUE --fix "), fitted ? " or by --material" : ""));
}

/// What a table's rows stand for: the one parameter that is left to the user, f0 or the index of a dielectric; none where
/// all are fixed.
std::string row_parameter(const model_request& wanted) {
    std::vector<std::string_view> left;
    for (const parameter& p : find_model<double>(wanted.model).parameters)
        if (!wanted.fixed.contains(std::string(p.name)) && p.name != "n_i") left.push_back(p.name);
    if (left.empty()) return {};
    if (left.front() == "eta")
        refuse_critical_angle(wanted.model, fmt::format("fresnel lut {} --fix eta=ETA", wanted.model));
    if (left.size() == 1 && left.front() == "f0") return "f0";
    if (left.size() == 1 && left.front() == "n_t") return "eta";
    refuse_open(wanted.model, left);
}

/// What a program reads: the table that its head says how to bake.
struct program_table {
    std::string rows, command;
    shape type = shape::three;
};

program_table table_of(const model_request& wanted) {
    record(wanted.model, {1, false, wanted.fixed}); // its name and its parameters are checked
    const fixed_values fixed = short_numbers(wanted.fixed);
    program_table table;
    table.rows = row_parameter(wanted);
    table.command = baking(wanted.model, fixed, table.rows);
    const lut_subject subject = model_subject(wanted.model, fixed, table.rows);
    if (subject.critical > 0) refuse_critical_angle(subject.caption, table.command);
    if (subject.channels == 1) table.type = shape::scalar;
    return table;
}

// ---- the head -----------------------------------------------------------------------------------------------

std::vector<std::string> table_lines(const program_table& table) {
    return {table.rows.empty()
                ? "The texture is one row against cos_i:"
                : fmt::format("The texture has cos_i along its rows, a row for each {}:", table.rows),
            fmt::format("`{} --map cos` bakes it.", table.command),
            table.type == shape::scalar ? "It has one channel." : "Its channels are those of a colour."};
}

std::vector<std::string> technique_lines(std::string_view how) {
    if (how == "highlights")
        return {"Draw once for each light, from the second on with ambient_color 0 and blending ONE, ONE."};
    if (how == "semitransparent")
        return {
            "The colour comes out multiplied by the opacity: draw with blending ONE, ONE_MINUS_SRC_ALPHA,",
            "and once more for each further light, with ambient_color 0 and blending ONE, ONE."};
    return {};
}

std::vector<std::string> head(const dialect& d, const technique& how, std::string_view made_by,
                              const std::vector<std::string>& particular) {
    std::vector<std::string> lines = {fmt::format("Fresnel reflectance in two stages: {}.", how.summary),
                                      fmt::format("{}. Made by `{}`; do not edit.", d.title, made_by), ""};
    lines.insert(lines.end(), particular.begin(), particular.end());
    lines.emplace_back("Colours are linear, and directions point away from the surface.");
    if (d.id == "hlsl" || d.id == "cg")
        lines.emplace_back("Matrices stand before the vectors that they transform: mul(M, v).");
    return lines;
}

// A function must not bear a name that the program uses, its parameters' among them.
model_request freely_named(const dialect& d, const model_request& wanted) {
    program p(d);
    declare_inputs(p), declare_textures(p), declare_functions(p);
    const auto& parameters = find_model<double>(wanted.model).parameters;
    const auto is_parameter = [&](const std::string& name) {
        return std::any_of(parameters.begin(), parameters.end(),
                           [&](const parameter& x) { return x.name == name; });
    };
    model_request request = wanted;
    if (request.name.empty() && is_parameter(request.model)) request.name = request.model + "_reflectance";
    if (request.name.empty()) return request;
    request.name = function_name(d.own(), request.name);
    while (std::find(ours.begin(), ours.end(), request.name) != ours.end() || p.declares(request.name) ||
           is_parameter(request.name))
        request.name += "_";
    return request;
}

} // namespace

std::span<const technique> techniques() { return all; }

const technique& find_technique(std::string_view name) {
    std::vector<std::string> names;
    for (const technique& t : all) {
        if (t.name == name) return t;
        names.emplace_back(t.name);
    }
    throw bad_input(fmt::format("--technique = '{}': is not a technique{}; one of {}", name,
                                did_you_mean(name, names), fmt::join(names, ", ")));
}

stage find_stage(std::string_view name) {
    if (name.empty()) return stage::both;
    if (name == "vertex") return stage::vertex;
    if (name == "fragment") return stage::fragment;
    throw bad_input(fmt::format("--stage = '{}': must be vertex or fragment", name));
}

std::string name_in_program(const dialect& d, const model_request& wanted) {
    return freely_named(d, wanted).name;
}

std::string technique_text(const dialect& d, const technique& how, const model_request& given, stage stages,
                           std::string_view made_by) {
    const model_request wanted = freely_named(d, given);
    program p(d);
    declare_inputs(p);
    declare_functions(p);
    if (how.name == "lut") {
        const program_table table = table_of(wanted);
        declare_textures(p);
        from_a_table(p, table.rows, table.type);
        return p.text(head(d, how, made_by, table_lines(table)), stages);
    }
    const reflectance model = declare_model(p, wanted);
    declare_textures(p);
    if (how.name == "per-vertex")
        at_vertices(p, model);
    else if (how.name == "highlights")
        highlights(p, model);
    else if (how.name == "semitransparent")
        semitransparent(p, model);
    else
        at_pixels(p, model, how.name);
    return p.text(head(d, how, made_by, technique_lines(how.name)), stages);
}

} // namespace fresnel::emit
