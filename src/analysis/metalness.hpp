#pragma once

#include <fresnel/color.hpp>

#include <span>
#include <string_view>

namespace fresnel {

/// A metalness parameterisation: base color, metalness and one number for the dielectric.
///
/// specular_name       what the law calls that number; empty for a law without one
/// specular_max        its largest value (the least is 0); it depends on the index for some laws
struct metalness_law {
    std::string_view name, citation, specular_name;
    double specular_max, specular_default;
    bool has_ior;
};

/// disney, unreal, frostbite, unity, gltf, openpbr.
std::span<const metalness_law> metalness_laws();

/// Throws bad_input with the nearest name where there is no such law.
const metalness_law& find_metalness_law(std::string_view name);

/// What an artist sets; ior counts for gltf and openpbr only.
struct metalness_values {
    rgb base;
    double metalness, specular, ior = 1.5;
};

/// What a shader needs: reflectance at normal incidence and diffuse color.
struct surface_colors {
    rgb f0, albedo;
};

surface_colors to_surface(const metalness_law& law, const metalness_values& values);

/// What a blend of the parameters of a dielectric and a metal gets wrong against a blend of their surfaces, the
/// artifact at borders in a filtered texture.
///
/// t   place between the dielectric (0) and the metal (1)
surface_colors metalness_border_error(const metalness_law& law, const rgb& dielectric_base,
                                      const rgb& metal_base, double t);

/// The values that come nearest to a pair of f0 and albedo, and how near.
struct metalness_fit {
    metalness_values values;
    surface_colors reproduced;
    double residual; ///< largest difference of any component
};

/// The inverse of `to_surface`, by least squares over the six components; exact where the law can express the
/// pair. Where many values do, as for grays, the dielectric's number keeps its default.
///
/// f0, albedo   components in [0, 1]
/// ior          as in `metalness_values`
metalness_fit from_surface(const metalness_law& law, const surface_colors& wanted, double ior = 1.5);

} // namespace fresnel
