#include "emit/library.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fresnel::emit {

namespace {

// ---- functions that call the scalar one -------------------------------------------------------------------

std::vector<std::string> argument_texts(const language& l, const function& f) {
    std::vector<std::string> texts;
    for (const argument& a : f.arguments)
        texts.push_back(argument_name(l, f, a.name));
    return texts;
}

std::string returning(const language& l, const std::string& value) {
    if (l.id == "c" && value.front() == '(') // the literal of a struct, which C++ does not know
        return fmt::format("    {} result = {};\n    return result;\n", l.triple,
                           value.substr(value.find('{')));
    return fmt::format("    return {};\n", value);
}

// The same text with a line for each part, where one line for all is too long.
std::string below_each_other(std::string text, const std::vector<std::string>& parts) {
    if (text.find('\n') <= longest_line) return text;
    const std::string indent(text.find(parts.front()), ' ');
    for (std::size_t i = 1; i < parts.size(); ++i)
        text.replace(text.find(", " + parts[i]), 2, ",\n" + indent);
    return text;
}

// Three channels by three calls.
std::string by_channel(const language& l, const function& rgb, const std::string& scalar_name) {
    const std::string name = printed_name(l, rgb.name, 3, false);
    std::vector<std::string> channels;
    for (int i = 0; i < 3; ++i) {
        std::vector<std::string> arguments = argument_texts(l, rgb);
        for (std::size_t k = 0; k < arguments.size(); ++k)
            if (rgb.arguments[k].width == 3) arguments[k] = component(l, arguments[k], i);
        channels.push_back(call(scalar_name, arguments));
    }
    return signature(l, rgb, name) + " {\n" +
           below_each_other(returning(l, triple_of(l, channels)), channels) + "}\n";
}

// The same function of two directions in place of cos_i.
std::string by_directions(const language& l, const function& f) {
    const std::string base = legal_name(l, f.name);
    const std::string inner = printed_name(l, f.name, f.width(), false);
    std::vector<std::string> arguments = argument_texts(l, f);
    arguments.back() = call("incidence_cosine", {legal_name(l, "normal"), "direction"});
    function outer = f;
    outer.arguments.pop_back();
    const std::string head = signature(l, outer, base);
    const std::string more =
        l.typed_names ? fmt::format("{0}: {2}, direction: {2}", legal_name(l, "normal"), "", l.vector)
                      : fmt::format("{1} {0}, {1} direction", legal_name(l, "normal"), l.vector);
    const std::size_t end = head.rfind(')');
    const std::size_t begin = head.find(base + "(");
    return head.substr(0, begin) + printed_name(l, f.name, f.width(), true) +
           head.substr(begin + base.size(), end - begin - base.size()) +
           (outer.arguments.empty() ? "" : ", ") + more + head.substr(end) + " {\n    return " +
           call(inner, arguments) + ";\n}\n";
}

bool compares(const function& f) {
    return needs_any(f, [](const expression& x) { return x.op == operation::choose; });
}

std::string rename(std::string text, const std::string& from, const std::string& to) {
    const std::size_t at = text.find(from + "(");
    return at == std::string::npos ? text : text.replace(at, from.size(), to);
}

bool has_rgb_argument(const function& f) {
    for (const argument& a : f.arguments)
        if (a.width == 3) return true;
    return false;
}

function named(const language& l, function f, const model_request& wanted) {
    if (!wanted.name.empty()) f.name = function_name(l, wanted.name);
    for (std::string& line : f.comment)
        if (line.starts_with("error ") && !wanted.error.empty()) line = "error   " + wanted.error;
    if (!wanted.about.empty()) f.comment.push_back("data    " + wanted.about);
    return f;
}

// The RGB function without what stands beside it.
std::string rgb_alone(const language& l, const function& rgb, const style& how) {
    const std::string own = legal_name(l, rgb.name);
    const std::string comment = how.comment ? comment_block(rgb.comment) : "";
    if (!l.arithmetic || compares(rgb)) return comment + by_channel(l, rgb, own);
    style plain = how;
    plain.comment = false;
    return comment + rename(print(l, rgb, plain), own, printed_name(l, rgb.name, 3, false));
}

std::string rgb_text(const language& l, const model_request& wanted, const style& how) {
    const std::string text = channels_text(l, wanted, how);
    if (text.empty()) return {};
    const function rgb = named(l, record(wanted.model, {3, false, wanted.fixed}), wanted);
    return "\n" + text + "\n" + by_directions(l, rgb);
}

// The type of three numbers, in a language that has none.
std::string triple_type(const language& l) {
    if (l.id != "c") return {};
    return "typedef struct {\n    float x, y, z; // RGB, or a direction\n} fresnel_float3;\n\n";
}

// The type of two numbers and what makes one, in a language that has none.
std::string pair_type(const language& l) {
    if (l.id != "c" && l.id != "osl") return {};
    const std::string_view function = l.id == "c" ? "static inline " : "";
    return std::string(l.id == "c" ? "typedef struct {\n    float x, y;\n} fresnel_float2;\n"
                                   : "struct fresnel_float2 {\n    float x;\n    float y;\n};\n") +
           fmt::format("\n{}fresnel_float2 fresnel_make_float2(float x, float y) {{\n"
                       "    fresnel_float2 result = {{x, y}};\n    return result;\n}}\n",
                       function);
}

// ---- what a file opens and closes with --------------------------------------------------------------------

// A text that is read once in a file, where the language has a preprocessor.
std::string once(const language& l, std::string_view part, const std::string& text) {
    return l.id != "wgsl" ? guarded(fmt::format("FRESNEL_{}{}", l.id, part), text) : text;
}

// What the language itself must have before a function of ours.
std::string opening(const language& l) {
    if (l.id == "msl") return "#include <metal_stdlib>\nusing namespace metal;\n\n";
    if (l.id == "c") return "#include <math.h>\n\n";
    if (l.id == "essl") return "precision highp float;\n\n";
    if (l.id == "cuda")
        return "#ifdef __CUDACC__\n"
               "#define FRESNEL_FUNCTION __host__ __device__ inline\n"
               "#elif defined(__HIP__)\n"
               "#include <hip/hip_runtime.h>\n"
               "#define FRESNEL_FUNCTION __host__ __device__ inline\n"
               "#else\n"
               "#define FRESNEL_FUNCTION inline\n"
               "#endif\n\n";
    return "";
}

const function& cosine_function() {
    static const function f = record_geometry().front();
    return f;
}

} // namespace

std::string boundary_type(const language& l) {
    constexpr std::string_view reflected = "// reflected, polarised across and along the plane of incidence";
    if (l.id == "wgsl")
        return fmt::format("struct fresnel_boundary {{\n    R_s: f32, {}\n    R_p: f32,\n"
                           "    T_s: f32, // transmitted\n    T_p: f32,\n}}\n",
                           reflected);
    if (l.id == "osl") // one name in a declaration
        return fmt::format("struct fresnel_boundary {{\n    float R_s; {}\n    float R_p;\n"
                           "    float T_s; // transmitted\n    float T_p;\n}};\n",
                           reflected);
    const bool c = l.id == "c";
    return fmt::format("{} {{\n    float R_s, R_p; {}\n    float T_s, T_p; // transmitted\n}}{};\n",
                       c ? "typedef struct" : "struct fresnel_boundary", reflected,
                       c ? " fresnel_boundary" : "");
}

namespace {

std::string head(const language& l, std::string_view made_by) {
    std::vector<std::string> lines = {
        fmt::format("Fresnel reflectance in {}.", l.title),
        fmt::format("Made by `{}`; do not edit.", made_by),
        "",
        "eta = n_t / n_i, the index behind the surface over the one in front; complex: n + i k.",
        "cos_i is the cosine of incidence, in [0, 1]. In the equations c is cos_i, s is sin_i and",
        "x is 1 - c; _s and _p are the polarisations across and along the plane of incidence.",
        "Directions are unit vectors and point away from the surface; the one beside the normal is",
        "yours: the view, the light or the half vector with either.",
        "Reflectance is of unpolarised light and lies in [0, 1]. RGB values are linear.",
    };
    if (l.id == "wgsl") {
        lines.emplace_back("");
        lines.emplace_back(
            "A module takes one such text, since WGSL has no preprocessor: name all models in one call.");
    }
    return comment_block(lines) + "\n";
}

// The cosine of two directions and what it needs. Several texts may be pasted into one file, which reads these once; but
// WGSL has no preprocessor, and takes one text.
std::string common(const language& l) {
    return once(l, "_common", opening(l) + triple_type(l) + print(l, cosine_function()));
}

// Whether the text of a model has a function of R_s, R_p, T_s and T_p.
bool has_boundary(const model_request& wanted) {
    return find_model<double>(wanted.model).kind == model_kind::exact &&
           record(wanted.model, {1, false, wanted.fixed}).width() == 1;
}

// Its type, once in a file too.
std::string guarded_boundary_type(const language& l) { return "\n" + once(l, "_boundary", boundary_type(l)); }

} // namespace

std::string preamble(const language& l, std::string_view made_by, std::span<const model_request> models,
                     const style& how) {
    std::string text = head(l, made_by) + common(l);
    if (std::any_of(models.begin(), models.end(), has_boundary)) text += guarded_boundary_type(l);
    for (const model_request& model : models)
        if (const std::string twofold = twofold_text_for(l, model, how); !twofold.empty())
            return text + "\n" + once(l, "_twofold", twofold);
    return text;
}

std::string twofold_text(const language& l, const style& how) {
    std::string text = pair_type(l);
    for (const function& f : record_twofold())
        text += (text.empty() ? "" : "\n") + wrapped_lines(print(l, f, how));
    return text;
}

std::string twofold_text_for(const language& l, const model_request& wanted, const style& how) {
    return calls_twofold(record(wanted.model, {1, false, wanted.fixed})) ? twofold_text(l, how) : "";
}

std::string scalar_text(const language& l, const model_request& wanted, const style& how) {
    return wrapped_lines(print(l, named(l, record(wanted.model, {1, false, wanted.fixed}), wanted), how));
}

std::string boundary_text(const language& l, const model_request& wanted, const style& how) {
    function f = named(l, record(wanted.model, {1, true, wanted.fixed}), wanted);
    f.name += "_boundary";
    f.comment.front() = "Reflectances and transmittances of both polarisations.";
    f.comment.resize(1);
    return wrapped_lines(print(l, f, how));
}

std::string channels_text(const language& l, const model_request& wanted, const style& how) {
    function rgb = named(l, record(wanted.model, {3, false, wanted.fixed}), wanted);
    if (!has_rgb_argument(rgb)) return {};
    rgb.comment = {"The same for three channels, which share the angle."};
    return wrapped_lines(rgb_alone(l, rgb, how));
}

namespace {

std::string unwrapped_model_text(const language& l, const model_request& wanted, const style& how) {
    const function scalar = named(l, record(wanted.model, {1, false, wanted.fixed}), wanted);
    std::string text;
    if (scalar.width() == 1) {
        text = print(l, scalar, how) + "\n" + by_directions(l, scalar) + rgb_text(l, wanted, how);
        if (has_boundary(wanted)) text += "\n" + boundary_text(l, wanted, how);
        return text;
    }
    // parameters that are fixed to colours: there is no scalar function
    const std::string own = legal_name(l, scalar.name);
    return rename(print(l, scalar, how), own, printed_name(l, scalar.name, 3, false)) + "\n" +
           by_directions(l, scalar);
}

} // namespace

std::string model_text(const language& l, const model_request& wanted, const style& how) {
    return wrapped_lines(unwrapped_model_text(l, wanted, how));
}

sole_function sole_text(const language& l, const model_request& wanted, int width) {
    const function scalar = named(l, record(wanted.model, {1, false, wanted.fixed}), wanted);
    function rgb = named(l, record(wanted.model, {3, false, wanted.fixed}), wanted);
    const bool three = width == 3 && scalar.width() == 1 && has_rgb_argument(rgb);
    const function& f = three ? rgb : scalar;
    sole_function sole{{}, printed_name(l, f.name, f.width(), false), f.arguments, f.width()};
    sole.arguments.pop_back();
    const std::string own = legal_name(l, f.name);
    sole.text = twofold_text_for(l, wanted);
    if (!sole.text.empty()) sole.text += "\n";
    if (!three) {
        sole.text += comment_block(f.comment) +
                     rename(print(l, f, {.precise = false, .comment = false}), own, sole.name);
    } else if (compares(rgb) || !l.arithmetic) {
        rgb.comment = {"The same for three channels, which share the angle."};
        sole.text += print(l, scalar) + "\n" + rgb_alone(l, rgb, {});
    } else {
        sole.text += rgb_alone(l, rgb, {});
    }
    return sole;
}

std::string library_text(const language& l) {
    std::string text = common(l) + guarded_boundary_type(l) + "\n" + rule("directions, angles and indices");
    std::vector<function> geometry = record_geometry();
    for (std::size_t i = 1; i < geometry.size(); ++i)
        text += wrapped_lines(print(l, geometry[i])) + "\n";
    text += rule("highlights and thin layers");
    for (const function& f : record_shading())
        text += wrapped_lines(print(l, f)) + "\n";
    std::string_view title;
    for (const model_row<double>& row : model_table<double>()) {
        const std::string_view kind = row.kind == model_kind::exact      ? "exact"
                                      : row.kind == model_kind::artistic ? "artistic"
                                                                         : "approximations";
        if (row.kind == model_kind::exact && title.empty())
            text += rule("twice the digits") + once(l, "_twofold", twofold_text(l)) + "\n";
        if (kind != title) text += rule(title = kind);
        text += model_text(l, {std::string(row.name)}) + "\n";
    }
    text.pop_back();
    return head(l, fmt::format("fresnel shader --all --lang {}", l.id)) + once(l, "", text);
}

} // namespace fresnel::emit
