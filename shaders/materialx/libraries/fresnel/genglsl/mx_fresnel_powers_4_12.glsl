#ifndef FRESNEL_POWERS_4_12
#define FRESNEL_POWERS_4_12

// Two powers through f0 and f82.
//
//   F = f0 + x^4 (p + q x^8), through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0216, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    16 operations
// source  this library
float fresnel_powers_4_12(float f0, float f82, float cos_i) {
    float one_minus_f0 = 1.0 - f0;
    float rise = one_minus_f0 - (f82 - f0) * 1.8526235; // 1 / x^4 at cos_i = 1/7: (7/6)^4
    float q = rise * 1.4111481; // 1 / (1 - x^8) there
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    return clamp(f0 + x4 * (one_minus_f0 - q + q * (x4 * x4)), 0.0, 1.0);
}

// The same for three channels, which share the angle.
vec3 fresnel_powers_4_12(vec3 f0, vec3 f82, float cos_i) {
    vec3 one_minus_f0 = 1.0 - f0;
    vec3 rise = one_minus_f0 - (f82 - f0) * 1.8526235; // 1 / x^4 at cos_i = 1/7: (7/6)^4
    vec3 q = rise * 1.4111481; // 1 / (1 - x^8) there
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    return clamp(f0 + x4 * (one_minus_f0 - q + q * (x4 * x4)), 0.0, 1.0);
}

void mx_fresnel_powers_4_12_cos_float(float f0, float f82, float cos_i, out float result) {
    result = fresnel_powers_4_12(f0, f82, cos_i);
}

void mx_fresnel_powers_4_12_cos_color3(vec3 f0, vec3 f82, float cos_i, out vec3 result) {
    result = fresnel_powers_4_12(f0, f82, cos_i);
}

#endif
