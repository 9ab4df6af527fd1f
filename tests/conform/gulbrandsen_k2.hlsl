// k^2 with (r - 1)^2 in place of (n - 1)^2.
float artist_fresnel(float r, float g, float c) {
    r = min(r, 0.9999);
    float n = lerp((1.0 + sqrt(r)) / (1.0 - sqrt(r)), (1.0 - r) / (1.0 + r), g);
    float k2 = max((r * (n + 1.0) * (n + 1.0) - (r - 1.0) * (r - 1.0)) / (1.0 - r), 0.0);
    float k = sqrt(k2), s2 = (1.0 - c) * (1.0 + c);
    float E = (n - 1.0) * (n + 1.0) - k2, Z = 2.0 * n * k;
    float t0 = E + c * c;
    float A = sqrt(t0 * t0 + Z * Z);
    float u = sqrt(max(0.5 * (A + abs(t0)), 1e-36)), v = 0.5 * Z / u;
    float a = t0 < 0.0 ? v : u, b = t0 < 0.0 ? u : v;
    float w = 4.0 * a * c * ((A + c * c) + 2.0 * a * c);
    float F = E * E + Z * Z;
    float Rs = F / max(F + w, 1e-30);
    float p = a * c - s2, q = b * c, m = a * c + s2;
    return min(0.5 * Rs * (1.0 + (p * p + q * q) / max(m * m + q * q, 1e-30)), 1.0);
}
