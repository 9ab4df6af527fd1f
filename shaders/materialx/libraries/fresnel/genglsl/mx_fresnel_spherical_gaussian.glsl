#ifndef FRESNEL_SPHERICAL_GAUSSIAN
#define FRESNEL_SPHERICAL_GAUSSIAN

// Schlick's curve by a spherical Gaussian.
//
//   F = f0 + (1 - f0) 2^((-5.55473 cos_i - 6.98316) cos_i)
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0847, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    10 operations
// source  Lagarde 2012, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel
float fresnel_spherical_gaussian(float f0, float cos_i) {
    float p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}

// The same for three channels, which share the angle.
vec3 fresnel_spherical_gaussian(vec3 f0, float cos_i) {
    float p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}

void mx_fresnel_spherical_gaussian_cos_float(float f0, float cos_i, out float result) {
    result = fresnel_spherical_gaussian(f0, cos_i);
}

void mx_fresnel_spherical_gaussian_cos_color3(vec3 f0, float cos_i, out vec3 result) {
    result = fresnel_spherical_gaussian(f0, cos_i);
}

#endif
