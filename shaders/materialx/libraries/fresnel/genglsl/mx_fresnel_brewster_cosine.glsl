// Cosine of Brewster's angle, at which p-polarised light is not reflected.
//
//   cos_B = 1 / sqrt(1 + eta^2)
//
// eta       n_t / n_i, above 0
float fresnel_brewster_cosine(float eta) {
    return 1.0 / sqrt(1.0 + eta * eta);
}

void mx_fresnel_brewster_cosine_float(float eta, out float result) {
    result = fresnel_brewster_cosine(eta);
}
