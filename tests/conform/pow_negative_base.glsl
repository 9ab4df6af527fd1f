// pow of a base below 0 is undefined, and NaN on most devices: cos_theta is often a rounding error above 1.
vec3 F_Schlick(float cos_theta, vec3 F0) {
    return F0 + (1.0 - F0) * pow(1.0 - cos_theta, 5.0);
}
