#ifndef FRESNEL_HOFFMAN
#define FRESNEL_HOFFMAN

// Schlick's approximation with a dip, any power and any reflectance at grazing incidence.
//
//   F = f0 + (f90 - f0) x^power - b c x^6, through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0185, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    34 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful; MaterialX
float fresnel_hoffman(float f0, float f82, float f90, float power, float cos_i) {
    float rise = f90 - f0;
    float at_82 = f0 + rise * pow(0.85714287, power); // at cos_i = 1/7: x is 6/7
    float b = (at_82 - f82) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return clamp(f0 + rise * pow(x, power) - b * cos_i * (x2 * x2 * x2), 0.0, 1.0);
}

// The same for three channels, which share the angle.
vec3 fresnel_hoffman(vec3 f0, vec3 f82, vec3 f90, vec3 power, float cos_i) {
    vec3 rise = f90 - f0;
    vec3 at_82 = f0 + rise * pow(vec3(0.85714287), power); // at cos_i = 1/7: x is 6/7
    vec3 b = (at_82 - f82) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return clamp(f0 + rise * pow(vec3(x), power) - b * cos_i * (x2 * x2 * x2), 0.0, 1.0);
}

void mx_fresnel_hoffman_cos_float(float f0, float f82, float f90, float power, float cos_i, out float result) {
    result = fresnel_hoffman(f0, f82, f90, power, cos_i);
}

void mx_fresnel_hoffman_cos_color3(vec3 f0, vec3 f82, vec3 f90, vec3 power, float cos_i, out vec3 result) {
    result = fresnel_hoffman(f0, f82, f90, power, cos_i);
}

#endif
