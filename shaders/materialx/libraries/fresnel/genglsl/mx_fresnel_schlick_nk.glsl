#ifndef FRESNEL_SCHLICK_NK
#define FRESNEL_SCHLICK_NK

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
float fresnel_schlick_nk(float n, float k, float cos_i) {
    float x = 1.0 - cos_i;
    float n_minus_1 = n - 1.0;
    float k2 = k * k;
    float x2 = x * x;
    float n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2), 1.0);
}

// The same for three channels, which share the angle.
vec3 fresnel_schlick_nk(vec3 n, vec3 k, float cos_i) {
    float x = 1.0 - cos_i;
    vec3 n_minus_1 = n - 1.0;
    vec3 k2 = k * k;
    float x2 = x * x;
    vec3 n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2),
            vec3(1.0));
}

void mx_fresnel_schlick_nk_cos_float(float n, float k, float cos_i, out float result) {
    result = fresnel_schlick_nk(n, k, cos_i);
}

void mx_fresnel_schlick_nk_cos_color3(vec3 n, vec3 k, float cos_i, out vec3 result) {
    result = fresnel_schlick_nk(n, k, cos_i);
}

#endif
