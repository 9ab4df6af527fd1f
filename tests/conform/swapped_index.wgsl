// The index the wrong way up: from the inside of the surface.
fn fresnel(cos_i: f32, eta: f32) -> f32 {
    let n = 1.0 / eta;
    let E = (n - 1.0) * (n + 1.0);
    let g = sqrt(max(E + cos_i * cos_i, 0.0));
    let s2 = (1.0 - cos_i) * (1.0 + cos_i);
    let w = 4.0 * cos_i * g * (g + cos_i) * (g + cos_i);
    let Rs = E * E / max(E * E + w, 1e-36);
    let q = (cos_i * g - s2) / max(cos_i * g + s2, 1e-36);
    return 0.5 * Rs * (1.0 + q * q);
}
