#include "lib/fresnel_boundary.glsl"

// Reflectances and transmittances of both polarisations.
fresnel_boundary fresnel_dielectric_fast_boundary(float n_i, float n_t, float cos_i) {
    float c = n_i * cos_i;
    float sin2 = 1.0 - cos_i * cos_i;
    float s2 = n_i * sin2;
    float g2 = n_t * n_t - n_i * s2;
    float g = sqrt(g2);
    float x = cos_i * g;
    float a = g + c;
    float a_2 = g2 <= 0.0 ? 1.0 : a;
    float b = x + s2;
    float b_2 = g2 <= 0.0 ? 1.0 : b;
    float r_s = g2 <= 0.0 ? 1.0 : (g - c) / a;
    float q = g2 <= 0.0 ? 1.0 : (x - s2) / b;
    float w = g2 <= 0.0 ? 0.0 : 4.0 * (c * g);
    float r_s2 = r_s * r_s;
    float t = w / (a_2 * a_2);
    return fresnel_boundary(r_s2, r_s2 * (q * q), min(t, 1.0), min(t + r_s2 * (w * sin2 / (b_2 * b_2)), 1.0));
}

void mx_fresnel_dielectric_fast_boundary_float(float n_i, float n_t, float cos_i, out float R_s, out float R_p, out float T_s, out float T_p) {
    fresnel_boundary boundary = fresnel_dielectric_fast_boundary(n_i, n_t, cos_i);
    R_s = boundary.R_s;
    R_p = boundary.R_p;
    T_s = boundary.T_s;
    T_p = boundary.T_p;
}
