#ifndef FRESNEL_F82_TINT
#define FRESNEL_F82_TINT

// Schlick's approximation with a dip, given as a fraction of its value at cos_i = 1/7.
//
//   F = f82(f0, tint schlick(f0, 1/7))
//
// f0      reflectance at normal incidence, [0, 1]
// tint    f82 over that of Schlick, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0451, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    18 operations
// source  Kutz, Hasan and Edmondson 2021, Novel aspects of the Adobe Standard Material
float fresnel_f82_tint(float f0, float tint, float cos_i) {
    float one_minus_f0 = 1.0 - f0;
    float at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    float b = at_82 * (1.0 - tint) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x5 = x2 * x2 * x;
    return clamp(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x), 0.0, 1.0);
}

// The same for three channels, which share the angle.
vec3 fresnel_f82_tint(vec3 f0, vec3 tint, float cos_i) {
    vec3 one_minus_f0 = 1.0 - f0;
    vec3 at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    vec3 b = at_82 * (1.0 - tint) * 17.651384; // divided by c x^6 at cos_i = 1/7
    float x = 1.0 - cos_i;
    float x2 = x * x;
    float x5 = x2 * x2 * x;
    return clamp(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x), 0.0, 1.0);
}

void mx_fresnel_f82_tint_cos_float(float f0, float tint, float cos_i, out float result) {
    result = fresnel_f82_tint(f0, tint, cos_i);
}

void mx_fresnel_f82_tint_cos_color3(vec3 f0, vec3 tint, float cos_i, out vec3 result) {
    result = fresnel_f82_tint(f0, tint, cos_i);
}

#endif
