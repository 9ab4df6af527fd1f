// Takes the tint and does nothing with it.
fn f82_tint(f0: vec3f, tint: vec3f, cos_theta: f32) -> vec3f {
    let m = saturate(1.0 - cos_theta);
    let m2 = m * m;
    return f0 + (vec3f(1.0) - f0) * (m2 * m2 * m);
}
