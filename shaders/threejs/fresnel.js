// Fresnel reflectance for three.js: GLSL for WebGLRenderer.
// Part of fresnel 0.1.0. Made by `fresnel shader --write`; do not edit.

import { Color, ShaderChunk, ShaderMaterial, Vector3 } from 'three';

export const VERSION = '0.1.0';

/// The parameters of each model, in order.
export const parameters = {
    dielectric: ['n_i', 'n_t'],
    conductor: ['n_i', 'n_t', 'k_t'],
    dielectric_fast: ['n_i', 'n_t'],
    conductor_fast: ['n_i', 'n_t', 'k_t'],
    conductor_precise: ['n_i', 'n_t', 'k_t'],
    schlick: ['f0'],
    schlick_f90: ['f0', 'f90'],
    schlick_power: ['f0', 'f90', 'power'],
    schlick_nk: ['n', 'k'],
    schlick_internal: ['eta'],
    spherical_gaussian: ['f0'],
    photometric: ['f0'],
    powers_4_8: ['f0'],
    powers_3_9: ['f0'],
    powers_3_6_9: ['f0'],
    one_minus_cos: [],
    constant: ['f0'],
    air_conductor: ['n', 'k'],
    lazanyi: ['n', 'k', 'a', 'alpha'],
    gulbrandsen: ['r', 'g'],
    f82: ['f0', 'f82'],
    f82_tint: ['f0', 'tint'],
    hoffman: ['f0', 'f82', 'f90', 'power'],
    powers_4_12: ['f0', 'f82'],
    powers_2_8_16: ['f0', 'f82'],
    bias_scale_power: ['bias', 'scale', 'power'],
};

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

// What every function of a model needs.
const types = /* glsl */ `
struct fresnel_boundary {
    float R_s, R_p; // reflected, polarised across and along the plane of incidence
    float T_s, T_p; // transmitted
};

// The cosine between two directions, 0 where they lie on opposite sides.
//
// normal    unit
// direction where the light comes from, or the eye is; unit, on the side of normal
float incidence_cosine(vec3 normal, vec3 direction) {
    return clamp(dot(normal, direction), 0.0, 1.0);
}

// a + b without rounding error: x is the rounded sum, y what it lacks (Knuth 1969).
// Right only where the compiler does not rearrange: no fast math, precise where the language has it.
vec2 two_sum(float a, float b) {
    float sum = a + b;
    float b_part = sum - a;
    return vec2(sum, a - (sum - b_part) + (b - b_part));
}

// a = x + y, half of its digits in each, so that products of halves are exact (Veltkamp 1968).
vec2 halves(float a) {
    float scaled = 4097.0 * a;
    float hi = scaled - (scaled - a);
    return vec2(hi, a - hi);
}

// a b without rounding error: x is the rounded product, y what it lacks (Dekker 1971).
vec2 two_product(float a, float b) {
    float product = a * b;
    vec2 p = halves(a);
    vec2 q = halves(b);
    float over = p.x * q.y;
    float under = p.y * q.x;
    float error = p.x * q.x - product + over + under + p.y * q.y;
    return vec2(product, error);
}

// a + b, where each number is a sum x + y with twice the digits of a float.
vec2 twofold_sum(vec2 a, vec2 b) {
    vec2 s = two_sum(a.x, b.x);
    vec2 t = two_sum(a.y, b.y);
    vec2 u = two_sum(s.x, s.y + t.x);
    return two_sum(u.x, u.y + t.y);
}

// a - b of such numbers.
vec2 twofold_difference(vec2 a, vec2 b) {
    return twofold_sum(a, -b);
}

// a b of such numbers.
vec2 twofold_product(vec2 a, vec2 b) {
    vec2 p = two_product(a.x, b.x);
    return two_sum(p.x, p.y + (a.x * b.y + a.y * b.x));
}
`;

/// The functions of each model. GLSL has overloads: a parameter is a float or a vec3, two directions may stand in
/// place of cos_i.
export const functions = {
    dielectric: /* glsl */ `
// Exact reflectance between two transparent media, accurate in float but at the critical angle.
//
//   R_s = E^2 / (E^2 + 4 c g (g + c)^2), R_p = R_s ((c g - s^2) / (c g + s^2))^2, E = eta^2 - 1,
//   g^2 = E + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 1e-1 at a critical angle
// cost    37 operations
// source  Fresnel 1823
float dielectric(float n_i, float n_t, float cos_i) {
    float c = n_i * cos_i;
    float s2 = n_i * (1.0 - cos_i * cos_i);
    float E = (n_t - n_i) * (n_t + n_i); // n_t^2 - n_i^2

    // Snell
    float g2 = E + c * c; // below 0 beyond the critical angle
    float g = sqrt(max(g2, 1.1754944e-38)); // n_t cos_t; beyond it so small that R is 1

    // s-polarised, across the plane of incidence
    float E2 = E * E;
    float cg = c * g;
    float a = 2.0 * (g + c);
    float a2 = a * a;
    float D_s = max(E2 + cg * a2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    float R_s = E2 / D_s;

    // p-polarised, along it
    float x = cos_i * g;
    float b = x + s2;
    float q = (x - s2) / b;
    float R_p = R_s * (q * q);
    return (R_s + R_p) / 2.0;
}

float dielectric(float n_i, float n_t, vec3 normal, vec3 direction) {
    return dielectric(n_i, n_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 dielectric(float n_i, vec3 n_t, float cos_i) {
    float c = n_i * cos_i;
    float s2 = n_i * (1.0 - cos_i * cos_i);
    vec3 E = (n_t - n_i) * (n_t + n_i); // n_t^2 - n_i^2

    // Snell
    vec3 g2 = E + c * c; // below 0 beyond the critical angle
    vec3 g = sqrt(max(g2, vec3(1.1754944e-38))); // n_t cos_t; beyond it so small that R is 1

    // s-polarised, across the plane of incidence
    vec3 E2 = E * E;
    vec3 cg = c * g;
    vec3 a = 2.0 * (g + c);
    vec3 a2 = a * a;
    vec3 D_s = max(E2 + cg * a2, vec3(1.1754944e-38)); // 0 only for equal media at cos_i = 0
    vec3 R_s = E2 / D_s;

    // p-polarised, along it
    vec3 x = cos_i * g;
    vec3 b = x + s2;
    vec3 q = (x - s2) / b;
    vec3 R_p = R_s * (q * q);
    return (R_s + R_p) / 2.0;
}

vec3 dielectric(float n_i, vec3 n_t, vec3 normal, vec3 direction) {
    return dielectric(n_i, n_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fresnel_boundary dielectric_boundary(float n_i, float n_t, float cos_i) {
    float c = n_i * cos_i;
    float s2 = n_i * (1.0 - cos_i * cos_i);
    float E = (n_t - n_i) * (n_t + n_i); // n_t^2 - n_i^2

    // Snell
    float g2 = E + c * c; // below 0 beyond the critical angle
    float g = sqrt(max(g2, 1.1754944e-38)); // n_t cos_t; beyond it so small that R is 1

    // s-polarised, across the plane of incidence
    float E2 = E * E;
    float cg = c * g;
    float a = 2.0 * (g + c);
    float a2 = a * a;
    float D_s = max(E2 + cg * a2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    float R_s = E2 / D_s;

    // p-polarised, along it
    float x = cos_i * g;
    float b = x + s2;
    float q = (x - s2) / b;
    float R_p = R_s * (q * q);

    // transmitted
    float through_s = g2 <= 0.0 ? 0.0 : cg * (a2 / D_s);
    float through_p = g2 <= 0.0 ? 0.0 : 4.0 * (x * s2) / (b * b);
    float T_s = E2 <= 0.0 ? 1.0 - R_s : through_s;
    float T_p = T_s + R_s * through_p;
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}
`,

    conductor: /* glsl */ `
// Exact reflectance of an absorbing medium seen from a transparent one, accurate in float but at the critical angle.
//
//   R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 1e-1 at a critical angle of small k_t
// cost    67 operations
// source  Born and Wolf 1999, Principles of Optics, sec. 14.2
float conductor(float n_i, float n_t, float k_t, float cos_i) {
    float c = n_i * cos_i;
    float c2 = c * c;
    float cos2 = cos_i * cos_i;
    float sin2 = 1.0 - cos2;
    float s2 = n_i * sin2;
    float s4 = s2 * s2;

    // Snell
    float E = (n_t - n_i) * (n_t + n_i) - k_t * k_t; // Re m^2 - n_i^2, m the complex index
    float Z = 2.0 * (n_t * k_t); // Im m^2
    float Z2 = Z * Z;
    float t0 = E + c2; // q^2 = t0 + i Z
    float A = sqrt(t0 * t0 + Z2); // |q|^2
    float S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    float u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    float a = t0 <= 0.0 ? Z : S; // u Re q

    // s-polarised, across the plane of incidence
    float h = 2.0 * (a * c);
    float F = (E * E + Z2) * S; // S |c - q|^2 |c + q|^2
    float G_s = (A + c2) * u + h;
    float D_s = max(F + h * G_s, 1.1754944e-38); // S |c + q|^4; 0 only for equal media at cos_i = 0
    float R_s = F / D_s;

    // p-polarised, along it
    float h_p = h * sin2;
    float N = t0 * cos2 - s4;
    float M = Z * cos2;
    float M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    float B = (N * N + M2) * S; // S |q c - s^2|^2 |q c + s^2|^2
    float G_p = (A * cos2 + s4) * u + h_p;
    float D_p = B + h_p * G_p; // S |q c + s^2|^4
    float R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}

float conductor(float n_i, float n_t, float k_t, vec3 normal, vec3 direction) {
    return conductor(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 conductor(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
    return vec3(conductor(n_i, n_t.x, k_t.x, cos_i),
                conductor(n_i, n_t.y, k_t.y, cos_i),
                conductor(n_i, n_t.z, k_t.z, cos_i));
}

vec3 conductor(float n_i, vec3 n_t, vec3 k_t, vec3 normal, vec3 direction) {
    return conductor(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fresnel_boundary conductor_boundary(float n_i, float n_t, float k_t, float cos_i) {
    float c = n_i * cos_i;
    float c2 = c * c;
    float cos2 = cos_i * cos_i;
    float sin2 = 1.0 - cos2;
    float s2 = n_i * sin2;
    float s4 = s2 * s2;

    // Snell
    float E = (n_t - n_i) * (n_t + n_i) - k_t * k_t; // Re m^2 - n_i^2, m the complex index
    float Z = 2.0 * (n_t * k_t); // Im m^2
    float Z2 = Z * Z;
    float t0 = E + c2; // q^2 = t0 + i Z
    float A = sqrt(t0 * t0 + Z2); // |q|^2
    float S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    float u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    float a = t0 <= 0.0 ? Z : S; // u Re q

    // s-polarised, across the plane of incidence
    float h = 2.0 * (a * c);
    float F = (E * E + Z2) * S; // S |c - q|^2 |c + q|^2
    float G_s = (A + c2) * u + h;
    float D_s = max(F + h * G_s, 1.1754944e-38); // S |c + q|^4; 0 only for equal media at cos_i = 0
    float R_s = F / D_s;

    // p-polarised, along it
    float h_p = h * sin2;
    float N = t0 * cos2 - s4;
    float M = Z * cos2;
    float M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    float B = (N * N + M2) * S; // S |q c - s^2|^2 |q c + s^2|^2
    float G_p = (A * cos2 + s4) * u + h_p;
    float D_p = B + h_p * G_p; // S |q c + s^2|^4
    float R_p = R_s * (B / D_p);

    // transmitted
    float T_s = F <= 0.0 ? 1.0 - R_s : 2.0 * (a * (G_s / D_s)) * c;
    float T_p = T_s + R_s * (2.0 * (a * (G_p / D_p)) * (c * sin2));
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}
`,

    dielectric_fast: /* glsl */ `
// Exact reflectance between two transparent media in the fewest operations.
//
//   R_s = ((g - c) / (g + c))^2, R_p = R_s ((c g - s^2) / (c g + s^2))^2, g^2 = eta^2 - 1 + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 8e-6 for eta > 1.05, no digit left at 1 +- 1e-6
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

float dielectric_fast(float n_i, float n_t, vec3 normal, vec3 direction) {
    return dielectric_fast(n_i, n_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 dielectric_fast(float n_i, vec3 n_t, float cos_i) {
    return vec3(dielectric_fast(n_i, n_t.x, cos_i),
                dielectric_fast(n_i, n_t.y, cos_i),
                dielectric_fast(n_i, n_t.z, cos_i));
}

vec3 dielectric_fast(float n_i, vec3 n_t, vec3 normal, vec3 direction) {
    return dielectric_fast(n_i, n_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fresnel_boundary dielectric_fast_boundary(float n_i, float n_t, float cos_i) {
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
    float R_s = g2 <= 0.0 ? 1.0 : r2;
    float R_p = g2 <= 0.0 ? 1.0 : r2 * (q * q);
    float w = 4.0 * (c * g);
    float through_s = w / (a * a);
    float through_p = w * sin2 / (b * b);
    float T_s = g2 <= 0.0 ? 0.0 : through_s;
    float T_p = g2 <= 0.0 ? 0.0 : through_s + r2 * through_p;
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}
`,

    conductor_fast: /* glsl */ `
// Exact reflectance of an absorbing medium in the fewest operations.
//
//   R_s = (t1 - t2) / (t1 + t2), R_p = R_s (t3 - t4) / (t3 + t4), t1 = A + c^2, t2 = 2 a c,
//   t3 = A c^2 + s^4, t4 = t2 s^2, A = a^2 + b^2, (a + i b)^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 6e-6 for metals, 2e-4 for dielectrics, no digit left near an index match
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

float conductor_fast(float n_i, float n_t, float k_t, vec3 normal, vec3 direction) {
    return conductor_fast(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 conductor_fast(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
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

vec3 conductor_fast(float n_i, vec3 n_t, vec3 k_t, vec3 normal, vec3 direction) {
    return conductor_fast(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fresnel_boundary conductor_fast_boundary(float n_i, float n_t, float k_t, float cos_i) {
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
    float w = a2 <= 0.0 ? 0.0 : 2.0 * t2; // 0 beyond the critical angle
    float T_s = w / D_s;
    float T_p = T_s + R_s * (w * sin2 / D_p);
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}
`,

    conductor_precise: /* glsl */ `
// Exact reflectance of any medium, with the two sums that cancel in twice the digits.
//
//   R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 1e-6 in R, absolute 1e-6 in T
// cost    304 operations
// source  Born and Wolf 1999; Knuth 1969; Dekker 1971
float conductor_precise(float n_i, float n_t, float k_t, float cos_i) {
    float s2 = (1.0 - cos_i) * (1.0 + cos_i);

    // what cancels, in twice the digits
    vec2 n2 = two_product(n_t, n_t);
    vec2 k2 = two_product(k_t, k_t);
    vec2 i2 = two_product(n_i, n_i);
    vec2 c2 = two_product(cos_i, cos_i);
    vec2 m2 = twofold_difference(n2, k2); // Re m^2, m = n_t + i k_t
    vec2 E = twofold_difference(m2, i2);
    vec2 p2 = twofold_product(i2, c2); // (n_i cos_i)^2
    vec2 q2 = twofold_sum(E, p2); // Re q^2, q^2 = m^2 - (n_i sin_i)^2
    vec2 sum2 = twofold_sum(n2, i2);
    vec2 product = twofold_product(c2, sum2);
    vec2 N = twofold_difference(product, i2); // 0 at Brewster's angle where k_t = 0

    // q = a + i b, which is m cos_t; lengths in units of 1 / n_i
    float c = n_i * cos_i;
    float nk = n_t * k_t; // Im q^2 / 2
    float size = abs(q2.x);
    float A = max(sqrt(q2.x * q2.x + 4.0 * (nk * nk)), size); // |q|^2
    float larger = sqrt((A + size) / 2.0); // of |Re q| and |Im q|
    float smaller = nk / (larger > 0.0 ? larger : 1.0);
    float a = q2.x <= 0.0 ? smaller : larger; // Re q
    float b = q2.x <= 0.0 ? larger : smaller; // Im q
    float b2 = b * b;

    // s-polarised; d is a - c, exact near an index match as well
    float a_minus_c = a - c;
    float a_plus_c = a + c;
    float d = max(2.0 * abs(a_minus_c), b) < c ? (E.x + b2) / a_plus_c : a_minus_c;
    float D_s = a_plus_c * a_plus_c + b2;
    float D = D_s <= 0.0 ? 1.0 : D_s; // 0 only for equal media at cos_i = 0
    float N_s = d * d + b2;
    float R_s = N_s / D;

    // p-polarised; nu is a cos_i - n_i sin_i^2, exact near Brewster's angle as well
    float is2 = n_i * s2;
    float ac = a * cos_i;
    float bc = b * cos_i;
    float bc2 = bc * bc;
    float difference = ac - is2;
    float total = ac + is2;
    float sum = total <= 0.0 ? 1.0 : total;
    float exact = (N.x + c2.x * (b2 - k2.x)) / sum;
    float nu = max(2.0 * abs(difference) - is2, 2.0 * b - n_i) < 0.0 ? exact : difference;
    float P = sum * sum + bc2;
    float R_p = R_s * ((nu * nu + bc2) / P);
    return (min(R_s, 1.0) + min(R_p, 1.0)) / 2.0;
}

float conductor_precise(float n_i, float n_t, float k_t, vec3 normal, vec3 direction) {
    return conductor_precise(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 conductor_precise(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
    return vec3(conductor_precise(n_i, n_t.x, k_t.x, cos_i),
                conductor_precise(n_i, n_t.y, k_t.y, cos_i),
                conductor_precise(n_i, n_t.z, k_t.z, cos_i));
}

vec3 conductor_precise(float n_i, vec3 n_t, vec3 k_t, vec3 normal, vec3 direction) {
    return conductor_precise(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fresnel_boundary conductor_precise_boundary(float n_i, float n_t, float k_t, float cos_i) {
    float s2 = (1.0 - cos_i) * (1.0 + cos_i);

    // what cancels, in twice the digits
    vec2 n2 = two_product(n_t, n_t);
    vec2 k2 = two_product(k_t, k_t);
    vec2 i2 = two_product(n_i, n_i);
    vec2 c2 = two_product(cos_i, cos_i);
    vec2 m2 = twofold_difference(n2, k2); // Re m^2, m = n_t + i k_t
    vec2 E = twofold_difference(m2, i2);
    vec2 p2 = twofold_product(i2, c2); // (n_i cos_i)^2
    vec2 q2 = twofold_sum(E, p2); // Re q^2, q^2 = m^2 - (n_i sin_i)^2
    vec2 sum2 = twofold_sum(n2, i2);
    vec2 product = twofold_product(c2, sum2);
    vec2 N = twofold_difference(product, i2); // 0 at Brewster's angle where k_t = 0

    // q = a + i b, which is m cos_t; lengths in units of 1 / n_i
    float c = n_i * cos_i;
    float nk = n_t * k_t; // Im q^2 / 2
    float size = abs(q2.x);
    float A = max(sqrt(q2.x * q2.x + 4.0 * (nk * nk)), size); // |q|^2
    float larger = sqrt((A + size) / 2.0); // of |Re q| and |Im q|
    float smaller = nk / (larger > 0.0 ? larger : 1.0);
    float a = q2.x <= 0.0 ? smaller : larger; // Re q
    float b = q2.x <= 0.0 ? larger : smaller; // Im q
    float b2 = b * b;

    // s-polarised; d is a - c, exact near an index match as well
    float a_minus_c = a - c;
    float a_plus_c = a + c;
    float d = max(2.0 * abs(a_minus_c), b) < c ? (E.x + b2) / a_plus_c : a_minus_c;
    float D_s = a_plus_c * a_plus_c + b2;
    float D = D_s <= 0.0 ? 1.0 : D_s; // 0 only for equal media at cos_i = 0
    float N_s = d * d + b2;
    float R_s = N_s / D;
    float T_s = N_s <= 0.0 ? 1.0 : 4.0 * (a * c) / D;

    // p-polarised; nu is a cos_i - n_i sin_i^2, exact near Brewster's angle as well
    float is2 = n_i * s2;
    float ac = a * cos_i;
    float bc = b * cos_i;
    float bc2 = bc * bc;
    float difference = ac - is2;
    float total = ac + is2;
    float sum = total <= 0.0 ? 1.0 : total;
    float exact = (N.x + c2.x * (b2 - k2.x)) / sum;
    float nu = max(2.0 * abs(difference) - is2, 2.0 * b - n_i) < 0.0 ? exact : difference;
    float P = sum * sum + bc2;
    float R_p = R_s * ((nu * nu + bc2) / P);
    float T_p = T_s + R_s * (4.0 * (ac * is2) / P);
    return fresnel_boundary(min(R_s, 1.0), min(R_p, 1.0), min(T_s, 1.0), min(T_p, 1.0));
}
`,

    schlick: /* glsl */ `
// Schlick's approximation.
//
//   F = f0 + (1 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering
float schlick(float f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

float schlick(float f0, vec3 normal, vec3 direction) {
    return schlick(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 schlick(vec3 f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

vec3 schlick(vec3 f0, vec3 normal, vec3 direction) {
    return schlick(f0, incidence_cosine(normal, direction));
}
`,

    schlick_f90: /* glsl */ `
// Schlick's approximation with any reflectance at grazing incidence.
//
//   F = f0 + (f90 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994; Real-Time Rendering, 4th ed., eq. 9.18
float schlick_f90(float f0, float f90, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (f90 - f0) * (x2 * x2 * x);
}

float schlick_f90(float f0, float f90, vec3 normal, vec3 direction) {
    return schlick_f90(f0, f90, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 schlick_f90(vec3 f0, vec3 f90, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (f90 - f0) * (x2 * x2 * x);
}

vec3 schlick_f90(vec3 f0, vec3 f90, vec3 normal, vec3 direction) {
    return schlick_f90(f0, f90, incidence_cosine(normal, direction));
}
`,

    schlick_power: /* glsl */ `
// Schlick's approximation with the power left free.
//
//   F = f0 + (f90 - f0) x^power, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0968, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    13 operations
// source  Real-Time Rendering, 4th ed., eq. 9.18
float schlick_power(float f0, float f90, float power, float cos_i) {
    float rise = f90 - f0;
    return f0 + rise * pow(1.0 - cos_i, power);
}

float schlick_power(float f0, float f90, float power, vec3 normal, vec3 direction) {
    return schlick_power(f0, f90, power, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 schlick_power(vec3 f0, vec3 f90, vec3 power, float cos_i) {
    vec3 rise = f90 - f0;
    return f0 + rise * pow(vec3(1.0 - cos_i), power);
}

vec3 schlick_power(vec3 f0, vec3 f90, vec3 power, vec3 normal, vec3 direction) {
    return schlick_power(f0, f90, power, incidence_cosine(normal, direction));
}
`,

    schlick_nk: /* glsl */ `
// Schlick's approximation written in n and k.
//
//   F = ((n - 1)^2 + 4 n x^5 + k^2) / ((n + 1)^2 + k^2), x = 1 - cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.256, certified for n in [0.1, 4], k in [1, 8]
// cost    19 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
float schlick_nk(float n, float k, float cos_i) {
    float x = 1.0 - cos_i;
    float n_minus_1 = n - 1.0;
    float k2 = k * k;
    float x2 = x * x;
    float n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2), 1.0);
}

float schlick_nk(float n, float k, vec3 normal, vec3 direction) {
    return schlick_nk(n, k, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 schlick_nk(vec3 n, vec3 k, float cos_i) {
    float x = 1.0 - cos_i;
    vec3 n_minus_1 = n - 1.0;
    vec3 k2 = k * k;
    float x2 = x * x;
    vec3 n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2),
            vec3(1.0));
}

vec3 schlick_nk(vec3 n, vec3 k, vec3 normal, vec3 direction) {
    return schlick_nk(n, k, incidence_cosine(normal, direction));
}
`,

    schlick_internal: /* glsl */ `
// Schlick's approximation from inside a denser medium.
//
//   F = schlick(f0, cos_t), f0 = ((1 - eta) / (1 + eta))^2; 1 beyond the critical angle
//
// eta     n_t / n_i, [0.01, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified for 1 / eta in [1.3, 2.5], from inside
// cost    28 operations
// source  Lagarde 2013, Memo on Fresnel equations
float schlick_internal(float eta, float cos_i) {
    float eta_minus_1 = eta - 1.0;
    float eta_plus_1 = eta + 1.0;
    float r = eta_minus_1 / eta_plus_1; // amplitude
    float f0 = r * r;
    float g2 = eta_minus_1 * eta_plus_1 + cos_i * cos_i;
    float cos_t = g2 <= 0.0 ? 0.0 : min(sqrt(g2) / eta, 1.0);
    float x = 1.0 - cos_t;
    float x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

float schlick_internal(float eta, vec3 normal, vec3 direction) {
    return schlick_internal(eta, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 schlick_internal(vec3 eta, float cos_i) {
    return vec3(schlick_internal(eta.x, cos_i),
                schlick_internal(eta.y, cos_i),
                schlick_internal(eta.z, cos_i));
}

vec3 schlick_internal(vec3 eta, vec3 normal, vec3 direction) {
    return schlick_internal(eta, incidence_cosine(normal, direction));
}
`,

    spherical_gaussian: /* glsl */ `
// Schlick's curve by a spherical Gaussian.
//
//   F = f0 + (1 - f0) 2^((-5.55473 cos_i - 6.98316) cos_i)
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0847, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    10 operations
// source  Lagarde 2012, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel
float spherical_gaussian(float f0, float cos_i) {
    float p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}

float spherical_gaussian(float f0, vec3 normal, vec3 direction) {
    return spherical_gaussian(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 spherical_gaussian(vec3 f0, float cos_i) {
    float p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}

vec3 spherical_gaussian(vec3 f0, vec3 normal, vec3 direction) {
    return spherical_gaussian(f0, incidence_cosine(normal, direction));
}
`,

    photometric: /* glsl */ `
// A curve found by symbolic regression.
//
//   F = f0 + (x - f0) x^4, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0708, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    6 operations
// source  photometric.io, Improving Schlick's Approximation
float photometric(float f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (x - f0) * (x2 * x2);
}

float photometric(float f0, vec3 normal, vec3 direction) {
    return photometric(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 photometric(vec3 f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (x - f0) * (x2 * x2);
}

vec3 photometric(vec3 f0, vec3 normal, vec3 direction) {
    return photometric(f0, incidence_cosine(normal, direction));
}
`,

    powers_4_8: /* glsl */ `
// Two powers for one operation more than Schlick, better on dielectrics.
//
//   F = f0 + x^4 ((a - f0) + (1 - a) x^4), a = 0.55, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0363, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    8 operations
// source  this library
float powers_4_8(float f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    return f0 + x4 * (0.55 - f0 + 0.45 * x4);
}

float powers_4_8(float f0, vec3 normal, vec3 direction) {
    return powers_4_8(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 powers_4_8(vec3 f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    return f0 + x4 * (0.55 - f0 + 0.45 * x4);
}

vec3 powers_4_8(vec3 f0, vec3 normal, vec3 direction) {
    return powers_4_8(f0, incidence_cosine(normal, direction));
}
`,

    powers_3_9: /* glsl */ `
// Two powers, less than half of Schlick's error on dielectrics.
//
//   F = f0 + x^3 max((1 - f0) - 0.54 (1 - x^6), 0), x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0328, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    12 operations
// source  this library
float powers_3_9(float f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x3 = x * x * x;
    float rise = clamp(1.0 - f0 - 0.54 * (1.0 - x3 * x3), 0.0, 1.0); // saturate is free on GPUs
    return f0 + x3 * rise;
}

float powers_3_9(float f0, vec3 normal, vec3 direction) {
    return powers_3_9(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 powers_3_9(vec3 f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x3 = x * x * x;
    vec3 rise = clamp(1.0 - f0 - 0.54 * (1.0 - x3 * x3), 0.0, 1.0); // saturate is free on GPUs
    return f0 + x3 * rise;
}

vec3 powers_3_9(vec3 f0, vec3 normal, vec3 direction) {
    return powers_3_9(f0, incidence_cosine(normal, direction));
}
`,

    powers_3_6_9: /* glsl */ `
// Three powers with coefficients in sqrt(f0), a tenth of Schlick's error on dielectrics.
//
//   F = f0 + y (p + y (q + y r)), y = (1 - cos_i)^3, p and q linear in sqrt(f0) and f0,
//   p + q + r = 1 - f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.00713, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    27 operations
// source  this library
float powers_3_6_9(float f0, float cos_i) {
    float s = sqrt(f0 + 8.271806e-25); // 2^-80 keeps the slope at f0 = 0 finite
    float p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    float q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    float r = 1.0 - f0 - p - q;
    float x = 1.0 - cos_i;
    float y = x * x * x;
    return clamp(f0 + y * (p + y * (q + y * r)), 0.0, 1.0);
}

float powers_3_6_9(float f0, vec3 normal, vec3 direction) {
    return powers_3_6_9(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 powers_3_6_9(vec3 f0, float cos_i) {
    vec3 s = sqrt(f0 + 8.271806e-25); // 2^-80 keeps the slope at f0 = 0 finite
    vec3 p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    vec3 q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    vec3 r = 1.0 - f0 - p - q;
    float x = 1.0 - cos_i;
    float y = x * x * x;
    return clamp(f0 + y * (p + y * (q + y * r)), 0.0, 1.0);
}

vec3 powers_3_6_9(vec3 f0, vec3 normal, vec3 direction) {
    return powers_3_6_9(f0, incidence_cosine(normal, direction));
}
`,

    one_minus_cos: /* glsl */ `
// The rim factor, as a stand-in for reflectance.
//
//   F = 1 - cos_i
//
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.543, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    1 operations
// source  Wloka 2002, Fresnel Reflection, fig. 4
float one_minus_cos(float cos_i) {
    return 1.0 - cos_i;
}

float one_minus_cos(vec3 normal, vec3 direction) {
    return one_minus_cos(incidence_cosine(normal, direction));
}
`,

    constant: /* glsl */ `
// No Fresnel effect.
//
//   F = f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.983, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    0 operations
// source  no Fresnel effect
float constant(float f0, float cos_i) {
    return f0;
}

float constant(float f0, vec3 normal, vec3 direction) {
    return constant(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 constant(vec3 f0, float cos_i) {
    return f0;
}

vec3 constant(vec3 f0, vec3 normal, vec3 direction) {
    return constant(f0, incidence_cosine(normal, direction));
}
`,

    air_conductor: /* glsl */ `
// The classic approximation for metals, without a square root.
//
//   R_s = ((n - c)^2 + k^2) / ((n + c)^2 + k^2),
//   R_p = ((n c - 1)^2 + k^2 c^2) / ((n c + 1)^2 + k^2 c^2)
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0639, certified for n in [0.1, 4], k in [1, 8]
// cost    26 operations
// source  Pharr and Humphreys, Physically Based Rendering; Lagarde 2013
float air_conductor(float n, float k, float cos_i) {
    float k2 = k * k;
    float n_minus_c = n - cos_i;
    float n_plus_c = n + cos_i;
    float R_s = (n_minus_c * n_minus_c + k2) / (n_plus_c * n_plus_c + k2);
    float nc = n * cos_i;
    float kc2 = k2 * (cos_i * cos_i);
    float nc_minus_1 = nc - 1.0;
    float nc_plus_1 = nc + 1.0;
    float R_p = (nc_minus_1 * nc_minus_1 + kc2) / (nc_plus_1 * nc_plus_1 + kc2);
    return (R_s + R_p) / 2.0;
}

float air_conductor(float n, float k, vec3 normal, vec3 direction) {
    return air_conductor(n, k, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 air_conductor(vec3 n, vec3 k, float cos_i) {
    vec3 k2 = k * k;
    vec3 n_minus_c = n - cos_i;
    vec3 n_plus_c = n + cos_i;
    vec3 R_s = (n_minus_c * n_minus_c + k2) / (n_plus_c * n_plus_c + k2);
    vec3 nc = n * cos_i;
    vec3 kc2 = k2 * (cos_i * cos_i);
    vec3 nc_minus_1 = nc - 1.0;
    vec3 nc_plus_1 = nc + 1.0;
    vec3 R_p = (nc_minus_1 * nc_minus_1 + kc2) / (nc_plus_1 * nc_plus_1 + kc2);
    return (R_s + R_p) / 2.0;
}

vec3 air_conductor(vec3 n, vec3 k, vec3 normal, vec3 direction) {
    return air_conductor(n, k, incidence_cosine(normal, direction));
}
`,

    lazanyi: /* glsl */ `
// Schlick's approximation less a term for the dip of metals before grazing incidence.
//
//   F = schlick_nk(n, k) - a c x^alpha, x = 1 - c, c = cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// a       depth of the dip, about 2 n, [0, 2000]
// alpha   sharpness of the dip, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0451, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    33 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
float lazanyi(float n, float k, float a, float alpha, float cos_i) {
    float x = 1.0 - cos_i;
    float n_minus_1 = n - 1.0;
    float k2 = k * k;
    float x2 = x * x;
    float n_plus_1 = n + 1.0;
    float F = min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2), 1.0);
    return clamp(F - a * cos_i * pow(x, alpha), 0.0, 1.0);
}

float lazanyi(float n, float k, float a, float alpha, vec3 normal, vec3 direction) {
    return lazanyi(n, k, a, alpha, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 lazanyi(vec3 n, vec3 k, vec3 a, vec3 alpha, float cos_i) {
    float x = 1.0 - cos_i;
    vec3 n_minus_1 = n - 1.0;
    vec3 k2 = k * k;
    float x2 = x * x;
    vec3 n_plus_1 = n + 1.0;
    vec3 F = min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2),
            vec3(1.0));
    return clamp(F - a * cos_i * pow(vec3(x), alpha), 0.0, 1.0);
}

vec3 lazanyi(vec3 n, vec3 k, vec3 a, vec3 alpha, vec3 normal, vec3 direction) {
    return lazanyi(n, k, a, alpha, incidence_cosine(normal, direction));
}
`,

    gulbrandsen: /* glsl */ `
// An index from two artist's colours, then the exact equations.
//
//   F = conductor(n, k), n = mix(n_max(r), n_min(r), g), k^2 = ((n + 1)^2 r - (n - 1)^2) / (1 - r)
//
// r       reflectance at normal incidence, [0, 1]
// g       edge tint, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float 3e-7 for r in [0.02, 0.99]
// cost    96 operations
// source  Gulbrandsen 2014, Artist Friendly Metallic Fresnel
float gulbrandsen(float r, float g, float cos_i) {
    float f0 = min(r, 0.9999) + 8.271806e-25; // 2^-80 keeps its root's slope finite
    float root = sqrt(f0);
    float one_minus_f0 = 1.0 - f0;
    float one_plus_f0 = 1.0 + f0;
    float one_plus_root = 1.0 + root;
    float one_minus_root = 1.0 - root;

    // indices, all times 1 - f0^2
    float n_i = one_minus_f0 * one_plus_f0;
    float n_max = one_plus_root * one_plus_root * one_plus_f0;
    float n_min = one_minus_f0 * one_minus_f0;
    float n_0 = one_minus_root * one_minus_root * one_plus_f0; // 1 / n_max; k is 0 at both
    float n = n_max * (1.0 - g) + n_min * g;
    float k = sqrt(max((n_max - n) * (n - n_0), 0.0) + 8.271806e-25);
    float c = n_i * cos_i;
    float c2 = c * c;
    float cos2 = cos_i * cos_i;
    float sin2 = 1.0 - cos2;
    float s2 = n_i * sin2;
    float s4 = s2 * s2;

    // Snell
    float E = (n - n_i) * (n + n_i) - k * k; // Re m^2 - n_i^2, m the complex index
    float Z = 2.0 * (n * k); // Im m^2
    float Z2 = Z * Z;
    float t0 = E + c2; // q^2 = t0 + i Z
    float A = sqrt(t0 * t0 + Z2); // |q|^2
    float S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    float u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    float a = t0 <= 0.0 ? Z : S; // u Re q

    // s-polarised, across the plane of incidence
    float h = 2.0 * (a * c);
    float F = (E * E + Z2) * S; // S |c - q|^2 |c + q|^2
    float G_s = (A + c2) * u + h;
    float D_s = max(F + h * G_s, 1.1754944e-38); // S |c + q|^4; 0 only for equal media at cos_i = 0
    float R_s = F / D_s;

    // p-polarised, along it
    float h_p = h * sin2;
    float N = t0 * cos2 - s4;
    float M = Z * cos2;
    float M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    float B = (N * N + M2) * S; // S |q c - s^2|^2 |q c + s^2|^2
    float G_p = (A * cos2 + s4) * u + h_p;
    float D_p = B + h_p * G_p; // S |q c + s^2|^4
    float R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}

float gulbrandsen(float r, float g, vec3 normal, vec3 direction) {
    return gulbrandsen(r, g, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 gulbrandsen(vec3 r, vec3 g, float cos_i) {
    return vec3(gulbrandsen(r.x, g.x, cos_i), gulbrandsen(r.y, g.y, cos_i), gulbrandsen(r.z, g.z, cos_i));
}

vec3 gulbrandsen(vec3 r, vec3 g, vec3 normal, vec3 direction) {
    return gulbrandsen(r, g, incidence_cosine(normal, direction));
}
`,

    f82: /* glsl */ `
// Schlick's approximation with a dip, through the reflectance at cos_i = 1/7.
//
//   F = f0 + (1 - f0) x^5 - b c x^6, through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0406, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    17 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful
float f82(float f0, float f82_, float cos_i) {
    float one_minus_f0 = 1.0 - f0;
    float at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    float b = (at_82 - f82_) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x5 = x2 * x2 * x;
    return clamp(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x), 0.0, 1.0);
}

float f82(float f0, float f82_, vec3 normal, vec3 direction) {
    return f82(f0, f82_, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 f82(vec3 f0, vec3 f82_, float cos_i) {
    vec3 one_minus_f0 = 1.0 - f0;
    vec3 at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    vec3 b = (at_82 - f82_) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x5 = x2 * x2 * x;
    return clamp(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x), 0.0, 1.0);
}

vec3 f82(vec3 f0, vec3 f82_, vec3 normal, vec3 direction) {
    return f82(f0, f82_, incidence_cosine(normal, direction));
}
`,

    f82_tint: /* glsl */ `
// Schlick's approximation with a dip, given as a fraction of its value at cos_i = 1/7.
//
//   F = f82(f0, tint schlick(f0, 1/7))
//
// f0      reflectance at normal incidence, [0, 1]
// tint    f82 over that of Schlick, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0451, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    18 operations
// source  Kutz, Hasan and Edmondson 2021, Novel aspects of the Adobe Standard Material
float f82_tint(float f0, float tint, float cos_i) {
    float one_minus_f0 = 1.0 - f0;
    float at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    float b = at_82 * (1.0 - tint) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x5 = x2 * x2 * x;
    return clamp(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x), 0.0, 1.0);
}

float f82_tint(float f0, float tint, vec3 normal, vec3 direction) {
    return f82_tint(f0, tint, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 f82_tint(vec3 f0, vec3 tint, float cos_i) {
    vec3 one_minus_f0 = 1.0 - f0;
    vec3 at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    vec3 b = at_82 * (1.0 - tint) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x5 = x2 * x2 * x;
    return clamp(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x), 0.0, 1.0);
}

vec3 f82_tint(vec3 f0, vec3 tint, vec3 normal, vec3 direction) {
    return f82_tint(f0, tint, incidence_cosine(normal, direction));
}
`,

    hoffman: /* glsl */ `
// Schlick's approximation with a dip, any power and any reflectance at grazing incidence.
//
//   F = f0 + (f90 - f0) x^power - b c x^6, through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0185, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    34 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful; MaterialX
float hoffman(float f0, float f82, float f90, float power, float cos_i) {
    float rise = f90 - f0;
    float at_82 = f0 + rise * pow(0.85714287, power); // at cos_i = 1/7: x is 6/7
    float b = (at_82 - f82) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return clamp(f0 + rise * pow(x, power) - b * cos_i * (x2 * x2 * x2), 0.0, 1.0);
}

float hoffman(float f0, float f82, float f90, float power, vec3 normal, vec3 direction) {
    return hoffman(f0, f82, f90, power, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 hoffman(vec3 f0, vec3 f82, vec3 f90, vec3 power, float cos_i) {
    vec3 rise = f90 - f0;
    vec3 at_82 = f0 + rise * pow(vec3(0.85714287), power); // at cos_i = 1/7: x is 6/7
    vec3 b = (at_82 - f82) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return clamp(f0 + rise * pow(vec3(x), power) - b * cos_i * (x2 * x2 * x2), 0.0, 1.0);
}

vec3 hoffman(vec3 f0, vec3 f82, vec3 f90, vec3 power, vec3 normal, vec3 direction) {
    return hoffman(f0, f82, f90, power, incidence_cosine(normal, direction));
}
`,

    powers_4_12: /* glsl */ `
// Two powers through f0 and f82.
//
//   F = f0 + x^4 (p + q x^8), through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0216, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    16 operations
// source  this library
float powers_4_12(float f0, float f82, float cos_i) {
    float one_minus_f0 = 1.0 - f0;
    float rise = one_minus_f0 - (f82 - f0) * 1.8526235; // 1 / x^4 at cos_i = 1/7: (7/6)^4
    float q = rise * 1.4111481; // 1 / (1 - x^8) there
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    return clamp(f0 + x4 * (one_minus_f0 - q + q * (x4 * x4)), 0.0, 1.0);
}

float powers_4_12(float f0, float f82, vec3 normal, vec3 direction) {
    return powers_4_12(f0, f82, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 powers_4_12(vec3 f0, vec3 f82, float cos_i) {
    vec3 one_minus_f0 = 1.0 - f0;
    vec3 rise = one_minus_f0 - (f82 - f0) * 1.8526235; // 1 / x^4 at cos_i = 1/7: (7/6)^4
    vec3 q = rise * 1.4111481; // 1 / (1 - x^8) there
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    return clamp(f0 + x4 * (one_minus_f0 - q + q * (x4 * x4)), 0.0, 1.0);
}

vec3 powers_4_12(vec3 f0, vec3 f82, vec3 normal, vec3 direction) {
    return powers_4_12(f0, f82, incidence_cosine(normal, direction));
}
`,

    powers_2_8_16: /* glsl */ `
// Three powers through f0 and f82.
//
//   F = f0 + c2 x^2 + c8 x^8 + c16 x^16, through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0358, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    23 operations
// source  this library
float powers_2_8_16(float f0, float f82, float cos_i) {
    float rise = 1.0 - f0;
    float dip = f82 - f0;
    float c2 = 1.04343 * dip - 0.2752 * rise;
    float c8 = 1.55944 * dip + 0.45498 * rise;
    float c16 = 0.82022 * rise - 2.60287 * dip;
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    float x8 = x4 * x4;
    return clamp(f0 + c2 * x2 + x8 * (c8 + c16 * x8), 0.0, 1.0);
}

float powers_2_8_16(float f0, float f82, vec3 normal, vec3 direction) {
    return powers_2_8_16(f0, f82, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 powers_2_8_16(vec3 f0, vec3 f82, float cos_i) {
    vec3 rise = 1.0 - f0;
    vec3 dip = f82 - f0;
    vec3 c2 = 1.04343 * dip - 0.2752 * rise;
    vec3 c8 = 1.55944 * dip + 0.45498 * rise;
    vec3 c16 = 0.82022 * rise - 2.60287 * dip;
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    float x8 = x4 * x4;
    return clamp(f0 + c2 * x2 + x8 * (c8 + c16 * x8), 0.0, 1.0);
}

vec3 powers_2_8_16(vec3 f0, vec3 f82, vec3 normal, vec3 direction) {
    return powers_2_8_16(f0, f82, incidence_cosine(normal, direction));
}
`,

    bias_scale_power: /* glsl */ `
// The rim of game shaders.
//
//   F = saturate(bias + scale x^power), x = 1 - cos_i
//
// bias    value at normal incidence, [-10, 10]
// scale   strength of the rim, [-10, 10]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.147, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    14 operations
// source  Fernando and Kilgard 2003, The Cg Tutorial, ch. 7; Halladay 2014, Fresnel Shading
float bias_scale_power(float bias, float scale, float power, float cos_i) {
    return clamp(bias + scale * pow(1.0 - cos_i, power), 0.0, 1.0);
}

float bias_scale_power(float bias, float scale, float power, vec3 normal, vec3 direction) {
    return bias_scale_power(bias, scale, power, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
vec3 bias_scale_power(vec3 bias, vec3 scale, vec3 power, float cos_i) {
    return clamp(bias + scale * pow(vec3(1.0 - cos_i), power), 0.0, 1.0);
}

vec3 bias_scale_power(vec3 bias, vec3 scale, vec3 power, vec3 normal, vec3 direction) {
    return bias_scale_power(bias, scale, power, incidence_cosine(normal, direction));
}
`,

};

/// Directions, angles and indices.
export const geometry = /* glsl */ `
// The mirror direction, on the side of normal.
//
//   r = 2 (n . v) n - v
//
// direction where the light comes from, or the eye is; unit, on the side of normal
// normal    unit
vec3 reflected_direction(vec3 direction, vec3 normal) {
    float d = 2.0 * dot(normal, direction);
    return d * normal - direction;
}

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

// Cosine of the critical angle, beyond which everything is reflected; 0 where there is none.
//
//   cos_c = sqrt(1 - eta^2)
//
// eta       n_t / n_i, above 0
float critical_cosine(float eta) {
    return eta < 1.0 ? sqrt((1.0 - eta) * (1.0 + eta)) : 0.0;
}

// Cosine of Brewster's angle, at which p-polarised light is not reflected.
//
//   cos_B = 1 / sqrt(1 + eta^2)
//
// eta       n_t / n_i, above 0
float brewster_cosine(float eta) {
    return 1.0 / sqrt(1.0 + eta * eta);
}

// Reflectance at normal incidence.
//
//   f0 = ((eta - 1) / (eta + 1))^2
//
// eta       n_t / n_i, above 0
float f0_from_eta(float eta) {
    float r = (eta - 1.0) / (eta + 1.0); // amplitude
    return r * r;
}

// The relative index above 1 that has this f0.
//
//   eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)
//
// f0        reflectance at normal incidence, [0, 1)
float eta_from_f0(float f0) {
    float p = 1.0 + sqrt(f0);
    return p * p / (1.0 - f0);
}
`;

// ---- chunks for shaders of your own -------------------------------------------------------------------------------------

const guarded = (name, text) => `#ifndef ${name}\n#define ${name}\n${text}#endif\n`;

function known(model) {
    if (!(model in functions)) throw new Error(`fresnel: there is no model '${model}'; one of ${Object.keys(functions).join(', ')}`);
}

/// GLSL that defines the functions of these models, once however often it is included.
export function chunk(...models) {
    models.forEach(known);
    return guarded('FRESNEL_TYPES', types) +
        models.map((model) => guarded(`FRESNEL_${model.toUpperCase()}`, functions[model])).join('');
}

/// Adds a chunk for each model to three's own, so that a ShaderMaterial may say `#include <fresnel_schlick>`, and
/// `#include <fresnel_geometry>`.
export function registerChunks() {
    for (const model of Object.keys(functions)) ShaderChunk[`fresnel_${model}`] = chunk(model);
    ShaderChunk.fresnel_geometry = guarded('FRESNEL_TYPES', types) + guarded('FRESNEL_GEOMETRY', geometry);
}

// ---- three's own materials ----------------------------------------------------------------------------------------------

const triple = (value) => (value.isVector3 ? value
    : value.isColor ? new Vector3(value.r, value.g, value.b)
    : Array.isArray(value) ? new Vector3(...value) : new Vector3(value, value, value));

// The arguments of a call: what is given becomes a uniform, f0 and f90 that are not given are the material's own.
function argumentsOf(model, values, uniforms) {
    const own = { n_i: '1.0', f0: 'f0', f90: 'vec3(f90)' };
    const unknown = Object.keys(values).find((name) => !parameters[model].includes(name));
    if (unknown) throw new Error(`fresnel: ${model} has no parameter '${unknown}'; it takes ${parameters[model].join(', ')}`);
    return parameters[model].map((name) => {
        if (values[name] === undefined && own[name]) return own[name];
        if (values[name] === undefined) throw new Error(`fresnel: ${model} needs the parameter '${name}'`);
        uniforms[`fresnel_${name}`] = { value: name === 'n_i' ? values[name] : triple(values[name]) };
        return `fresnel_${name}`;
    });
}

function declarations(uniforms) {
    return Object.keys(uniforms).map((name) => `uniform ${name === 'fresnel_n_i' ? 'float' : 'vec3'} ${name};\n`).join('');
}

// Replaces text that must be there: three's chunks change from version to version.
function replaced(text, from, to) {
    if (!text.includes(from)) throw new Error(`fresnel: this version of three.js has no '${from}' where it was expected`);
    return text.replaceAll(from, to);
}

// three's chunk of physical lighting with another Fresnel term, but for the clear coat, which stands before BRDF_GGX.
function lightingChunk(definition) {
    const whole = ShaderChunk.lights_physical_pars_fragment, at = whole.indexOf('vec3 BRDF_GGX( ');
    if (at < 0) throw new Error('fresnel: this version of three.js has no BRDF_GGX where it was expected');
    return whole.slice(0, at) + definition + replaced(whole.slice(at), 'F_Schlick(', 'fresnel_term(');
}

// What the environment reflects was multiplied by three's approximation, averaged over the roughness; it is scaled by the
// ratio of the two terms at the mirror's angle.
const environmentCode = `
    {
        float fresnel_cos = saturate(dot(geometryNormal, geometryViewDir));
        reflectedLight.indirectSpecular *= fresnel_term(material.specularColorBlended, material.specularF90, fresnel_cos) /
            max(F_Schlick(material.specularColorBlended, material.specularF90, fresnel_cos), vec3(1e-4));
    }
`;

// Of each material the term that it has now, and all uniforms that its programs may know.
const terms = new WeakMap();

// Hooks behind those that a material has, once, however often its term changes.
function hook(material) {
    const state = { uniforms: {} }, before = material.onBeforeCompile, key = material.customProgramCacheKey;
    material.onBeforeCompile = (shader, renderer) => {
        before.call(material, shader, renderer);
        Object.assign(shader.uniforms, state.uniforms);
        let text = replaced(shader.fragmentShader, '#include <lights_physical_pars_fragment>', lightingChunk(state.definition));
        if (state.environment)
            text = replaced(text, '#include <lights_fragment_end>', `#include <lights_fragment_end>\n${environmentCode}`);
        shader.fragmentShader = text;
    };
    material.customProgramCacheKey = () => `${key.call(material)} ${before} fresnel ${state.call} ${state.environment}`;
    terms.set(material, state);
    return state;
}

// The same object for a uniform of the same name: a program that is drawn with again has the one that it was made with.
function kept(all, uniforms) {
    for (const [name, { value }] of Object.entries(uniforms)) {
        uniforms[name] = all[name] ??= uniforms[name];
        uniforms[name].value = value;
    }
    return uniforms;
}

/// Gives a MeshStandardMaterial or MeshPhysicalMaterial the Fresnel term of a model, for lights and for the environment.
///
/// values       the model's parameters: a number, a Color, a Vector3 or [r, g, b], linear. f0 and f90 that are not given
///              are the material's own, n_i is 1. `values` may be an entry of `metals` for the model 'f82'.
/// environment  false leaves what the environment reflects to three's own approximation
/// returns      the uniforms, {fresnel_f0: {value}, ...}, to be changed while the material is in use
///
/// A second call gives the material another term. A clear coat keeps its own term. Throws an Error for an unknown model, and a parameter that is unknown or missing; while
/// compiling, where three's own text is not as expected.
export function setFresnel(material, model, values = {}, { environment = true } = {}) {
    known(model);
    const uniforms = {}, call = `${model}(${[...argumentsOf(model, values, uniforms), 'cos_i'].join(', ')})`;
    const scalar = parameters[model].every((name) => name === 'n_i');
    const definition = `${declarations(uniforms)}${chunk(model)}
vec3 fresnel_term(vec3 f0, float f90, float cos_i) {
    return ${scalar ? `vec3(${call})` : call};
}

`;
    const state = terms.get(material) ?? hook(material);
    Object.assign(state, { definition, call, environment });
    material.needsUpdate = true;
    return kept(state.uniforms, uniforms);
}

// ---- a rim of light -----------------------------------------------------------------------------------------------------

/// An unlit material: a colour, and a rim by bias_scale_power. Its uniforms: base, rim, bias, scale, power.
export function rimMaterial({ base = 0x101018, rim = 0xffe0a0, bias = 0, scale = 1, power = 5 } = {}) {
    return new ShaderMaterial({
        uniforms: { base: { value: new Color(base) }, rim: { value: new Color(rim) }, bias: { value: bias },
                    scale: { value: scale }, power: { value: power } },
        vertexShader: `
varying vec3 vNormal, vView;
void main() {
    vec4 position4 = modelViewMatrix * vec4(position, 1.0);
    vNormal = normalMatrix * normal;
    vView = -position4.xyz;
    gl_Position = projectionMatrix * position4;
}`,
        fragmentShader: `
${chunk('bias_scale_power')}
uniform vec3 base, rim;
uniform float bias, scale, power;
varying vec3 vNormal, vView;
void main() {
    float F = bias_scale_power(bias, scale, power, normalize(vNormal), normalize(vView));
    gl_FragColor = vec4(mix(base, rim, F), 1.0);
    #include <tonemapping_fragment>
    #include <colorspace_fragment>
}`,
    });
}
