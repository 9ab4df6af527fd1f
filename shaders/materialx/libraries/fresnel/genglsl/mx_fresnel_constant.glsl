#ifndef FRESNEL_CONSTANT
#define FRESNEL_CONSTANT

// No Fresnel effect.
//
//   F = f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.983, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    0 operations
// source  no Fresnel effect
float fresnel_constant(float f0, float cos_i) {
    return f0;
}

// The same for three channels, which share the angle.
vec3 fresnel_constant(vec3 f0, float cos_i) {
    return f0;
}

void mx_fresnel_constant_cos_float(float f0, float cos_i, out float result) {
    result = fresnel_constant(f0, cos_i);
}

void mx_fresnel_constant_cos_color3(vec3 f0, float cos_i, out vec3 result) {
    result = fresnel_constant(f0, cos_i);
}

#endif
