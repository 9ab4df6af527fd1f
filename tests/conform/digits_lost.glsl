// eta^2 - 1 keeps no digit near an index match.
float fresnel(float cosTheta, float ior) {
    float g2 = ior * ior - 1.0 + cosTheta * cosTheta;
    if (g2 <= 0.0) return 1.0;
    float g = sqrt(g2);
    float c = cosTheta;
    float A = (g - c) / (g + c);
    float B = (c * (g + c) - 1.0) / (c * (g - c) + 1.0);
    return 0.5 * A * A * (1.0 + B * B);
}
