// Cosine of the critical angle, beyond which everything is reflected; 0 where there is none.
//
//   cos_c = sqrt(1 - eta^2)
//
// eta       n_t / n_i, above 0
float fresnel_critical_cosine(float eta) {
    return eta < 1.0 ? sqrt((1.0 - eta) * (1.0 + eta)) : 0.0;
}

void mx_fresnel_critical_cosine_float(float eta, out float result) {
    result = fresnel_critical_cosine(eta);
}
