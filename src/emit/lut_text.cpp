#include "emit/lut_text.hpp"

#include "analysis/curve.hpp"
#include "emit/printer.hpp"
#include "error.hpp"

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

/// How a language reads a texture at coordinates without derivatives, so that it works in every stage and branch. Pixel
/// programs of shader model 2 can only read with them; they have no branches.
struct texture_style {
    std::string_view language;
    std::string_view parameters; ///< what the function takes before the numbers
    std::string_view read;       ///< {0} and {1} are the coordinates
};

constexpr std::array texture_styles = {
    texture_style{"glsl", "sampler2D table", "textureLod(table, vec2({}, {}), 0.0)"},
    texture_style{"essl", "highp sampler2D table", "textureLod(table, vec2({}, {}), 0.0)"},
    texture_style{"hlsl", "Texture2D table, SamplerState filtering",
                  "table.SampleLevel(filtering, float2({}, {}), 0.0)"},
    texture_style{"cg", "sampler2D table", "tex2D(table, float2({}, {}))"},
    texture_style{"slang", "Texture2D table, SamplerState filtering",
                  "table.SampleLevel(filtering, float2({}, {}), 0.0)"},
    texture_style{"msl", "texture2d<float> table, sampler filtering",
                  "table.sample(filtering, float2({}, {}), level(0.0f))"},
    texture_style{"wgsl", "table: texture_2d<f32>, filtering: sampler",
                  "textureSampleLevel(table, filtering, vec2f({}, {}), 0.0)"},
    texture_style{"osl", "string table",
                  "texture(table, {}, {}, \"wrap\", \"clamp\", \"interp\", \"linear\", \"width\", 0.0)"},
    texture_style{"cuda", "fresnel_table table", "tex2D<{2}>(table, {0}, {1})"},
};

constexpr std::string_view cuda_head = "#pragma once\n\n#ifdef __HIPCC__\n#include <hip/hip_runtime.h>\n"
                                       "typedef hipTextureObject_t fresnel_table;\n#else\n"
                                       "typedef cudaTextureObject_t fresnel_table;\n#endif\n\n";

// What stands before the function's comment, so that the text compiles by itself.
std::string_view opening(const language& l) {
    if (l.id == "cuda") return cuda_head;
    return l.id == "essl" ? "precision highp float;\n\n" : "";
}

const texture_style& find_style(std::string_view id) {
    for (const texture_style& s : texture_styles)
        if (s.language == id) return s;
    if (id == "hip") return find_style("cuda");
    throw bad_input(fmt::format("--lang {}: reads no texture; use --format c", id));
}

// Whether a texel is read as four numbers, where a language must say how many.
bool has_four_channels(const lut& table) {
    return table.channels() == 3 || table.format == texel_format::rgba32f;
}

// ---- comments -----------------------------------------------------------------------------------------------

std::string rounded(double x) { return fmt::format("{:.2g}", x); }

std::string map_text(const lut& table) {
    if (table.subject.critical == 0) return table.map->name == "cos" ? "cos_i" : "sqrt(cos_i)";
    return "sqrt((cos_i - cos_c) / (1 - cos_c))";
}

std::vector<std::string> head_lines(const lut& table, const lut_names& names) {
    std::string size = fmt::format("{} texels", table.columns);
    if (table.subject.by)
        size = fmt::format("{} x {} texels, the rows even in {} from {} to {}", table.columns, table.rows,
                           table.subject.by->name, table.subject.by->lo, table.subject.by->hi);
    std::vector<std::string> lines = {
        fmt::format("Fresnel reflectance from a table: {}.", table.subject.caption),
        fmt::format("{}, even in {}.", size, map_text(table)),
        fmt::format("Made by `{}`; do not edit.", names.made_by), ""};
    if (table.subject.critical > 0)
        lines.insert(lines.begin() + 2, fmt::format("Below the critical cosine, cos_c = {}, the first "
                                                    "texel is read: 1.",
                                                    static_cast<float>(table.subject.critical)));
    return lines;
}

void add_error(std::vector<std::string>& lines, const lut& table) {
    lines.push_back(fmt::format("{:<9} {}", "error", error_text(table)));
    if (table.format != texel_format::c)
        lines.push_back(
            fmt::format("{:<9} max {} where the filter's weights have 8 bits, as in many graphics "
                        "processors",
                        "", rounded(table.error.max_8_bit)));
    if (table.subject.critical > 0)
        lines.push_back(
            fmt::format("{:<9} up to {} within 1e-6 of cos_c, where the root magnifies the rounding of "
                        "a float",
                        "", rounded(table.error.at_critical)));
    lines.push_back(fmt::format("{:<9} Wloka 2002, \"Fresnel Reflection\", the texture variant", "source"));
    if (!table.subject.data.empty()) lines.push_back(fmt::format("{:<9} {}", "data", table.subject.data));
}

void add_arguments(std::vector<std::string>& lines, const lut& table) {
    if (table.subject.by)
        lines.push_back(
            fmt::format("{:<9} {}", table.subject.by->name,
                        table.subject.by->name == "eta" ? "n_t / n_i" : "reflectance at normal incidence"));
    lines.push_back(fmt::format("{:<9} cosine of incidence, [0, 1]", "cos_i"));
}

// What CUDA's description of a texture must hold.
void add_descriptor(std::vector<std::string>& lines, const lut& table) {
    const bool fractions = table.format == texel_format::r8 || table.format == texel_format::r16;
    lines.push_back(fmt::format("{:<9} normalizedCoords = 1, readMode = {}{}", "",
                                fractions ? "cudaReadModeNormalizedFloat" : "cudaReadModeElementType",
                                has_four_channels(table) ? ", four channels" : ""));
}

// What must be said of the texture for it to be read as it was measured.
std::vector<std::string> texture_lines(const language& l, const lut& table, const lut_names& names) {
    std::vector<std::string> lines = head_lines(table, names);
    lines.push_back(
        fmt::format("{:<9} {}linear numbers (no sRGB decoding), linear filter, clamped, no mipmaps", "table",
                    names.file.empty() ? "" : names.file + ": "));
    if (l.id == "cuda") add_descriptor(lines, table);
    if (table.subject.by)
        lines.push_back(
            fmt::format("{:<9} the first row is {} = {}; a loader that begins at the bottom turns "
                        "the rows round",
                        "", table.subject.by->name, table.subject.by->lo));
    if (table.format == texel_format::rgba32f)
        lines.push_back(fmt::format("{:<9} to filter 32-bit floats is an option of a device "
                                    "(OES_texture_float_linear, float32-filterable)",
                                    ""));
    add_arguments(lines, table);
    add_error(lines, table);
    return lines;
}

// ---- the sampler's body -----------------------------------------------------------------------------------------

/// Lines of one function in one language.
class body {
public:
    explicit body(const language& l) : l_(l) {}

    /// Declares a value; returns the name that it got.
    std::string let(std::string_view wanted, const std::string& value, std::string_view type = {}) {
        std::string name = legal_name(l_, wanted);
        if (l_.typed_names)
            text_ += fmt::format("    let {} = {};\n", name, value);
        else
            text_ += fmt::format("    {}{} {} = {};\n", l_.id == "c" ? "const " : "",
                                 type.empty() ? l_.scalar : type, name, value);
        return name;
    }
    void line(const std::string& text) { text_ += "    " + text + "\n"; }
    const std::string& text() const { return text_; }

    std::string number(double x) const { return literal(l_, static_cast<float>(x)); }
    std::string limited(const std::string& x) const {
        if (l_.has_saturate) return fmt::format("saturate({})", x);
        if (l_.id == "c" || l_.id == "cuda") return fmt::format("fminf(fmaxf({}, 0.0f), 1.0f)", x);
        return fmt::format("clamp({}, 0.0, 1.0)", x);
    }
    // Distance from `from`, in units of `length`.
    std::string share(const std::string& x, double from, double length) const {
        const std::string distance = from == 0  ? x
                                     : from < 0 ? fmt::format("({} + {})", x, number(-from))
                                                : fmt::format("({} - {})", x, number(from));
        return length == 1 ? distance : fmt::format("{} / {}", distance, number(length));
    }

    /// t along the columns: the cosine, limited and mapped.
    std::string column_coordinate(const lut& table) {
        const double critical = static_cast<double>(static_cast<float>(table.subject.critical));
        const std::string cos_i = legal_name(l_, "cos_i");
        const std::string c = critical > 0
                                  ? let("c", limited(fmt::format("({0} - {1}) / (1.0{2} - {1})", cos_i,
                                                                 number(critical), l_.literal_suffix)))
                                  : let("c", limited(cos_i));
        return table.map->name == "cos"
                   ? c
                   : let("t", fmt::format("{}({})", l_.name_of(operation::square_root), c));
    }
    /// s along the rows.
    std::string row_coordinate(const lut_axis& by) {
        const float lo = static_cast<float>(by.lo), hi = static_cast<float>(by.hi);
        const std::string x = legal_name(l_, by.name);
        return let("s", limited(share(x, double(lo), double(hi - lo))));
    }

private:
    const language& l_;
    std::string text_;
};

// `parameters` is what the function takes before the numbers.
std::string signature(const language& l, std::string_view parameters, const lut& table,
                      const std::string& name) {
    const auto number = [&](std::string_view argument) {
        const std::string own = legal_name(l, argument);
        return l.typed_names ? fmt::format("{}: {}", own, l.scalar) : fmt::format("{} {}", l.scalar, own);
    };
    std::string list(parameters);
    if (table.subject.by) list += (list.empty() ? "" : ", ") + number(table.subject.by->name);
    list += (list.empty() ? "" : ", ") + number("cos_i");
    if (l.id == "c" && table.channels() == 3)
        return fmt::format("static inline void {}({}, float rgb[3])", name, list);
    const std::string_view type = l.type(table.subject.channels);
    if (l.typed_names) return fmt::format("fn {}({}) -> {}", name, list, type);
    const std::string_view qualifier = l.id == "cuda" ? "__device__ inline" : l.qualifier;
    return fmt::format("{}{}{} {}({})", qualifier, qualifier.empty() ? "" : " ", type, name, list);
}

std::string function_name(const language& l, const lut& table, const lut_names& names) {
    const std::string name =
        legal_name(l, names.function.empty() ? table.subject.name + "_lut" : names.function);
    return l.id == "cuda" && name == "fresnel_table" ? name + "_" : name; // the type of a texture
}

std::string texel_coordinate(const body& b, const std::string& t, std::size_t count) {
    const auto n = static_cast<double>(count);
    return fmt::format("({} * {} + {}) / {}", t, b.number(n - 1), b.number(0.5), b.number(n));
}

std::string scaling(const body& b, const lut& table) {
    std::string text = fmt::format(" * {}", b.number(table.hi - table.lo));
    if (table.lo != 0) text += fmt::format(" - {}", b.number(-table.lo));
    return text;
}

void return_texel(body& b, const language& l, const texture_style& style, const lut& table,
                  const std::string& u, const std::string& v) {
    const bool rgb = table.channels() == 3, wide = has_four_channels(table);
    const std::string scale = table.scaled() ? scaling(b, table) : "";
    const std::string read = fmt::format(fmt::runtime(style.read), u, v, wide ? "float4" : "float");
    if (l.id == "osl") {
        const std::string F = b.let("F", read, rgb ? "color" : "float");
        return b.line(fmt::format("return {}{};", F, scale));
    }
    if (l.id != "cuda") return b.line(fmt::format("return {}.{}{};", read, rgb ? "rgb" : "r", scale));
    if (!wide) return b.line(fmt::format("return {}{};", read, scale));
    const std::string F = b.let("F", read, "float4");
    if (!rgb) return b.line(fmt::format("return {}.x{};", F, scale));
    b.line(fmt::format("return make_float3({0}.x{1}, {0}.y{1}, {0}.z{1});", F, scale));
}

// ---- C99 ------------------------------------------------------------------------------------------------------

std::string array_text(const language& l, const lut& table, const std::string& name) {
    const std::string rows = table.subject.by ? fmt::format("[{}]", table.rows) : "";
    const std::string channels = table.channels() == 3 ? "[3]" : "";
    std::string text =
        fmt::format("static const float {}{}[{}]{} = {{\n", name, rows, table.columns, channels);
    const std::size_t in_line = table.channels() == 3 ? 2 : 6;
    std::size_t k = 0;
    for (std::size_t row = 0; row < table.rows; ++row) {
        if (table.subject.by) text += "    {\n";
        for (std::size_t i = 0; i < table.columns; ++i) {
            std::vector<std::string> values;
            for (std::size_t c = 0; c < table.channels(); ++c)
                values.push_back(literal(l, table.texels[k++]));
            const std::string texel = fmt::format("{}", fmt::join(values, ", "));
            text += (i % in_line == 0 ? "    " : " ") + (channels.empty() ? texel : "{" + texel + "}") + ",";
            if (i % in_line == in_line - 1 || i + 1 == table.columns) text += "\n";
        }
        if (table.subject.by) text += "    },\n";
    }
    return text + "};\n\n";
}

// Index and weight along one axis; t (N - 1) is at most N - 1, and its last whole part still has a neighbour.
void add_index(body& b, const std::string& t, std::size_t count, const std::string& x, const std::string& i,
               const std::string& w) {
    b.let(x, fmt::format("{} * {}", t, b.number(static_cast<double>(count - 1))));
    b.let(i, fmt::format("(int)fminf({}, {})", x, b.number(static_cast<double>(count - 2))), "int");
    b.let(w, fmt::format("{} - (float){}", x, i));
}

// (1 - w) a[i] + w a[i + 1] in a row of the array.
std::string interpolated(const std::string& row, const std::string& channel) {
    return fmt::format("(1.0f - w) * {0}[i]{1} + w * {0}[i + 1]{1}", row, channel);
}

void return_interpolated(body& b, const lut& table, const std::string& array) {
    const bool rgb = table.channels() == 3;
    const std::string channel = rgb ? "[k]" : "", put = rgb ? "rgb[k] =" : "return";
    const std::string indent = rgb ? "    " : "";
    if (rgb) b.line("for (int k = 0; k < 3; ++k) {");
    if (table.subject.by) {
        b.line(fmt::format("{}const float a = {};", indent, interpolated(array + "[j]", channel)));
        b.line(fmt::format("{}const float b = {};", indent, interpolated(array + "[j + 1]", channel)));
        b.line(fmt::format("{}{} (1.0f - h) * a + h * b;", indent, put));
    } else {
        b.line(fmt::format("{}{} {};", indent, put, interpolated(array, channel)));
    }
    if (rgb) b.line("}");
}

} // namespace

std::string error_text(const lut& table) {
    const lut_error& e = table.error;
    std::string where = fmt::format("cos_i = {:.3g} ({:.1f} degrees)", e.cos_i, degrees_of_cosine(e.cos_i));
    if (table.subject.by) where += fmt::format(", {} = {:.3g}", table.subject.by->name, e.by);
    return fmt::format("max {} at {}, rms {} even in angle", rounded(e.max), where, rounded(e.rms));
}

std::string sampler_text(std::string_view id, const lut& table, const lut_names& names) {
    const language& l = find_language(id);
    const std::string name = function_name(l, table, names);
    if (l.id == "c" || table.format == texel_format::c)
        throw bad_input(fmt::format("--lang {} with --format {}: C reads the array of --format c, the other "
                                    "languages read textures",
                                    l.id, to_string(table.format)));
    const texture_style& style = find_style(id);
    body b(l);
    const std::string t = b.column_coordinate(table);
    std::string v = b.number(0.5);
    if (table.subject.by) v = b.row_coordinate(*table.subject.by);
    const std::string u = b.let("u", texel_coordinate(b, t, table.columns));
    if (table.subject.by) v = b.let("v", texel_coordinate(b, v, table.rows));
    return_texel(b, l, style, table, u, v);
    return std::string(opening(l)) + comment_block(texture_lines(l, table, names)) +
           signature(l, style.parameters, table, name) + " {\n" + b.text() + "}\n";
}

std::string lut_header(const lut& table, const lut_names& names) {
    const language& l = find_language("c");
    const std::string name = function_name(l, table, names), array = name + "_table";
    std::string guard = name;
    for (char& c : guard)
        c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    body b(l);
    const std::string t = b.column_coordinate(table);
    const std::string s = table.subject.by ? b.row_coordinate(*table.subject.by) : "";
    add_index(b, t, table.columns, "x", "i", "w");
    if (table.subject.by) add_index(b, s, table.rows, "y", "j", "h");
    return_interpolated(b, table, array);
    std::vector<std::string> lines = head_lines(table, names);
    add_arguments(lines, table);
    if (table.channels() == 3) lines.push_back(fmt::format("{:<9} the colour", "rgb"));
    add_error(lines, table);
    return fmt::format("#ifndef {0}_H\n#define {0}_H\n\n#include <math.h>\n\n", guard) +
           array_text(l, table, array) + comment_block(lines) + signature(l, "", table, name) + " {\n" +
           b.text() + "}\n\n#endif\n";
}

} // namespace fresnel::emit
