// Reflectance at normal incidence.
//
//   f0 = ((eta - 1) / (eta + 1))^2
//
// eta       n_t / n_i, above 0
float fresnel_f0_from_eta(float eta) {
    float r = (eta - 1.0) / (eta + 1.0); // amplitude
    return r * r;
}

void mx_fresnel_f0_from_eta_float(float eta, out float result) {
    result = fresnel_f0_from_eta(eta);
}
