// Godot 4: an include file with every model, and spatial shaders that use it, as an addon's folder.

#include "analysis/curve.hpp"
#include "emit/library.hpp"
#include "emit/pack.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace fresnel::emit {

namespace {

constexpr std::string_view root = "godot/addons/fresnel/";

std::string head(std::string_view what) {
    return fmt::format("// {}\n// Part of fresnel {}. Made by `fresnel shader --write`; do not edit.\n"
                       "shader_type spatial;\n",
                       what, FRESNEL_VERSION);
}

std::string numbers(const rgb& colour) {
    const auto limited = [](double x) { return std::clamp(x, 0.0, 1.0); };
    return fmt::format("vec3({:.4f}, {:.4f}, {:.4f})", limited(colour[0]), limited(colour[1]),
                       limited(colour[2]));
}

constexpr std::string_view surface = R"(
uniform vec4 base_color : source_color = vec4(0.2, 0.2, 0.25, 1.0);
uniform sampler2D base_texture : source_color, hint_default_white, filter_linear_mipmap_anisotropic, repeat_enable;
uniform sampler2D normal_texture : hint_normal, filter_linear_mipmap_anisotropic, repeat_enable;
uniform float normal_strength : hint_range(0.0, 4.0) = 1.0;
)";

constexpr std::string_view bent_normal = R"(
// The normal of the surface, bent by the normal map as Godot bends it by NORMAL_MAP and NORMAL_MAP_DEPTH.
vec3 bent_normal(vec3 normal, vec3 tangent, vec3 binormal, vec2 uv) {
    vec2 slope = texture(normal_texture, uv).xy * 2.0 - 1.0;
    float height = sqrt(max(1.0 - dot(slope, slope), 0.0));
    vec3 bent = tangent * slope.x + binormal * slope.y + normal * height;
    return normalize(mix(normal, bent, normal_strength));
}
)";

std::string rim() {
    return head("A rim of light over a base colour: a mix of the two by bias_scale_power.") + R"(
#include "fresnel.gdshaderinc"
)" + std::string(surface) +
           R"(uniform vec3 rim_color : source_color = vec3(1.0, 0.9, 0.7);
uniform float rim_energy : hint_range(0.0, 16.0) = 1.0;
uniform float bias : hint_range(-1.0, 1.0) = 0.0;
uniform float scale : hint_range(0.0, 4.0) = 1.0;
uniform float power : hint_range(0.1, 20.0) = 5.0;
uniform float roughness : hint_range(0.0, 1.0) = 0.6;
)" + std::string(bent_normal) +
           R"(
void fragment() {
    NORMAL = bent_normal(NORMAL, TANGENT, BINORMAL, UV);
    float F = bias_scale_power_dir(bias, scale, power, NORMAL, VIEW);
    ALBEDO = base_color.rgb * texture(base_texture, UV).rgb * (1.0 - F);
    ROUGHNESS = roughness;
    EMISSION = rim_color * (rim_energy * F);
}
)";
}

std::string fade() {
    return head("A film, a bubble or a shield: as opaque as its surface is reflective.") + R"(
#include "fresnel.gdshaderinc"
)" + std::string(surface) +
           R"(uniform float index : hint_range(1.0, 3.0) = 1.5;
uniform float least_opacity : hint_range(0.0, 1.0) = 0.0;
)" + std::string(bent_normal) +
           R"(
void fragment() {
    NORMAL = bent_normal(NORMAL, TANGENT, BINORMAL, UV);
    vec4 base = base_color * texture(base_texture, UV);
    ALBEDO = base.rgb;
    ALPHA = base.a * max(dielectric_dir(1.0, index, NORMAL, VIEW), least_opacity);
}
)";
}

std::string reflective() {
    return head("A clear coat over a base: the environment is reflected by the exact reflectance of its "
                "index.") +
           R"(
#include "fresnel.gdshaderinc"
)" + std::string(surface) +
           R"(uniform float index : hint_range(1.0, 3.0) = 1.5;
uniform samplerCube environment : source_color, hint_default_black;
uniform float environment_energy : hint_range(0.0, 16.0) = 1.0;
)" + std::string(bent_normal) +
           R"(
void fragment() {
    NORMAL = bent_normal(NORMAL, TANGENT, BINORMAL, UV);
    float F = dielectric_dir(1.0, index, NORMAL, VIEW);
    vec3 mirrored = (INV_VIEW_MATRIX * vec4(reflected_direction(VIEW, NORMAL), 0.0)).xyz;
    ALBEDO = base_color.rgb * texture(base_texture, UV).rgb * (1.0 - F); // what the coat lets through
    ROUGHNESS = 1.0;
    SPECULAR = 0.0; // the coat is the only mirror
    EMISSION = texture(environment, mirrored).rgb * (environment_energy * F);
}
)";
}

std::string metal() {
    const normal_colour gold = colour_at_normal(load_material("gold"), color_space::srgb, 1);
    return head(
               "A metal by its colours at normal incidence and at cos 1/7: lights, and an environment map.") +
           fmt::format(R"(render_mode ambient_light_disabled;

#include "fresnel.gdshaderinc"

// Linear sRGB of {}, {}: `fresnel f0 NAME` prints those of other metals.
uniform vec3 f0 = {};
uniform vec3 f82_color = {};
)",
                       gold.material, gold.page, numbers(gold.f0), numbers(gold.f82)) +
           R"(uniform float roughness : hint_range(0.05, 1.0) = 0.25;
uniform samplerCube environment : source_color, hint_default_black;
uniform float environment_energy : hint_range(0.0, 16.0) = 1.0;

void fragment() {
    vec3 mirrored = (INV_VIEW_MATRIX * vec4(reflected_direction(VIEW, NORMAL), 0.0)).xyz;
    ALBEDO = vec3(0.0);
    METALLIC = 1.0;
    ROUGHNESS = roughness;
    EMISSION = textureLod(environment, mirrored, 8.0 * roughness).rgb *
        (environment_energy * f82_rgb_dir(f0, f82_color, NORMAL, VIEW));
}

// Microfacets with the GGX distribution and Smith's correlated shadowing; the angle of incidence is that with the half
// vector.
void light() {
    vec3 half_vector = normalize(VIEW + LIGHT);
    float n_l = max(dot(NORMAL, LIGHT), 0.0);
    float n_v = max(dot(NORMAL, VIEW), 1e-4);
    float n_h = max(dot(NORMAL, half_vector), 0.0);
    float a2 = pow(roughness, 4.0);
    float d = n_h * n_h * (a2 - 1.0) + 1.0;
    float distribution = a2 / (PI * d * d);
    float masked = n_l * sqrt(n_v * n_v * (1.0 - a2) + a2);
    float shadowed = n_v * sqrt(n_l * n_l * (1.0 - a2) + a2);
    float shadowing = 0.5 / max(masked + shadowed, 1e-5);
    vec3 F = f82_rgb_dir(f0, f82_color, half_vector, VIEW);
    SPECULAR_LIGHT += F * (distribution * shadowing * n_l) * ATTENUATION * LIGHT_COLOR;
}
)";
}

std::string readme() {
    std::string text = fmt::format("# Fresnel for Godot 4, version {}\n", FRESNEL_VERSION);
    text += R"(
Fresnel reflectance in Godot's shading language: every model of `fresnel`, exact, approximate and artistic, in
`fresnel.gdshaderinc`, and four spatial shaders that use it.

## Install

Copy the folder `addons` into your project, so that `res://addons/fresnel/fresnel.gdshaderinc` exists. There is no plugin to
enable. Checked in Godot 4.6 with the Compatibility renderer; nothing in the files is particular to it.

| file | what it is |
|---|---|
| `rim.gdshader` | a rim of light over a textured, normal-mapped base: bias 0, scale 1, power 5 |
| `fade.gdshader` | transparent but where it reflects: opacity by the exact reflectance of an index |
| `reflective.gdshader` | a coat of an index over a base: a cubemap reflected by the exact reflectance |
| `metal.gdshader` | gold, or any metal by two colours: lights by microfacets, a cubemap |
| `fresnel.gdshaderinc` | the functions |

## In your own shaders

    #include "res://addons/fresnel/fresnel.gdshaderinc"

    void fragment() {
        float F = dielectric_dir(1.0, 1.5, NORMAL, VIEW); // from air onto glass
        ...
    }

Godot has no overloads, so a name says what a function takes: `schlick` one number and the cosine, `schlick_rgb` three
channels that share the angle, `schlick_dir` and `schlick_rgb_dir` two directions in place of the cosine. `NORMAL` and `VIEW`
both point away from the surface, as these functions expect. Inside `light()` the angle of incidence is that of `VIEW` or
`LIGHT` with their half vector.

Colours are linear: give `f0` of a measured material as a plain `vec3`, without the hint `source_color`.

## Limits

`VIEW` points to the camera's place also where the camera is orthogonal, so that a rim then leans to the edges of the picture.
Godot's own reflections of the sky and of probes always use its built-in approximation. `reflective` and `metal` therefore
take the environment from a cubemap of their own and switch the built-in one off; a cubemap needs mipmaps to look rough.
)";
    return text;
}

} // namespace

std::vector<pack_file> godot_pack() {
    const std::string folder(root);
    return {{folder + "README.md", readme()},
            {folder + "fade.gdshader", fade()},
            {folder + "fresnel.gdshaderinc", library_text(find_language("gdshader"))},
            {folder + "metal.gdshader", metal()},
            {folder + "reflective.gdshader", reflective()},
            {folder + "rim.gdshader", rim()}};
}

} // namespace fresnel::emit
