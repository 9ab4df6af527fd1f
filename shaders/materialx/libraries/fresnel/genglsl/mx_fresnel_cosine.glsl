// The cosine between two directions, 0 where they lie on opposite sides.
//
// normal    unit
// direction where the light comes from, or the eye is; unit, on the side of normal
float fresnel_incidence_cosine(vec3 normal, vec3 direction) {
    return clamp(dot(normal, direction), 0.0, 1.0);
}

void mx_fresnel_cosine_float(vec3 normal, vec3 viewdirection, out float result) {
    result = fresnel_incidence_cosine(normal, -viewdirection);
}
