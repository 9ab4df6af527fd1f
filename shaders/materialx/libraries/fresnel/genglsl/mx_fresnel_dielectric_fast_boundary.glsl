#include "lib/fresnel_boundary.glsl"

// Reflectances and transmittances of both polarisations.
fresnel_boundary fresnel_dielectric_fast_boundary(float n_i, float n_t, float cos_i) {
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
    fresnel_boundary result;
    result.R_s = R_s;
    result.R_p = R_p;
    result.T_s = min(T_s, 1.0);
    result.T_p = min(T_p, 1.0);
    return result;
}

void mx_fresnel_dielectric_fast_boundary_float(float n_i, float n_t, float cos_i, out float R_s, out float R_p, out float T_s, out float T_p) {
    fresnel_boundary boundary = fresnel_dielectric_fast_boundary(n_i, n_t, cos_i);
    R_s = boundary.R_s;
    R_p = boundary.R_p;
    T_s = boundary.T_s;
    T_p = boundary.T_p;
}
