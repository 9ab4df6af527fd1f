#ifndef FRESNEL_SCHLICK_F90
#define FRESNEL_SCHLICK_F90

// Schlick's approximation with any reflectance at grazing incidence.
//
//   F = f0 + (f90 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994; Real-Time Rendering, 4th ed., eq. 9.18
float fresnel_schlick_f90(float f0, float f90, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (f90 - f0) * (x2 * x2 * x);
}

// The same for three channels, which share the angle.
vec3 fresnel_schlick_f90(vec3 f0, vec3 f90, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (f90 - f0) * (x2 * x2 * x);
}

void mx_fresnel_schlick_f90_cos_float(float f0, float f90, float cos_i, out float result) {
    result = fresnel_schlick_f90(f0, f90, cos_i);
}

void mx_fresnel_schlick_f90_cos_color3(vec3 f0, vec3 f90, float cos_i, out vec3 result) {
    result = fresnel_schlick_f90(f0, f90, cos_i);
}

#endif
