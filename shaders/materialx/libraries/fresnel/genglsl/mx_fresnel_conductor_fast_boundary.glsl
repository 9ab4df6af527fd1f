#include "lib/fresnel_boundary.glsl"

// Reflectances and transmittances of both polarisations.
fresnel_boundary fresnel_conductor_fast_boundary(float n_i, float n_t, float k_t, float cos_i) {
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
    fresnel_boundary result;
    result.R_s = R_s;
    result.R_p = R_p;
    result.T_s = min(T_s, 1.0);
    result.T_p = min(T_p, 1.0);
    return result;
}

void mx_fresnel_conductor_fast_boundary_float(float n_i, float n_t, float k_t, float cos_i, out float R_s, out float R_p, out float T_s, out float T_p) {
    fresnel_boundary boundary = fresnel_conductor_fast_boundary(n_i, n_t, k_t, cos_i);
    R_s = boundary.R_s;
    R_p = boundary.R_p;
    T_s = boundary.T_s;
    T_p = boundary.T_p;
}
