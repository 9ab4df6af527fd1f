#ifndef FRESNEL_GULBRANDSEN
#define FRESNEL_GULBRANDSEN

// An index from two artist's colours, then the exact equations.
//
//   F = conductor(n, k), n = mix(n_max(r), n_min(r), g), k^2 = ((n + 1)^2 r - (n - 1)^2) / (1 - r)
//
// r       reflectance at normal incidence, [0, 1]
// g       edge tint, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float 3e-7 for r in [0.02, 0.99]
// cost    96 operations
// source  Gulbrandsen 2014, Artist Friendly Metallic Fresnel
float fresnel_gulbrandsen(float r, float g, float cos_i) {
    float f0 = min(r, 0.9999) + 8.271806e-25; // 2^-80 keeps its root's slope finite
    float root = sqrt(f0);
    float one_minus_f0 = 1.0 - f0;
    float one_plus_f0 = 1.0 + f0;
    float one_plus_root = 1.0 + root;
    float one_minus_root = 1.0 - root;

    // indices, all times 1 - f0^2
    float n_i = one_minus_f0 * one_plus_f0;
    float n_max = one_plus_root * one_plus_root * one_plus_f0;
    float n_min = one_minus_f0 * one_minus_f0;
    float n_0 = one_minus_root * one_minus_root * one_plus_f0; // 1 / n_max; k is 0 at both
    float n = n_max * (1.0 - g) + n_min * g;
    float k = sqrt(max((n_max - n) * (n - n_0), 0.0) + 8.271806e-25);
    float c = n_i * cos_i;
    float c2 = c * c;
    float cos2 = cos_i * cos_i;
    float sin2 = 1.0 - cos2;
    float s2 = n_i * sin2;
    float s4 = s2 * s2;

    // Snell
    float E = (n - n_i) * (n + n_i) - k * k; // Re m^2 - n_i^2, m the complex index
    float Z = 2.0 * (n * k); // Im m^2
    float Z2 = Z * Z;
    float t0 = E + c2; // q^2 = t0 + i Z
    float A = sqrt(t0 * t0 + Z2); // |q|^2
    float S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    float u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    float a = t0 <= 0.0 ? Z : S; // u Re q

    // s-polarised, across the plane of incidence
    float h = 2.0 * (a * c);
    float F = (E * E + Z2) * S; // S |c - q|^2 |c + q|^2
    float G_s = (A + c2) * u + h;
    float D_s = max(F + h * G_s, 1.1754944e-38); // S |c + q|^4; 0 only for equal media at cos_i = 0
    float R_s = F / D_s;

    // p-polarised, along it
    float h_p = h * sin2;
    float N = t0 * cos2 - s4;
    float M = Z * cos2;
    float M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    float B = (N * N + M2) * S; // S |q c - s^2|^2 |q c + s^2|^2
    float G_p = (A * cos2 + s4) * u + h_p;
    float D_p = B + h_p * G_p; // S |q c + s^2|^4
    float R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}

// The same for three channels, which share the angle.
vec3 fresnel_gulbrandsen(vec3 r, vec3 g, float cos_i) {
    return vec3(fresnel_gulbrandsen(r.x, g.x, cos_i),
                fresnel_gulbrandsen(r.y, g.y, cos_i),
                fresnel_gulbrandsen(r.z, g.z, cos_i));
}

void mx_fresnel_gulbrandsen_cos_float(float r, float g, float cos_i, out float result) {
    result = fresnel_gulbrandsen(r, g, cos_i);
}

void mx_fresnel_gulbrandsen_cos_color3(vec3 r, vec3 g, float cos_i, out vec3 result) {
    result = fresnel_gulbrandsen(r, g, cos_i);
}

#endif
