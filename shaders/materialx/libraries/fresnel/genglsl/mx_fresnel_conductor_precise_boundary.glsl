#include "lib/fresnel_boundary.glsl"

#include "lib/fresnel_twofold.glsl"

// Reflectances and transmittances of both polarisations.
fresnel_boundary fresnel_conductor_precise_boundary(float n_i, float n_t, float k_t, float cos_i) {
    float s2 = (1.0 - cos_i) * (1.0 + cos_i);

    // what cancels, in twice the digits
    vec2 n2 = two_product(n_t, n_t);
    vec2 k2 = two_product(k_t, k_t);
    vec2 i2 = two_product(n_i, n_i);
    vec2 c2 = two_product(cos_i, cos_i);
    vec2 m2 = twofold_difference(n2, k2); // Re m^2, m = n_t + i k_t
    vec2 E = twofold_difference(m2, i2);
    vec2 p2 = twofold_product(i2, c2); // (n_i cos_i)^2
    vec2 q2 = twofold_sum(E, p2); // Re q^2, q^2 = m^2 - (n_i sin_i)^2
    vec2 sum2 = twofold_sum(n2, i2);
    vec2 product = twofold_product(c2, sum2);
    vec2 N = twofold_difference(product, i2); // 0 at Brewster's angle where k_t = 0

    // q = a + i b, which is m cos_t; lengths in units of 1 / n_i
    float c = n_i * cos_i;
    float nk = n_t * k_t; // Im q^2 / 2
    float size = abs(q2.x);
    float A = max(sqrt(q2.x * q2.x + 4.0 * (nk * nk)), size); // |q|^2
    float larger = sqrt((A + size) / 2.0); // of |Re q| and |Im q|
    float smaller = nk / (larger > 0.0 ? larger : 1.0);
    float a = q2.x <= 0.0 ? smaller : larger; // Re q
    float b = q2.x <= 0.0 ? larger : smaller; // Im q
    float b2 = b * b;

    // s-polarised; d is a - c, exact near an index match as well
    float a_minus_c = a - c;
    float a_plus_c = a + c;
    float d = max(2.0 * abs(a_minus_c), b) < c ? (E.x + b2) / a_plus_c : a_minus_c;
    float D_s = a_plus_c * a_plus_c + b2;
    float D = D_s <= 0.0 ? 1.0 : D_s; // 0 only for equal media at cos_i = 0
    float N_s = d * d + b2;
    float R_s = N_s / D;
    float T_s = N_s <= 0.0 ? 1.0 : 4.0 * (a * c) / D;

    // p-polarised; nu is a cos_i - n_i sin_i^2, exact near Brewster's angle as well
    float is2 = n_i * s2;
    float ac = a * cos_i;
    float bc = b * cos_i;
    float bc2 = bc * bc;
    float difference = ac - is2;
    float total = ac + is2;
    float sum = total <= 0.0 ? 1.0 : total;
    float exact = (N.x + c2.x * (b2 - k2.x)) / sum;
    float nu = max(2.0 * abs(difference) - is2, 2.0 * b - n_i) < 0.0 ? exact : difference;
    float P = sum * sum + bc2;
    float R_p = R_s * ((nu * nu + bc2) / P);
    float T_p = T_s + R_s * (4.0 * (ac * is2) / P);
    fresnel_boundary result;
    result.R_s = min(R_s, 1.0);
    result.R_p = min(R_p, 1.0);
    result.T_s = min(T_s, 1.0);
    result.T_p = min(T_p, 1.0);
    return result;
}

void mx_fresnel_conductor_precise_boundary_float(float n_i, float n_t, float k_t, float cos_i, out float R_s, out float R_p, out float T_s, out float T_p) {
    fresnel_boundary boundary = fresnel_conductor_precise_boundary(n_i, n_t, k_t, cos_i);
    R_s = boundary.R_s;
    R_p = boundary.R_p;
    T_s = boundary.T_s;
    T_p = boundary.T_p;
}
