// Fresnel reflectance for three.js: nodes for WebGPURenderer, on WebGPU and on WebGL 2.
// Part of fresnel 0.1.0. Made by `fresnel shader --write`; do not edit.

import { Fn, glslFn, wgslFn } from 'three/tsl';

export const VERSION = '0.1.0';

/// Measured metals in air, as parameters of f82: linear sRGB at normal incidence and at cos 1/7.
export const metals = {
    aluminium: { f0: [0.9158, 0.9226, 0.9237], f82: [0.8691, 0.8970, 0.9193] }, // main/Al/nk/Cheng
    chromium: { f0: [0.5496, 0.5560, 0.5542], f82: [0.5615, 0.5702, 0.6190] }, // main/Cr/nk/Johnson
    copper: { f0: [0.9317, 0.6227, 0.5223], f82: [0.9459, 0.7549, 0.7024] }, // main/Cu/nk/Johnson
    gold: { f0: [1.0000, 0.7284, 0.3646], f82: [0.9909, 0.8572, 0.6464] }, // main/Au/nk/Johnson
    iron: { f0: [0.5297, 0.5132, 0.4942], f82: [0.5716, 0.5666, 0.5837] }, // main/Fe/nk/Johnson
    nickel: { f0: [0.6971, 0.6405, 0.5632], f82: [0.6825, 0.6730, 0.6664] }, // main/Ni/nk/Johnson
    platinum: { f0: [0.6789, 0.6395, 0.5836], f82: [0.6554, 0.6604, 0.6630] }, // main/Pt/nk/Rakic-BB
    silver: { f0: [0.9894, 0.9840, 0.9778], f82: [0.9876, 0.9860, 0.9870] }, // main/Ag/nk/Johnson
    titanium: { f0: [0.6186, 0.5794, 0.5425], f82: [0.6111, 0.6118, 0.6189] }, // main/Ti/nk/Johnson
};

// A function in both languages: which one is called is known when a material is built for a backend. A name ends in Rgb
// where parameters are vec3, in Dir where two directions stand in place of cos_i.
function native(wgsl, glsl, needs) {
    const inWgsl = wgslFn(wgsl, needs.map((f) => f.inWgsl)), inGlsl = glslFn(glsl, needs.map((f) => f.inGlsl));
    const node = Fn((args, builder) => (builder.renderer.backend.isWebGPUBackend ? inWgsl : inGlsl)(...args));
    return Object.assign((...args) => node(...args), { inWgsl, inGlsl });
}

export const incidenceCosine = /*@__PURE__*/ native(/* wgsl */ `
// The cosine between two directions, 0 where they lie on opposite sides.
//
// normal    unit
// direction where the light comes from, or the eye is; unit, on the side of normal
fn incidence_cosine(normal: vec3f, direction: vec3f) -> f32 {
    return saturate(dot(normal, direction));
}
`, /* glsl */ `
// The cosine between two directions, 0 where they lie on opposite sides.
//
// normal    unit
// direction where the light comes from, or the eye is; unit, on the side of normal
float incidence_cosine(vec3 normal, vec3 direction) {
    return clamp(dot(normal, direction), 0.0, 1.0);
}
`, []);

export const reflectedDirection = /*@__PURE__*/ native(/* wgsl */ `
// The mirror direction, on the side of normal.
//
//   r = 2 (n . v) n - v
//
// direction where the light comes from, or the eye is; unit, on the side of normal
// normal    unit
fn reflected_direction(direction: vec3f, normal: vec3f) -> vec3f {
    return 2.0 * dot(normal, direction) * normal - direction;
}
`, /* glsl */ `
// The mirror direction, on the side of normal.
//
//   r = 2 (n . v) n - v
//
// direction where the light comes from, or the eye is; unit, on the side of normal
// normal    unit
vec3 reflected_direction(vec3 direction, vec3 normal) {
    return 2.0 * dot(normal, direction) * normal - direction;
}
`, []);

export const refractedDirection = /*@__PURE__*/ native(/* wgsl */ `
// The refracted direction, on the other side of normal; the zero vector beyond the critical angle.
//
//   t = -(v - cos_i n) / eta - cos_t n
//
// direction where the light comes from, or the eye is; unit, on the side of normal
// normal    unit
// eta       n_t / n_i, above 0
fn refracted_direction(direction: vec3f, normal: vec3f, eta: f32) -> vec3f {
    let cos_i = dot(normal, direction);
    let g2 = (eta - 1.0) * (eta + 1.0) + cos_i * cos_i;
    let cos_t = select(min(sqrt(g2) / eta, 1.0), 0.0, g2 <= 0.0);
    let scale = select(1.0 / eta, 0.0, g2 < 0.0);
    let down = select(cos_t, 0.0, g2 < 0.0);
    return -scale * (direction - cos_i * normal) - down * normal;
}
`, /* glsl */ `
// The refracted direction, on the other side of normal; the zero vector beyond the critical angle.
//
//   t = -(v - cos_i n) / eta - cos_t n
//
// direction where the light comes from, or the eye is; unit, on the side of normal
// normal    unit
// eta       n_t / n_i, above 0
vec3 refracted_direction(vec3 direction, vec3 normal, float eta) {
    float cos_i = dot(normal, direction);
    float g2 = (eta - 1.0) * (eta + 1.0) + cos_i * cos_i;
    float cos_t = g2 <= 0.0 ? 0.0 : min(sqrt(g2) / eta, 1.0);
    float scale = g2 < 0.0 ? 0.0 : 1.0 / eta;
    float down = g2 < 0.0 ? 0.0 : cos_t;
    return -scale * (direction - cos_i * normal) - down * normal;
}
`, []);

export const refractedCosine = /*@__PURE__*/ native(/* wgsl */ `
// Snell's law: cosine of the transmitted ray, 0 beyond the critical angle.
//
//   cos_t = sqrt(eta^2 - 1 + cos_i^2) / eta
//
// eta       n_t / n_i, above 0
// cos_i     cosine of incidence, [0, 1]
fn refracted_cosine(eta: f32, cos_i: f32) -> f32 {
    let g2 = (eta - 1.0) * (eta + 1.0) + cos_i * cos_i;
    return select(min(sqrt(g2) / eta, 1.0), 0.0, g2 <= 0.0);
}
`, /* glsl */ `
// Snell's law: cosine of the transmitted ray, 0 beyond the critical angle.
//
//   cos_t = sqrt(eta^2 - 1 + cos_i^2) / eta
//
// eta       n_t / n_i, above 0
// cos_i     cosine of incidence, [0, 1]
float refracted_cosine(float eta, float cos_i) {
    float g2 = (eta - 1.0) * (eta + 1.0) + cos_i * cos_i;
    return g2 <= 0.0 ? 0.0 : min(sqrt(g2) / eta, 1.0);
}
`, []);

export const criticalCosine = /*@__PURE__*/ native(/* wgsl */ `
// Cosine of the critical angle, beyond which everything is reflected; 0 where there is none.
//
//   cos_c = sqrt(1 - eta^2)
//
// eta       n_t / n_i, above 0
fn critical_cosine(eta: f32) -> f32 {
    return select(0.0, sqrt((1.0 - eta) * (1.0 + eta)), eta < 1.0);
}
`, /* glsl */ `
// Cosine of the critical angle, beyond which everything is reflected; 0 where there is none.
//
//   cos_c = sqrt(1 - eta^2)
//
// eta       n_t / n_i, above 0
float critical_cosine(float eta) {
    return eta < 1.0 ? sqrt((1.0 - eta) * (1.0 + eta)) : 0.0;
}
`, []);

export const brewsterCosine = /*@__PURE__*/ native(/* wgsl */ `
// Cosine of Brewster's angle, at which p-polarised light is not reflected.
//
//   cos_B = 1 / sqrt(1 + eta^2)
//
// eta       n_t / n_i, above 0
fn brewster_cosine(eta: f32) -> f32 {
    return 1.0 / sqrt(1.0 + eta * eta);
}
`, /* glsl */ `
// Cosine of Brewster's angle, at which p-polarised light is not reflected.
//
//   cos_B = 1 / sqrt(1 + eta^2)
//
// eta       n_t / n_i, above 0
float brewster_cosine(float eta) {
    return 1.0 / sqrt(1.0 + eta * eta);
}
`, []);

export const f0FromEta = /*@__PURE__*/ native(/* wgsl */ `
// Reflectance at normal incidence.
//
//   f0 = ((eta - 1) / (eta + 1))^2
//
// eta       n_t / n_i, above 0
fn f0_from_eta(eta: f32) -> f32 {
    let t = (eta - 1.0) / (eta + 1.0);
    return t * t;
}
`, /* glsl */ `
// Reflectance at normal incidence.
//
//   f0 = ((eta - 1) / (eta + 1))^2
//
// eta       n_t / n_i, above 0
float f0_from_eta(float eta) {
    float t = (eta - 1.0) / (eta + 1.0);
    return t * t;
}
`, []);

export const etaFromF0 = /*@__PURE__*/ native(/* wgsl */ `
// The relative index above 1 that has this f0.
//
//   eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)
//
// f0        reflectance at normal incidence, [0, 1)
fn eta_from_f0(f0: f32) -> f32 {
    let t = 1.0 + sqrt(f0);
    return t * t / (1.0 - f0);
}
`, /* glsl */ `
// The relative index above 1 that has this f0.
//
//   eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)
//
// f0        reflectance at normal incidence, [0, 1)
float eta_from_f0(float f0) {
    float t = 1.0 + sqrt(f0);
    return t * t / (1.0 - f0);
}
`, []);

export const phongLobe = /*@__PURE__*/ native(/* wgsl */ `
// The lobe of Phong's highlight, to be multiplied by the reflectance.
//
//   max(cos_r, 0)^shininess
//
// cos_r     cosine between the view and the mirrored light, [-1, 1]
// shininess sharpness, above 0
fn phong_lobe(cos_r: f32, shininess: f32) -> f32 {
    return pow(max(cos_r, 0.0), shininess);
}
`, /* glsl */ `
// The lobe of Phong's highlight, to be multiplied by the reflectance.
//
//   max(cos_r, 0)^shininess
//
// cos_r     cosine between the view and the mirrored light, [-1, 1]
// shininess sharpness, above 0
float phong_lobe(float cos_r, float shininess) {
    return pow(max(cos_r, 0.0), shininess);
}
`, []);

export const opacityFresnel = /*@__PURE__*/ native(/* wgsl */ `
// Opacity by reflection: from the user's value to 1 at the silhouette.
//
//   a0 + (1 - a0) (1 - cos_i)^5
//
// a0        opacity by reflection seen along the normal, [0, 1]
// cos_i     cosine between view and normal, [0, 1]
fn opacity_fresnel(a0: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return a0 + (1.0 - a0) * (m2 * m2 * m);
}
`, /* glsl */ `
// Opacity by reflection: from the user's value to 1 at the silhouette.
//
//   a0 + (1 - a0) (1 - cos_i)^5
//
// a0        opacity by reflection seen along the normal, [0, 1]
// cos_i     cosine between view and normal, [0, 1]
float opacity_fresnel(float a0, float cos_i) {
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return a0 + (1.0 - a0) * (m2 * m2 * m);
}
`, []);

export const opacitySilhouette = /*@__PURE__*/ native(/* wgsl */ `
// Opacity by attenuation in a thin layer, in proportion to the path through it.
//
//   min(1, a / cos_i)
//
// a         opacity by attenuation seen along the normal, [0, 1]
// cos_i     cosine between view and normal, [0, 1]
fn opacity_silhouette(a: f32, cos_i: f32) -> f32 {
    return select(min(a / cos_i, 1.0), select(a, 1.0, a > 0.0), cos_i <= 0.0);
}
`, /* glsl */ `
// Opacity by attenuation in a thin layer, in proportion to the path through it.
//
//   min(1, a / cos_i)
//
// a         opacity by attenuation seen along the normal, [0, 1]
// cos_i     cosine between view and normal, [0, 1]
float opacity_silhouette(float a, float cos_i) {
    return cos_i <= 0.0 ? (a > 0.0 ? 1.0 : a) : min(a / cos_i, 1.0);
}
`, []);

export const opacityAttenuation = /*@__PURE__*/ native(/* wgsl */ `
// The opacity by attenuation that gives a layer a total opacity; negative where there is none.
//
//   (total - fresnel) / (1 - fresnel)
//
// total     opacity of the whole, [0, 1]
// fresnel   opacity by reflection, [0, 1)
fn opacity_attenuation(total: f32, fresnel: f32) -> f32 {
    return (total - fresnel) / (1.0 - fresnel);
}
`, /* glsl */ `
// The opacity by attenuation that gives a layer a total opacity; negative where there is none.
//
//   (total - fresnel) / (1 - fresnel)
//
// total     opacity of the whole, [0, 1]
// fresnel   opacity by reflection, [0, 1)
float opacity_attenuation(float total, float fresnel) {
    return (total - fresnel) / (1.0 - fresnel);
}
`, []);

export const opacityTotal = /*@__PURE__*/ native(/* wgsl */ `
// Opacity of a layer that attenuates and reflects.
//
//   1 - (1 - attenuation) (1 - fresnel)
//
// attenuation opacity by attenuation, [0, 1]
// fresnel   opacity by reflection, [0, 1]
fn opacity_total(attenuation: f32, fresnel: f32) -> f32 {
    return attenuation + fresnel * (1.0 - attenuation);
}
`, /* glsl */ `
// Opacity of a layer that attenuates and reflects.
//
//   1 - (1 - attenuation) (1 - fresnel)
//
// attenuation opacity by attenuation, [0, 1]
// fresnel   opacity by reflection, [0, 1]
float opacity_total(float attenuation, float fresnel) {
    return attenuation + fresnel * (1.0 - attenuation);
}
`, []);

export const dielectric = /*@__PURE__*/ native(/* wgsl */ `
// Exact reflectance between two transparent media, accurate in float everywhere.
//
//   R_s = E^2 / (E^2 + 4 c g (g + c)^2), R_p = R_s ((c g - s^2) / (c g + s^2))^2, E = eta^2 - 1,
//   g^2 = E + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 6e-2 at a critical angle
// cost    37 operations
// source  Fresnel 1823
fn dielectric(n_i: f32, n_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let s2 = n_i * (1.0 - cos_i * cos_i);
    let E = (n_t - n_i) * (n_t + n_i); // eta^2 - 1
    let g2 = E + c * c; // below 0 under total internal reflection
    let g = sqrt(max(g2, 1.1754944e-38)); // eta cos_t; so little there that R is 1
    let E2 = E * E;
    let cg = c * g;
    let a = 2.0 * (g + c);
    let a2 = a * a;
    let D_s = max(E2 + cg * a2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    let R_s = E2 / D_s;
    let x = cos_i * g;
    let b = x + s2;
    let q = (x - s2) / b;
    let R_p = R_s * (q * q);
    return (R_s + R_p) / 2.0;
}
`, /* glsl */ `
// Exact reflectance between two transparent media, accurate in float everywhere.
//
//   R_s = E^2 / (E^2 + 4 c g (g + c)^2), R_p = R_s ((c g - s^2) / (c g + s^2))^2, E = eta^2 - 1,
//   g^2 = E + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 6e-2 at a critical angle
// cost    37 operations
// source  Fresnel 1823
float dielectric(float n_i, float n_t, float cos_i) {
    float c = n_i * cos_i;
    float s2 = n_i * (1.0 - cos_i * cos_i);
    float E_ = (n_t - n_i) * (n_t + n_i); // eta^2 - 1
    float g2 = E_ + c * c; // below 0 under total internal reflection
    float g = sqrt(max(g2, 1.1754944e-38)); // eta cos_t; so little there that R is 1
    float E2 = E_ * E_;
    float cg = c * g;
    float a = 2.0 * (g + c);
    float a2 = a * a;
    float D_s = max(E2 + cg * a2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    float R_s = E2 / D_s;
    float x = cos_i * g;
    float b = x + s2;
    float q = (x - s2) / b;
    float R_p = R_s * (q * q);
    return (R_s + R_p) / 2.0;
}
`, []);

export const dielectricDir = /*@__PURE__*/ native(/* wgsl */ `
fn dielectric_dir(n_i: f32, n_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return dielectric(n_i, n_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float dielectric_dir(float n_i, float n_t, vec3 normal, vec3 direction) {
    return dielectric(n_i, n_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, dielectric]);

export const dielectricRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn dielectric_rgb(n_i: f32, n_t: vec3f, cos_i: f32) -> vec3f {
    let c = n_i * cos_i;
    let s2 = n_i * (1.0 - cos_i * cos_i);
    let E = (n_t - n_i) * (n_t + n_i); // eta^2 - 1
    let g2 = E + c * c; // below 0 under total internal reflection
    let g = sqrt(max(g2, vec3f(1.1754944e-38))); // eta cos_t; so little there that R is 1
    let E2 = E * E;
    let cg = c * g;
    let a = 2.0 * (g + c);
    let a2 = a * a;
    let D_s = max(E2 + cg * a2, vec3f(1.1754944e-38)); // 0 only for equal media at cos_i = 0
    let R_s = E2 / D_s;
    let x = cos_i * g;
    let b = x + s2;
    let q = (x - s2) / b;
    let R_p = R_s * (q * q);
    return (R_s + R_p) / 2.0;
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 dielectric_rgb(float n_i, vec3 n_t, float cos_i) {
    float c = n_i * cos_i;
    float s2 = n_i * (1.0 - cos_i * cos_i);
    vec3 E_ = (n_t - n_i) * (n_t + n_i); // eta^2 - 1
    vec3 g2 = E_ + c * c; // below 0 under total internal reflection
    vec3 g = sqrt(max(g2, vec3(1.1754944e-38))); // eta cos_t; so little there that R is 1
    vec3 E2 = E_ * E_;
    vec3 cg = c * g;
    vec3 a = 2.0 * (g + c);
    vec3 a2 = a * a;
    vec3 D_s = max(E2 + cg * a2, vec3(1.1754944e-38)); // 0 only for equal media at cos_i = 0
    vec3 R_s = E2 / D_s;
    vec3 x = cos_i * g;
    vec3 b = x + s2;
    vec3 q = (x - s2) / b;
    vec3 R_p = R_s * (q * q);
    return (R_s + R_p) / 2.0;
}
`, []);

export const dielectricRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn dielectric_rgb_dir(n_i: f32, n_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return dielectric_rgb(n_i, n_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 dielectric_rgb_dir(float n_i, vec3 n_t, vec3 normal, vec3 direction) {
    return dielectric_rgb(n_i, n_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, dielectricRgb]);

export const conductor = /*@__PURE__*/ native(/* wgsl */ `
// Exact reflectance of an absorbing medium seen from a transparent one, accurate in float everywhere.
//
//   R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 6e-2 at a critical angle of k_t = 0
// cost    67 operations
// source  Born and Wolf 1999, Principles of Optics, sec. 14.2
fn conductor(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let s4 = s2 * s2;
    let E = (n_t - n_i) * (n_t + n_i) - k_t * k_t; // Re m^2 - 1
    let Z = 2.0 * (n_t * k_t); // Im m^2
    let Z2 = Z * Z;
    let t0 = E + c2; // q^2 = t0 + i Z
    let A = sqrt(t0 * t0 + Z2); // |q|^2
    let S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    let u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    let a = select(S, Z, t0 <= 0.0); // u Re q
    let h = 2.0 * (a * c);
    let F = (E * E + Z2) * S; // |c - q|^2 |c + q|^2
    let G_s = (A + c2) * u + h;
    let D_s = max(F + h * G_s, 1.1754944e-38); // |c + q|^4; 0 only for equal media at cos_i = 0
    let R_s = F / D_s;
    let h_p = h * sin2;
    let N = t0 * cos2 - s4;
    let M = Z * cos2;
    let M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    let B = (N * N + M2) * S; // |q c - s^2|^2 |q c + s^2|^2
    let G_p = (A * cos2 + s4) * u + h_p;
    let D_p = B + h_p * G_p; // |q c + s^2|^4
    let R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}
`, /* glsl */ `
// Exact reflectance of an absorbing medium seen from a transparent one, accurate in float everywhere.
//
//   R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 6e-2 at a critical angle of k_t = 0
// cost    67 operations
// source  Born and Wolf 1999, Principles of Optics, sec. 14.2
float conductor(float n_i, float n_t, float k_t, float cos_i) {
    float c = n_i * cos_i;
    float c2 = c * c;
    float cos2 = cos_i * cos_i;
    float sin2 = 1.0 - cos2;
    float s2 = n_i * sin2;
    float s4 = s2 * s2;
    float E_ = (n_t - n_i) * (n_t + n_i) - k_t * k_t; // Re m^2 - 1
    float Z = 2.0 * (n_t * k_t); // Im m^2
    float Z2 = Z * Z;
    float t0 = E_ + c2; // q^2 = t0 + i Z
    float A = sqrt(t0 * t0 + Z2); // |q|^2
    float S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    float u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    float a = t0 <= 0.0 ? Z : S; // u Re q
    float h = 2.0 * (a * c);
    float F = (E_ * E_ + Z2) * S; // |c - q|^2 |c + q|^2
    float G_s = (A + c2) * u + h;
    float D_s = max(F + h * G_s, 1.1754944e-38); // |c + q|^4; 0 only for equal media at cos_i = 0
    float R_s = F / D_s;
    float h_p = h * sin2;
    float N = t0 * cos2 - s4;
    float M = Z * cos2;
    float M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    float B = (N * N + M2) * S; // |q c - s^2|^2 |q c + s^2|^2
    float G_p = (A * cos2 + s4) * u + h_p;
    float D_p = B + h_p * G_p; // |q c + s^2|^4
    float R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}
`, []);

export const conductorDir = /*@__PURE__*/ native(/* wgsl */ `
fn conductor_dir(n_i: f32, n_t: f32, k_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return conductor(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float conductor_dir(float n_i, float n_t, float k_t, vec3 normal, vec3 direction) {
    return conductor(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, conductor]);

export const conductorRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn conductor_rgb(n_i: f32, n_t: vec3f, k_t: vec3f, cos_i: f32) -> vec3f {
    return vec3f(conductor(n_i, n_t.x, k_t.x, cos_i), conductor(n_i, n_t.y, k_t.y, cos_i),
            conductor(n_i, n_t.z, k_t.z, cos_i));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 conductor_rgb(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
    return vec3(conductor(n_i, n_t.x, k_t.x, cos_i), conductor(n_i, n_t.y, k_t.y, cos_i),
            conductor(n_i, n_t.z, k_t.z, cos_i));
}
`, [conductor]);

export const conductorRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn conductor_rgb_dir(n_i: f32, n_t: vec3f, k_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return conductor_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 conductor_rgb_dir(float n_i, vec3 n_t, vec3 k_t, vec3 normal, vec3 direction) {
    return conductor_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, conductorRgb]);

export const dielectricFast = /*@__PURE__*/ native(/* wgsl */ `
// Exact reflectance between two transparent media in the fewest operations.
//
//   R_s = ((g - c) / (g + c))^2, R_p = R_s ((c g - s^2) / (c g + s^2))^2, g^2 = eta^2 - 1 + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 4e-6 for eta > 1.05, no digit left at 1 +- 1e-6
// cost    31 operations
// source  Cook and Torrance 1982
fn dielectric_fast(n_i: f32, n_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let sin2 = 1.0 - cos_i * cos_i;
    let s2 = n_i * sin2;
    let g2 = n_t * n_t - n_i * s2; // below 0 under total internal reflection
    let g = sqrt(abs(g2));
    let x = cos_i * g;
    let a = g + c;
    let b = x + s2;
    let r_s = (g - c) / a;
    let q = (x - s2) / b;
    let r2 = r_s * r_s;
    let R_p = r2 * (q * q);
    return select((r2 + R_p) / 2.0, 1.0, g2 <= 0.0);
}
`, /* glsl */ `
// Exact reflectance between two transparent media in the fewest operations.
//
//   R_s = ((g - c) / (g + c))^2, R_p = R_s ((c g - s^2) / (c g + s^2))^2, g^2 = eta^2 - 1 + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 4e-6 for eta > 1.05, no digit left at 1 +- 1e-6
// cost    31 operations
// source  Cook and Torrance 1982
float dielectric_fast(float n_i, float n_t, float cos_i) {
    float c = n_i * cos_i;
    float sin2 = 1.0 - cos_i * cos_i;
    float s2 = n_i * sin2;
    float g2 = n_t * n_t - n_i * s2; // below 0 under total internal reflection
    float g = sqrt(abs(g2));
    float x = cos_i * g;
    float a = g + c;
    float b = x + s2;
    float r_s = (g - c) / a;
    float q = (x - s2) / b;
    float r2 = r_s * r_s;
    float R_p = r2 * (q * q);
    return g2 <= 0.0 ? 1.0 : (r2 + R_p) / 2.0;
}
`, []);

export const dielectricFastDir = /*@__PURE__*/ native(/* wgsl */ `
fn dielectric_fast_dir(n_i: f32, n_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return dielectric_fast(n_i, n_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float dielectric_fast_dir(float n_i, float n_t, vec3 normal, vec3 direction) {
    return dielectric_fast(n_i, n_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, dielectricFast]);

export const dielectricFastRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn dielectric_fast_rgb(n_i: f32, n_t: vec3f, cos_i: f32) -> vec3f {
    return vec3f(dielectric_fast(n_i, n_t.x, cos_i), dielectric_fast(n_i, n_t.y, cos_i),
            dielectric_fast(n_i, n_t.z, cos_i));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 dielectric_fast_rgb(float n_i, vec3 n_t, float cos_i) {
    return vec3(dielectric_fast(n_i, n_t.x, cos_i), dielectric_fast(n_i, n_t.y, cos_i),
            dielectric_fast(n_i, n_t.z, cos_i));
}
`, [dielectricFast]);

export const dielectricFastRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn dielectric_fast_rgb_dir(n_i: f32, n_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return dielectric_fast_rgb(n_i, n_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 dielectric_fast_rgb_dir(float n_i, vec3 n_t, vec3 normal, vec3 direction) {
    return dielectric_fast_rgb(n_i, n_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, dielectricFastRgb]);

export const conductorFast = /*@__PURE__*/ native(/* wgsl */ `
// Exact reflectance of an absorbing medium in the fewest operations.
//
//   R_s = (t1 - t2) / (t1 + t2), R_p = R_s (t3 - t4) / (t3 + t4)
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 3e-6 for metals, 1e-4 for dielectrics, no digit left near an index match
// cost    50 operations
// source  Lagarde 2013, Memo on Fresnel equations, after Shirley
fn conductor_fast(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let t0 = n_t * n_t - n_i * n_i - k_t * k_t + c2;
    let nk2 = 2.0 * (n_t * k_t);
    let A = sqrt(t0 * t0 + nk2 * nk2); // a^2 + b^2
    let a2 = 2.0 * (A + t0); // (2 a)^2
    let a = sqrt(max(a2, 1.1754944e-38));
    let t1 = A + c2;
    let t2 = a * c;
    let t3 = cos2 * A + (s2 * s2 + 1.1754944e-38); // above 0 where n_t << n_i, at cos_i = 1
    let t4 = t2 * sin2;
    let D_s = max(t1 + t2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    let D_p = t3 + t4;
    let R_s = abs((t1 - t2) / D_s); // rounding may bring it below 0
    let R_p = R_s * abs((t3 - t4) / D_p);
    return (R_s + R_p) / 2.0;
}
`, /* glsl */ `
// Exact reflectance of an absorbing medium in the fewest operations.
//
//   R_s = (t1 - t2) / (t1 + t2), R_p = R_s (t3 - t4) / (t3 + t4)
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 3e-6 for metals, 1e-4 for dielectrics, no digit left near an index match
// cost    50 operations
// source  Lagarde 2013, Memo on Fresnel equations, after Shirley
float conductor_fast(float n_i, float n_t, float k_t, float cos_i) {
    float c = n_i * cos_i;
    float c2 = c * c;
    float cos2 = cos_i * cos_i;
    float sin2 = 1.0 - cos2;
    float s2 = n_i * sin2;
    float t0 = n_t * n_t - n_i * n_i - k_t * k_t + c2;
    float nk2 = 2.0 * (n_t * k_t);
    float A = sqrt(t0 * t0 + nk2 * nk2); // a^2 + b^2
    float a2 = 2.0 * (A + t0); // (2 a)^2
    float a = sqrt(max(a2, 1.1754944e-38));
    float t1 = A + c2;
    float t2 = a * c;
    float t3 = cos2 * A + (s2 * s2 + 1.1754944e-38); // above 0 where n_t << n_i, at cos_i = 1
    float t4 = t2 * sin2;
    float D_s = max(t1 + t2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    float D_p = t3 + t4;
    float R_s = abs((t1 - t2) / D_s); // rounding may bring it below 0
    float R_p = R_s * abs((t3 - t4) / D_p);
    return (R_s + R_p) / 2.0;
}
`, []);

export const conductorFastDir = /*@__PURE__*/ native(/* wgsl */ `
fn conductor_fast_dir(n_i: f32, n_t: f32, k_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return conductor_fast(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float conductor_fast_dir(float n_i, float n_t, float k_t, vec3 normal, vec3 direction) {
    return conductor_fast(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, conductorFast]);

export const conductorFastRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn conductor_fast_rgb(n_i: f32, n_t: vec3f, k_t: vec3f, cos_i: f32) -> vec3f {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let t0 = n_t * n_t - n_i * n_i - k_t * k_t + c2;
    let nk2 = 2.0 * (n_t * k_t);
    let A = sqrt(t0 * t0 + nk2 * nk2); // a^2 + b^2
    let a2 = 2.0 * (A + t0); // (2 a)^2
    let a = sqrt(max(a2, vec3f(1.1754944e-38)));
    let t1 = A + c2;
    let t2 = a * c;
    let t3 = cos2 * A + (s2 * s2 + 1.1754944e-38); // above 0 where n_t << n_i, at cos_i = 1
    let t4 = t2 * sin2;
    let D_s = max(t1 + t2, vec3f(1.1754944e-38)); // 0 only for equal media at cos_i = 0
    let D_p = t3 + t4;
    let R_s = abs((t1 - t2) / D_s); // rounding may bring it below 0
    let R_p = R_s * abs((t3 - t4) / D_p);
    return (R_s + R_p) / 2.0;
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 conductor_fast_rgb(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
    float c = n_i * cos_i;
    float c2 = c * c;
    float cos2 = cos_i * cos_i;
    float sin2 = 1.0 - cos2;
    float s2 = n_i * sin2;
    vec3 t0 = n_t * n_t - n_i * n_i - k_t * k_t + c2;
    vec3 nk2 = 2.0 * (n_t * k_t);
    vec3 A = sqrt(t0 * t0 + nk2 * nk2); // a^2 + b^2
    vec3 a2 = 2.0 * (A + t0); // (2 a)^2
    vec3 a = sqrt(max(a2, vec3(1.1754944e-38)));
    vec3 t1 = A + c2;
    vec3 t2 = a * c;
    vec3 t3 = cos2 * A + (s2 * s2 + 1.1754944e-38); // above 0 where n_t << n_i, at cos_i = 1
    vec3 t4 = t2 * sin2;
    vec3 D_s = max(t1 + t2, vec3(1.1754944e-38)); // 0 only for equal media at cos_i = 0
    vec3 D_p = t3 + t4;
    vec3 R_s = abs((t1 - t2) / D_s); // rounding may bring it below 0
    vec3 R_p = R_s * abs((t3 - t4) / D_p);
    return (R_s + R_p) / 2.0;
}
`, []);

export const conductorFastRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn conductor_fast_rgb_dir(n_i: f32, n_t: vec3f, k_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return conductor_fast_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 conductor_fast_rgb_dir(float n_i, vec3 n_t, vec3 k_t, vec3 normal, vec3 direction) {
    return conductor_fast_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, conductorFastRgb]);

export const conductorPrecise = /*@__PURE__*/ native(/* wgsl */ `
// Exact reflectance of any medium, with the two sums that cancel in twice the digits.
//
//   F = as conductor, with the sums that cancel in twice the digits
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 1e-6
// cost    304 operations
// source  Born and Wolf 1999; Knuth 1969; Dekker 1971
fn conductor_precise(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> f32 {
    let n_t2 = n_t * n_t;
    let k_t2 = k_t * k_t;
    let t = n_t2 + (-k_t2);
    let t_2 = t - n_t2;
    let t_3 = 4097.0 * n_t;
    let t_4 = t_3 - (t_3 - n_t);
    let t_5 = n_t - t_4;
    let t_6 = t_4 * t_5;
    let t_7 = t_4 * t_4 - n_t2 + t_6 + t_6 + t_5 * t_5;
    let t_8 = 4097.0 * k_t;
    let t_9 = t_8 - (t_8 - k_t);
    let t_10 = k_t - t_9;
    let t_11 = t_9 * t_10;
    let t_12 = t_9 * t_9 - k_t2 + t_11 + t_11 + t_10 * t_10;
    let t_13 = t_7 + (-t_12);
    let t_14 = n_t2 - (t - t_2) + (-k_t2 - t_2) + t_13;
    let t_15 = t + t_14;
    let t_16 = t_15 - t;
    let t_17 = t_13 - t_7;
    let t_18 = t - (t_15 - t_16) + (t_14 - t_16) + (t_7 - (t_13 - t_17) + (-t_12 - t_17));
    let t_19 = t_15 + t_18;
    let n_i2 = n_i * n_i;
    let t_20 = t_19 + (-n_i2);
    let t_21 = t_20 - t_19;
    let t_22 = t_19 - t_15;
    let t_23 = t_15 - (t_19 - t_22) + (t_18 - t_22);
    let t_24 = 4097.0 * n_i;
    let t_25 = t_24 - (t_24 - n_i);
    let t_26 = n_i - t_25;
    let t_27 = t_25 * t_26;
    let t_28 = t_25 * t_25 - n_i2 + t_27 + t_27 + t_26 * t_26;
    let t_29 = t_23 + (-t_28);
    let t_30 = t_19 - (t_20 - t_21) + (-n_i2 - t_21) + t_29;
    let t_31 = t_20 + t_30;
    let t_32 = t_31 - t_20;
    let t_33 = t_29 - t_23;
    let t_34 = t_20 - (t_31 - t_32) + (t_30 - t_32) + (t_23 - (t_29 - t_33) + (-t_28 - t_33));
    let t_35 = t_31 + t_34;
    let cos2 = cos_i * cos_i;
    let t_36 = n_i2 * cos2;
    let t_37 = 4097.0 * n_i2;
    let t_38 = t_37 - (t_37 - n_i2);
    let t_39 = 4097.0 * cos2;
    let t_40 = t_39 - (t_39 - cos2);
    let t_41 = cos2 - t_40;
    let t_42 = n_i2 - t_38;
    let t_43 = 4097.0 * cos_i;
    let t_44 = t_43 - (t_43 - cos_i);
    let t_45 = cos_i - t_44;
    let t_46 = t_44 * t_45;
    let t_47 = t_44 * t_44 - cos2 + t_46 + t_46 + t_45 * t_45;
    let t_48 = t_38 * t_40 - t_36 + t_38 * t_41 + t_42 * t_40 + t_42 * t_41 + (n_i2 * t_47 + t_28 * cos2);
    let t_49 = t_36 + t_48;
    let t_50 = t_35 + t_49;
    let t_51 = t_50 - t_35;
    let t_52 = t_35 - t_31;
    let t_53 = t_31 - (t_35 - t_52) + (t_34 - t_52);
    let t_54 = t_49 - t_36;
    let t_55 = t_36 - (t_49 - t_54) + (t_48 - t_54);
    let t_56 = t_53 + t_55;
    let t_57 = t_35 - (t_50 - t_51) + (t_49 - t_51) + t_56;
    let t_58 = t_50 + t_57;
    let t_59 = t_58 - t_50;
    let t_60 = t_56 - t_53;
    let t_61 = t_58 + (t_50 - (t_58 - t_59) + (t_57 - t_59) + (t_53 - (t_56 - t_60) + (t_55 - t_60)));
    let t_62 = n_t * k_t;
    let t_63 = abs(t_61);
    let t_64 = sqrt((max(sqrt(t_61 * t_61 + 4.0 * (t_62 * t_62)), t_63) + t_63) / 2.0);
    let t_65 = t_62 / select(1.0, t_64, t_64 > 0.0);
    let t_66 = select(t_64, t_65, t_61 < 0.0);
    let t_67 = n_i * cos_i;
    let t_68 = t_66 - t_67;
    let t_69 = select(t_65, t_64, t_61 < 0.0);
    let t_70 = t_69 * t_69;
    let t_71 = t_66 + t_67;
    let t_72 = select(t_68, (t_35 + t_70) / t_71, max(2.0 * abs(t_68), t_69) < t_67);
    let t_73 = t_71 * t_71 + t_70;
    let t_74 = (t_72 * t_72 + t_70) / select(t_73, 1.0, t_73 <= 0.0);
    let t_75 = t_66 * cos_i;
    let t_76 = n_i * ((1.0 - cos_i) * (1.0 + cos_i));
    let t_77 = t_75 - t_76;
    let t_78 = n_t2 + n_i2;
    let t_79 = t_78 - n_t2;
    let t_80 = t_7 + t_28;
    let t_81 = n_t2 - (t_78 - t_79) + (n_i2 - t_79) + t_80;
    let t_82 = t_78 + t_81;
    let t_83 = t_82 - t_78;
    let t_84 = t_80 - t_7;
    let t_85 = t_78 - (t_82 - t_83) + (t_81 - t_83) + (t_7 - (t_80 - t_84) + (t_28 - t_84));
    let t_86 = t_82 + t_85;
    let t_87 = cos2 * t_86;
    let t_88 = 4097.0 * t_86;
    let t_89 = t_88 - (t_88 - t_86);
    let t_90 = t_86 - t_89;
    let t_91 = t_86 - t_82;
    let t_92 = t_40 * t_89 - t_87 + t_40 * t_90 + t_41 * t_89 + t_41 * t_90 +
            (cos2 * (t_82 - (t_86 - t_91) + (t_85 - t_91)) + t_47 * t_86);
    let t_93 = t_87 + t_92;
    let t_94 = t_93 + (-n_i2);
    let t_95 = t_94 - t_93;
    let t_96 = t_93 - t_87;
    let t_97 = t_87 - (t_93 - t_96) + (t_92 - t_96);
    let t_98 = t_97 + (-t_28);
    let t_99 = t_93 - (t_94 - t_95) + (-n_i2 - t_95) + t_98;
    let t_100 = t_94 + t_99;
    let t_101 = t_100 - t_94;
    let t_102 = t_98 - t_97;
    let t_103 = t_75 + t_76;
    let t_104 = select(t_103, 1.0, t_103 <= 0.0);
    let t_105 = select(t_77, (t_100 +
            (t_94 - (t_100 - t_101) + (t_99 - t_101) + (t_97 - (t_98 - t_102) + (-t_28 - t_102))) +
            cos2 * (t_70 - k_t2)) / t_104, max(2.0 * abs(t_77) - t_76, 2.0 * t_69 - n_i) < 0.0);
    let t_106 = t_69 * cos_i;
    let t_107 = t_106 * t_106;
    return (min(t_74, 1.0) + min(t_74 * ((t_105 * t_105 + t_107) / (t_104 * t_104 + t_107)), 1.0)) / 2.0;
}
`, /* glsl */ `
// Exact reflectance of any medium, with the two sums that cancel in twice the digits.
//
//   F = as conductor, with the sums that cancel in twice the digits
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 1e-6
// cost    304 operations
// source  Born and Wolf 1999; Knuth 1969; Dekker 1971
float conductor_precise(float n_i, float n_t, float k_t, float cos_i) {
    float n_t2 = n_t * n_t;
    float k_t2 = k_t * k_t;
    float t = n_t2 + (-k_t2);
    float t_2 = t - n_t2;
    float t_3 = 4097.0 * n_t;
    float t_4 = t_3 - (t_3 - n_t);
    float t_5 = n_t - t_4;
    float t_6 = t_4 * t_5;
    float t_7 = t_4 * t_4 - n_t2 + t_6 + t_6 + t_5 * t_5;
    float t_8 = 4097.0 * k_t;
    float t_9 = t_8 - (t_8 - k_t);
    float t_10 = k_t - t_9;
    float t_11 = t_9 * t_10;
    float t_12 = t_9 * t_9 - k_t2 + t_11 + t_11 + t_10 * t_10;
    float t_13 = t_7 + (-t_12);
    float t_14 = n_t2 - (t - t_2) + (-k_t2 - t_2) + t_13;
    float t_15 = t + t_14;
    float t_16 = t_15 - t;
    float t_17 = t_13 - t_7;
    float t_18 = t - (t_15 - t_16) + (t_14 - t_16) + (t_7 - (t_13 - t_17) + (-t_12 - t_17));
    float t_19 = t_15 + t_18;
    float n_i2 = n_i * n_i;
    float t_20 = t_19 + (-n_i2);
    float t_21 = t_20 - t_19;
    float t_22 = t_19 - t_15;
    float t_23 = t_15 - (t_19 - t_22) + (t_18 - t_22);
    float t_24 = 4097.0 * n_i;
    float t_25 = t_24 - (t_24 - n_i);
    float t_26 = n_i - t_25;
    float t_27 = t_25 * t_26;
    float t_28 = t_25 * t_25 - n_i2 + t_27 + t_27 + t_26 * t_26;
    float t_29 = t_23 + (-t_28);
    float t_30 = t_19 - (t_20 - t_21) + (-n_i2 - t_21) + t_29;
    float t_31 = t_20 + t_30;
    float t_32 = t_31 - t_20;
    float t_33 = t_29 - t_23;
    float t_34 = t_20 - (t_31 - t_32) + (t_30 - t_32) + (t_23 - (t_29 - t_33) + (-t_28 - t_33));
    float t_35 = t_31 + t_34;
    float cos2 = cos_i * cos_i;
    float t_36 = n_i2 * cos2;
    float t_37 = 4097.0 * n_i2;
    float t_38 = t_37 - (t_37 - n_i2);
    float t_39 = 4097.0 * cos2;
    float t_40 = t_39 - (t_39 - cos2);
    float t_41 = cos2 - t_40;
    float t_42 = n_i2 - t_38;
    float t_43 = 4097.0 * cos_i;
    float t_44 = t_43 - (t_43 - cos_i);
    float t_45 = cos_i - t_44;
    float t_46 = t_44 * t_45;
    float t_47 = t_44 * t_44 - cos2 + t_46 + t_46 + t_45 * t_45;
    float t_48 = t_38 * t_40 - t_36 + t_38 * t_41 + t_42 * t_40 + t_42 * t_41 + (n_i2 * t_47 + t_28 * cos2);
    float t_49 = t_36 + t_48;
    float t_50 = t_35 + t_49;
    float t_51 = t_50 - t_35;
    float t_52 = t_35 - t_31;
    float t_53 = t_31 - (t_35 - t_52) + (t_34 - t_52);
    float t_54 = t_49 - t_36;
    float t_55 = t_36 - (t_49 - t_54) + (t_48 - t_54);
    float t_56 = t_53 + t_55;
    float t_57 = t_35 - (t_50 - t_51) + (t_49 - t_51) + t_56;
    float t_58 = t_50 + t_57;
    float t_59 = t_58 - t_50;
    float t_60 = t_56 - t_53;
    float t_61 = t_58 + (t_50 - (t_58 - t_59) + (t_57 - t_59) + (t_53 - (t_56 - t_60) + (t_55 - t_60)));
    float t_62 = n_t * k_t;
    float t_63 = abs(t_61);
    float t_64 = sqrt((max(sqrt(t_61 * t_61 + 4.0 * (t_62 * t_62)), t_63) + t_63) / 2.0);
    float t_65 = t_62 / (t_64 > 0.0 ? t_64 : 1.0);
    float t_66 = t_61 < 0.0 ? t_65 : t_64;
    float t_67 = n_i * cos_i;
    float t_68 = t_66 - t_67;
    float t_69 = t_61 < 0.0 ? t_64 : t_65;
    float t_70 = t_69 * t_69;
    float t_71 = t_66 + t_67;
    float t_72 = max(2.0 * abs(t_68), t_69) < t_67 ? (t_35 + t_70) / t_71 : t_68;
    float t_73 = t_71 * t_71 + t_70;
    float t_74 = (t_72 * t_72 + t_70) / (t_73 <= 0.0 ? 1.0 : t_73);
    float t_75 = t_66 * cos_i;
    float t_76 = n_i * ((1.0 - cos_i) * (1.0 + cos_i));
    float t_77 = t_75 - t_76;
    float t_78 = n_t2 + n_i2;
    float t_79 = t_78 - n_t2;
    float t_80 = t_7 + t_28;
    float t_81 = n_t2 - (t_78 - t_79) + (n_i2 - t_79) + t_80;
    float t_82 = t_78 + t_81;
    float t_83 = t_82 - t_78;
    float t_84 = t_80 - t_7;
    float t_85 = t_78 - (t_82 - t_83) + (t_81 - t_83) + (t_7 - (t_80 - t_84) + (t_28 - t_84));
    float t_86 = t_82 + t_85;
    float t_87 = cos2 * t_86;
    float t_88 = 4097.0 * t_86;
    float t_89 = t_88 - (t_88 - t_86);
    float t_90 = t_86 - t_89;
    float t_91 = t_86 - t_82;
    float t_92 = t_40 * t_89 - t_87 + t_40 * t_90 + t_41 * t_89 + t_41 * t_90 +
            (cos2 * (t_82 - (t_86 - t_91) + (t_85 - t_91)) + t_47 * t_86);
    float t_93 = t_87 + t_92;
    float t_94 = t_93 + (-n_i2);
    float t_95 = t_94 - t_93;
    float t_96 = t_93 - t_87;
    float t_97 = t_87 - (t_93 - t_96) + (t_92 - t_96);
    float t_98 = t_97 + (-t_28);
    float t_99 = t_93 - (t_94 - t_95) + (-n_i2 - t_95) + t_98;
    float t_100 = t_94 + t_99;
    float t_101 = t_100 - t_94;
    float t_102 = t_98 - t_97;
    float t_103 = t_75 + t_76;
    float t_104 = t_103 <= 0.0 ? 1.0 : t_103;
    float t_105 = max(2.0 * abs(t_77) - t_76, 2.0 * t_69 - n_i) < 0.0 ?
            (t_100 + (t_94 - (t_100 - t_101) + (t_99 - t_101) + (t_97 - (t_98 - t_102) + (-t_28 - t_102))) +
            cos2 * (t_70 - k_t2)) / t_104 : t_77;
    float t_106 = t_69 * cos_i;
    float t_107 = t_106 * t_106;
    return (min(t_74, 1.0) + min(t_74 * ((t_105 * t_105 + t_107) / (t_104 * t_104 + t_107)), 1.0)) / 2.0;
}
`, []);

export const conductorPreciseDir = /*@__PURE__*/ native(/* wgsl */ `
fn conductor_precise_dir(n_i: f32, n_t: f32, k_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return conductor_precise(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float conductor_precise_dir(float n_i, float n_t, float k_t, vec3 normal, vec3 direction) {
    return conductor_precise(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, conductorPrecise]);

export const conductorPreciseRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn conductor_precise_rgb(n_i: f32, n_t: vec3f, k_t: vec3f, cos_i: f32) -> vec3f {
    return vec3f(conductor_precise(n_i, n_t.x, k_t.x, cos_i), conductor_precise(n_i, n_t.y, k_t.y, cos_i),
            conductor_precise(n_i, n_t.z, k_t.z, cos_i));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 conductor_precise_rgb(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
    return vec3(conductor_precise(n_i, n_t.x, k_t.x, cos_i), conductor_precise(n_i, n_t.y, k_t.y, cos_i),
            conductor_precise(n_i, n_t.z, k_t.z, cos_i));
}
`, [conductorPrecise]);

export const conductorPreciseRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn conductor_precise_rgb_dir(n_i: f32, n_t: vec3f, k_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return conductor_precise_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 conductor_precise_rgb_dir(float n_i, vec3 n_t, vec3 k_t, vec3 normal, vec3 direction) {
    return conductor_precise_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}
`, [incidenceCosine, conductorPreciseRgb]);

export const schlick = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation.
//
//   F = f0 + (1 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering
fn schlick(f0: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}
`, /* glsl */ `
// Schlick's approximation.
//
//   F = f0 + (1 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering
float schlick(float f0, float cos_i) {
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}
`, []);

export const schlickDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float schlick_dir(float f0, vec3 normal, vec3 direction) {
    return schlick(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlick]);

export const schlickRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn schlick_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 schlick_rgb(vec3 f0, float cos_i) {
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}
`, []);

export const schlickRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_rgb(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 schlick_rgb_dir(vec3 f0, vec3 normal, vec3 direction) {
    return schlick_rgb(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickRgb]);

export const schlickF90 = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation with any reflectance at grazing incidence.
//
//   F = f0 + (f90 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994; Real-Time Rendering, 4th ed., eq. 9.18
fn schlick_f90(f0: f32, f90: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}
`, /* glsl */ `
// Schlick's approximation with any reflectance at grazing incidence.
//
//   F = f0 + (f90 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994; Real-Time Rendering, 4th ed., eq. 9.18
float schlick_f90(float f0, float f90, float cos_i) {
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}
`, []);

export const schlickF90Dir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_f90_dir(f0: f32, f90: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_f90(f0, f90, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float schlick_f90_dir(float f0, float f90, vec3 normal, vec3 direction) {
    return schlick_f90(f0, f90, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickF90]);

export const schlickF90Rgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn schlick_f90_rgb(f0: vec3f, f90: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 schlick_f90_rgb(vec3 f0, vec3 f90, float cos_i) {
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}
`, []);

export const schlickF90RgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_f90_rgb_dir(f0: vec3f, f90: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_f90_rgb(f0, f90, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 schlick_f90_rgb_dir(vec3 f0, vec3 f90, vec3 normal, vec3 direction) {
    return schlick_f90_rgb(f0, f90, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickF90Rgb]);

export const schlickPower = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation with the power left free.
//
//   F = f0 + (f90 - f0) x^power, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.123, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    13 operations
// source  Real-Time Rendering, 4th ed., eq. 9.18
fn schlick_power(f0: f32, f90: f32, power: f32, cos_i: f32) -> f32 {
    return f0 + (f90 - f0) * pow(1.0 - cos_i, power);
}
`, /* glsl */ `
// Schlick's approximation with the power left free.
//
//   F = f0 + (f90 - f0) x^power, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.123, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    13 operations
// source  Real-Time Rendering, 4th ed., eq. 9.18
float schlick_power(float f0, float f90, float power, float cos_i) {
    return f0 + (f90 - f0) * pow(1.0 - cos_i, power);
}
`, []);

export const schlickPowerDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_power_dir(f0: f32, f90: f32, power: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_power(f0, f90, power, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float schlick_power_dir(float f0, float f90, float power, vec3 normal, vec3 direction) {
    return schlick_power(f0, f90, power, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickPower]);

export const schlickPowerRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn schlick_power_rgb(f0: vec3f, f90: vec3f, power: vec3f, cos_i: f32) -> vec3f {
    return f0 + (f90 - f0) * pow(vec3f(1.0 - cos_i), power);
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 schlick_power_rgb(vec3 f0, vec3 f90, vec3 power, float cos_i) {
    return f0 + (f90 - f0) * pow(vec3(1.0 - cos_i), power);
}
`, []);

export const schlickPowerRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_power_rgb_dir(f0: vec3f, f90: vec3f, power: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_power_rgb(f0, f90, power, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 schlick_power_rgb_dir(vec3 f0, vec3 f90, vec3 power, vec3 normal, vec3 direction) {
    return schlick_power_rgb(f0, f90, power, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickPowerRgb]);

export const schlickNk = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation written in n and k.
//
//   F = ((n - 1)^2 + 4 n x^5 + k^2) / ((n + 1)^2 + k^2), x = 1 - cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.255, certified: n in [0.1, 4], k in [1, 8]
// cost    19 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
fn schlick_nk(n: f32, k: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let m2 = m * m;
    let n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2), 1.0);
}
`, /* glsl */ `
// Schlick's approximation written in n and k.
//
//   F = ((n - 1)^2 + 4 n x^5 + k^2) / ((n + 1)^2 + k^2), x = 1 - cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.255, certified: n in [0.1, 4], k in [1, 8]
// cost    19 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
float schlick_nk(float n, float k, float cos_i) {
    float m = 1.0 - cos_i;
    float n_minus_1 = n - 1.0;
    float k2 = k * k;
    float m2 = m * m;
    float n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2), 1.0);
}
`, []);

export const schlickNkDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_nk_dir(n: f32, k: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_nk(n, k, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float schlick_nk_dir(float n, float k, vec3 normal, vec3 direction) {
    return schlick_nk(n, k, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickNk]);

export const schlickNkRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn schlick_nk_rgb(n: vec3f, k: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let m2 = m * m;
    let n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            vec3f(1.0));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 schlick_nk_rgb(vec3 n, vec3 k, float cos_i) {
    float m = 1.0 - cos_i;
    vec3 n_minus_1 = n - 1.0;
    vec3 k2 = k * k;
    float m2 = m * m;
    vec3 n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            vec3(1.0));
}
`, []);

export const schlickNkRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_nk_rgb_dir(n: vec3f, k: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_nk_rgb(n, k, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 schlick_nk_rgb_dir(vec3 n, vec3 k, vec3 normal, vec3 direction) {
    return schlick_nk_rgb(n, k, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickNkRgb]);

export const schlickInternal = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation from inside a denser medium.
//
//   F = schlick(f0, cos_t), f0 = ((1 - eta) / (1 + eta))^2; 1 beyond the critical angle
//
// eta     n_t / n_i, [0.01, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: 1 / eta in [1.3, 2.5], from inside
// cost    28 operations
// source  Lagarde 2013, Memo on Fresnel equations
fn schlick_internal(eta: f32, cos_i: f32) -> f32 {
    let eta_minus_1 = eta - 1.0;
    let eta_plus_1 = eta + 1.0;
    let t = eta_minus_1 / eta_plus_1;
    let f0 = t * t;
    let g2 = eta_minus_1 * eta_plus_1 + cos_i * cos_i;
    let cos_t = select(min(sqrt(g2) / eta, 1.0), 0.0, g2 <= 0.0);
    let m = 1.0 - cos_t;
    let m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}
`, /* glsl */ `
// Schlick's approximation from inside a denser medium.
//
//   F = schlick(f0, cos_t), f0 = ((1 - eta) / (1 + eta))^2; 1 beyond the critical angle
//
// eta     n_t / n_i, [0.01, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: 1 / eta in [1.3, 2.5], from inside
// cost    28 operations
// source  Lagarde 2013, Memo on Fresnel equations
float schlick_internal(float eta, float cos_i) {
    float eta_minus_1 = eta - 1.0;
    float eta_plus_1 = eta + 1.0;
    float t = eta_minus_1 / eta_plus_1;
    float f0 = t * t;
    float g2 = eta_minus_1 * eta_plus_1 + cos_i * cos_i;
    float cos_t = g2 <= 0.0 ? 0.0 : min(sqrt(g2) / eta, 1.0);
    float m = 1.0 - cos_t;
    float m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}
`, []);

export const schlickInternalDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_internal_dir(eta: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_internal(eta, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float schlick_internal_dir(float eta, vec3 normal, vec3 direction) {
    return schlick_internal(eta, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickInternal]);

export const schlickInternalRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn schlick_internal_rgb(eta: vec3f, cos_i: f32) -> vec3f {
    return vec3f(schlick_internal(eta.x, cos_i), schlick_internal(eta.y, cos_i),
            schlick_internal(eta.z, cos_i));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 schlick_internal_rgb(vec3 eta, float cos_i) {
    return vec3(schlick_internal(eta.x, cos_i), schlick_internal(eta.y, cos_i),
            schlick_internal(eta.z, cos_i));
}
`, [schlickInternal]);

export const schlickInternalRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn schlick_internal_rgb_dir(eta: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_internal_rgb(eta, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 schlick_internal_rgb_dir(vec3 eta, vec3 normal, vec3 direction) {
    return schlick_internal_rgb(eta, incidence_cosine(normal, direction));
}
`, [incidenceCosine, schlickInternalRgb]);

export const sphericalGaussian = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's curve by a spherical Gaussian.
//
//   F = f0 + (1 - f0) 2^((-5.55473 cos_i - 6.98316) cos_i)
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0846, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    10 operations
// source  Lagarde 2012, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel
fn spherical_gaussian(f0: f32, cos_i: f32) -> f32 {
    let p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}
`, /* glsl */ `
// Schlick's curve by a spherical Gaussian.
//
//   F = f0 + (1 - f0) 2^((-5.55473 cos_i - 6.98316) cos_i)
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0846, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    10 operations
// source  Lagarde 2012, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel
float spherical_gaussian(float f0, float cos_i) {
    float p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}
`, []);

export const sphericalGaussianDir = /*@__PURE__*/ native(/* wgsl */ `
fn spherical_gaussian_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return spherical_gaussian(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float spherical_gaussian_dir(float f0, vec3 normal, vec3 direction) {
    return spherical_gaussian(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, sphericalGaussian]);

export const sphericalGaussianRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn spherical_gaussian_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 spherical_gaussian_rgb(vec3 f0, float cos_i) {
    float p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}
`, []);

export const sphericalGaussianRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn spherical_gaussian_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return spherical_gaussian_rgb(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 spherical_gaussian_rgb_dir(vec3 f0, vec3 normal, vec3 direction) {
    return spherical_gaussian_rgb(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, sphericalGaussianRgb]);

export const photometric = /*@__PURE__*/ native(/* wgsl */ `
// A curve found by symbolic regression.
//
//   F = f0 + (x - f0) x^4, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0708, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    6 operations
// source  photometric.io, Improving Schlick's Approximation
fn photometric(f0: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (m - f0) * (m2 * m2);
}
`, /* glsl */ `
// A curve found by symbolic regression.
//
//   F = f0 + (x - f0) x^4, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0708, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    6 operations
// source  photometric.io, Improving Schlick's Approximation
float photometric(float f0, float cos_i) {
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return f0 + (m - f0) * (m2 * m2);
}
`, []);

export const photometricDir = /*@__PURE__*/ native(/* wgsl */ `
fn photometric_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return photometric(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float photometric_dir(float f0, vec3 normal, vec3 direction) {
    return photometric(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, photometric]);

export const photometricRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn photometric_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (m - f0) * (m2 * m2);
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 photometric_rgb(vec3 f0, float cos_i) {
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return f0 + (m - f0) * (m2 * m2);
}
`, []);

export const photometricRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn photometric_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return photometric_rgb(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 photometric_rgb_dir(vec3 f0, vec3 normal, vec3 direction) {
    return photometric_rgb(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, photometricRgb]);

export const powers48 = /*@__PURE__*/ native(/* wgsl */ `
// Two powers at Schlick's cost, better on dielectrics.
//
//   F = f0 + x^4 ((a - f0) + (1 - a) x^4), a = 0.55, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0363, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    8 operations
// source  this library
fn powers_4_8(f0: f32, cos_i: f32) -> f32 {
    let one_minus_cos_i = 1.0 - cos_i;
    let t = one_minus_cos_i * one_minus_cos_i;
    let m4 = t * t;
    return f0 + m4 * (0.55 - f0 + 0.45 * m4);
}
`, /* glsl */ `
// Two powers at Schlick's cost, better on dielectrics.
//
//   F = f0 + x^4 ((a - f0) + (1 - a) x^4), a = 0.55, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0363, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    8 operations
// source  this library
float powers_4_8(float f0, float cos_i) {
    float one_minus_cos_i = 1.0 - cos_i;
    float t = one_minus_cos_i * one_minus_cos_i;
    float m4 = t * t;
    return f0 + m4 * (0.55 - f0 + 0.45 * m4);
}
`, []);

export const powers48Dir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_4_8_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_4_8(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float powers_4_8_dir(float f0, vec3 normal, vec3 direction) {
    return powers_4_8(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers48]);

export const powers48Rgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn powers_4_8_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let one_minus_cos_i = 1.0 - cos_i;
    let t = one_minus_cos_i * one_minus_cos_i;
    let m4 = t * t;
    return f0 + m4 * (0.55 - f0 + 0.45 * m4);
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 powers_4_8_rgb(vec3 f0, float cos_i) {
    float one_minus_cos_i = 1.0 - cos_i;
    float t = one_minus_cos_i * one_minus_cos_i;
    float m4 = t * t;
    return f0 + m4 * (0.55 - f0 + 0.45 * m4);
}
`, []);

export const powers48RgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_4_8_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_4_8_rgb(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 powers_4_8_rgb_dir(vec3 f0, vec3 normal, vec3 direction) {
    return powers_4_8_rgb(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers48Rgb]);

export const powers39 = /*@__PURE__*/ native(/* wgsl */ `
// Two powers, less than half of Schlick's error on dielectrics.
//
//   F = f0 + x^3 ((a - f0) + (1 - a) x^6), a = max(0.46, f0), x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0328, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    13 operations
// source  this library
fn powers_3_9(f0: f32, cos_i: f32) -> f32 {
    let a = max(0.46, f0);
    let m = 1.0 - cos_i;
    let m3 = m * m * m;
    return saturate(f0 + m3 * (a - f0 + (1.0 - a) * (m3 * m3)));
}
`, /* glsl */ `
// Two powers, less than half of Schlick's error on dielectrics.
//
//   F = f0 + x^3 ((a - f0) + (1 - a) x^6), a = max(0.46, f0), x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0328, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    13 operations
// source  this library
float powers_3_9(float f0, float cos_i) {
    float a = max(0.46, f0);
    float m = 1.0 - cos_i;
    float m3 = m * m * m;
    return clamp(f0 + m3 * (a - f0 + (1.0 - a) * (m3 * m3)), 0.0, 1.0);
}
`, []);

export const powers39Dir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_3_9_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_3_9(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float powers_3_9_dir(float f0, vec3 normal, vec3 direction) {
    return powers_3_9(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers39]);

export const powers39Rgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn powers_3_9_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let a = max(vec3f(0.46), f0);
    let m = 1.0 - cos_i;
    let m3 = m * m * m;
    return saturate(f0 + m3 * (a - f0 + (1.0 - a) * (m3 * m3)));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 powers_3_9_rgb(vec3 f0, float cos_i) {
    vec3 a = max(vec3(0.46), f0);
    float m = 1.0 - cos_i;
    float m3 = m * m * m;
    return clamp(f0 + m3 * (a - f0 + (1.0 - a) * (m3 * m3)), 0.0, 1.0);
}
`, []);

export const powers39RgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_3_9_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_3_9_rgb(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 powers_3_9_rgb_dir(vec3 f0, vec3 normal, vec3 direction) {
    return powers_3_9_rgb(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers39Rgb]);

export const powers369 = /*@__PURE__*/ native(/* wgsl */ `
// Three powers with coefficients in sqrt(f0), a tenth of Schlick's error on dielectrics.
//
//   F = f0 + y (p + y (q + y r)), y = (1 - cos_i)^3, p and q linear in sqrt(f0) and f0,
//   p + q + r = 1 - f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.00713, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    27 operations
// source  this library
fn powers_3_6_9(f0: f32, cos_i: f32) -> f32 {
    let s = sqrt(f0 + 8.271806e-25);
    let p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    let q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    let r = 1.0 - f0 - p - q;
    let m = 1.0 - cos_i;
    let y = m * m * m;
    return saturate(f0 + y * (p + y * (q + y * r)));
}
`, /* glsl */ `
// Three powers with coefficients in sqrt(f0), a tenth of Schlick's error on dielectrics.
//
//   F = f0 + y (p + y (q + y r)), y = (1 - cos_i)^3, p and q linear in sqrt(f0) and f0,
//   p + q + r = 1 - f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.00713, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    27 operations
// source  this library
float powers_3_6_9(float f0, float cos_i) {
    float s = sqrt(f0 + 8.271806e-25);
    float p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    float q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    float r = 1.0 - f0 - p - q;
    float m = 1.0 - cos_i;
    float y = m * m * m;
    return clamp(f0 + y * (p + y * (q + y * r)), 0.0, 1.0);
}
`, []);

export const powers369Dir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_3_6_9_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_3_6_9(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float powers_3_6_9_dir(float f0, vec3 normal, vec3 direction) {
    return powers_3_6_9(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers369]);

export const powers369Rgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn powers_3_6_9_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let s = sqrt(f0 + 8.271806e-25);
    let p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    let q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    let r = 1.0 - f0 - p - q;
    let m = 1.0 - cos_i;
    let y = m * m * m;
    return saturate(f0 + y * (p + y * (q + y * r)));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 powers_3_6_9_rgb(vec3 f0, float cos_i) {
    vec3 s = sqrt(f0 + 8.271806e-25);
    vec3 p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    vec3 q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    vec3 r = 1.0 - f0 - p - q;
    float m = 1.0 - cos_i;
    float y = m * m * m;
    return clamp(f0 + y * (p + y * (q + y * r)), 0.0, 1.0);
}
`, []);

export const powers369RgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_3_6_9_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_3_6_9_rgb(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 powers_3_6_9_rgb_dir(vec3 f0, vec3 normal, vec3 direction) {
    return powers_3_6_9_rgb(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers369Rgb]);

export const oneMinusCos = /*@__PURE__*/ native(/* wgsl */ `
// The rim factor, as a stand-in for reflectance.
//
//   F = 1 - cos_i
//
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.542, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    1 operations
// source  Wloka 2002, Fresnel Reflection, fig. 4
fn one_minus_cos(cos_i: f32) -> f32 {
    return 1.0 - cos_i;
}
`, /* glsl */ `
// The rim factor, as a stand-in for reflectance.
//
//   F = 1 - cos_i
//
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.542, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    1 operations
// source  Wloka 2002, Fresnel Reflection, fig. 4
float one_minus_cos(float cos_i) {
    return 1.0 - cos_i;
}
`, []);

export const oneMinusCosDir = /*@__PURE__*/ native(/* wgsl */ `
fn one_minus_cos_dir(normal: vec3f, direction: vec3f) -> f32 {
    return one_minus_cos(incidence_cosine(normal, direction));
}
`, /* glsl */ `
float one_minus_cos_dir(vec3 normal, vec3 direction) {
    return one_minus_cos(incidence_cosine(normal, direction));
}
`, [incidenceCosine, oneMinusCos]);

export const constant = /*@__PURE__*/ native(/* wgsl */ `
// No Fresnel effect.
//
//   F = f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.983, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    0 operations
// source  no Fresnel effect
fn constant(f0: f32, cos_i: f32) -> f32 {
    return f0;
}
`, /* glsl */ `
// No Fresnel effect.
//
//   F = f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.983, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    0 operations
// source  no Fresnel effect
float constant(float f0, float cos_i) {
    return f0;
}
`, []);

export const constantDir = /*@__PURE__*/ native(/* wgsl */ `
fn constant_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return constant(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float constant_dir(float f0, vec3 normal, vec3 direction) {
    return constant(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, constant]);

export const constantRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn constant_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    return f0;
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 constant_rgb(vec3 f0, float cos_i) {
    return f0;
}
`, []);

export const constantRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn constant_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return constant_rgb(f0, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 constant_rgb_dir(vec3 f0, vec3 normal, vec3 direction) {
    return constant_rgb(f0, incidence_cosine(normal, direction));
}
`, [incidenceCosine, constantRgb]);

export const airConductor = /*@__PURE__*/ native(/* wgsl */ `
// The classic approximation for metals, without a square root.
//
//   R_s = ((n - c)^2 + k^2) / ((n + c)^2 + k^2),
//   R_p = ((n c - 1)^2 + k^2 c^2) / ((n c + 1)^2 + k^2 c^2)
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0638, certified: n in [0.1, 4], k in [1, 8]
// cost    26 operations
// source  Pharr and Humphreys, Physically Based Rendering; Lagarde 2013
fn air_conductor(n: f32, k: f32, cos_i: f32) -> f32 {
    let k2 = k * k;
    let t = n - cos_i;
    let t_2 = n + cos_i;
    let R_s = (t * t + k2) / (t_2 * t_2 + k2);
    let t_3 = n * cos_i;
    let t_3_minus_1 = t_3 - 1.0;
    let t_4 = k2 * (cos_i * cos_i);
    let t_3_plus_1 = t_3 + 1.0;
    let R_p = (t_3_minus_1 * t_3_minus_1 + t_4) / (t_3_plus_1 * t_3_plus_1 + t_4);
    return (R_s + R_p) / 2.0;
}
`, /* glsl */ `
// The classic approximation for metals, without a square root.
//
//   R_s = ((n - c)^2 + k^2) / ((n + c)^2 + k^2),
//   R_p = ((n c - 1)^2 + k^2 c^2) / ((n c + 1)^2 + k^2 c^2)
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0638, certified: n in [0.1, 4], k in [1, 8]
// cost    26 operations
// source  Pharr and Humphreys, Physically Based Rendering; Lagarde 2013
float air_conductor(float n, float k, float cos_i) {
    float k2 = k * k;
    float t = n - cos_i;
    float t_2 = n + cos_i;
    float R_s = (t * t + k2) / (t_2 * t_2 + k2);
    float t_3 = n * cos_i;
    float t_3_minus_1 = t_3 - 1.0;
    float t_4 = k2 * (cos_i * cos_i);
    float t_3_plus_1 = t_3 + 1.0;
    float R_p = (t_3_minus_1 * t_3_minus_1 + t_4) / (t_3_plus_1 * t_3_plus_1 + t_4);
    return (R_s + R_p) / 2.0;
}
`, []);

export const airConductorDir = /*@__PURE__*/ native(/* wgsl */ `
fn air_conductor_dir(n: f32, k: f32, normal: vec3f, direction: vec3f) -> f32 {
    return air_conductor(n, k, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float air_conductor_dir(float n, float k, vec3 normal, vec3 direction) {
    return air_conductor(n, k, incidence_cosine(normal, direction));
}
`, [incidenceCosine, airConductor]);

export const airConductorRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn air_conductor_rgb(n: vec3f, k: vec3f, cos_i: f32) -> vec3f {
    let k2 = k * k;
    let t = n - cos_i;
    let t_2 = n + cos_i;
    let R_s = (t * t + k2) / (t_2 * t_2 + k2);
    let t_3 = n * cos_i;
    let t_3_minus_1 = t_3 - 1.0;
    let t_4 = k2 * (cos_i * cos_i);
    let t_3_plus_1 = t_3 + 1.0;
    let R_p = (t_3_minus_1 * t_3_minus_1 + t_4) / (t_3_plus_1 * t_3_plus_1 + t_4);
    return (R_s + R_p) / 2.0;
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 air_conductor_rgb(vec3 n, vec3 k, float cos_i) {
    vec3 k2 = k * k;
    vec3 t = n - cos_i;
    vec3 t_2 = n + cos_i;
    vec3 R_s = (t * t + k2) / (t_2 * t_2 + k2);
    vec3 t_3 = n * cos_i;
    vec3 t_3_minus_1 = t_3 - 1.0;
    vec3 t_4 = k2 * (cos_i * cos_i);
    vec3 t_3_plus_1 = t_3 + 1.0;
    vec3 R_p = (t_3_minus_1 * t_3_minus_1 + t_4) / (t_3_plus_1 * t_3_plus_1 + t_4);
    return (R_s + R_p) / 2.0;
}
`, []);

export const airConductorRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn air_conductor_rgb_dir(n: vec3f, k: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return air_conductor_rgb(n, k, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 air_conductor_rgb_dir(vec3 n, vec3 k, vec3 normal, vec3 direction) {
    return air_conductor_rgb(n, k, incidence_cosine(normal, direction));
}
`, [incidenceCosine, airConductorRgb]);

export const lazanyi = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation less a term for the dip of metals before grazing incidence.
//
//   F = schlick_nk(n, k) - a c x^alpha, x = 1 - c, c = cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// a       depth of the dip, about 2 n, [0, 2000]
// alpha   sharpness of the dip, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.045, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    33 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
fn lazanyi(n: f32, k: f32, a: f32, alpha: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let m2 = m * m;
    let n_plus_1 = n + 1.0;
    return saturate(min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            1.0) - a * cos_i * pow(m, alpha));
}
`, /* glsl */ `
// Schlick's approximation less a term for the dip of metals before grazing incidence.
//
//   F = schlick_nk(n, k) - a c x^alpha, x = 1 - c, c = cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// a       depth of the dip, about 2 n, [0, 2000]
// alpha   sharpness of the dip, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.045, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    33 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
float lazanyi(float n, float k, float a, float alpha, float cos_i) {
    float m = 1.0 - cos_i;
    float n_minus_1 = n - 1.0;
    float k2 = k * k;
    float m2 = m * m;
    float n_plus_1 = n + 1.0;
    return clamp(min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            1.0) - a * cos_i * pow(m, alpha), 0.0, 1.0);
}
`, []);

export const lazanyiDir = /*@__PURE__*/ native(/* wgsl */ `
fn lazanyi_dir(n: f32, k: f32, a: f32, alpha: f32, normal: vec3f, direction: vec3f) -> f32 {
    return lazanyi(n, k, a, alpha, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float lazanyi_dir(float n, float k, float a, float alpha, vec3 normal, vec3 direction) {
    return lazanyi(n, k, a, alpha, incidence_cosine(normal, direction));
}
`, [incidenceCosine, lazanyi]);

export const lazanyiRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn lazanyi_rgb(n: vec3f, k: vec3f, a: vec3f, alpha: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let m2 = m * m;
    let n_plus_1 = n + 1.0;
    return saturate(min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            vec3f(1.0)) - a * cos_i * pow(vec3f(m), alpha));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 lazanyi_rgb(vec3 n, vec3 k, vec3 a, vec3 alpha, float cos_i) {
    float m = 1.0 - cos_i;
    vec3 n_minus_1 = n - 1.0;
    vec3 k2 = k * k;
    float m2 = m * m;
    vec3 n_plus_1 = n + 1.0;
    return clamp(min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            vec3(1.0)) - a * cos_i * pow(vec3(m), alpha), 0.0, 1.0);
}
`, []);

export const lazanyiRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn lazanyi_rgb_dir(n: vec3f, k: vec3f, a: vec3f, alpha: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return lazanyi_rgb(n, k, a, alpha, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 lazanyi_rgb_dir(vec3 n, vec3 k, vec3 a, vec3 alpha, vec3 normal, vec3 direction) {
    return lazanyi_rgb(n, k, a, alpha, incidence_cosine(normal, direction));
}
`, [incidenceCosine, lazanyiRgb]);

export const gulbrandsen = /*@__PURE__*/ native(/* wgsl */ `
// An index from two artist's colours, then the exact equations.
//
//   F = conductor(n, k), n = mix(n_max(r), n_min(r), g), k^2 = ((n + 1)^2 r - (n - 1)^2) / (1 - r)
//
// r       reflectance at normal incidence, [0, 1]
// g       edge tint, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 1e-13, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    99 operations
// source  Gulbrandsen 2014, Artist Friendly Metallic Fresnel
fn gulbrandsen(r: f32, g: f32, cos_i: f32) -> f32 {
    let f0 = min(r, 0.9999) + 8.271806e-25;
    let t = 1.0 + sqrt(f0);
    let t_2 = t * t;
    let one_minus_f0 = 1.0 - f0;
    let n_max = t_2 / one_minus_f0;
    let n_min = one_minus_f0 / (1.0 + f0);
    let n = n_max * (1.0 - g) + n_min * g;
    let k = sqrt(max((n_max - n) * (n - one_minus_f0 / t_2), 0.0) + 8.271806e-25);
    let c2 = cos_i * cos_i;
    let sin2 = 1.0 - c2;
    let s4 = sin2 * sin2;
    let E = (n - 1.0) * (n + 1.0) - k * k; // Re m^2 - 1
    let Z = 2.0 * (n * k); // Im m^2
    let Z2 = Z * Z;
    let t0 = E + c2; // q^2 = t0 + i Z
    let A = sqrt(t0 * t0 + Z2); // |q|^2
    let S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    let u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    let a = select(S, Z, t0 <= 0.0); // u Re q
    let h = 2.0 * (a * cos_i);
    let F = (E * E + Z2) * S; // |c - q|^2 |c + q|^2
    let G_s = (A + c2) * u + h;
    let D_s = max(F + h * G_s, 1.1754944e-38); // |c + q|^4; 0 only for equal media at cos_i = 0
    let R_s = F / D_s;
    let h_p = h * sin2;
    let N = t0 * c2 - s4;
    let M = Z * c2;
    let M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    let B = (N * N + M2) * S; // |q c - s^2|^2 |q c + s^2|^2
    let G_p = (A * c2 + s4) * u + h_p;
    let D_p = B + h_p * G_p; // |q c + s^2|^4
    let R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}
`, /* glsl */ `
// An index from two artist's colours, then the exact equations.
//
//   F = conductor(n, k), n = mix(n_max(r), n_min(r), g), k^2 = ((n + 1)^2 r - (n - 1)^2) / (1 - r)
//
// r       reflectance at normal incidence, [0, 1]
// g       edge tint, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 1e-13, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    99 operations
// source  Gulbrandsen 2014, Artist Friendly Metallic Fresnel
float gulbrandsen(float r, float g, float cos_i) {
    float f0 = min(r, 0.9999) + 8.271806e-25;
    float t = 1.0 + sqrt(f0);
    float t_2 = t * t;
    float one_minus_f0 = 1.0 - f0;
    float n_max = t_2 / one_minus_f0;
    float n_min = one_minus_f0 / (1.0 + f0);
    float n = n_max * (1.0 - g) + n_min * g;
    float k = sqrt(max((n_max - n) * (n - one_minus_f0 / t_2), 0.0) + 8.271806e-25);
    float c2 = cos_i * cos_i;
    float sin2 = 1.0 - c2;
    float s4 = sin2 * sin2;
    float E_ = (n - 1.0) * (n + 1.0) - k * k; // Re m^2 - 1
    float Z = 2.0 * (n * k); // Im m^2
    float Z2 = Z * Z;
    float t0 = E_ + c2; // q^2 = t0 + i Z
    float A = sqrt(t0 * t0 + Z2); // |q|^2
    float S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    float u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    float a = t0 <= 0.0 ? Z : S; // u Re q
    float h = 2.0 * (a * cos_i);
    float F = (E_ * E_ + Z2) * S; // |c - q|^2 |c + q|^2
    float G_s = (A + c2) * u + h;
    float D_s = max(F + h * G_s, 1.1754944e-38); // |c + q|^4; 0 only for equal media at cos_i = 0
    float R_s = F / D_s;
    float h_p = h * sin2;
    float N = t0 * c2 - s4;
    float M = Z * c2;
    float M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    float B = (N * N + M2) * S; // |q c - s^2|^2 |q c + s^2|^2
    float G_p = (A * c2 + s4) * u + h_p;
    float D_p = B + h_p * G_p; // |q c + s^2|^4
    float R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}
`, []);

export const gulbrandsenDir = /*@__PURE__*/ native(/* wgsl */ `
fn gulbrandsen_dir(r: f32, g: f32, normal: vec3f, direction: vec3f) -> f32 {
    return gulbrandsen(r, g, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float gulbrandsen_dir(float r, float g, vec3 normal, vec3 direction) {
    return gulbrandsen(r, g, incidence_cosine(normal, direction));
}
`, [incidenceCosine, gulbrandsen]);

export const gulbrandsenRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn gulbrandsen_rgb(r: vec3f, g: vec3f, cos_i: f32) -> vec3f {
    return vec3f(gulbrandsen(r.x, g.x, cos_i), gulbrandsen(r.y, g.y, cos_i), gulbrandsen(r.z, g.z, cos_i));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 gulbrandsen_rgb(vec3 r, vec3 g, float cos_i) {
    return vec3(gulbrandsen(r.x, g.x, cos_i), gulbrandsen(r.y, g.y, cos_i), gulbrandsen(r.z, g.z, cos_i));
}
`, [gulbrandsen]);

export const gulbrandsenRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn gulbrandsen_rgb_dir(r: vec3f, g: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return gulbrandsen_rgb(r, g, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 gulbrandsen_rgb_dir(vec3 r, vec3 g, vec3 normal, vec3 direction) {
    return gulbrandsen_rgb(r, g, incidence_cosine(normal, direction));
}
`, [incidenceCosine, gulbrandsenRgb]);

export const f82 = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation with a dip, through the reflectance at cos_i = 1/7.
//
//   f0 + (1 - f0) x^5 - b c x^6 through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0517, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    17 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful
fn f82(f0: f32, f82_: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437;
    let b = (at_82 - f82_) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    return saturate(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m));
}
`, /* glsl */ `
// Schlick's approximation with a dip, through the reflectance at cos_i = 1/7.
//
//   f0 + (1 - f0) x^5 - b c x^6 through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0517, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    17 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful
float f82(float f0, float f82_, float cos_i) {
    float one_minus_f0 = 1.0 - f0;
    float at_82 = f0 + one_minus_f0 * 0.46266437;
    float b = (at_82 - f82_) * 17.651384;
    float m = 1.0 - cos_i;
    float m2 = m * m;
    float m5 = m2 * m2 * m;
    return clamp(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m), 0.0, 1.0);
}
`, []);

export const f82Dir = /*@__PURE__*/ native(/* wgsl */ `
fn f82_dir(f0: f32, f82_: f32, normal: vec3f, direction: vec3f) -> f32 {
    return f82(f0, f82_, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float f82_dir(float f0, float f82_, vec3 normal, vec3 direction) {
    return f82(f0, f82_, incidence_cosine(normal, direction));
}
`, [incidenceCosine, f82]);

export const f82Rgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn f82_rgb(f0: vec3f, f82_: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437;
    let b = (at_82 - f82_) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    return saturate(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 f82_rgb(vec3 f0, vec3 f82_, float cos_i) {
    vec3 one_minus_f0 = 1.0 - f0;
    vec3 at_82 = f0 + one_minus_f0 * 0.46266437;
    vec3 b = (at_82 - f82_) * 17.651384;
    float m = 1.0 - cos_i;
    float m2 = m * m;
    float m5 = m2 * m2 * m;
    return clamp(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m), 0.0, 1.0);
}
`, []);

export const f82RgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn f82_rgb_dir(f0: vec3f, f82_: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return f82_rgb(f0, f82_, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 f82_rgb_dir(vec3 f0, vec3 f82_, vec3 normal, vec3 direction) {
    return f82_rgb(f0, f82_, incidence_cosine(normal, direction));
}
`, [incidenceCosine, f82Rgb]);

export const f82Tint = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation with a dip, given as a fraction of its value at cos_i = 1/7.
//
//   F = f82(f0, tint schlick(f0, 1/7))
//
// f0      reflectance at normal incidence, [0, 1]
// tint    f82 over that of Schlick, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0517, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    18 operations
// source  Kutz, Hasan and Edmondson 2021, Novel aspects of the Adobe Standard Material
fn f82_tint(f0: f32, tint: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437;
    let b = at_82 * (1.0 - tint) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    return saturate(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m));
}
`, /* glsl */ `
// Schlick's approximation with a dip, given as a fraction of its value at cos_i = 1/7.
//
//   F = f82(f0, tint schlick(f0, 1/7))
//
// f0      reflectance at normal incidence, [0, 1]
// tint    f82 over that of Schlick, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0517, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    18 operations
// source  Kutz, Hasan and Edmondson 2021, Novel aspects of the Adobe Standard Material
float f82_tint(float f0, float tint, float cos_i) {
    float one_minus_f0 = 1.0 - f0;
    float at_82 = f0 + one_minus_f0 * 0.46266437;
    float b = at_82 * (1.0 - tint) * 17.651384;
    float m = 1.0 - cos_i;
    float m2 = m * m;
    float m5 = m2 * m2 * m;
    return clamp(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m), 0.0, 1.0);
}
`, []);

export const f82TintDir = /*@__PURE__*/ native(/* wgsl */ `
fn f82_tint_dir(f0: f32, tint: f32, normal: vec3f, direction: vec3f) -> f32 {
    return f82_tint(f0, tint, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float f82_tint_dir(float f0, float tint, vec3 normal, vec3 direction) {
    return f82_tint(f0, tint, incidence_cosine(normal, direction));
}
`, [incidenceCosine, f82Tint]);

export const f82TintRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn f82_tint_rgb(f0: vec3f, tint: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437;
    let b = at_82 * (1.0 - tint) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    return saturate(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 f82_tint_rgb(vec3 f0, vec3 tint, float cos_i) {
    vec3 one_minus_f0 = 1.0 - f0;
    vec3 at_82 = f0 + one_minus_f0 * 0.46266437;
    vec3 b = at_82 * (1.0 - tint) * 17.651384;
    float m = 1.0 - cos_i;
    float m2 = m * m;
    float m5 = m2 * m2 * m;
    return clamp(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m), 0.0, 1.0);
}
`, []);

export const f82TintRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn f82_tint_rgb_dir(f0: vec3f, tint: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return f82_tint_rgb(f0, tint, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 f82_tint_rgb_dir(vec3 f0, vec3 tint, vec3 normal, vec3 direction) {
    return f82_tint_rgb(f0, tint, incidence_cosine(normal, direction));
}
`, [incidenceCosine, f82TintRgb]);

export const hoffman = /*@__PURE__*/ native(/* wgsl */ `
// Schlick's approximation with a dip, any power and any reflectance at grazing incidence.
//
//   f0 + (f90 - f0) x^power - b c x^6 through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0184, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    34 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful; MaterialX
fn hoffman(f0: f32, f82: f32, f90: f32, power: f32, cos_i: f32) -> f32 {
    let t = f90 - f0;
    let at_82 = f0 + t * pow(0.85714287, power);
    let b = (at_82 - f82) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return saturate(f0 + t * pow(m, power) - b * cos_i * (m2 * m2 * m2));
}
`, /* glsl */ `
// Schlick's approximation with a dip, any power and any reflectance at grazing incidence.
//
//   f0 + (f90 - f0) x^power - b c x^6 through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0184, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    34 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful; MaterialX
float hoffman(float f0, float f82, float f90, float power, float cos_i) {
    float t = f90 - f0;
    float at_82 = f0 + t * pow(0.85714287, power);
    float b = (at_82 - f82) * 17.651384;
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return clamp(f0 + t * pow(m, power) - b * cos_i * (m2 * m2 * m2), 0.0, 1.0);
}
`, []);

export const hoffmanDir = /*@__PURE__*/ native(/* wgsl */ `
fn hoffman_dir(f0: f32, f82: f32, f90: f32, power: f32, normal: vec3f, direction: vec3f) -> f32 {
    return hoffman(f0, f82, f90, power, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float hoffman_dir(float f0, float f82, float f90, float power, vec3 normal, vec3 direction) {
    return hoffman(f0, f82, f90, power, incidence_cosine(normal, direction));
}
`, [incidenceCosine, hoffman]);

export const hoffmanRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn hoffman_rgb(f0: vec3f, f82: vec3f, f90: vec3f, power: vec3f, cos_i: f32) -> vec3f {
    let t = f90 - f0;
    let at_82 = f0 + t * pow(vec3f(0.85714287), power);
    let b = (at_82 - f82) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return saturate(f0 + t * pow(vec3f(m), power) - b * cos_i * (m2 * m2 * m2));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 hoffman_rgb(vec3 f0, vec3 f82, vec3 f90, vec3 power, float cos_i) {
    vec3 t = f90 - f0;
    vec3 at_82 = f0 + t * pow(vec3(0.85714287), power);
    vec3 b = (at_82 - f82) * 17.651384;
    float m = 1.0 - cos_i;
    float m2 = m * m;
    return clamp(f0 + t * pow(vec3(m), power) - b * cos_i * (m2 * m2 * m2), 0.0, 1.0);
}
`, []);

export const hoffmanRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn hoffman_rgb_dir(f0: vec3f, f82: vec3f, f90: vec3f, power: vec3f, normal: vec3f,
        direction: vec3f) -> vec3f {
    return hoffman_rgb(f0, f82, f90, power, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 hoffman_rgb_dir(vec3 f0, vec3 f82, vec3 f90, vec3 power, vec3 normal, vec3 direction) {
    return hoffman_rgb(f0, f82, f90, power, incidence_cosine(normal, direction));
}
`, [incidenceCosine, hoffmanRgb]);

export const powers412 = /*@__PURE__*/ native(/* wgsl */ `
// Two powers through f0 and f82.
//
//   f0 + x^4 (p + q x^8) through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0342, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    16 operations
// source  this library
fn powers_4_12(f0: f32, f82: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let rise = one_minus_f0 - (f82 - f0) * 1.8526235;
    let q = rise * 1.4111481;
    let one_minus_cos_i = 1.0 - cos_i;
    let t = one_minus_cos_i * one_minus_cos_i;
    let m4 = t * t;
    return saturate(f0 + m4 * (one_minus_f0 - q + q * (m4 * m4)));
}
`, /* glsl */ `
// Two powers through f0 and f82.
//
//   f0 + x^4 (p + q x^8) through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0342, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    16 operations
// source  this library
float powers_4_12(float f0, float f82, float cos_i) {
    float one_minus_f0 = 1.0 - f0;
    float rise = one_minus_f0 - (f82 - f0) * 1.8526235;
    float q = rise * 1.4111481;
    float one_minus_cos_i = 1.0 - cos_i;
    float t = one_minus_cos_i * one_minus_cos_i;
    float m4 = t * t;
    return clamp(f0 + m4 * (one_minus_f0 - q + q * (m4 * m4)), 0.0, 1.0);
}
`, []);

export const powers412Dir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_4_12_dir(f0: f32, f82: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_4_12(f0, f82, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float powers_4_12_dir(float f0, float f82, vec3 normal, vec3 direction) {
    return powers_4_12(f0, f82, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers412]);

export const powers412Rgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn powers_4_12_rgb(f0: vec3f, f82: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let rise = one_minus_f0 - (f82 - f0) * 1.8526235;
    let q = rise * 1.4111481;
    let one_minus_cos_i = 1.0 - cos_i;
    let t = one_minus_cos_i * one_minus_cos_i;
    let m4 = t * t;
    return saturate(f0 + m4 * (one_minus_f0 - q + q * (m4 * m4)));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 powers_4_12_rgb(vec3 f0, vec3 f82, float cos_i) {
    vec3 one_minus_f0 = 1.0 - f0;
    vec3 rise = one_minus_f0 - (f82 - f0) * 1.8526235;
    vec3 q = rise * 1.4111481;
    float one_minus_cos_i = 1.0 - cos_i;
    float t = one_minus_cos_i * one_minus_cos_i;
    float m4 = t * t;
    return clamp(f0 + m4 * (one_minus_f0 - q + q * (m4 * m4)), 0.0, 1.0);
}
`, []);

export const powers412RgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_4_12_rgb_dir(f0: vec3f, f82: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_4_12_rgb(f0, f82, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 powers_4_12_rgb_dir(vec3 f0, vec3 f82, vec3 normal, vec3 direction) {
    return powers_4_12_rgb(f0, f82, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers412Rgb]);

export const powers2816 = /*@__PURE__*/ native(/* wgsl */ `
// Three powers through f0 and f82.
//
//   f0 + c2 x^2 + c8 x^8 + c16 x^16 through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0357, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    23 operations
// source  this library
fn powers_2_8_16(f0: f32, f82: f32, cos_i: f32) -> f32 {
    let rise = 1.0 - f0;
    let dip = f82 - f0;
    let c2 = 1.04343 * dip - 0.2752 * rise;
    let c8 = 1.55944 * dip + 0.45498 * rise;
    let c16 = 0.82022 * rise - 2.60287 * dip;
    let one_minus_cos_i = 1.0 - cos_i;
    let m2 = one_minus_cos_i * one_minus_cos_i;
    let m2_2 = m2 * m2;
    let m8 = m2_2 * m2_2;
    return saturate(f0 + c2 * m2 + m8 * (c8 + c16 * m8));
}
`, /* glsl */ `
// Three powers through f0 and f82.
//
//   f0 + c2 x^2 + c8 x^8 + c16 x^16 through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0357, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    23 operations
// source  this library
float powers_2_8_16(float f0, float f82, float cos_i) {
    float rise = 1.0 - f0;
    float dip = f82 - f0;
    float c2 = 1.04343 * dip - 0.2752 * rise;
    float c8 = 1.55944 * dip + 0.45498 * rise;
    float c16 = 0.82022 * rise - 2.60287 * dip;
    float one_minus_cos_i = 1.0 - cos_i;
    float m2 = one_minus_cos_i * one_minus_cos_i;
    float m2_2 = m2 * m2;
    float m8 = m2_2 * m2_2;
    return clamp(f0 + c2 * m2 + m8 * (c8 + c16 * m8), 0.0, 1.0);
}
`, []);

export const powers2816Dir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_2_8_16_dir(f0: f32, f82: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_2_8_16(f0, f82, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float powers_2_8_16_dir(float f0, float f82, vec3 normal, vec3 direction) {
    return powers_2_8_16(f0, f82, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers2816]);

export const powers2816Rgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn powers_2_8_16_rgb(f0: vec3f, f82: vec3f, cos_i: f32) -> vec3f {
    let rise = 1.0 - f0;
    let dip = f82 - f0;
    let c2 = 1.04343 * dip - 0.2752 * rise;
    let c8 = 1.55944 * dip + 0.45498 * rise;
    let c16 = 0.82022 * rise - 2.60287 * dip;
    let one_minus_cos_i = 1.0 - cos_i;
    let m2 = one_minus_cos_i * one_minus_cos_i;
    let m2_2 = m2 * m2;
    let m8 = m2_2 * m2_2;
    return saturate(f0 + c2 * m2 + m8 * (c8 + c16 * m8));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 powers_2_8_16_rgb(vec3 f0, vec3 f82, float cos_i) {
    vec3 rise = 1.0 - f0;
    vec3 dip = f82 - f0;
    vec3 c2 = 1.04343 * dip - 0.2752 * rise;
    vec3 c8 = 1.55944 * dip + 0.45498 * rise;
    vec3 c16 = 0.82022 * rise - 2.60287 * dip;
    float one_minus_cos_i = 1.0 - cos_i;
    float m2 = one_minus_cos_i * one_minus_cos_i;
    float m2_2 = m2 * m2;
    float m8 = m2_2 * m2_2;
    return clamp(f0 + c2 * m2 + m8 * (c8 + c16 * m8), 0.0, 1.0);
}
`, []);

export const powers2816RgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn powers_2_8_16_rgb_dir(f0: vec3f, f82: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_2_8_16_rgb(f0, f82, incidence_cosine(normal, direction));
}
`, /* glsl */ `
vec3 powers_2_8_16_rgb_dir(vec3 f0, vec3 f82, vec3 normal, vec3 direction) {
    return powers_2_8_16_rgb(f0, f82, incidence_cosine(normal, direction));
}
`, [incidenceCosine, powers2816Rgb]);

export const biasScalePower = /*@__PURE__*/ native(/* wgsl */ `
// The rim of game shaders.
//
//   F = saturate(bias + scale x^power), x = 1 - cos_i
//
// bias    value at normal incidence, [-10, 10]
// scale   strength of the rim, [-10, 10]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.275, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    14 operations
// source  Fernando and Kilgard 2003, The Cg Tutorial, ch. 7; Halladay 2014, Fresnel Shading
fn bias_scale_power(bias: f32, scale: f32, power: f32, cos_i: f32) -> f32 {
    return saturate(bias + scale * pow(1.0 - cos_i, power));
}
`, /* glsl */ `
// The rim of game shaders.
//
//   F = saturate(bias + scale x^power), x = 1 - cos_i
//
// bias    value at normal incidence, [-10, 10]
// scale   strength of the rim, [-10, 10]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.275, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    14 operations
// source  Fernando and Kilgard 2003, The Cg Tutorial, ch. 7; Halladay 2014, Fresnel Shading
float bias_scale_power(float bias, float scale, float power, float cos_i) {
    return clamp(bias + scale * pow(1.0 - cos_i, power), 0.0, 1.0);
}
`, []);

export const biasScalePowerDir = /*@__PURE__*/ native(/* wgsl */ `
fn bias_scale_power_dir(bias: f32, scale: f32, power: f32, normal: vec3f, direction: vec3f) -> f32 {
    return bias_scale_power(bias, scale, power, incidence_cosine(normal, direction));
}
`, /* glsl */ `
float bias_scale_power_dir(float bias, float scale, float power, vec3 normal, vec3 direction) {
    return bias_scale_power(bias, scale, power, incidence_cosine(normal, direction));
}
`, [incidenceCosine, biasScalePower]);

export const biasScalePowerRgb = /*@__PURE__*/ native(/* wgsl */ `
// The same for three channels, which share the angle.
fn bias_scale_power_rgb(bias: vec3f, scale: vec3f, power: vec3f, cos_i: f32) -> vec3f {
    return saturate(bias + scale * pow(vec3f(1.0 - cos_i), power));
}
`, /* glsl */ `
// The same for three channels, which share the angle.
vec3 bias_scale_power_rgb(vec3 bias, vec3 scale, vec3 power, float cos_i) {
    return clamp(bias + scale * pow(vec3(1.0 - cos_i), power), 0.0, 1.0);
}
`, []);

export const biasScalePowerRgbDir = /*@__PURE__*/ native(/* wgsl */ `
fn bias_scale_power_rgb_dir(bias: vec3f, scale: vec3f, power: vec3f, normal: vec3f,
        direction: vec3f) -> vec3f {
    return bias_scale_power_rgb(bias, scale, power, incidence_cosine(normal, direction));
}

`, /* glsl */ `
vec3 bias_scale_power_rgb_dir(vec3 bias, vec3 scale, vec3 power, vec3 normal, vec3 direction) {
    return bias_scale_power_rgb(bias, scale, power, incidence_cosine(normal, direction));
}
`, [incidenceCosine, biasScalePowerRgb]);
