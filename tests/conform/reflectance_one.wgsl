// A reflectance of 1 divides by 0.
fn artist_fresnel(r: f32, g: f32, cos_theta: f32) -> f32 {
    let c = cos_theta;
    let s = sqrt(r);
    let n_max = (1.0 + s) / (1.0 - s);
    let n_min = (1.0 - s * s) / (1.0 + s * s);
    let span = n_max - n_min;
    let n = select(n_min + span * (1.0 - g), n_max - span * g, g < 0.5);
    let k2 = max((n_max - n) * (n - 1.0 / n_max), 0.0);
    let k = sqrt(k2);
    let s2 = (1.0 - c) * (1.0 + c);
    let E = (n - 1.0) * (n + 1.0) - k2;
    let Z = 2.0 * n * k;
    let t0 = E + c * c;
    let A = sqrt(t0 * t0 + Z * Z);
    let u = sqrt(max(0.5 * (A + abs(t0)), 1e-36));
    let v = 0.5 * Z / u;
    let a = select(u, v, t0 < 0.0);
    let b = select(v, u, t0 < 0.0);
    let w = 4.0 * a * c * ((A + c * c) + 2.0 * a * c);
    let F = E * E + Z * Z;
    let Rs = F / max(F + w, 1e-30);
    let p = a * c - s2;
    let q = b * c;
    let m = a * c + s2;
    return 0.5 * Rs * (1.0 + (p * p + q * q) / max(m * m + q * q, 1e-30));
}
