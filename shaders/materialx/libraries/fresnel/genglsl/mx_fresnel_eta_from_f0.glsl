// The relative index above 1 that has this f0.
//
//   eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)
//
// f0        reflectance at normal incidence, [0, 1)
float fresnel_eta_from_f0(float f0) {
    float p = 1.0 + sqrt(f0);
    return p * p / (1.0 - f0);
}

void mx_fresnel_eta_from_f0_float(float f0, out float result) {
    result = fresnel_eta_from_f0(f0);
}
