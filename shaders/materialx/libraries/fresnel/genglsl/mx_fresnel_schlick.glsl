#ifndef FRESNEL_SCHLICK
#define FRESNEL_SCHLICK

// Schlick's approximation.
//
//   F = f0 + (1 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering
float fresnel_schlick(float f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

// The same for three channels, which share the angle.
vec3 fresnel_schlick(vec3 f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

void mx_fresnel_schlick_cos_float(float f0, float cos_i, out float result) {
    result = fresnel_schlick(f0, cos_i);
}

void mx_fresnel_schlick_cos_color3(vec3 f0, float cos_i, out vec3 result) {
    result = fresnel_schlick(f0, cos_i);
}

#endif
