#ifndef FRESNEL_PHOTOMETRIC
#define FRESNEL_PHOTOMETRIC

// A curve found by symbolic regression.
//
//   F = f0 + (x - f0) x^4, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0708, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    6 operations
// source  photometric.io, Improving Schlick's Approximation
float fresnel_photometric(float f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (x - f0) * (x2 * x2);
}

// The same for three channels, which share the angle.
vec3 fresnel_photometric(vec3 f0, float cos_i) {
    float x = 1.0 - cos_i;
    float x2 = x * x;
    return f0 + (x - f0) * (x2 * x2);
}

void mx_fresnel_photometric_cos_float(float f0, float cos_i, out float result) {
    result = fresnel_photometric(f0, cos_i);
}

void mx_fresnel_photometric_cos_color3(vec3 f0, float cos_i, out vec3 result) {
    result = fresnel_photometric(f0, cos_i);
}

#endif
