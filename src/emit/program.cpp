#include "emit/program.hpp"

#include "emit/printer.hpp"
#include "error.hpp"

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

constexpr std::array<std::string_view, 8> glsl_types = {"float", "vec2", "vec3",      "vec4",
                                                        "mat3",  "mat4", "sampler2D", "samplerCube"};
constexpr std::array<std::string_view, 8> hlsl_types = {"float",    "float2",   "float3",    "float4",
                                                        "float3x3", "float4x4", "Texture2D", "TextureCube"};
constexpr std::array<std::string_view, 8> cg_types = {"float",    "float2",   "float3",    "float4",
                                                      "float3x3", "float4x4", "sampler2D", "samplerCUBE"};
constexpr std::array<std::string_view, 8> msl_types = {
    "float", "float2", "float3", "float4", "float3x3", "float4x4", "texture2d<float>", "texturecube<float>"};
constexpr std::array<std::string_view, 8> wgsl_types = {
    "f32", "vec2f", "vec3f", "vec4f", "mat3x3f", "mat4x4f", "texture_2d<f32>", "texture_cube<f32>"};

constexpr std::string_view glsl_read = "texture({}, {})", object_read = "{0}.Sample({0}_sampler, {1})",
                           msl_read = "{0}.sample({0}_sampler, {1})",
                           wgsl_read = "textureSample({0}, {0}_sampler, {1})";

constexpr std::array all = {
    dialect{"glsl", "glsl", "GLSL 3.30", glsl_types, "", "", glsl_read, glsl_read, "mix", true, false, false,
            false},
    dialect{"essl", "essl", "GLSL ES 3.00", glsl_types, "", "", glsl_read, glsl_read, "mix", true, false,
            false, false},
    dialect{"hlsl", "hlsl", "HLSL, shader model 4 and later", hlsl_types, "input.", "", object_read,
            object_read, "lerp", false, true, false, true},
    dialect{"cg", "hlsl", "HLSL, shader models 2 and 3, and Cg", cg_types, "input.", "", "tex2D({}, {})",
            "texCUBE({}, {})", "lerp", false, true, false, false},
    dialect{"slang", "slang", "Slang", hlsl_types, "input.", "", object_read, object_read, "lerp", false,
            true, false, true},
    dialect{"msl", "msl", "Metal shading language", msl_types, "input.", "u.", msl_read, msl_read, "mix",
            false, false, true, true},
    dialect{"wgsl", "wgsl", "WGSL", wgsl_types, "input.", "u.", wgsl_read, wgsl_read, "mix", false, false,
            false, true},
};

// Lines of code, the comments behind them in one column.
class lines {
public:
    void add(std::string code, std::string meaning) {
        if (!meaning.empty()) column_ = std::max(column_, code.size());
        lines_.emplace_back(std::move(code), std::move(meaning));
    }
    std::string text() const {
        std::string all_lines;
        for (const auto& [code, meaning] : lines_)
            all_lines +=
                meaning.empty() ? code + "\n" : fmt::format("{:<{}} // {}\n", code, column_, meaning);
        return all_lines;
    }

private:
    std::vector<std::pair<std::string, std::string>> lines_;
    std::size_t column_ = 0;
};

std::string indented(const std::string& text) {
    std::string lines;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = text.find('\n', at);
        lines += "    " + text.substr(at, end - at) + "\n";
        at = end + 1;
    }
    return lines;
}

} // namespace

std::span<const dialect> dialects() { return all; }

const dialect& find_dialect(std::string_view id) {
    std::vector<std::string_view> ids;
    for (const dialect& d : all) {
        if (d.id == id) return d;
        ids.push_back(d.id);
    }
    find_language(id); // an unknown language is said to be one
    throw bad_input(
        fmt::format("--lang = '{}': has no vertex and fragment stages; with --technique one of {}", id,
                    fmt::join(ids, ", ")));
}

// ---- what a program uses ------------------------------------------------------------------------------------

void program::function(std::string name, std::string text, std::string calls) {
    helpers_.push_back({std::move(name), std::move(text), std::move(calls)});
}

program::item& program::find(std::vector<item>& items, std::string_view name) {
    for (item& x : items)
        if (x.what.name == name) return x;
    throw failure(fmt::format("a program uses '{}', which it does not declare", name));
}

bool program::declares(std::string_view name) const {
    for (const auto* items : {&uniforms_, &attributes_, &varyings_})
        for (const item& x : *items)
            if (x.what.name == name || (x.is_texture() && d_.samplers && x.what.name + "_sampler" == name))
                return true;
    for (const helper& x : helpers_)
        if (x.name == name) return true;
    return false;
}

std::string program::use(std::string_view uniform) {
    item& x = find(uniforms_, uniform);
    x.stages |= static_cast<int>(now_);
    return std::string(x.is_texture() ? "" : d_.uniform) + x.what.name;
}

std::string program::in(std::string_view name) {
    item& x = find(now_ == stage::vertex ? attributes_ : varyings_, name);
    x.stages |= static_cast<int>(now_);
    return std::string(d_.member) + x.what.name;
}

void program::mark(const std::string& function) {
    for (helper& x : helpers_) {
        if (x.name != function) continue;
        x.stages |= static_cast<int>(now_);
        for (std::size_t at = 0; at < x.calls.size();) {
            const std::size_t end = std::min(x.calls.find(' ', at), x.calls.size());
            mark(x.calls.substr(at, end - at));
            at = end + 1;
        }
        return;
    }
}

// ---- expressions --------------------------------------------------------------------------------------------

std::string program::call(const std::string& function, const std::vector<std::string>& arguments) {
    mark(function);
    return emit::call(function, arguments);
}

std::string program::made(shape type, const std::vector<std::string>& parts) const {
    return emit::call(std::string(d_.type(type)), parts);
}

std::string program::product(const std::string& matrix, const std::string& vector) const {
    return d_.mul ? fmt::format("mul({}, {})", matrix, vector) : fmt::format("{} * {}", matrix, vector);
}

std::string program::mix(const std::string& a, const std::string& b, const std::string& weight,
                         shape of_weight) const {
    const bool splat = d_.splat_weight && of_weight == shape::scalar;
    return emit::call(std::string(d_.mix), {a, b, splat ? made(shape::three, {weight}) : weight});
}

std::string program::sample(std::string_view texture, const std::string& coordinate, shape read) {
    const std::string name = use(texture);
    const bool cube = find(uniforms_, texture).what.type == shape::cube;
    return fmt::format(fmt::runtime(cube ? d_.sample_cube : d_.sample_map), name, coordinate) +
           (read == shape::scalar ? ".r" : ".rgb");
}

std::string program::limited(const std::string& value) const {
    if (d_.own().has_saturate) return emit::call("saturate", {value});
    return emit::call("clamp", {value, number(0), number(1)});
}

std::string program::number(float x) const { return literal(d_.own(), x); }

std::string program::choice(const std::string& condition, const std::string& a, const std::string& b) const {
    if (d_.id == "wgsl") return emit::call("select", {b, a, condition});
    return fmt::format("{} ? {} : {}", condition, a, b);
}

// ---- statements ---------------------------------------------------------------------------------------------

void program::line(const std::string& text) { (now_ == stage::vertex ? vertex_ : fragment_) += text; }

std::string program::let(shape type, const std::string& name, const std::string& value,
                         const std::string& comment) {
    const std::string head =
        d_.id == "wgsl" ? fmt::format("let {}", name) : fmt::format("{} {}", d_.type(type), name);
    const std::string code = fmt::format("{} = {};", head, value);
    if (comment.empty())
        line(code + "\n");
    else if (code.size() + comment.size() > 96)
        line(fmt::format("// {}\n{}\n", comment, code));
    else
        line(fmt::format("{} // {}\n", code, comment));
    return name;
}

void program::note(const std::string& comment) { line("// " + comment + "\n"); }

void program::out(std::string_view varying, const std::string& value) {
    item& x = find(varyings_, varying);
    x.stages |= static_cast<int>(stage::vertex);
    line(fmt::format("{}{} = {};\n", d_.apart ? "" : "output.", x.what.name, value));
}

// ---- declarations -------------------------------------------------------------------------------------------

std::string program::globals(int stages) const {
    lines text;
    for (const item& x : uniforms_)
        if (x.used_by(stages))
            text.add(fmt::format("uniform {} {};", d_.type(x.what.type), x.what.name), x.what.meaning);
    return text.text();
}

// The textures and their samplers, which stand outside of the uniform block.
std::string program::textures(int stages) const {
    lines text;
    int slot = 0;
    for (const item& x : uniforms_) {
        if (!x.used_by(stages) || !x.is_texture()) continue;
        const std::string_view type = d_.type(x.what.type);
        const std::string& name = x.what.name;
        if (d_.id == "wgsl") {
            text.add(fmt::format("@group(0) @binding({}) var {}: {};", 2 * slot + 1, name, type),
                     x.what.meaning);
            text.add(fmt::format("@group(0) @binding({}) var {}_sampler: sampler;", 2 * slot + 2, name), "");
        } else if (d_.id == "slang") { // Slang gives out the slots of every target itself
            text.add(fmt::format("{} {};", type, name), x.what.meaning);
            text.add(fmt::format("SamplerState {}_sampler;", name), "");
        } else {
            text.add(fmt::format("{} {} : register(t{});", type, name, slot), x.what.meaning);
            text.add(fmt::format("SamplerState {}_sampler : register(s{});", name, slot), "");
        }
        ++slot;
    }
    return text.text();
}

std::string program::uniform_block(int stages) const {
    lines members;
    for (const item& x : uniforms_) {
        if (!x.used_by(stages) || x.is_texture()) continue;
        const std::string_view type = d_.type(x.what.type);
        members.add(d_.id == "wgsl" ? fmt::format("    {}: {},", x.what.name, type)
                                    : fmt::format("    {} {};", type, x.what.name),
                    x.what.meaning);
    }
    if (d_.id == "wgsl")
        return fmt::format("struct program_uniforms {{\n{}}}\n\n@group(0) @binding(0) var<uniform> u: "
                           "program_uniforms;\n{}",
                           members.text(), textures(stages));
    if (d_.id == "msl") return fmt::format("struct program_uniforms {{\n{}}};\n", members.text());
    return fmt::format("cbuffer program_uniforms{} {{\n{}}};\n\n{}",
                       d_.id == "slang" ? "" : " : register(b0)", members.text(), textures(stages));
}

std::string program::member(const declared& x, bool attribute, int location) const {
    const std::string_view type = d_.type(x.type);
    if (d_.id == "wgsl") return fmt::format("    @location({}) {}: {},", location, x.name, type);
    if (d_.id == "msl")
        return attribute ? fmt::format("    {} {} [[attribute({})]];", type, x.name, location)
                         : fmt::format("    {} {};", type, x.name);
    std::string semantic = attribute ? x.name : fmt::format("TEXCOORD{}", location);
    for (char& c : semantic)
        c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return fmt::format("    {} {} : {};", type, x.name, semantic);
}

// The inputs of a stage as a struct: attributes, or what the vertex stage hands on.
std::string program::structure(std::string_view name, bool attributes) const {
    lines members;
    if (!attributes)
        members.add(d_.id == "wgsl"  ? "    @builtin(position) clip_position: vec4f,"
                    : d_.id == "msl" ? "    float4 clip_position [[position]];"
                    : d_.id == "cg"  ? "    float4 clip_position : POSITION;"
                                     : "    float4 clip_position : SV_Position;",
                    "");
    int location = 0;
    for (const item& x : attributes ? attributes_ : varyings_)
        if (x.stages != 0) members.add(member(x.what, attributes, location++), x.what.meaning);
    return fmt::format("struct {} {{\n{}}}{}\n", name, members.text(), d_.id == "wgsl" ? "" : ";");
}

std::string program::helpers(int stages) const {
    std::string text;
    for (const helper& x : helpers_)
        if ((x.stages & stages) != 0) text += x.text + "\n";
    return text;
}

// ---- the text -----------------------------------------------------------------------------------------------

std::string program::glsl_stage(stage s) const {
    const bool vertex = s == stage::vertex;
    std::string text = d_.id == "essl" ? "#version 300 es\n" : "#version 330 core\n";
    if (d_.id == "essl")
        text += "precision highp float;\nprecision highp sampler2D;\nprecision highp samplerCube;\n";
    text += "\n" + globals(static_cast<int>(s)) + "\n";
    lines attributes, varyings;
    int location = 0;
    for (const item& x : attributes_)
        if (x.stages != 0)
            attributes.add(
                fmt::format("layout(location = {}) in {} {};", location++, d_.type(x.what.type), x.what.name),
                x.what.meaning);
    for (const item& x : varyings_)
        if (x.stages != 0)
            varyings.add(fmt::format("{} {} {};", vertex ? "out" : "in", d_.type(x.what.type), x.what.name),
                         x.what.meaning);
    text += vertex ? attributes.text() + "\n" + varyings.text()
                   : varyings.text() + "\nlayout(location = 0) out vec4 color;\n";
    return text + "\n" + helpers(static_cast<int>(s)) + "void main() {\n" +
           indented((vertex ? vertex_ : fragment_) + returned(s)) + "}\n";
}

std::string program::returned(stage s) const {
    if (s == stage::fragment)
        return d_.apart ? fmt::format("color = {};\n", color_) : fmt::format("return {};\n", color_);
    if (d_.apart) return fmt::format("gl_Position = {};\n", position_);
    return fmt::format("output.clip_position = {};\nreturn output;\n", position_);
}

std::string program::entry(stage s) const {
    const bool vertex = s == stage::vertex;
    const std::string_view input = vertex ? "vertex_input" : "fragment_input";
    std::string head;
    if (d_.id == "wgsl") {
        head = vertex ? "@vertex\nfn vertex_main(input: vertex_input) -> fragment_input"
                      : "@fragment\nfn fragment_main(input: fragment_input) -> @location(0) vec4f";
    } else if (d_.id == "msl") {
        head = fmt::format("{} {}_main({} input [[stage_in]], constant program_uniforms& u [[buffer(1)]]",
                           vertex ? "vertex fragment_input" : "fragment float4",
                           vertex ? "vertex" : "fragment", input);
        int slot = 0;
        for (const item& x : uniforms_)
            if (x.is_texture() && x.used_by(static_cast<int>(s))) {
                head += fmt::format(",\n                              {0} {1} [[texture({2})]], sampler "
                                    "{1}_sampler [[sampler({2})]]",
                                    d_.type(x.what.type), x.what.name, slot);
                ++slot;
            }
        head += ")";
    } else {
        head = vertex ? "fragment_input vertex_main(vertex_input input)"
                      : fmt::format("float4 fragment_main(fragment_input input) : {}",
                                    d_.id == "cg" ? "COLOR" : "SV_Target");
    }
    const std::string output = !vertex           ? ""
                               : d_.id == "wgsl" ? "var output: fragment_input;\n"
                                                 : "fragment_input output;\n";
    return head + " {\n" + indented(output + (vertex ? vertex_ : fragment_) + returned(s)) + "}\n";
}

std::string program::declarations(int stages) const {
    std::string text =
        d_.id == "msl" ? "#include <metal_stdlib>\n\nusing namespace metal;\n\n" : std::string();
    text += d_.id == "cg" ? globals(stages) : uniform_block(stages);
    if ((stages & static_cast<int>(stage::vertex)) != 0) text += "\n" + structure("vertex_input", true);
    return text + "\n" + structure("fragment_input", false) + "\n";
}

std::string program::text(const std::vector<std::string>& head, stage wanted) const {
    const int stages = static_cast<int>(wanted);
    const bool vertex = wanted != stage::fragment, fragment = wanted != stage::vertex;
    std::string text = comment_block(head);
    if (d_.apart) {
        // the version must come first in each text, so the head goes behind it
        const auto headed = [&](stage s) {
            std::string one = glsl_stage(s);
            return one.insert(one.find('\n') + 1, text);
        };
        if (wanted != stage::both) return wrapped_lines(headed(wanted));
        return wrapped_lines(rule("vertex stage") + headed(stage::vertex) + "\n" + rule("fragment stage") +
                             glsl_stage(stage::fragment));
    }
    text += "\n" + declarations(stages) + helpers(stages);
    if (vertex) text += entry(stage::vertex);
    if (vertex && fragment) text += "\n";
    if (fragment) text += entry(stage::fragment);
    return wrapped_lines(text);
}

} // namespace fresnel::emit
