#include "lib/fresnel_boundary.glsl"

// Reflectances and transmittances of both polarisations.
fresnel_boundary fresnel_conductor_boundary(float n_i, float n_t, float k_t, float cos_i) {
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
    fresnel_boundary result;
    result.R_s = R_s;
    result.R_p = R_p;
    result.T_s = min(T_s, 1.0);
    result.T_p = min(T_p, 1.0);
    return result;
}

void mx_fresnel_conductor_boundary_float(float n_i, float n_t, float k_t, float cos_i, out float R_s, out float R_p, out float T_s, out float T_p) {
    fresnel_boundary boundary = fresnel_conductor_boundary(n_i, n_t, k_t, cos_i);
    R_s = boundary.R_s;
    R_p = boundary.R_p;
    T_s = boundary.T_s;
    T_p = boundary.T_p;
}
