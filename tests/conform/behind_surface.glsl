// The cosine of directions on opposite sides of the surface is negative, and the rim grows without bound.
vec3 fresnel(vec3 n, vec3 v, vec3 F0) {
    float m = 1.0 - dot(n, v);
    float m2 = m * m;
    return F0 + (1.0 - F0) * (m2 * m2 * m);
}
