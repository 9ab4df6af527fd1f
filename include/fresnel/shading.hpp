#pragma once

// Laws of shading around Fresnel reflectance: how engines pack f0 and the diffuse color into metalness, what an
// f0 below 0.02 means to them, how a semitransparent surface turns opaque, and the highlight of a Phong lobe.

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/number.hpp>

namespace fresnel {

// ---- metalness --------------------------------------------------------------------------------------------

/// One channel of a surface: reflectance at normal incidence, and the diffuse color below it.
template <class T>
struct surface_channel {
    T f0, rho_ss;
};

/// Metalness as Disney and Unreal have it.
///
///   f0 = mix(0.08 specular, base, metalness)      rho_ss = base (1 - metalness)
///
/// base        surface color      [0, 1]
/// metalness   0 dielectric, 1 metal   [0, 1]
/// specular    of the dielectric  [0, 1]; 0.5 is f0 = 0.04
/// source      Burley 2012, "Physically-Based Shading at Disney"; Karis 2013, "Real Shading in Unreal Engine 4"
template <class T>
surface_channel<T> metalness_disney(T base, T metalness, T specular) {
    return {mix(ratio<T, 2, 25>() * specular, base, metalness), base * (1 - metalness)};
}

/// Metalness as Frostbite and Filament have it, with a wider range of dielectrics.
///
///   f0 = mix(0.16 reflectance^2, base, metalness)      rho_ss = base (1 - metalness)
///
/// reflectance   of the dielectric   [0, 1]; 0.5 is f0 = 0.04, 1 is 0.16
/// source        Lagarde and de Rousiers 2014, "Moving Frostbite to Physically Based Rendering"
template <class T>
surface_channel<T> metalness_frostbite(T base, T metalness, T reflectance) {
    return {mix(ratio<T, 4, 25>() * square(reflectance), base, metalness), base * (1 - metalness)};
}

/// Metalness as Unity's built-in shaders have it: every dielectric has f0 = 0.04, taken from its diffuse color.
///
///   f0 = mix(0.04, base, metalness)      rho_ss = base (1 - metalness) (1 - 0.04)
///
/// source   Unity, built-in shader source, UnityStandardUtils.cginc
template <class T>
surface_channel<T> metalness_unity(T base, T metalness) {
    return {mix(ratio<T, 1, 25>(), base, metalness), base * (1 - metalness) * ratio<T, 24, 25>()};
}

/// Metalness as glTF has it, with its extensions for the index and for specular.
///
///   f0 = mix(min(((ior - 1) / (ior + 1))^2 color, 1) specular, base, metalness)
///
/// specular   [0, 1]; scales f0 (and, as a renderer applies it, f90)
/// color      specularColorFactor, [0, infinity)
/// ior        index of the dielectric, 1.5 by default   >= 1
/// source     Khronos, glTF 2.0 appendix B, KHR_materials_ior, KHR_materials_specular
template <class T>
surface_channel<T> metalness_gltf(T base, T metalness, T specular, T color, T ior) {
    const T f0 = min(normal_reflectance(T(1), ior, T(0)) * color, T(1)) * specular;
    return {mix(f0, base, metalness), base * (1 - metalness)};
}

/// The index that OpenPBR's specular_weight makes of another.
///
///   epsilon = sgn(eta - 1) sqrt(weight F0(eta)),   eta' = (1 + epsilon) / (1 - epsilon)
///
/// eta      n_t / n_i          > 0
/// weight   specular_weight    [0, 1 / F0(eta))
/// source   OpenPBR Surface 1.1, "Dielectric base"
template <class T>
T openpbr_eta(T eta, T weight) {
    const T root = let("root", sqrt(weight) * abs((eta - 1) / (eta + 1)));
    const T epsilon = let("epsilon", select(eta < 1, -root, root));
    return (1 + epsilon) / (1 - epsilon);
}

/// Metalness as OpenPBR has it: the weight scales the dielectric's f0 and the metal's color.
///
///   f0 = weight mix(F0(ior), base, metalness)      rho_ss = base (1 - metalness)
///
/// source   OpenPBR Surface 1.1
template <class T>
surface_channel<T> metalness_openpbr(T base, T metalness, T weight, T ior) {
    return {weight * mix(normal_reflectance(T(1), ior, T(0)), base, metalness), base * (1 - metalness)};
}

/// Reflectance at grazing incidence by the rule that an f0 below 0.02 is occlusion, since no solid in air has one.
///
///   f90 = saturate(50 f0)
///
/// Only for a value an artist painted for air. A measured f0 needs no such rule (ice has 0.018), and an immersed
/// one is rightly small: apply it before `immersed_f0`.
///
/// f0      as painted, in air   [0, 1]
/// source  Schuler 2009, in ShaderX7; Unreal and Frostbite as in Lagarde and de Rousiers 2014
template <class T>
T cavity_f90(T f0) {
    return saturate(50 * f0);
}

/// The f0 in another medium of a dielectric known by its f0 in air.
///
///   n = eta_from_f0(f0),   f0' = ((n - n_i) / (n + n_i))^2
///
/// f0      in air                       [0, 1)
/// n_i     index of the other medium    [0.01, 100]
template <class T>
T immersed_f0(T f0, T n_i) {
    const T n = eta_from_f0(f0);
    return square((n - n_i) / (n + n_i));
}

// ---- semitransparent surfaces -----------------------------------------------------------------------------

/// Opacity by reflection, which leaves less light to pass.
///
///   alpha_F = schlick(a0, cos_i)
///
/// a0      opacity at normal view    [0, 1]
/// cos_i   of the view, N.V          [0, 1]
/// source  Kraus 2012, "GLSL Programming/Unity", Fresnel highlights
template <class T>
T opacity_fresnel(T a0, T cos_i) {
    return schlick(a0, cos_i);
}

/// Opacity of a thin layer by the length of a straight path through it.
///
///   alpha_att = min(1, a / cos_i)
///
/// a       opacity at normal view, the attenuation constant   [0, 1]
/// cos_i   of the view   [0, 1]
/// source  Kraus 2012, "GLSL Programming/Unity", Silhouette enhancement
template <class T>
T opacity_silhouette(T a, T cos_i) {
    const auto thin = a < cos_i;
    return select(thin, a / select(thin, cos_i, T(1)), select(a > 0, T(1), T(0)));
}

/// Opacity of an absorbing layer, Beer and Lambert's law along the refracted ray.
///
///   alpha_att = 1 - exp(-tau / cos_t)
///
/// tau     optical depth at normal view   [0, infinity)
/// cos_t   inside the layer               [0, 1]
/// error   relative 2e-15 in float64, also for the thinnest layers
template <class T>
T opacity_slab(T tau, T cos_t) {
    const T x = let("x", select(cos_t > 0, tau / select(cos_t > 0, cos_t, T(1)), T(1)));
    // 1 - exp(-x) by its series where the difference would cancel
    const auto thin = 8 * x < 1;
    const T y = let("y", select(thin, x, T(0)));
    const T high = let("high", 1 - y / 7 * (1 - y / 8 * (1 - y / 9 * (1 - y / 10 * (1 - y / 11)))));
    const T series =
        let("series", y * (1 - y / 2 * (1 - y / 3 * (1 - y / 4 * (1 - y / 5 * (1 - y / 6 * high))))));
    const T opaque = select(tau > 0, T(1), T(0));
    return select(cos_t > 0, select(thin, series, 1 - exp2(-x / log(T(2)))), opaque);
}

/// Total opacity of a layer that attenuates and reflects.
///
///   1 - (1 - attenuation) (1 - fresnel)
///
/// source  Kraus 2012, "GLSL Programming/Unity", Fresnel highlights
template <class T>
T opacity_total(T attenuation, T fresnel) {
    return attenuation + fresnel * (1 - attenuation);
}

/// The attenuation at normal view that gives a total opacity together with one by reflection.
///
///   (total - fresnel) / (1 - fresnel)
///
/// total, fresnel   at normal view   [0, 1], fresnel < 1
/// returns          negative where fresnel > total: no layer does that, and the caller must refuse it
template <class T>
T opacity_attenuation(T total, T fresnel) {
    return (total - fresnel) / (1 - fresnel);
}

// ---- highlights -------------------------------------------------------------------------------------------

/// Phong's lobe.
///
///   max(cos_r, 0)^shininess
///
/// cos_r       R.V, between the mirror direction of the light and the view   [-1, 1]
/// shininess   [0.1, 1000]
/// source      Phong 1975, "Illumination for Computer Generated Pictures"
template <class T>
T phong_lobe(T cos_r, T shininess) {
    return pow(max(cos_r, T(0)), shininess);
}

/// A Phong highlight with Schlick's factor on the half vector; nothing with the light behind the surface.
///
///   schlick(f0, cos_h) phong_lobe(cos_r, shininess)
///
/// f0      specular material color     [0, 1]
/// cos_h   H.V, of the half vector     [0, 1]
/// cos_l   N.L, of the light           [-1, 1]
/// source  Kraus 2012, "GLSL Programming/Unity", Fresnel highlights
template <class T>
T fresnel_highlight(T f0, T cos_h, T cos_r, T shininess, T cos_l) {
    return select(cos_l < 0, T(0), schlick(f0, cos_h) * phong_lobe(cos_r, shininess));
}

} // namespace fresnel
