// A strong tint goes below 0.
fn f82_tint(f0: vec3f, tint: vec3f, cos_theta: f32) -> vec3f {
    let m = saturate(1.0 - cos_theta);
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    let at_82 = f0 + (vec3f(1.0) - f0) * 0.46266437;
    let b = at_82 * (vec3f(1.0) - tint) * 17.651384;
    return f0 + (vec3f(1.0) - f0) * m5 - b * cos_theta * (m5 * m);
}
