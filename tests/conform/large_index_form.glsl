// The form for a large index, taken for the exact one.
float conductor(float n, float k, float cosi) {
    float t = (n * n + k * k) * cosi * cosi;
    float Rp = (t - 2.0 * n * cosi + 1.0) / (t + 2.0 * n * cosi + 1.0);
    float u = n * n + k * k;
    float Rs = (u - 2.0 * n * cosi + cosi * cosi) / (u + 2.0 * n * cosi + cosi * cosi);
    return clamp(0.5 * (Rs + Rp), 0.0, 1.0);
}
