#ifndef FRESNEL_POWERS_4_8
#define FRESNEL_POWERS_4_8

// Two powers for one operation more than Schlick, better on dielectrics.
//
//   F = f0 + x^4 ((a - f0) + (1 - a) x^4), a = 0.55, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0363, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    8 operations
// source  this library
float fresnel_powers_4_8(float f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    return f0 + x4 * (0.55 - f0 + 0.45 * x4);
}

// The same for three channels, which share the angle.
vec3 fresnel_powers_4_8(vec3 f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x4 = x2 * x2;
    return f0 + x4 * (0.55 - f0 + 0.45 * x4);
}

void mx_fresnel_powers_4_8_cos_float(float f0, float cos_i, out float result) {
    result = fresnel_powers_4_8(f0, cos_i);
}

void mx_fresnel_powers_4_8_cos_color3(vec3 f0, float cos_i, out vec3 result) {
    result = fresnel_powers_4_8(f0, cos_i);
}

#endif
