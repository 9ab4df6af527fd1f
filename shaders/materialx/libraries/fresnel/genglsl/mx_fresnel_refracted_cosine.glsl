// Snell's law: cosine of the transmitted ray, 0 beyond the critical angle.
//
//   cos_t = sqrt(eta^2 - 1 + cos_i^2) / eta
//
// eta       n_t / n_i, above 0
// cos_i     cosine of incidence, [0, 1]
float fresnel_refracted_cosine(float eta, float cos_i) {
    float g2 = (eta - 1.0) * (eta + 1.0) + cos_i * cos_i;
    return g2 <= 0.0 ? 0.0 : min(sqrt(g2) / eta, 1.0);
}

void mx_fresnel_refracted_cosine_float(float eta, float cos_i, out float result) {
    result = fresnel_refracted_cosine(eta, cos_i);
}
