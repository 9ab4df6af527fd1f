// Negative near n = 1, k = 0, where t1 and t2 are equal but for their rounding.
float conductor(float n, float k, float c) {
    float c2 = c * c, s2 = 1.0 - c2;
    float t0 = n * n - k * k - s2;
    float A = sqrt(t0 * t0 + 4.0 * n * n * k * k);
    float a = sqrt(max(0.5 * (A + t0), 0.0));
    float t1 = A + c2, t2 = 2.0 * c * a;
    float Rs = (t1 - t2) / max(t1 + t2, 1e-30);
    float t3 = c2 * A + s2 * s2, t4 = t2 * s2;
    float Rp = Rs * (t3 - t4) / max(t3 + t4, 1e-30);
    return 0.5 * (Rs + Rp);
}
