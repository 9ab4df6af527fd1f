#include "emit/language.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cctype>

namespace fresnel::emit {

namespace {

// Words that some language keeps for itself, and functions it already has. A name is refused everywhere that any
// language of its group refuses it: less to look up for a reader who moves text from one to another. The receivers
// compile a function by each name of scripts/receivers.d/words.txt that is not changed here.

// Keywords of C and C++.
constexpr std::string_view c_family =
    " alignas alignof and and_eq asm atomic auto bitand bitor bool break case catch char char8_t char16_t "
    "char32_t class compl complex concept const const_cast consteval constexpr constinit continue "
    "co_await co_return co_yield decltype default delete do double dynamic_cast else enum explicit export "
    "extern false float for friend goto half if imaginary inline int long mutable namespace new noexcept "
    "not not_eq nullptr operator or or_eq private protected public register reinterpret_cast requires "
    "restrict return short signed sizeof static static_assert static_cast struct switch template this "
    "thread_local throw true try typedef typeid typename typeof union unsigned using virtual void "
    "volatile wchar_t while xor xor_eq main ";

// Functions and macros of their headers, and those that compilers know without a header.
constexpr std::string_view c_functions =
    " abs acos asin atan atan2 ceil cos cosh erf exp exp2 expf exp2f fabs fabsf floor fma fmax fmaxf fmin "
    "fminf fmod hypot isnan isinf j0 j1 jn log log10 log2 logf log2f max min pow powf remainder rint "
    "round sin sinh sqrt sqrtf tan tanh trunc y0 y1 yn index signal div FP_NAN HUGE_VAL HUGE_VALF "
    "INFINITY NAN NULL MAXFLOAT M_PI M_PI_2 M_PI_4 M_1_PI M_2_PI M_2_SQRTPI M_E M_LN2 M_LN10 M_LOG2E "
    "M_LOG10E M_SQRT2 M_SQRT1_2 abort acosf acosh acoshf asinf asinh atan2f atanf atanh cabs calloc carg "
    "cbrt cbrtf ccos ceilf ceill cexp cimag clog conj copysign cosf coshf cpow cproj creal csin csqrt "
    "double_t erfc exit exp10 exp10f expm1 expm1f fabsl fdim float_t floorf fmaf fmodf fpclassify fprintf "
    "fputs free frexp frexpf hypotf ilogb ilogbf isalnum isalpha isblank iscntrl isdigit isfinite isgraph "
    "islower isnormal isprint ispunct isspace isupper iswalpha isxdigit isgreater isgreaterequal isless "
    "islessequal islessgreater isunordered labs ldexp ldexpf lgamma lgammaf llabs llrint llround log10f "
    "log1p log1pf logb lrint lround malloc math_errhandling memcmp memcpy memmove memset modf modff nan "
    "nanf nanl nearbyint nextafter nexttoward printf putchar puts realloc remquo rintf roundf scalbln "
    "scalbn scanf signbit signgam sinf sinhf sprintf strcat strcmp strcpy strlen strncmp strstr tanf "
    "tanhf tgamma tolower toupper towlower truncf vprintf alloca div_t int8_t int16_t int32_t int64_t "
    "uint8_t uint16_t uint32_t uint64_t size_t std uint ulong ushort uchar typeof_unqual Bool sincosf "
    "gamma j0f y0f drem finite significand scalb pow10 linux unix i386 ";

constexpr std::string_view gl_words =
    " active array asm attribute buffer bvec2 bvec3 bvec4 cast centroid coherent common dmat2 dmat3 dmat4 "
    "double dvec2 dvec3 dvec4 discard dispatch external filter fixed flat fvec2 fvec3 fvec4 goto half "
    "highp hvec2 hvec3 hvec4 in inout input interface invariant isampler2D ivec2 ivec3 ivec4 layout lowp "
    "mat2 mat3 mat4 mediump mod noinline noperspective out output packed partition patch precise "
    "precision public readonly resource sample sampler sampler1D sampler2D sampler3D samplerCube shared "
    "sizeof smooth subroutine superp uint uniform uvec2 uvec3 uvec4 varying vec2 vec3 vec4 volatile "
    "writeonly abs acos all any asin atan ceil clamp cos cross degrees determinant distance dot equal exp "
    "exp2 floor fma fract frexp greaterThan inverse inversesqrt isinf isnan ldexp length lessThan log "
    "log2 main matrixCompMult max min mix modf noise normalize not notEqual outerProduct pow radians "
    "reflect refract round sign sin smoothstep sqrt step tan texture transpose trunc atomic_uint "
    "atomicAdd atomicMin atomicMax atomicLoad atomicStore sinh cosh tanh asinh acosh atanh roundEven "
    "floatBitsToInt floatBitsToUint intBitsToFloat uintBitsToFloat packUnorm2x16 packSnorm2x16 "
    "packUnorm4x8 packSnorm4x8 unpackUnorm2x16 unpackSnorm2x16 unpackUnorm4x8 unpackSnorm4x8 packHalf2x16 "
    "unpackHalf2x16 faceforward lessThanEqual greaterThanEqual uaddCarry usubBorrow umulExtended "
    "imulExtended bitfieldExtract bitfieldInsert bitfieldReverse bitCount findLSB findMSB textureSize "
    "textureProj textureLod textureOffset texelFetch texelFetchOffset textureProjOffset textureLodOffset "
    "textureProjLod textureProjLodOffset textureGrad textureGradOffset textureProjGrad "
    "textureProjGradOffset textureGather textureGatherOffset textureGatherOffsets interpolateAtCentroid "
    "interpolateAtSample interpolateAtOffset memoryBarrier imageLoad imageStore subpassLoad dFdx dFdy "
    "fwidth GL_ES countLeadingZeros countTrailingZeros subgroupAdd subgroupBallot subpassInput ";

constexpr std::string_view hlsl_words =
    " AppendStructuredBuffer BlendState Buffer ByteAddressBuffer bool2 bool3 bool4 cbuffer centroid "
    "column_major compile compile_fragment ComputeShader discard double2 double3 double4 dword export "
    "extern float1 float2 float3 float4 fxgroup groupshared half1 half2 half3 half4 in InputPatch int2 "
    "int3 int4 interface inout line lineadj linear LineStream matrix min10float min16float min16int "
    "min16uint nointerpolation noperspective NULL out OutputPatch packoffset pass pixelfragment "
    "PixelShader point PointStream precise RasterizerState register row_major sample sampler SamplerState "
    "shared snorm stateblock string StructuredBuffer tbuffer technique texture Texture2D Texture3D "
    "TextureCube triangle triangleadj TriangleStream uint uint2 uint3 uint4 uniform unorm vector "
    "vertexfragment VertexShader abs acos all any asin atan atan2 ceil clamp clip cos cosh cross ddx ddy "
    "degrees determinant distance dot exp exp2 faceforward floor fma fmod frac frexp fwidth isfinite "
    "isinf isnan ldexp length lerp lit log log10 log2 mad max min modf mul noise normalize pow radians "
    "rcp reflect refract round rsqrt saturate select sign sin sincos sinh smoothstep sqrt step tan tanh "
    "transpose trunc mix packed fixed sampler_state ConsumeStructuredBuffer RWBuffer RWByteAddressBuffer "
    "RWStructuredBuffer ConstantBuffer TextureBuffer SamplerComparisonState globallycoherent min12int "
    "int8_t int16_t int32_t int64_t uint8_t uint16_t uint32_t uint64_t float16_t float32_t float64_t "
    "spirv_asm DepthStencilState DepthStencilView GeometryShader HullShader DomainShader RenderTargetView "
    "stateblock_state technique10 technique11 asm_fragment CompileShader FeedbackTexture2D asdouble "
    "GetAttributeAtVertex RayQuery dst std ";

constexpr std::string_view msl_words =
    " array buffer constant device fragment half half2 half3 half4 kernel metal ptr_t sampler stage_in "
    "texture thread threadgroup uint vec vector vertex clamp cross distance dot fract length mix "
    "normalize reflect refract rsqrt saturate select sign smoothstep step float2 float3 float4 bool2 "
    "bool3 bool4 uint2 uint3 uint4 int2 int3 int4 access matrix visible intersection raytracing patch "
    "M_PI_F M_E_F uchar ushort ulong size_t powr divide copysign fdim fmax fmin fmod nextafter fmax3 "
    "fmin3 fmedian3 max3 min3 median3 exp10 sinpi cospi tanpi texturecube texturecube_array depthcube "
    "depthcube_array ";

// https://www.w3.org/TR/WGSL/ sections 15.1, 15.2 and 17, and what older versions of it kept
constexpr std::string_view wgsl_words =
    " NULL Self abstract active alias alignas alignof array as asm asm_fragment async atomic attribute "
    "auto await become binding_array bitcast bool break case cast catch class co_await co_return co_yield "
    "coherent column_major common compile compile_fragment concept const const_assert const_cast "
    "consteval constexpr constinit continue continuing crate debugger decltype default delete demote "
    "demote_to_helper diagnostic discard do dynamic_cast else enable enum explicit export extends extern "
    "external f16 f32 false fallthrough filter final finally fn for friend from fxgroup get goto "
    "groupshared highp i32 if impl implements import inline instanceof interface layout let loop lowp "
    "macro macro_rules mat2x2 mat3x3 mat4x4 match mediump meta mod module move mut mutable namespace new "
    "nil noexcept noinline nointerpolation non_coherent noncoherent noperspective null nullptr of "
    "operator override package packoffset partition pass patch pixelfragment precise precision premerge "
    "priv private protected ptr pub public readonly ref regardless register reinterpret_cast require "
    "requires resource restrict return sampler self set shared sizeof smooth snorm static static_assert "
    "static_cast std struct subroutine super switch target template texture this thread_local throw trait "
    "true try type typedef typeid typename typeof u32 union unless unorm unsafe unsized use using var "
    "varying vec2 vec2f vec3 vec3f vec4 vec4f virtual volatile wgsl where while with writeonly yield abs "
    "acos all any asin atan atan2 ceil clamp cos cosh cross degrees determinant distance dot exp exp2 "
    "floor fma fract length log log2 max min mix modf normalize pow radians reflect refract round "
    "saturate select sign sin sinh smoothstep sqrt step tan tanh transpose trunc inout DomainShader "
    "GeometryShader CompileShader ComputeShader Hullshader signed handle sampler_comparison ";

constexpr std::string_view osl_words =
    " and bool break case catch char class closure color const continue default delete displacement do "
    "double else emit enum extern false float for friend goto if illuminance illuminate int inline long "
    "matrix namespace new normal not operator or output point private protected public return short "
    "signed sizeof static string struct surface switch template this throw true try typedef uniform union "
    "unsigned using varying vector virtual void volatile volume while shader abs acos asin atan atan2 "
    "background blackbody calculatenormal ceil clamp concat cos cosh cross degrees determinant dict_find "
    "diffuse distance dot emission endswith erf erfc error exp exp2 expm1 fabs filterwidth floor fmod "
    "format fprintf getattribute getmessage gettextureinfo hash hypot inversesqrt isconnected isfinite "
    "isinf isnan length linearstep log log10 log2 logb luminance max microfacet min mix mod noise "
    "normalize oren_nayar phong pointcloud_get pow printf pnoise psnoise radians raytype reflect "
    "reflection refract refraction regex_match regex_search rotate round select setmessage sign sin "
    "sincos sinh smoothstep smooth_linearstep snoise spline splineinverse sqrt startswith step strlen "
    "substr surfacearea tan tanh texture texture3d trace transform transpose trunc ward warning "
    "wavelength_color I N Ng P dPdu dPdv u v time dtime Ps Ci M_PI M_2_PI M_2PI M_4PI M_1_PI M_LN2 "
    "M_LOG10E dPdtime M_PI_2 M_PI_4 M_2_SQRTPI M_E M_LN10 M_LOG2E M_SQRT2 M_SQRT1_2 aastep cellnoise "
    "hashnoise ";

constexpr std::string_view cuda_words =
    " float1 float2 float3 float4 int2 int3 int4 uint uint2 uint3 uint4 double2 double3 double4 dim3 "
    "blockIdx blockDim gridDim threadIdx warpSize clock saturate rsqrt rsqrtf norm normf norm3df rhypot "
    "sinpi cospi fdividef make_float2 make_float4 make_int3 make_uint3 make_uchar4 char1 uchar4 assert "
    "cudaError_t cudaStream_t nullptr_t offsetof ptrdiff_t stdin stdout stderr va_list ";

constexpr std::string_view slang_words =
    " associatedtype cbuffer enum extension func functype import in inout interface internal is let out "
    "property some struct subscript uniform var where __init __generic no_diff throws try none each "
    "expand module implementing precedence optional This dynamic_dispatch spirv_asm uintptr_t intptr_t ";

// Godot's own, beside those of GLSL.
constexpr std::string_view gdshader_words = " E PI TAU TIME INF NAN global group_uniforms hint_range "
                                            "instance render_mode shader_type source_color varying "
                                            "vertex fragment light start process sky fog ";

// What the emitted text declares around a function and uses in it.
constexpr std::array ours = {
    "incidence_cosine",   "normal",         "direction", "fresnel_boundary", "fresnel_float3",
    "fresnel_dot",        "make_float3",    "result",    "fresnel_float2",   "fresnel_make_float2",
    "make_float2",        "two_sum",        "halves",    "two_product",      "twofold_sum",
    "twofold_difference", "twofold_product"};

bool holds(std::string_view words, std::string_view word) {
    return words.find(fmt::format(" {} ", word)) != std::string_view::npos;
}

// The lists that together hold a language's words.
std::vector<std::string_view> lists(const language& l) {
    if (l.id == "glsl" || l.id == "essl") return {c_family, gl_words};
    if (l.id == "gdshader") return {c_family, gl_words, gdshader_words};
    if (l.id == "hlsl") return {c_family, hlsl_words};
    if (l.id == "msl") return {c_family, c_functions, msl_words};
    if (l.id == "wgsl") return {wgsl_words};
    if (l.id == "osl") return {osl_words};
    if (l.id == "cuda") return {c_family, c_functions, cuda_words};
    if (l.id == "slang") return {c_family, hlsl_words, slang_words};
    return {c_family, c_functions};
}

bool remove_prefix(std::string_view& word, std::string_view prefix) {
    if (!word.starts_with(prefix)) return false;
    word.remove_prefix(prefix.size());
    return true;
}

bool is_digit(char c) { return std::isdigit(static_cast<unsigned char>(c)) != 0; }

// float3, half4x4, uint64_t2, vec3f, dmat2x3: a type and how many of it.
bool is_shape(std::string_view word) {
    constexpr std::array types = {"float",     "half",      "double",   "int",      "uint",     "bool",
                                  "fixed",     "vec",       "ivec",     "uvec",     "bvec",     "dvec",
                                  "hvec",      "fvec",      "mat",      "dmat",     "int16_t",  "uint16_t",
                                  "int32_t",   "uint32_t",  "int64_t",  "uint64_t", "char",     "uchar",
                                  "short",     "ushort",    "long",     "ulong",    "longlong", "ulonglong",
                                  "float16_t", "float32_t", "float64_t"};
    if (word.size() > 1 && std::string_view("fhiu").find(word.back()) != std::string_view::npos)
        word.remove_suffix(1);
    if (word.size() > 2 && is_digit(word.back()) && word[word.size() - 2] == 'x') word.remove_suffix(2);
    if (word.empty() || !is_digit(word.back())) return false;
    word.remove_suffix(1);
    return std::find(types.begin(), types.end(), word) != types.end();
}

// sampler2DArray, uimage3D, texture_2d, RWTexture2D: something to read a picture from.
bool is_picture(std::string_view word) {
    if (!word.starts_with("image") && !remove_prefix(word, "RW") && !remove_prefix(word, "i"))
        remove_prefix(word, "u");
    for (const std::string_view type : {"sampler", "image", "texture", "Texture", "Sampler", "depth"})
        if (remove_prefix(word, type))
            return !word.empty() && word.back() != '_' &&
                   std::islower(static_cast<unsigned char>(word.front())) == 0;
    return false;
}

bool is_reserved(const language& l, std::string_view word) {
    const std::vector<std::string_view> all = lists(l);
    return is_shape(word) || is_picture(word) ||
           std::any_of(all.begin(), all.end(), [&](std::string_view words) { return holds(words, word); });
}

} // namespace

std::vector<std::string> reserved_words(const language& l) {
    std::vector<std::string> all;
    for (const std::string_view words : lists(l))
        for (std::size_t at = words.find_first_not_of(' '); at != std::string_view::npos;) {
            const std::size_t end = words.find(' ', at);
            all.emplace_back(words.substr(at, end - at));
            at = words.find_first_not_of(' ', end);
        }
    return all;
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
    // gl_ is kept for the built-in variables of GLSL
    if (legal.empty() || is_digit(legal.front()) || legal.starts_with("gl_")) legal = "f_" + legal;
    return is_reserved(l, legal) ? legal + "_" : legal;
}

std::string function_name(const language& l, std::string_view name) {
    std::string legal = legal_name(l, name);
    const auto is_ours = [&] {
        return std::any_of(ours.begin(), ours.end(),
                           [&](const char* word) { return legal == word || legal == legal_name(l, word); });
    };
    if (legal.starts_with("FRESNEL_")) legal = "f_" + legal; // our macros
    while (is_ours())
        legal += legal.back() == '_' ? "f" : "_";
    return legal;
}

} // namespace fresnel::emit
