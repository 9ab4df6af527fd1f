#include "emit/language.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <string>

namespace fresnel::emit {

namespace {

constexpr std::array all = {
    language{"glsl", "GLSL 3.30 and later", "glsl", "float", "vec3", "vec3", "bvec3", "", "",
             choice_style::ternary, struct_style::constructor, true, true, false, false, "xyz"},
    language{"essl", "GLSL ES 3.00 and later", "essl", "float", "vec3", "vec3", "bvec3", "", "",
             choice_style::ternary, struct_style::constructor, true, true, false, false, "xyz"},
    language{"hlsl", "HLSL, shader model 2 and later, and Cg", "hlsl", "float", "float3", "float3", "", "",
             "", choice_style::ternary, struct_style::initializer, true, true, false, true, "xyz"},
    language{"msl", "Metal shading language", "metal", "float", "float3", "float3", "bool3", "inline", "f",
             choice_style::select, struct_style::initializer, true, true, false, true, "xyz"},
    language{"wgsl", "WGSL", "wgsl", "f32", "vec3f", "vec3f", "vec3<bool>", "", "", choice_style::select,
             struct_style::constructor, false, true, true, true, "xyz"},
    language{"osl", "Open Shading Language", "osl", "float", "color", "vector", "", "", "",
             choice_style::ternary, struct_style::initializer, true, true, false, false, "[]"},
    language{"cuda", "CUDA and HIP", "cuh", "float", "float3", "float3", "", "FRESNEL_FUNCTION", "f",
             choice_style::ternary, struct_style::initializer, true, false, false, false, "xyz"},
    language{"c", "C99", "h", "float", "fresnel_float3", "fresnel_float3", "", "static inline", "f",
             choice_style::ternary, struct_style::initializer, false, false, false, false, "xyz"},
    language{"slang", "Slang", "slang", "float", "float3", "float3", "", "", "", choice_style::ternary,
             struct_style::initializer, true, true, false, true, "xyz"},
};

// The shading language of Godot 4, whose engine pack is made of it; it has no overloads.
constexpr language gdshader{"gdshader",
                            "the shading language of Godot 4",
                            "gdshaderinc",
                            "float",
                            "vec3",
                            "vec3",
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

// Words that some language keeps for itself, and functions it already has. A name is refused everywhere that any
// language of its group refuses it: less to look up for a reader who moves text from one to another.
constexpr std::string_view c_family = " alignas alignof and and_eq asm atomic auto bitand bitor bool break "
                                      "case catch char char8_t char16_t char32_t class "
                                      "compl complex concept const const_cast consteval constexpr constinit "
                                      "continue co_await co_return co_yield decltype "
                                      "default delete do double dynamic_cast else enum explicit export "
                                      "extern false float for friend goto half if imaginary "
                                      "inline int long mutable namespace new noexcept not not_eq nullptr "
                                      "operator or or_eq private protected public register "
                                      "reinterpret_cast requires restrict return short signed sizeof static "
                                      "static_assert static_cast struct switch template "
                                      "this thread_local throw true try typedef typeid typename typeof union "
                                      "unsigned using virtual void volatile wchar_t while "
                                      "xor xor_eq main ";
constexpr std::string_view c_functions = " abs acos asin atan atan2 ceil cos cosh erf exp exp2 expf exp2f "
                                         "fabs fabsf floor fma fmax fmaxf fmin fminf fmod hypot "
                                         "isnan isinf j0 j1 jn log log10 log2 logf log2f max min pow powf "
                                         "remainder rint round sin sinh sqrt sqrtf tan tanh trunc "
                                         "y0 y1 yn index signal div ";
constexpr std::string_view gl_words = " active array asm attribute buffer bvec2 bvec3 bvec4 cast centroid "
                                      "coherent common dmat2 dmat3 dmat4 double dvec2 dvec3 "
                                      "dvec4 discard dispatch external filter fixed flat fvec2 fvec3 fvec4 "
                                      "goto half highp hvec2 hvec3 hvec4 in inout input "
                                      "interface invariant isampler2D ivec2 ivec3 ivec4 layout lowp mat2 "
                                      "mat3 mat4 mediump mod noinline noperspective out "
                                      "output packed partition patch precise precision public readonly "
                                      "resource sample sampler sampler1D sampler2D sampler3D "
                                      "samplerCube shared sizeof smooth subroutine superp uint uniform uvec2 "
                                      "uvec3 uvec4 varying vec2 vec3 vec4 volatile "
                                      "writeonly abs acos all any asin atan ceil clamp cos cross degrees "
                                      "determinant distance dot equal exp exp2 floor fma "
                                      "fract frexp greaterThan inverse inversesqrt isinf isnan ldexp length "
                                      "lessThan log log2 main matrixCompMult max min mix "
                                      "modf noise normalize not notEqual outerProduct pow radians reflect "
                                      "refract round sign sin smoothstep sqrt step tan "
                                      "texture transpose trunc ";
constexpr std::string_view hlsl_words = " AppendStructuredBuffer BlendState Buffer ByteAddressBuffer bool2 "
                                        "bool3 bool4 cbuffer centroid column_major "
                                        "compile compile_fragment ComputeShader discard double2 double3 "
                                        "double4 dword export extern float1 float2 float3 float4 "
                                        "fxgroup groupshared half1 half2 half3 half4 in InputPatch int2 int3 "
                                        "int4 interface inout line lineadj linear "
                                        "LineStream matrix min10float min16float min16int min16uint "
                                        "nointerpolation noperspective NULL out OutputPatch packoffset "
                                        "pass pixelfragment PixelShader point PointStream precise "
                                        "RasterizerState register row_major sample sampler "
                                        "SamplerState shared snorm stateblock string StructuredBuffer "
                                        "tbuffer technique texture Texture2D Texture3D TextureCube "
                                        "triangle triangleadj TriangleStream uint uint2 uint3 uint4 uniform "
                                        "unorm vector vertexfragment VertexShader abs acos all "
                                        "any asin atan atan2 ceil clamp clip cos cosh cross ddx ddy degrees "
                                        "determinant distance dot exp exp2 faceforward floor "
                                        "fma fmod frac frexp fwidth isfinite isinf isnan ldexp length lerp "
                                        "lit log log10 log2 mad max min modf mul noise normalize "
                                        "pow radians rcp reflect refract round rsqrt saturate select sign "
                                        "sin sincos sinh smoothstep sqrt step tan tanh transpose "
                                        "trunc mix packed fixed ";
constexpr std::string_view msl_words = " array buffer constant device fragment half half2 half3 half4 kernel "
                                       "metal ptr_t sampler stage_in texture thread "
                                       "threadgroup uint vec vector vertex clamp cross distance dot fract "
                                       "length mix normalize reflect refract rsqrt saturate "
                                       "select sign smoothstep step float2 float3 float4 bool2 bool3 bool4 "
                                       "uint2 uint3 uint4 int2 int3 int4 access matrix visible "
                                       "intersection raytracing patch ";
// https://www.w3.org/TR/WGSL/ sections 15.1, 15.2 and 17
constexpr std::string_view wgsl_words = " NULL Self abstract active alias alignas alignof array as asm "
                                        "asm_fragment async atomic attribute auto await become binding_array "
                                        "bitcast bool break case cast catch class co_await co_return "
                                        "co_yield coherent column_major common compile "
                                        "compile_fragment concept const const_assert const_cast consteval "
                                        "constexpr constinit continue continuing crate debugger "
                                        "decltype default delete demote demote_to_helper diagnostic discard "
                                        "do dynamic_cast else enable enum explicit export extends extern "
                                        "external f16 f32 false fallthrough filter final finally fn for "
                                        "friend from fxgroup get goto groupshared highp i32 if impl "
                                        "implements import inline instanceof interface layout let loop lowp "
                                        "macro macro_rules mat2x2 mat3x3 mat4x4 match mediump "
                                        "meta mod module move mut mutable namespace new nil noexcept "
                                        "noinline nointerpolation non_coherent noncoherent "
                                        "noperspective null nullptr of operator override package packoffset "
                                        "partition pass patch pixelfragment precise precision premerge "
                                        "priv private protected ptr pub public readonly ref regardless "
                                        "register reinterpret_cast require requires resource restrict return "
                                        "sampler self set shared sizeof smooth snorm static static_assert "
                                        "static_cast std struct subroutine super switch target "
                                        "template texture this thread_local throw trait true try type "
                                        "typedef typeid typename typeof u32 union unless unorm unsafe "
                                        "unsized use using var varying vec2 vec2f vec3 vec3f vec4 vec4f "
                                        "virtual volatile wgsl where while with writeonly yield "
                                        "abs acos all any asin atan atan2 ceil clamp cos cosh cross degrees "
                                        "determinant distance dot exp exp2 floor fma fract "
                                        "length log log2 max min mix modf normalize pow radians reflect "
                                        "refract round saturate select sign sin sinh smoothstep "
                                        "sqrt step tan tanh transpose trunc ";
constexpr std::string_view osl_words = " and bool break case catch char class closure color const continue "
                                       "default delete displacement do double else emit enum "
                                       "extern false float for friend goto if illuminance illuminate int "
                                       "inline long matrix namespace new normal not operator or "
                                       "output point private protected public return short signed sizeof "
                                       "static string struct surface switch template this "
                                       "throw true try typedef uniform union unsigned using varying vector "
                                       "virtual void volatile volume while shader abs acos "
                                       "asin atan atan2 background blackbody calculatenormal ceil clamp "
                                       "concat cos cosh cross degrees determinant dict_find "
                                       "diffuse distance dot emission endswith erf erfc error exp exp2 expm1 "
                                       "fabs filterwidth floor fmod format fprintf "
                                       "getattribute getmessage gettextureinfo hash hypot inversesqrt "
                                       "isconnected isfinite isinf isnan length linearstep log "
                                       "log10 log2 logb luminance max microfacet min mix mod noise normalize "
                                       "oren_nayar phong pointcloud_get pow printf pnoise "
                                       "psnoise radians raytype reflect reflection refract refraction "
                                       "regex_match regex_search rotate round select setmessage "
                                       "sign sin sincos sinh smoothstep smooth_linearstep snoise spline "
                                       "splineinverse sqrt startswith step strlen substr "
                                       "surfacearea tan tanh texture texture3d trace transform transpose "
                                       "trunc ward warning wavelength_color I N Ng P dPdu dPdv "
                                       "u v time dtime Ps Ci ";
constexpr std::string_view cuda_words =
    " float1 float2 float3 float4 int2 int3 int4 uint uint2 uint3 uint4 double2 double3 double4 dim3 "
    "blockIdx blockDim gridDim "
    "threadIdx warpSize clock saturate rsqrt rsqrtf norm normf norm3df rhypot sinpi cospi fdividef ";
constexpr std::string_view slang_words = " associatedtype cbuffer enum extension func functype import in "
                                         "inout interface internal is let let out property some "
                                         "struct subscript uniform var where __init __generic no_diff throws "
                                         "try none each expand module implementing "
                                         "precedence optional This dynamic_dispatch ";

constexpr std::string_view gdshader_words = " E PI TAU TIME INF NAN global group_uniforms hint_range "
                                            "instance render_mode shader_type source_color varying "
                                            "vertex fragment light start process sky fog ";

bool holds(std::string_view words, std::string_view word) {
    return words.find(fmt::format(" {} ", word)) != std::string_view::npos;
}

bool is_reserved(const language& l, std::string_view word) {
    if (l.id == "gdshader")
        return holds(c_family, word) || holds(gl_words, word) || holds(gdshader_words, word);
    if (l.id == "glsl" || l.id == "essl")
        return holds(c_family, word) || holds(gl_words, word) || word.starts_with("gl_");
    if (l.id == "hlsl") return holds(c_family, word) || holds(hlsl_words, word);
    if (l.id == "msl") return holds(c_family, word) || holds(c_functions, word) || holds(msl_words, word);
    if (l.id == "wgsl") return holds(wgsl_words, word);
    if (l.id == "osl") return holds(osl_words, word);
    if (l.id == "cuda") return holds(c_family, word) || holds(c_functions, word) || holds(cuda_words, word);
    if (l.id == "slang") return holds(c_family, word) || holds(hlsl_words, word) || holds(slang_words, word);
    return holds(c_family, word) || holds(c_functions, word);
}

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

std::string legal_name(const language& l, std::string_view name) {
    std::string legal;
    for (const char c : name) {
        const bool fits = std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_';
        const char kept = fits ? c : '_';
        // two underscores in a row belong to the implementation
        if (kept == '_' && (legal.empty() || legal.back() == '_')) continue;
        legal += kept;
    }
    if (legal.empty() || std::isdigit(static_cast<unsigned char>(legal.front())) != 0) legal = "f_" + legal;
    return is_reserved(l, legal) ? legal + "_" : legal;
}

} // namespace fresnel::emit
