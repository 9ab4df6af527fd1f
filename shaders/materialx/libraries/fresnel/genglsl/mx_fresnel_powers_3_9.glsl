#ifndef FRESNEL_POWERS_3_9
#define FRESNEL_POWERS_3_9

// Two powers, less than half of Schlick's error on dielectrics.
//
//   F = f0 + x^3 max((1 - f0) - 0.54 (1 - x^6), 0), x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0328, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    12 operations
// source  this library
float fresnel_powers_3_9(float f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x3 = x * x * x;
    float rise = clamp(1.0 - f0 - 0.54 * (1.0 - x3 * x3), 0.0, 1.0); // saturate is free on GPUs
    return f0 + x3 * rise;
}

// The same for three channels, which share the angle.
vec3 fresnel_powers_3_9(vec3 f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x3 = x * x * x;
    vec3 rise = clamp(1.0 - f0 - 0.54 * (1.0 - x3 * x3), 0.0, 1.0); // saturate is free on GPUs
    return f0 + x3 * rise;
}

void mx_fresnel_powers_3_9_cos_float(float f0, float cos_i, out float result) {
    result = fresnel_powers_3_9(f0, cos_i);
}

void mx_fresnel_powers_3_9_cos_color3(vec3 f0, float cos_i, out vec3 result) {
    result = fresnel_powers_3_9(f0, cos_i);
}

#endif
