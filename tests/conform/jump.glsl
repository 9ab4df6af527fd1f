// Two formulas that do not meet where one takes over from the other.
float F(float f0, float u) {
    float m = 1.0 - u;
    if (u > 0.7) return f0;
    return f0 + (1.0 - f0) * m * m * m * m * m;
}
