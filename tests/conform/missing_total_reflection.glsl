// Beyond the critical angle this is the root of a negative number.
float fresnel(float cos_i, float eta) {
    float E = (eta - 1.0) * (eta + 1.0);
    float g = sqrt(E + cos_i * cos_i);
    float s2 = (1.0 - cos_i) * (1.0 + cos_i);
    float w = 4.0 * cos_i * g * (g + cos_i) * (g + cos_i);
    float Rs = E * E / max(E * E + w, 1e-36);
    float b = max(cos_i * g + s2, 1e-36);
    float q = (cos_i * g - s2) / b;
    return 0.5 * Rs * (1.0 + q * q);
}
