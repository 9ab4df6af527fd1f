#ifndef FRESNEL_POWERS_3_6_9
#define FRESNEL_POWERS_3_6_9

// Three powers with coefficients in sqrt(f0), a tenth of Schlick's error on dielectrics.
//
//   F = f0 + y (p + y (q + y r)), y = (1 - cos_i)^3, p and q linear in sqrt(f0) and f0,
//   p + q + r = 1 - f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.00713, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    27 operations
// source  this library
float fresnel_powers_3_6_9(float f0, float cos_i) {
    float s = sqrt(f0 + 8.271806e-25); // 2^-80 keeps the slope at f0 = 0 finite
    float p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    float q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    float r = 1.0 - f0 - p - q;
    float x = 1.0 - cos_i;
    float y = x * x * x;
    return clamp(f0 + y * (p + y * (q + y * r)), 0.0, 1.0);
}

// The same for three channels, which share the angle.
vec3 fresnel_powers_3_6_9(vec3 f0, float cos_i) {
    vec3 s = sqrt(f0 + 8.271806e-25); // 2^-80 keeps the slope at f0 = 0 finite
    vec3 p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    vec3 q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    vec3 r = 1.0 - f0 - p - q;
    float x = 1.0 - cos_i;
    float y = x * x * x;
    return clamp(f0 + y * (p + y * (q + y * r)), 0.0, 1.0);
}

void mx_fresnel_powers_3_6_9_cos_float(float f0, float cos_i, out float result) {
    result = fresnel_powers_3_6_9(f0, cos_i);
}

void mx_fresnel_powers_3_6_9_cos_color3(vec3 f0, float cos_i, out vec3 result) {
    result = fresnel_powers_3_6_9(f0, cos_i);
}

#endif
