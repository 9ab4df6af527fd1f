// The medium in front is asked for and not used.
float conductor(float n_i, float n_t, float k_t, float c) {
    float n = n_t, k = k_t;
    float E = (n - 1.0) * (n + 1.0) - k * k, Z = 2.0 * n * k, s2 = (1.0 - c) * (1.0 + c);
    float t0 = E + c * c;
    float A = sqrt(t0 * t0 + Z * Z);
    float u = sqrt(max(0.5 * (A + abs(t0)), 1e-36)), v = 0.5 * Z / u;
    float a = t0 < 0.0 ? v : u, b = t0 < 0.0 ? u : v;
    float w = 4.0 * a * c * ((A + c * c) + 2.0 * a * c);
    float F = E * E + Z * Z;
    float Rs = F / max(F + w, 1e-30);
    float p = a * c - s2, q = b * c, m = a * c + s2;
    float Rp = Rs * (p * p + q * q) / max(m * m + q * q, 1e-30);
    return min(0.5 * (Rs + Rp), 1.0);
}
