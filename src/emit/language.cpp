#include "emit/language.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <array>
#include <string>

namespace fresnel::emit {

namespace {

constexpr std::array all = {
    language{"glsl", "GLSL 3.30 and later", "glsl", "float", "vec3", "vec3", "vec2", "bvec3", "", "",
             choice_style::ternary, struct_style::constructor, true, true, false, false, "xyz"},
    language{"essl", "GLSL ES 3.00 and later", "essl", "float", "vec3", "vec3", "vec2", "bvec3", "", "",
             choice_style::ternary, struct_style::constructor, true, true, false, false, "xyz"},
    language{"hlsl", "HLSL, shader model 2 and later, and Cg", "hlsl", "float", "float3", "float3", "float2",
             "", "", "", choice_style::ternary, struct_style::initializer, true, true, false, true, "xyz"},
    language{"msl", "Metal shading language", "metal", "float", "float3", "float3", "float2", "bool3",
             "inline", "f", choice_style::select, struct_style::initializer, true, true, false, true, "xyz"},
    language{"wgsl", "WGSL", "wgsl", "f32", "vec3f", "vec3f", "vec2f", "vec3<bool>", "", "",
             choice_style::select, struct_style::constructor, false, true, true, true, "xyz"},
    language{"osl", "Open Shading Language", "osl", "float", "color", "vector", "fresnel_float2", "", "", "",
             choice_style::ternary, struct_style::initializer, true, true, false, false, "[]"},
    language{"cuda", "CUDA and HIP", "cuh", "float", "float3", "float3", "float2", "", "FRESNEL_FUNCTION",
             "f", choice_style::ternary, struct_style::initializer, true, false, false, false, "xyz"},
    language{"c", "C99", "h", "float", "fresnel_float3", "fresnel_float3", "fresnel_float2", "",
             "static inline", "f", choice_style::ternary, struct_style::initializer, false, false, false,
             false, "xyz"},
    language{"slang", "Slang", "slang", "float", "float3", "float3", "float2", "", "", "",
             choice_style::ternary, struct_style::initializer, true, true, false, true, "xyz"},
};

// The shading language of Godot 4, whose engine pack is made of it; it has no overloads.
constexpr language gdshader{"gdshader",
                            "the shading language of Godot 4",
                            "gdshaderinc",
                            "float",
                            "vec3",
                            "vec3",
                            "vec2",
                            "bvec3",
                            "",
                            "",
                            choice_style::ternary,
                            struct_style::constructor,
                            false,
                            true,
                            false,
                            false,
                            "xyz"};

} // namespace

std::string_view language::name_of(operation op) const {
    const bool c = id == "c" || id == "cuda";
    switch (op) {
    case operation::square_root:
        return c ? "sqrtf" : "sqrt";
    case operation::absolute:
        return c ? "fabsf" : "abs";
    case operation::minimum:
        return c ? "fminf" : "min";
    case operation::maximum:
        return c ? "fmaxf" : "max";
    case operation::exponential2:
        return c ? "exp2f" : "exp2";
    case operation::logarithm2:
        return c ? "log2f" : "log2";
    case operation::logarithm:
        return c ? "logf" : "log";
    case operation::power:
        return c ? "powf" : "pow";
    case operation::dot_product:
        return c ? "fresnel_dot" : "dot";
    default:
        return {};
    }
}

std::span<const language> languages() { return all; }

const language& find_language(std::string_view id) {
    std::vector<std::string> ids;
    for (const language& l : all) {
        if (l.id == id) return l;
        ids.emplace_back(l.id);
    }
    if (id == "gdshader") return gdshader;
    if (id == "hip") return find_language("cuda");
    if (id == "cg") return find_language("hlsl");
    throw bad_input(fmt::format("--lang = '{}': is not a language{}; one of {}", id, did_you_mean(id, ids),
                                fmt::join(ids, ", ")));
}

} // namespace fresnel::emit
