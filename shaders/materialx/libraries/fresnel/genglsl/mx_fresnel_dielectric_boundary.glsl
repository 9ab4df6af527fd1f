#include "lib/fresnel_boundary.glsl"

// Reflectances and transmittances of both polarisations.
fresnel_boundary fresnel_dielectric_boundary(float n_i, float n_t, float cos_i) {
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
    fresnel_boundary result;
    result.R_s = R_s;
    result.R_p = R_p;
    result.T_s = min(T_s, 1.0);
    result.T_p = min(T_p, 1.0);
    return result;
}

void mx_fresnel_dielectric_boundary_float(float n_i, float n_t, float cos_i, out float R_s, out float R_p, out float T_s, out float T_p) {
    fresnel_boundary boundary = fresnel_dielectric_boundary(n_i, n_t, cos_i);
    R_s = boundary.R_s;
    R_p = boundary.R_p;
    T_s = boundary.T_s;
    T_p = boundary.T_p;
}
