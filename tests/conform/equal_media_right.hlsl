float fresnel(float cosTheta, float ior) {
    float c = cosTheta;
    float E = (ior - 1.0) * (ior + 1.0);
    float g = sqrt(max(E + c * c, 0.0));
    float s2 = (1.0 - c) * (1.0 + c);
    float rs = E / max((g + c) * (g + c), 1e-18);
    float q = (c * g - s2) / max(c * g + s2, 1e-36);
    if (E + c * c < 0.0) return 1.0;
    return 0.5 * rs * rs * (1.0 + q * q);
}
