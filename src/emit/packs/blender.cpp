// Blender: an OSL shader for every model, for the Script node of Cycles. Each file stands alone, since a text inside a
// .blend file cannot include another.

#include "emit/library.hpp"
#include "emit/pack.hpp"
#include "emit/packs/label.hpp"

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

/// What socket a parameter becomes.
enum class socket { number, colour, triple };

socket socket_of(const model_row<double>& row, const parameter& p) {
    const std::string_view name = p.name;
    if (row.kind == model_kind::artistic || name == "n_i" || name == "eta" || name == "power")
        return socket::number;
    if (name == "n_t" && row.parameters.size() == 2) return socket::number; // transparent media: one index
    if (p.max <= 1) return socket::colour;
    return socket::triple; // an index is no colour: three numbers, as in the Metallic BSDF
}

bool has_channels(const model_row<double>& row) {
    for (const parameter& p : row.parameters)
        if (socket_of(row, p) != socket::number) return true;
    return false;
}

// A parameter hides the function whose name it has.
std::string argument_name(const language& l, const model_row<double>& row, const parameter& p) {
    const std::string name = legal_name(l, p.name);
    return name == legal_name(l, row.name) ? name + "_" : name;
}

std::string declared(const language& l, const model_row<double>& row, const parameter& p) {
    const socket kind = socket_of(row, p);
    const std::string value = literal(l, static_cast<float>(p.default_value));
    const std::string_view type = kind == socket::number   ? "float"
                                  : kind == socket::colour ? "color"
                                                           : "vector";
    return fmt::format(
        "    {} {} = {}\n        [[ string label = \"{}\", float min = {}, float max = {} ]],\n", type,
        argument_name(l, row, p),
        kind == socket::number ? value : fmt::format("{0}({1}, {1}, {1})", type, value),
        parameter_label(p.name), literal(l, static_cast<float>(p.min)),
        literal(l, static_cast<float>(p.max)));
}

// A socket's value as an argument of the function.
std::string passed(const language& l, const model_row<double>& row, const parameter& p) {
    const std::string name = argument_name(l, row, p);
    const bool wide = has_channels(row) && p.name != "n_i";
    if (wide && socket_of(row, p) == socket::triple)
        return fmt::format("color({0}[0], {0}[1], {0}[2])", name);
    if (wide && socket_of(row, p) == socket::number) return fmt::format("color({})", name);
    return name;
}

bool is_transparent(const model_row<double>& row) {
    return row.parameters.size() == 2 && row.parameters[1].name == "n_t";
}

std::string shader_text(const language& l, const model_row<double>& row) {
    const std::string name = legal_name(l, row.name);
    std::string text = fmt::format("shader fresnel_{}(\n", row.name);
    std::vector<std::string> arguments;
    for (const parameter& p : row.parameters) {
        text += declared(l, row, p);
        arguments.push_back(passed(l, row, p));
    }
    arguments.push_back("cos_i");
    text += "    normal Normal = N,\n    output color F = 0.0) {\n"
            "    float cos_i = incidence_cosine(Normal, I); // in Cycles I points to the eye\n";
    if (is_transparent(row))
        text += fmt::format(
            "    if (backfacing()) // the ray is inside\n        F = {};\n    else\n        F = {};\n",
            call(name, {"n_t", "n_i", "cos_i"}), call(name, arguments));
    else
        text += fmt::format("    F = {};\n", call(name, arguments));
    return text + "}\n";
}

std::string file_text(const language& l, const model_row<double>& row) {
    const model_request request{std::string(row.name)};
    const std::string head = fmt::format(
        "fresnel {}: {} as an OSL shader for Cycles. Made by `fresnel shader --write`; do not edit.",
        FRESNEL_VERSION, row.name);
    std::string text = comment_block({head}) + "\n" + print(l, record_geometry().front()) + "\n";
    if (const std::string twofold = twofold_text_for(l, request); !twofold.empty()) text += twofold + "\n";
    text += scalar_text(l, request) + "\n";
    if (has_channels(row)) text += channels_text(l, request) + "\n";
    return text + wrapped_lines(shader_text(l, row));
}

std::string readme() {
    std::string text = fmt::format("# Fresnel shaders for Blender, version {}\n", FRESNEL_VERSION);
    text += R"(
OSL shaders for the Script node of Cycles: one for every Fresnel model of `fresnel`. Their output `F` is the
reflectance as a colour, to be the factor of a Mix Shader, or the colour of a Glossy BSDF.

## Use

1. Render engine Cycles, device CPU (or OptiX), and check *Open Shading Language* in the render settings.
2. Add a Script node, set it to *External*, and choose a file of this folder; or open the file in the text editor, set
   the node to *Internal* and choose it there. Each file stands alone.
3. Connect `F`. `Normal` is the shading normal where nothing is connected.

Colours are linear. An index is a vector of three numbers, red, green and blue, as in Blender's Metallic BSDF; that of the
transparent media is one number, and seen from inside (a back face) the two are swapped. Sockets do not clamp: outside
their ranges the models are not defined.

`fresnel.h` holds every function, with directions, angles and indices, for shaders that you write:
`#include "fresnel.h"`.

## Shaders

| file | sockets | what it is | source |
|---|---|---|---|
)";
    for (const model_row<double>& row : model_table<double>()) {
        std::vector<std::string> sockets;
        for (const parameter& p : row.parameters)
            sockets.push_back(parameter_label(p.name));
        text += fmt::format("| `fresnel_{}.osl` | {} | {} | {} |\n", row.name, fmt::join(sockets, ", "),
                            row.summary, row.citation);
    }
    return text;
}

} // namespace

std::vector<pack_file> blender_pack() {
    const language& l = find_language("osl");
    std::vector<pack_file> files = {{"blender/README.md", readme()}, {"blender/fresnel.h", library_text(l)}};
    for (const model_row<double>& row : model_table<double>())
        files.push_back({fmt::format("blender/fresnel_{}.osl", row.name), file_text(l, row)});
    return files;
}

} // namespace fresnel::emit
