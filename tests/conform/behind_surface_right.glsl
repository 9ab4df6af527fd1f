vec3 fresnel(vec3 n, vec3 v, vec3 F0) {
    float m = 1.0 - clamp(dot(n, v), 0.0, 1.0);
    float m2 = m * m;
    return F0 + (1.0 - F0) * (m2 * m2 * m);
}
