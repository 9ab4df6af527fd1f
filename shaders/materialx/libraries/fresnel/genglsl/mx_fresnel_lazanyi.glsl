#ifndef FRESNEL_LAZANYI
#define FRESNEL_LAZANYI

// Schlick's approximation less a term for the dip of metals before grazing incidence.
//
//   F = schlick_nk(n, k) - a c x^alpha, x = 1 - c, c = cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// a       depth of the dip, about 2 n, [0, 2000]
// alpha   sharpness of the dip, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0451, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    33 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
float fresnel_lazanyi(float n, float k, float a, float alpha, float cos_i) {
    float x = 1.0 - cos_i;
    float n_minus_1 = n - 1.0;
    float k2 = k * k;
    float x2 = x * x;
    float n_plus_1 = n + 1.0;
    float F = min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2), 1.0);
    return clamp(F - a * cos_i * pow(x, alpha), 0.0, 1.0);
}

// The same for three channels, which share the angle.
vec3 fresnel_lazanyi(vec3 n, vec3 k, vec3 a, vec3 alpha, float cos_i) {
    float x = 1.0 - cos_i;
    vec3 n_minus_1 = n - 1.0;
    vec3 k2 = k * k;
    float x2 = x * x;
    vec3 n_plus_1 = n + 1.0;
    vec3 F = min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2),
            vec3(1.0));
    return clamp(F - a * cos_i * pow(vec3(x), alpha), 0.0, 1.0);
}

void mx_fresnel_lazanyi_cos_float(float n, float k, float a, float alpha, float cos_i, out float result) {
    result = fresnel_lazanyi(n, k, a, alpha, cos_i);
}

void mx_fresnel_lazanyi_cos_color3(vec3 n, vec3 k, vec3 a, vec3 alpha, float cos_i, out vec3 result) {
    result = fresnel_lazanyi(n, k, a, alpha, cos_i);
}

#endif
