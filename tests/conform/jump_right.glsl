float F(float f0, float u) {
    float m = 1.0 - u;
    return f0 + (1.0 - f0) * m * m * m * m * m;
}
