// three.js: a package of two modules. fresnel.js for WebGLRenderer holds GLSL ES and puts it into materials; fresnel-tsl.js
// for WebGPURenderer holds the same functions as nodes, in WGSL and in GLSL for its WebGL 2 backend.

#include "analysis/curve.hpp"
#include "emit/library.hpp"
#include "emit/pack.hpp"
#include "emit/packs/threejs_text.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fresnel::emit {

namespace {

constexpr std::string_view root = "threejs/";

std::string head(std::string_view what) {
    return fmt::format("// {}\n// Part of fresnel {}. Made by `fresnel shader --write`; do not edit.\n\n",
                       what, FRESNEL_VERSION);
}

// Text inside a JavaScript template literal.
std::string js_string(std::string_view text) {
    std::string literal = "/* glsl */ `\n";
    for (const char c : text) {
        if (c == '`' || c == '\\' || c == '$') literal += '\\';
        literal += c;
    }
    return literal + "`";
}

// {dielectric: ['n_i', 'n_t'], ...}
std::string parameter_lists() {
    std::string text = "/// The parameters of each model, in order.\nexport const parameters = {\n";
    for (const model_row<double>& row : model_table<double>()) {
        std::vector<std::string> names;
        for (const parameter& p : row.parameters)
            names.push_back(fmt::format("'{}'", p.name));
        text += fmt::format("    {}: [{}],\n", row.name, fmt::join(names, ", "));
    }
    return text + "};\n\n";
}

std::string colour_text(const rgb& colour) {
    const auto limited = [](double x) { return std::clamp(x, 0.0, 1.0); };
    return fmt::format("[{:.4f}, {:.4f}, {:.4f}]", limited(colour[0]), limited(colour[1]),
                       limited(colour[2]));
}

std::string metals() {
    std::string text =
        "/// Measured metals in air, as parameters of f82: linear sRGB at normal incidence and at "
        "cos 1/7.\nexport const metals = {\n";
    for (const char* name :
         {"aluminium", "chromium", "copper", "gold", "iron", "nickel", "platinum", "silver", "titanium"}) {
        const normal_colour c = colour_at_normal(load_material(name), color_space::srgb, 1);
        text += fmt::format("    {}: {{ f0: {}, f82: {} }}, // {}\n", name, colour_text(c.f0),
                            colour_text(c.f82), c.page);
    }
    return text + "};\n\n";
}

// ---- fresnel.js -------------------------------------------------------------------------------------------

std::string glsl_module() {
    const language& l = find_language("essl");
    std::string text = head("Fresnel reflectance for three.js: GLSL for WebGLRenderer.");
    text += "import { Color, ShaderChunk, ShaderMaterial, Vector3 } from 'three';\n\n";
    text += fmt::format("export const VERSION = '{}';\n\n", FRESNEL_VERSION);
    text += parameter_lists() + metals();
    text +=
        "// What every function of a model needs.\nconst types = " +
        js_string(boundary_type(l) + "\n" + print(l, record_geometry().front()) + "\n" + twofold_text(l)) +
        ";\n\n";
    text += "/// The functions of each model. GLSL has overloads: a parameter is a float or a vec3, two "
            "directions may stand in\n/// place of cos_i.\nexport const functions = {\n";
    for (const model_row<double>& row : model_table<double>())
        text += fmt::format("    {}: {},\n\n", row.name, js_string(model_text(l, {std::string(row.name)})));
    text += "};\n\n/// Directions, angles and indices.\nexport const geometry = ";
    std::string geometry;
    for (const function& f : record_geometry())
        if (f.name != "incidence_cosine") geometry += print(l, f) + "\n";
    geometry.pop_back();
    return text + js_string(geometry) + ";\n" + std::string(threejs_glsl_code);
}

// ---- fresnel-tsl.js ---------------------------------------------------------------------------------------

/// A function of a library's text, with its comment.
struct piece {
    std::string name, text;
    std::vector<std::string> needs = {}; ///< names of functions that it calls
};

std::string name_before(const std::string& text, std::size_t bracket) {
    const std::size_t begin = text.rfind(' ', bracket) + 1;
    return text.substr(begin, bracket - begin);
}

// Where a piece ends: at the first empty line that is not within braces.
std::size_t end_of_piece(const std::string& all, std::size_t at) {
    const std::size_t end = all.find("\n\n", at), open = all.find(" {\n", at);
    return std::min(open < end ? all.find("\n\n", all.find("\n}", open)) : end, all.size());
}

// The functions of a library: each is one block of lines that ends with a closing brace. Those that return a struct are
// left out, since a node of three.js has no such type.
std::vector<piece> pieces_of(const language& l) {
    const std::string all = library_text(l);
    std::vector<piece> found;
    for (std::size_t at = 0; at < all.size();) {
        const std::size_t end = end_of_piece(all, at);
        const std::string block = all.substr(at, end - at) + "\n";
        at = end + 2;
        std::size_t line = 0; // of the head, behind the comment
        while (block.compare(line, 2, "//") == 0)
            line = block.find('\n', line) + 1;
        const std::size_t bracket = block.find('(', line), open = block.find(" {\n", line);
        if (bracket == std::string::npos || open == std::string::npos || bracket > open) continue;
        if (block.substr(line).find("fresnel_boundary") != std::string::npos) continue;
        found.push_back({name_before(block, bracket), block});
    }
    for (piece& p : found) {
        const std::string body = p.text.substr(p.text.find(" {\n"));
        for (const piece& other : found)
            if (body.find(" " + other.name + "(") != std::string::npos ||
                body.find("(" + other.name + "(") != std::string::npos)
                p.needs.push_back(other.name);
    }
    return found;
}

std::string js_name(std::string_view name) {
    std::string text;
    bool capital = false;
    for (const char c : name) {
        if (c == '_') {
            capital = true;
            continue;
        }
        text += capital ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
        capital = false;
    }
    return text;
}

std::string tsl_module() {
    const std::vector<piece> wgsl = pieces_of(find_language("wgsl"));
    const std::vector<piece> glsl = pieces_of(find_language("gdshader")); // GLSL without overloads
    std::string text =
        head("Fresnel reflectance for three.js: nodes for WebGPURenderer, on WebGPU and on WebGL 2.");
    text += "import { Fn, glslFn, wgslFn } from 'three/tsl';\n\n";
    text += fmt::format("export const VERSION = '{}';\n", FRESNEL_VERSION);
    text += "\n" + metals() + std::string(threejs_tsl_code);
    for (const piece& w : wgsl) {
        const auto g =
            std::find_if(glsl.begin(), glsl.end(), [&](const piece& p) { return p.name == w.name; });
        if (g == glsl.end()) throw failure(fmt::format("{}: is in WGSL only", w.name));
        std::vector<std::string> needs;
        for (const std::string& name : w.needs)
            needs.push_back(js_name(name));
        std::string wgsl_literal = js_string(w.text);
        wgsl_literal.replace(3, 4, "wgsl");
        text += fmt::format("\nexport const {} = /*@__PURE__*/ native({}, {}, [{}]);\n", js_name(w.name),
                            wgsl_literal, js_string(g->text), fmt::join(needs, ", "));
    }
    return text;
}

std::string package() {
    return fmt::format(R"({{
    "name": "fresnel-three",
    "version": "{}",
    "description": "Fresnel reflectance for three.js: exact, approximate and artistic models in GLSL and as TSL nodes",
    "type": "module",
    "exports": {{
        ".": "./fresnel.js",
        "./tsl": "./fresnel-tsl.js"
    }},
    "files": ["fresnel.js", "fresnel-tsl.js", "example.html", "example-tsl.html", "README.md"],
    "peerDependencies": {{
        "three": ">=0.187.0"
    }},
    "sideEffects": false
}}
)",
                       FRESNEL_VERSION);
}

} // namespace

std::vector<pack_file> threejs_pack() {
    const std::string folder(root);
    return {{folder + "README.md", fmt::format(threejs_readme, FRESNEL_VERSION)},
            {folder + "example-tsl.html", std::string(threejs_tsl_example)},
            {folder + "example.html", std::string(threejs_example)},
            {folder + "fresnel-tsl.js", tsl_module()},
            {folder + "fresnel.js", glsl_module()},
            {folder + "package.json", package()}};
}

} // namespace fresnel::emit
