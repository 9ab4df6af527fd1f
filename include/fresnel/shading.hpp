#pragma once

// What shaders make of reflectance: opacity of thin layers, a highlight, and the metalness parametrisations
// that pack F0 and albedo into one colour. Everything is per colour channel.

#include <fresnel/approx.hpp>
#include <fresnel/geometry.hpp>
#include <fresnel/number.hpp>
#include <fresnel/slab.hpp>

namespace fresnel {

// ---- semitransparent surfaces -----------------------------------------------------------------------------
//
// A layer hides what is behind it by attenuation inside and by reflection at its surface. In compositing, the
// diffuse light of the layer is weighted by the opacity of attenuation alone, and its specular light by none:
// it carries the reflectance already.

/// Opacity by reflection: rises from the user's value to 1 at the silhouette.
///
///   alpha_F = a0 + (1 - a0) (1 - cos_i)^5
///
/// a0      opacity by reflection seen along the normal   [0, 1]
/// cos_i   cosine between view and normal                [0, 1]
/// returns [a0, 1]
/// source  "GLSL Programming/Unity/Specular Highlights at Silhouettes", Wikibooks
template <class T>
T opacity_fresnel(T a0, T cos_i) {
    return schlick(a0, cos_i);
}

/// Opacity by attenuation of a thin layer: in proportion to the path through it.
///
///   alpha_att = min(1, a / cos_i)
///
/// a       opacity by attenuation seen along the normal   [0, 1]
/// cos_i   cosine between view and normal                 [0, 1]
/// returns [a, 1]; 1 at cos_i = 0, but 0 for a = 0
/// source  "GLSL Programming/Unity/Silhouette Enhancement", Wikibooks
template <class T>
T opacity_silhouette(T a, T cos_i) {
    const auto edge = cos_i <= 0;
    const T path = let("path", select(edge, T(1), cos_i));
    return select(edge, select(a > 0, T(1), a), min(a / path, T(1)));
}

/// Opacity by attenuation of a layer of any thickness.
///
///   alpha = 1 - e^(-tau / cos_t)
///
/// tau     optical depth along the normal, natural logarithm   [0, inf)
/// cos_t   cosine inside the layer                             [0, 1]
/// returns [0, 1], of full relative precision for thin layers too; 1 at cos_t = 0, but 0 for tau = 0
/// source  Bouguer 1729; Beer 1852. `opacity_silhouette` is its first term in tau, with a = tau
template <class T>
T opacity_slab(T tau, T cos_t) {
    return pass(tau, cos_t).absorbed;
}

/// Opacity of a layer that attenuates and reflects.
///
///   alpha = 1 - (1 - alpha_att) (1 - alpha_F) = alpha_att + alpha_F (1 - alpha_att)
///
/// attenuation, fresnel   opacity by attenuation and by reflection   [0, 1]
/// returns [0, 1]
/// source  "GLSL Programming/Unity/Specular Highlights at Silhouettes", Wikibooks
template <class T>
T opacity_total(T attenuation, T fresnel) {
    return attenuation + fresnel * (1 - attenuation);
}

/// The opacity by attenuation that gives a layer the user's total opacity; the inverse of `opacity_total`.
///
///   alpha_att = (alpha - alpha_F) / (1 - alpha_F)
///
/// total     opacity of the whole   [0, 1]
/// fresnel   opacity by reflection  [0, 1)
/// returns   at most 1; negative where fresnel > total, which no layer does: it would have to emit
/// source    "GLSL Programming/Unity/Specular Highlights at Silhouettes", Wikibooks
template <class T>
T opacity_attenuation(T total, T fresnel) {
    return (total - fresnel) / (1 - fresnel);
}

// ---- highlights -------------------------------------------------------------------------------------------

/// The lobe of Phong's highlight.
///
///   max(cos_r, 0)^shininess
///
/// cos_r       cosine between the view and the mirrored light   [-1, 1]
/// shininess   sharpness                                        > 0
/// returns     [0, 1]
/// source      Phong 1975, "Illumination for Computer Generated Pictures"
template <class T>
T phong_lobe(T cos_r, T shininess) {
    return pow(max(cos_r, T(0)), shininess);
}

/// Phong's highlight whose colour turns white where light grazes the surface.
///
///   schlick(f0, cos_h) max(cos_r, 0)^shininess,   0 for a light below the surface
///
/// f0          specular colour of the material                      [0, 1]
/// cos_h       cosine between the view and the half vector          [0, 1]
/// cos_r       cosine between the view and the mirrored light       [-1, 1]
/// shininess   sharpness                                            > 0
/// cos_l       cosine between the normal and the light              [-1, 1]
/// returns     [0, 1], to be multiplied by the light; not normalised: the lobe loses energy as it sharpens
/// source      "GLSL Programming/Unity/Specular Highlights at Silhouettes", Wikibooks
template <class T>
T fresnel_highlight(T f0, T cos_h, T cos_r, T shininess, T cos_l) {
    const T lit = let("lit", schlick(f0, cos_h) * phong_lobe(cos_r, shininess));
    return select(cos_l >= 0, lit, max(cos_l, T(0))); // a NaN stays one
}

// ---- F0 as an artist's value ------------------------------------------------------------------------------

/// The reflectance at grazing incidence of an F0 that was painted: below 0.02 it means occlusion.
///
///   f90 = saturate(50 f0)
///
/// Hardly any material in air is below 0.02 (ice has 0.018), and so a painted F0 down there darkens cavities, and f90
/// has to follow.
/// For an artist's value in air only: never for a measured F0, nor for one that was `immersed`, which may
/// well be below 0.02.
///
/// f0      painted reflectance at normal incidence, in air   [0, 1]
/// source  Schuler 2009, "An Efficient and Physically Plausible Real-Time Shading Model", ShaderX7; used by
///         Karis 2013 (Unreal) and Lagarde and de Rousiers 2014 (Frostbite)
template <class T>
T cavity_f90(T f0) {
    return saturate(50 * f0);
}

/// An F0 that is known in air, in another ambient medium.
///
///   n = eta_from_f0(f0),   f0' = ((n - n_a) / (n + n_a))^2
///
/// Written with n = (1 + sqrt f0) / (1 - sqrt f0) multiplied out, so that a perfect mirror stays one. Apply
/// `cavity_f90` to the value in air, before this.
///
/// f0        reflectance at normal incidence in air, of a dielectric denser than air   [0, 1]
/// ambient   n_a, index of the medium outside                                          [0.01, 100]
/// returns   [0, 1]; 0 where the indices match
/// source    "Real-Time Rendering", 4th ed., table 9.4
template <class T>
T immersed(T f0, T ambient) {
    const T s = let("s", sqrt(f0));
    return normal_reflectance(ambient * (1 - s), 1 + s, T(0));
}

// ---- metalness --------------------------------------------------------------------------------------------
//
// One colour and a metalness stand for two: the colour is F0 where the surface is metal and albedo where it is
// not. The laws differ in the F0 that they give to the dielectric.

/// What a metalness material stands for, per channel.
template <class T>
struct surface_color {
    T f0;     ///< reflectance at normal incidence
    T albedo; ///< diffuse colour, rho_ss
};

/// The interpolation that all laws share.
///
///   f0 = m base + (1 - m) f0_dielectric        rho_ss = (1 - m) base
///
/// base            base colour                                     [0, 1]
/// metalness       m                                               [0, 1]
/// f0_dielectric   reflectance at normal incidence where m = 0     [0, 1]
/// source          Burley 2012, "Physically-Based Shading at Disney"; "Real-Time Rendering", 4th ed., sec. 9.5.2
template <class T>
surface_color<T> metalness_surface(T base, T metalness, T f0_dielectric) {
    return {metalness * base + (1 - metalness) * f0_dielectric, (1 - metalness) * base};
}

/// F0 of the dielectric from Disney's "specular", which is Unreal's too.
///
///   f0 = 0.08 specular
///
/// specular   [0, 1]; 0.5 is an index of 1.5
/// source     Burley 2012, "Physically-Based Shading at Disney"; Karis 2013, "Real Shading in Unreal Engine 4"
template <class T>
T disney_f0(T specular) {
    return ratio<T, 8, 100>() * specular;
}

/// Disney's and Unreal's "specular" of an F0; above 1 beyond their range, f0 > 0.08.
template <class T>
T disney_specular(T f0) {
    return ratio<T, 100, 8>() * f0;
}

/// F0 of the dielectric from Frostbite's "reflectance".
///
///   f0 = 0.16 reflectance^2
///
/// reflectance   [0, 1]; 0.5 is an index of 1.5
/// source        Lagarde and de Rousiers 2014, "Moving Frostbite to Physically Based Rendering"
template <class T>
T frostbite_f0(T reflectance) {
    return ratio<T, 16, 100>() * square(reflectance);
}

/// Frostbite's "reflectance" of an F0; above 1 beyond its range, f0 > 0.16.
template <class T>
T frostbite_reflectance(T f0) {
    return ratio<T, 10, 4>() * sqrt(f0);
}

/// The one F0 that Unity gives to dielectrics, 0.04.
template <class T>
T unity_f0() {
    return ratio<T, 4, 100>();
}

/// Unity's law: the dielectric keeps for its diffuse light what it does not reflect.
///
///   f0 = m base + 0.04 (1 - m)        rho_ss = 0.96 (1 - m) base
///
/// base, metalness   as `metalness_surface`
/// source            Unity built-in shader library, `DiffuseAndSpecularFromMetallic` in UnityStandardUtils.cginc
template <class T>
surface_color<T> unity_surface(T base, T metalness) {
    const surface_color<T> plain = metalness_surface(base, metalness, unity_f0<T>());
    return {plain.f0, (1 - unity_f0<T>()) * plain.albedo};
}

/// F0 of the dielectric in glTF.
///
///   f0 = min(((ior - 1) / (ior + 1))^2 specular_color, 1) specular
///
/// ior              index of the dielectric     [1, 100]; glTF's default is 1.5
/// specular_color   tint, per channel           [0, inf)
/// specular         strength                    [0, 1]
/// source           Khronos, glTF 2.0, KHR_materials_specular and KHR_materials_ior
template <class T>
T gltf_f0(T ior, T specular_color, T specular) {
    return min(normal_reflectance(T(1), ior, T(0)) * specular_color, T(1)) * specular;
}

/// The index whose F0 is that of eta times OpenPBR's specular weight.
///
///   eta' = (1 + e) / (1 - e),   e = sqrt(w) (eta - 1) / (eta + 1) = sgn(eta - 1) sqrt(w f0(eta))
///
/// eta               n_t / n_i              [0.01, 100]
/// specular_weight   w                      >= 0 with w f0(eta) < 1
/// returns           above 1 as eta is; 1 for w = 0
/// source            OpenPBR Surface 1.1, "Dielectric base"
template <class T>
T openpbr_eta(T eta, T specular_weight) {
    const T e = let("e", sqrt(specular_weight) * ((eta - 1) / (eta + 1)));
    return (1 + e) / (1 - e);
}

/// OpenPBR's law: the weight scales the reflectance of metal and dielectric alike.
///
///   f0 = w (m base + (1 - m) f0(eta))        rho_ss = (1 - m) base
///
/// base, metalness   as `metalness_surface`
/// eta               index of the dielectric, relative to the ambient medium   [0.01, 100]
/// specular_weight   w                                                         [0, 1]
/// source            OpenPBR Surface 1.1, "Metal" and "Dielectric base"
template <class T>
surface_color<T> openpbr_surface(T base, T metalness, T eta, T specular_weight) {
    const surface_color<T> plain = metalness_surface(base, metalness, normal_reflectance(T(1), eta, T(0)));
    return {specular_weight * plain.f0, plain.albedo};
}

/// OpenPBR's specular weight that gives a dielectric of index eta an F0.
///
///   w = f0 / f0(eta)
template <class T>
T openpbr_specular_weight(T f0, T eta) {
    return f0 / normal_reflectance(T(1), eta, T(0));
}

} // namespace fresnel
