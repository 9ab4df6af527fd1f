// Fresnel reflectance in WGSL. Made by `fresnel shader --all --lang wgsl`; do not edit.
//
// eta = n_t / n_i, the index behind the surface over the one in front; complex: n + i k.
// cos_i is the cosine of incidence, in [0, 1].
// Directions are unit vectors and point away from the surface; the one beside the normal is
// yours: the view, the light or the half vector with either.
// Reflectance is of unpolarised light and lies in [0, 1]. RGB values are linear.

struct fresnel_boundary {
    R_s: f32,
    R_p: f32,
    T_s: f32,
    T_p: f32,
}

// The cosine between two directions, 0 where they lie on opposite sides.
//
// normal    unit
// direction where the light comes from, or the eye is; unit, on the side of normal
fn incidence_cosine(normal: vec3f, direction: vec3f) -> f32 {
    return saturate(dot(normal, direction));
}

// ---- directions, angles and indices --------------------------------------------------------------------------

// The mirror direction, on the side of normal.
//
//   r = 2 (n . v) n - v
//
// direction where the light comes from, or the eye is; unit, on the side of normal
// normal    unit
fn reflected_direction(direction: vec3f, normal: vec3f) -> vec3f {
    return 2.0 * dot(normal, direction) * normal - direction;
}

// The refracted direction, on the other side of normal; the zero vector beyond the critical angle.
//
//   t = -(v - cos_i n) / eta - cos_t n
//
// direction where the light comes from, or the eye is; unit, on the side of normal
// normal    unit
// eta       n_t / n_i, above 0
fn refracted_direction(direction: vec3f, normal: vec3f, eta: f32) -> vec3f {
    let cos_i = dot(normal, direction);
    let g2 = (eta - 1.0) * (eta + 1.0) + cos_i * cos_i;
    let cos_t = select(min(sqrt(g2) / eta, 1.0), 0.0, g2 <= 0.0);
    let scale = select(1.0 / eta, 0.0, g2 < 0.0);
    let down = select(cos_t, 0.0, g2 < 0.0);
    return -scale * (direction - cos_i * normal) - down * normal;
}

// Snell's law: cosine of the transmitted ray, 0 beyond the critical angle.
//
//   cos_t = sqrt(eta^2 - 1 + cos_i^2) / eta
//
// eta       n_t / n_i, above 0
// cos_i     cosine of incidence, [0, 1]
fn refracted_cosine(eta: f32, cos_i: f32) -> f32 {
    let g2 = (eta - 1.0) * (eta + 1.0) + cos_i * cos_i;
    return select(min(sqrt(g2) / eta, 1.0), 0.0, g2 <= 0.0);
}

// Cosine of the critical angle, beyond which everything is reflected; 0 where there is none.
//
//   cos_c = sqrt(1 - eta^2)
//
// eta       n_t / n_i, above 0
fn critical_cosine(eta: f32) -> f32 {
    return select(0.0, sqrt((1.0 - eta) * (1.0 + eta)), eta < 1.0);
}

// Cosine of Brewster's angle, at which p-polarised light is not reflected.
//
//   cos_B = 1 / sqrt(1 + eta^2)
//
// eta       n_t / n_i, above 0
fn brewster_cosine(eta: f32) -> f32 {
    return 1.0 / sqrt(1.0 + eta * eta);
}

// Reflectance at normal incidence.
//
//   f0 = ((eta - 1) / (eta + 1))^2
//
// eta       n_t / n_i, above 0
fn f0_from_eta(eta: f32) -> f32 {
    let t = (eta - 1.0) / (eta + 1.0);
    return t * t;
}

// The relative index above 1 that has this f0.
//
//   eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)
//
// f0        reflectance at normal incidence, [0, 1)
fn eta_from_f0(f0: f32) -> f32 {
    let t = 1.0 + sqrt(f0);
    return t * t / (1.0 - f0);
}

// ---- highlights and thin layers ------------------------------------------------------------------------------

// The lobe of Phong's highlight, to be multiplied by the reflectance.
//
//   max(cos_r, 0)^shininess
//
// cos_r     cosine between the view and the mirrored light, [-1, 1]
// shininess sharpness, above 0
fn phong_lobe(cos_r: f32, shininess: f32) -> f32 {
    return pow(max(cos_r, 0.0), shininess);
}

// Opacity by reflection: from the user's value to 1 at the silhouette.
//
//   a0 + (1 - a0) (1 - cos_i)^5
//
// a0        opacity by reflection seen along the normal, [0, 1]
// cos_i     cosine between view and normal, [0, 1]
fn opacity_fresnel(a0: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return a0 + (1.0 - a0) * (m2 * m2 * m);
}

// Opacity by attenuation in a thin layer, in proportion to the path through it.
//
//   min(1, a / cos_i)
//
// a         opacity by attenuation seen along the normal, [0, 1]
// cos_i     cosine between view and normal, [0, 1]
fn opacity_silhouette(a: f32, cos_i: f32) -> f32 {
    return select(min(a / cos_i, 1.0), select(a, 1.0, a > 0.0), cos_i <= 0.0);
}

// The opacity by attenuation that gives a layer a total opacity; negative where there is none.
//
//   (total - fresnel) / (1 - fresnel)
//
// total     opacity of the whole, [0, 1]
// fresnel   opacity by reflection, [0, 1)
fn opacity_attenuation(total: f32, fresnel: f32) -> f32 {
    return (total - fresnel) / (1.0 - fresnel);
}

// Opacity of a layer that attenuates and reflects.
//
//   1 - (1 - attenuation) (1 - fresnel)
//
// attenuation opacity by attenuation, [0, 1]
// fresnel   opacity by reflection, [0, 1]
fn opacity_total(attenuation: f32, fresnel: f32) -> f32 {
    return attenuation + fresnel * (1.0 - attenuation);
}

// ---- exact ---------------------------------------------------------------------------------------------------

// Exact reflectance between two transparent media, accurate in float everywhere.
//
//   R_s = E^2 / (E^2 + 4 c g (g + c)^2), R_p = R_s ((c g - s^2) / (c g + s^2))^2, E = eta^2 - 1,
//   g^2 = E + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 6e-2 at a critical angle
// cost    37 operations
// source  Fresnel 1823
fn dielectric(n_i: f32, n_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let s2 = n_i * (1.0 - cos_i * cos_i);
    let E = (n_t - n_i) * (n_t + n_i); // eta^2 - 1
    let g2 = E + c * c; // below 0 under total internal reflection
    let g = sqrt(max(g2, 1.1754944e-38)); // eta cos_t; so little there that R is 1
    let E2 = E * E;
    let cg = c * g;
    let a = 2.0 * (g + c);
    let a2 = a * a;
    let D_s = max(E2 + cg * a2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    let R_s = E2 / D_s;
    let x = cos_i * g;
    let b = x + s2;
    let q = (x - s2) / b;
    let R_p = R_s * (q * q);
    return (R_s + R_p) / 2.0;
}

fn dielectric_dir(n_i: f32, n_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return dielectric(n_i, n_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn dielectric_rgb(n_i: f32, n_t: vec3f, cos_i: f32) -> vec3f {
    let c = n_i * cos_i;
    let s2 = n_i * (1.0 - cos_i * cos_i);
    let E = (n_t - n_i) * (n_t + n_i); // eta^2 - 1
    let g2 = E + c * c; // below 0 under total internal reflection
    let g = sqrt(max(g2, vec3f(1.1754944e-38))); // eta cos_t; so little there that R is 1
    let E2 = E * E;
    let cg = c * g;
    let a = 2.0 * (g + c);
    let a2 = a * a;
    let D_s = max(E2 + cg * a2, vec3f(1.1754944e-38)); // 0 only for equal media at cos_i = 0
    let R_s = E2 / D_s;
    let x = cos_i * g;
    let b = x + s2;
    let q = (x - s2) / b;
    let R_p = R_s * (q * q);
    return (R_s + R_p) / 2.0;
}

fn dielectric_rgb_dir(n_i: f32, n_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return dielectric_rgb(n_i, n_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fn dielectric_boundary(n_i: f32, n_t: f32, cos_i: f32) -> fresnel_boundary {
    let c = n_i * cos_i;
    let s2 = n_i * (1.0 - cos_i * cos_i);
    let E = (n_t - n_i) * (n_t + n_i); // eta^2 - 1
    let g2 = E + c * c; // below 0 under total internal reflection
    let g = sqrt(max(g2, 1.1754944e-38)); // eta cos_t; so little there that R is 1
    let E2 = E * E;
    let cg = c * g;
    let a = 2.0 * (g + c);
    let a2 = a * a;
    let D_s = max(E2 + cg * a2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    let R_s = E2 / D_s;
    let x = cos_i * g;
    let b = x + s2;
    let q = (x - s2) / b;
    let R_p = R_s * (q * q);
    let through_s = select(cg * (a2 / D_s), 0.0, g2 <= 0.0);
    let through_p = select(4.0 * (x * s2) / (b * b), 0.0, g2 <= 0.0);
    let T_s = select(through_s, 1.0 - R_s, E2 <= 0.0);
    let T_p = T_s + R_s * through_p;
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}

// Exact reflectance of an absorbing medium seen from a transparent one, accurate in float everywhere.
//
//   R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 6e-2 at a critical angle of k_t = 0
// cost    67 operations
// source  Born and Wolf 1999, Principles of Optics, sec. 14.2
fn conductor(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let s4 = s2 * s2;
    let E = (n_t - n_i) * (n_t + n_i) - k_t * k_t; // Re m^2 - 1
    let Z = 2.0 * (n_t * k_t); // Im m^2
    let Z2 = Z * Z;
    let t0 = E + c2; // q^2 = t0 + i Z
    let A = sqrt(t0 * t0 + Z2); // |q|^2
    let S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    let u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    let a = select(S, Z, t0 <= 0.0); // u Re q
    let h = 2.0 * (a * c);
    let F = (E * E + Z2) * S; // |c - q|^2 |c + q|^2
    let G_s = (A + c2) * u + h;
    let D_s = max(F + h * G_s, 1.1754944e-38); // |c + q|^4; 0 only for equal media at cos_i = 0
    let R_s = F / D_s;
    let h_p = h * sin2;
    let N = t0 * cos2 - s4;
    let M = Z * cos2;
    let M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    let B = (N * N + M2) * S; // |q c - s^2|^2 |q c + s^2|^2
    let G_p = (A * cos2 + s4) * u + h_p;
    let D_p = B + h_p * G_p; // |q c + s^2|^4
    let R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}

fn conductor_dir(n_i: f32, n_t: f32, k_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return conductor(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn conductor_rgb(n_i: f32, n_t: vec3f, k_t: vec3f, cos_i: f32) -> vec3f {
    return vec3f(conductor(n_i, n_t.x, k_t.x, cos_i), conductor(n_i, n_t.y, k_t.y, cos_i),
            conductor(n_i, n_t.z, k_t.z, cos_i));
}

fn conductor_rgb_dir(n_i: f32, n_t: vec3f, k_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return conductor_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fn conductor_boundary(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> fresnel_boundary {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let s4 = s2 * s2;
    let E = (n_t - n_i) * (n_t + n_i) - k_t * k_t; // Re m^2 - 1
    let Z = 2.0 * (n_t * k_t); // Im m^2
    let Z2 = Z * Z;
    let t0 = E + c2; // q^2 = t0 + i Z
    let A = sqrt(t0 * t0 + Z2); // |q|^2
    let S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    let u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    let a = select(S, Z, t0 <= 0.0); // u Re q
    let h = 2.0 * (a * c);
    let F = (E * E + Z2) * S; // |c - q|^2 |c + q|^2
    let G_s = (A + c2) * u + h;
    let D_s = max(F + h * G_s, 1.1754944e-38); // |c + q|^4; 0 only for equal media at cos_i = 0
    let R_s = F / D_s;
    let h_p = h * sin2;
    let N = t0 * cos2 - s4;
    let M = Z * cos2;
    let M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    let B = (N * N + M2) * S; // |q c - s^2|^2 |q c + s^2|^2
    let G_p = (A * cos2 + s4) * u + h_p;
    let D_p = B + h_p * G_p; // |q c + s^2|^4
    let R_p = R_s * (B / D_p);
    let T_s = select(2.0 * (a * (G_s / D_s)) * c, 1.0 - R_s, F <= 0.0);
    let T_p = T_s + R_s * (2.0 * (a * (G_p / D_p)) * (c * sin2));
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}

// Exact reflectance between two transparent media in the fewest operations.
//
//   R_s = ((g - c) / (g + c))^2, R_p = R_s ((c g - s^2) / (c g + s^2))^2, g^2 = eta^2 - 1 + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 4e-6 for eta > 1.05, no digit left at 1 +- 1e-6
// cost    31 operations
// source  Cook and Torrance 1982
fn dielectric_fast(n_i: f32, n_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let sin2 = 1.0 - cos_i * cos_i;
    let s2 = n_i * sin2;
    let g2 = n_t * n_t - n_i * s2; // below 0 under total internal reflection
    let g = sqrt(abs(g2));
    let x = cos_i * g;
    let a = g + c;
    let b = x + s2;
    let r_s = (g - c) / a;
    let q = (x - s2) / b;
    let r2 = r_s * r_s;
    let R_p = r2 * (q * q);
    return select((r2 + R_p) / 2.0, 1.0, g2 <= 0.0);
}

fn dielectric_fast_dir(n_i: f32, n_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return dielectric_fast(n_i, n_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn dielectric_fast_rgb(n_i: f32, n_t: vec3f, cos_i: f32) -> vec3f {
    return vec3f(dielectric_fast(n_i, n_t.x, cos_i), dielectric_fast(n_i, n_t.y, cos_i),
            dielectric_fast(n_i, n_t.z, cos_i));
}

fn dielectric_fast_rgb_dir(n_i: f32, n_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return dielectric_fast_rgb(n_i, n_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fn dielectric_fast_boundary(n_i: f32, n_t: f32, cos_i: f32) -> fresnel_boundary {
    let c = n_i * cos_i;
    let sin2 = 1.0 - cos_i * cos_i;
    let s2 = n_i * sin2;
    let g2 = n_t * n_t - n_i * s2; // below 0 under total internal reflection
    let g = sqrt(abs(g2));
    let x = cos_i * g;
    let a = g + c;
    let b = x + s2;
    let r_s = (g - c) / a;
    let q = (x - s2) / b;
    let r2 = r_s * r_s;
    let R_s = select(r2, 1.0, g2 <= 0.0);
    let R_p = select(r2 * (q * q), 1.0, g2 <= 0.0);
    let w = 4.0 * (c * g);
    let T_s = w / (a * a);
    let T_s_2 = select(T_s, 0.0, g2 <= 0.0);
    let T_p = select(T_s + r2 * (w * sin2 / (b * b)), 0.0, g2 <= 0.0);
    return fresnel_boundary(R_s, R_p, min(T_s_2, 1.0), min(T_p, 1.0));
}

// Exact reflectance of an absorbing medium in the fewest operations.
//
//   R_s = (t1 - t2) / (t1 + t2), R_p = R_s (t3 - t4) / (t3 + t4)
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 3e-6 for metals, 1e-4 for dielectrics, no digit left near an index match
// cost    50 operations
// source  Lagarde 2013, Memo on Fresnel equations, after Shirley
fn conductor_fast(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let t0 = n_t * n_t - n_i * n_i - k_t * k_t + c2;
    let nk2 = 2.0 * (n_t * k_t);
    let A = sqrt(t0 * t0 + nk2 * nk2); // a^2 + b^2
    let a2 = 2.0 * (A + t0); // (2 a)^2
    let a = sqrt(max(a2, 1.1754944e-38));
    let t1 = A + c2;
    let t2 = a * c;
    let t3 = cos2 * A + (s2 * s2 + 1.1754944e-38); // above 0 where n_t << n_i, at cos_i = 1
    let t4 = t2 * sin2;
    let D_s = max(t1 + t2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    let D_p = t3 + t4;
    let R_s = abs((t1 - t2) / D_s); // rounding may bring it below 0
    let R_p = R_s * abs((t3 - t4) / D_p);
    return (R_s + R_p) / 2.0;
}

fn conductor_fast_dir(n_i: f32, n_t: f32, k_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return conductor_fast(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn conductor_fast_rgb(n_i: f32, n_t: vec3f, k_t: vec3f, cos_i: f32) -> vec3f {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let t0 = n_t * n_t - n_i * n_i - k_t * k_t + c2;
    let nk2 = 2.0 * (n_t * k_t);
    let A = sqrt(t0 * t0 + nk2 * nk2); // a^2 + b^2
    let a2 = 2.0 * (A + t0); // (2 a)^2
    let a = sqrt(max(a2, vec3f(1.1754944e-38)));
    let t1 = A + c2;
    let t2 = a * c;
    let t3 = cos2 * A + (s2 * s2 + 1.1754944e-38); // above 0 where n_t << n_i, at cos_i = 1
    let t4 = t2 * sin2;
    let D_s = max(t1 + t2, vec3f(1.1754944e-38)); // 0 only for equal media at cos_i = 0
    let D_p = t3 + t4;
    let R_s = abs((t1 - t2) / D_s); // rounding may bring it below 0
    let R_p = R_s * abs((t3 - t4) / D_p);
    return (R_s + R_p) / 2.0;
}

fn conductor_fast_rgb_dir(n_i: f32, n_t: vec3f, k_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return conductor_fast_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fn conductor_fast_boundary(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> fresnel_boundary {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let t0 = n_t * n_t - n_i * n_i - k_t * k_t + c2;
    let nk2 = 2.0 * (n_t * k_t);
    let A = sqrt(t0 * t0 + nk2 * nk2); // a^2 + b^2
    let a2 = 2.0 * (A + t0); // (2 a)^2
    let a = sqrt(max(a2, 1.1754944e-38));
    let t1 = A + c2;
    let t2 = a * c;
    let t3 = cos2 * A + (s2 * s2 + 1.1754944e-38); // above 0 where n_t << n_i, at cos_i = 1
    let t4 = t2 * sin2;
    let D_s = max(t1 + t2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    let D_p = t3 + t4;
    let R_s = abs((t1 - t2) / D_s); // rounding may bring it below 0
    let R_p = R_s * abs((t3 - t4) / D_p);
    let w = select(2.0 * t2, 0.0, a2 <= 0.0); // 0 beyond the critical angle
    let T_s = w / D_s;
    let T_p = T_s + R_s * (w * sin2 / D_p);
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}

// Exact reflectance of any medium, with the two sums that cancel in twice the digits.
//
//   F = as conductor, with the sums that cancel in twice the digits
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 1e-6
// cost    304 operations
// source  Born and Wolf 1999; Knuth 1969; Dekker 1971
fn conductor_precise(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> f32 {
    let n_t2 = n_t * n_t;
    let k_t2 = k_t * k_t;
    let t = n_t2 + (-k_t2);
    let t_2 = t - n_t2;
    let t_3 = 4097.0 * n_t;
    let t_4 = t_3 - (t_3 - n_t);
    let t_5 = n_t - t_4;
    let t_6 = t_4 * t_5;
    let t_7 = t_4 * t_4 - n_t2 + t_6 + t_6 + t_5 * t_5;
    let t_8 = 4097.0 * k_t;
    let t_9 = t_8 - (t_8 - k_t);
    let t_10 = k_t - t_9;
    let t_11 = t_9 * t_10;
    let t_12 = t_9 * t_9 - k_t2 + t_11 + t_11 + t_10 * t_10;
    let t_13 = t_7 + (-t_12);
    let t_14 = n_t2 - (t - t_2) + (-k_t2 - t_2) + t_13;
    let t_15 = t + t_14;
    let t_16 = t_15 - t;
    let t_17 = t_13 - t_7;
    let t_18 = t - (t_15 - t_16) + (t_14 - t_16) + (t_7 - (t_13 - t_17) + (-t_12 - t_17));
    let t_19 = t_15 + t_18;
    let n_i2 = n_i * n_i;
    let t_20 = t_19 + (-n_i2);
    let t_21 = t_20 - t_19;
    let t_22 = t_19 - t_15;
    let t_23 = t_15 - (t_19 - t_22) + (t_18 - t_22);
    let t_24 = 4097.0 * n_i;
    let t_25 = t_24 - (t_24 - n_i);
    let t_26 = n_i - t_25;
    let t_27 = t_25 * t_26;
    let t_28 = t_25 * t_25 - n_i2 + t_27 + t_27 + t_26 * t_26;
    let t_29 = t_23 + (-t_28);
    let t_30 = t_19 - (t_20 - t_21) + (-n_i2 - t_21) + t_29;
    let t_31 = t_20 + t_30;
    let t_32 = t_31 - t_20;
    let t_33 = t_29 - t_23;
    let t_34 = t_20 - (t_31 - t_32) + (t_30 - t_32) + (t_23 - (t_29 - t_33) + (-t_28 - t_33));
    let t_35 = t_31 + t_34;
    let cos2 = cos_i * cos_i;
    let t_36 = n_i2 * cos2;
    let t_37 = 4097.0 * n_i2;
    let t_38 = t_37 - (t_37 - n_i2);
    let t_39 = 4097.0 * cos2;
    let t_40 = t_39 - (t_39 - cos2);
    let t_41 = cos2 - t_40;
    let t_42 = n_i2 - t_38;
    let t_43 = 4097.0 * cos_i;
    let t_44 = t_43 - (t_43 - cos_i);
    let t_45 = cos_i - t_44;
    let t_46 = t_44 * t_45;
    let t_47 = t_44 * t_44 - cos2 + t_46 + t_46 + t_45 * t_45;
    let t_48 = t_38 * t_40 - t_36 + t_38 * t_41 + t_42 * t_40 + t_42 * t_41 + (n_i2 * t_47 + t_28 * cos2);
    let t_49 = t_36 + t_48;
    let t_50 = t_35 + t_49;
    let t_51 = t_50 - t_35;
    let t_52 = t_35 - t_31;
    let t_53 = t_31 - (t_35 - t_52) + (t_34 - t_52);
    let t_54 = t_49 - t_36;
    let t_55 = t_36 - (t_49 - t_54) + (t_48 - t_54);
    let t_56 = t_53 + t_55;
    let t_57 = t_35 - (t_50 - t_51) + (t_49 - t_51) + t_56;
    let t_58 = t_50 + t_57;
    let t_59 = t_58 - t_50;
    let t_60 = t_56 - t_53;
    let t_61 = t_58 + (t_50 - (t_58 - t_59) + (t_57 - t_59) + (t_53 - (t_56 - t_60) + (t_55 - t_60)));
    let t_62 = n_t * k_t;
    let t_63 = abs(t_61);
    let t_64 = sqrt((max(sqrt(t_61 * t_61 + 4.0 * (t_62 * t_62)), t_63) + t_63) / 2.0);
    let t_65 = t_62 / select(1.0, t_64, t_64 > 0.0);
    let t_66 = select(t_64, t_65, t_61 < 0.0);
    let t_67 = n_i * cos_i;
    let t_68 = t_66 - t_67;
    let t_69 = select(t_65, t_64, t_61 < 0.0);
    let t_70 = t_69 * t_69;
    let t_71 = t_66 + t_67;
    let t_72 = select(t_68, (t_35 + t_70) / t_71, max(2.0 * abs(t_68), t_69) < t_67);
    let t_73 = t_71 * t_71 + t_70;
    let t_74 = (t_72 * t_72 + t_70) / select(t_73, 1.0, t_73 <= 0.0);
    let t_75 = t_66 * cos_i;
    let t_76 = n_i * ((1.0 - cos_i) * (1.0 + cos_i));
    let t_77 = t_75 - t_76;
    let t_78 = n_t2 + n_i2;
    let t_79 = t_78 - n_t2;
    let t_80 = t_7 + t_28;
    let t_81 = n_t2 - (t_78 - t_79) + (n_i2 - t_79) + t_80;
    let t_82 = t_78 + t_81;
    let t_83 = t_82 - t_78;
    let t_84 = t_80 - t_7;
    let t_85 = t_78 - (t_82 - t_83) + (t_81 - t_83) + (t_7 - (t_80 - t_84) + (t_28 - t_84));
    let t_86 = t_82 + t_85;
    let t_87 = cos2 * t_86;
    let t_88 = 4097.0 * t_86;
    let t_89 = t_88 - (t_88 - t_86);
    let t_90 = t_86 - t_89;
    let t_91 = t_86 - t_82;
    let t_92 = t_40 * t_89 - t_87 + t_40 * t_90 + t_41 * t_89 + t_41 * t_90 +
            (cos2 * (t_82 - (t_86 - t_91) + (t_85 - t_91)) + t_47 * t_86);
    let t_93 = t_87 + t_92;
    let t_94 = t_93 + (-n_i2);
    let t_95 = t_94 - t_93;
    let t_96 = t_93 - t_87;
    let t_97 = t_87 - (t_93 - t_96) + (t_92 - t_96);
    let t_98 = t_97 + (-t_28);
    let t_99 = t_93 - (t_94 - t_95) + (-n_i2 - t_95) + t_98;
    let t_100 = t_94 + t_99;
    let t_101 = t_100 - t_94;
    let t_102 = t_98 - t_97;
    let t_103 = t_75 + t_76;
    let t_104 = select(t_103, 1.0, t_103 <= 0.0);
    let t_105 = select(t_77, (t_100 +
            (t_94 - (t_100 - t_101) + (t_99 - t_101) + (t_97 - (t_98 - t_102) + (-t_28 - t_102))) +
            cos2 * (t_70 - k_t2)) / t_104, max(2.0 * abs(t_77) - t_76, 2.0 * t_69 - n_i) < 0.0);
    let t_106 = t_69 * cos_i;
    let t_107 = t_106 * t_106;
    return (min(t_74, 1.0) + min(t_74 * ((t_105 * t_105 + t_107) / (t_104 * t_104 + t_107)), 1.0)) / 2.0;
}

fn conductor_precise_dir(n_i: f32, n_t: f32, k_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return conductor_precise(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn conductor_precise_rgb(n_i: f32, n_t: vec3f, k_t: vec3f, cos_i: f32) -> vec3f {
    return vec3f(conductor_precise(n_i, n_t.x, k_t.x, cos_i), conductor_precise(n_i, n_t.y, k_t.y, cos_i),
            conductor_precise(n_i, n_t.z, k_t.z, cos_i));
}

fn conductor_precise_rgb_dir(n_i: f32, n_t: vec3f, k_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return conductor_precise_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fn conductor_precise_boundary(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> fresnel_boundary {
    let n_t2 = n_t * n_t;
    let k_t2 = k_t * k_t;
    let t = n_t2 + (-k_t2);
    let t_2 = t - n_t2;
    let t_3 = 4097.0 * n_t;
    let t_4 = t_3 - (t_3 - n_t);
    let t_5 = n_t - t_4;
    let t_6 = t_4 * t_5;
    let t_7 = t_4 * t_4 - n_t2 + t_6 + t_6 + t_5 * t_5;
    let t_8 = 4097.0 * k_t;
    let t_9 = t_8 - (t_8 - k_t);
    let t_10 = k_t - t_9;
    let t_11 = t_9 * t_10;
    let t_12 = t_9 * t_9 - k_t2 + t_11 + t_11 + t_10 * t_10;
    let t_13 = t_7 + (-t_12);
    let t_14 = n_t2 - (t - t_2) + (-k_t2 - t_2) + t_13;
    let t_15 = t + t_14;
    let t_16 = t_15 - t;
    let t_17 = t_13 - t_7;
    let t_18 = t - (t_15 - t_16) + (t_14 - t_16) + (t_7 - (t_13 - t_17) + (-t_12 - t_17));
    let t_19 = t_15 + t_18;
    let n_i2 = n_i * n_i;
    let t_20 = t_19 + (-n_i2);
    let t_21 = t_20 - t_19;
    let t_22 = t_19 - t_15;
    let t_23 = t_15 - (t_19 - t_22) + (t_18 - t_22);
    let t_24 = 4097.0 * n_i;
    let t_25 = t_24 - (t_24 - n_i);
    let t_26 = n_i - t_25;
    let t_27 = t_25 * t_26;
    let t_28 = t_25 * t_25 - n_i2 + t_27 + t_27 + t_26 * t_26;
    let t_29 = t_23 + (-t_28);
    let t_30 = t_19 - (t_20 - t_21) + (-n_i2 - t_21) + t_29;
    let t_31 = t_20 + t_30;
    let t_32 = t_31 - t_20;
    let t_33 = t_29 - t_23;
    let t_34 = t_20 - (t_31 - t_32) + (t_30 - t_32) + (t_23 - (t_29 - t_33) + (-t_28 - t_33));
    let t_35 = t_31 + t_34;
    let cos2 = cos_i * cos_i;
    let t_36 = n_i2 * cos2;
    let t_37 = 4097.0 * n_i2;
    let t_38 = t_37 - (t_37 - n_i2);
    let t_39 = 4097.0 * cos2;
    let t_40 = t_39 - (t_39 - cos2);
    let t_41 = cos2 - t_40;
    let t_42 = n_i2 - t_38;
    let t_43 = 4097.0 * cos_i;
    let t_44 = t_43 - (t_43 - cos_i);
    let t_45 = cos_i - t_44;
    let t_46 = t_44 * t_45;
    let t_47 = t_44 * t_44 - cos2 + t_46 + t_46 + t_45 * t_45;
    let t_48 = t_38 * t_40 - t_36 + t_38 * t_41 + t_42 * t_40 + t_42 * t_41 + (n_i2 * t_47 + t_28 * cos2);
    let t_49 = t_36 + t_48;
    let t_50 = t_35 + t_49;
    let t_51 = t_50 - t_35;
    let t_52 = t_35 - t_31;
    let t_53 = t_31 - (t_35 - t_52) + (t_34 - t_52);
    let t_54 = t_49 - t_36;
    let t_55 = t_36 - (t_49 - t_54) + (t_48 - t_54);
    let t_56 = t_53 + t_55;
    let t_57 = t_35 - (t_50 - t_51) + (t_49 - t_51) + t_56;
    let t_58 = t_50 + t_57;
    let t_59 = t_58 - t_50;
    let t_60 = t_56 - t_53;
    let t_61 = t_58 + (t_50 - (t_58 - t_59) + (t_57 - t_59) + (t_53 - (t_56 - t_60) + (t_55 - t_60)));
    let t_62 = n_t * k_t;
    let t_63 = abs(t_61);
    let t_64 = sqrt((max(sqrt(t_61 * t_61 + 4.0 * (t_62 * t_62)), t_63) + t_63) / 2.0);
    let t_65 = t_62 / select(1.0, t_64, t_64 > 0.0);
    let t_66 = select(t_64, t_65, t_61 < 0.0);
    let t_67 = n_i * cos_i;
    let t_68 = t_66 - t_67;
    let t_69 = select(t_65, t_64, t_61 < 0.0);
    let t_70 = t_69 * t_69;
    let t_71 = t_66 + t_67;
    let t_72 = select(t_68, (t_35 + t_70) / t_71, max(2.0 * abs(t_68), t_69) < t_67);
    let t_73 = t_72 * t_72 + t_70;
    let t_74 = t_71 * t_71 + t_70;
    let t_75 = select(t_74, 1.0, t_74 <= 0.0);
    let t_76 = t_73 / t_75;
    let t_77 = t_66 * cos_i;
    let t_78 = n_i * ((1.0 - cos_i) * (1.0 + cos_i));
    let t_79 = t_77 - t_78;
    let t_80 = n_t2 + n_i2;
    let t_81 = t_80 - n_t2;
    let t_82 = t_7 + t_28;
    let t_83 = n_t2 - (t_80 - t_81) + (n_i2 - t_81) + t_82;
    let t_84 = t_80 + t_83;
    let t_85 = t_84 - t_80;
    let t_86 = t_82 - t_7;
    let t_87 = t_80 - (t_84 - t_85) + (t_83 - t_85) + (t_7 - (t_82 - t_86) + (t_28 - t_86));
    let t_88 = t_84 + t_87;
    let t_89 = cos2 * t_88;
    let t_90 = 4097.0 * t_88;
    let t_91 = t_90 - (t_90 - t_88);
    let t_92 = t_88 - t_91;
    let t_93 = t_88 - t_84;
    let t_94 = t_40 * t_91 - t_89 + t_40 * t_92 + t_41 * t_91 + t_41 * t_92 +
            (cos2 * (t_84 - (t_88 - t_93) + (t_87 - t_93)) + t_47 * t_88);
    let t_95 = t_89 + t_94;
    let t_96 = t_95 + (-n_i2);
    let t_97 = t_96 - t_95;
    let t_98 = t_95 - t_89;
    let t_99 = t_89 - (t_95 - t_98) + (t_94 - t_98);
    let t_100 = t_99 + (-t_28);
    let t_101 = t_95 - (t_96 - t_97) + (-n_i2 - t_97) + t_100;
    let t_102 = t_96 + t_101;
    let t_103 = t_102 - t_96;
    let t_104 = t_100 - t_99;
    let t_105 = t_77 + t_78;
    let t_106 = select(t_105, 1.0, t_105 <= 0.0);
    let t_107 = select(t_79, (t_102 +
            (t_96 - (t_102 - t_103) + (t_101 - t_103) + (t_99 - (t_100 - t_104) + (-t_28 - t_104))) +
            cos2 * (t_70 - k_t2)) / t_106, max(2.0 * abs(t_79) - t_78, 2.0 * t_69 - n_i) < 0.0);
    let t_108 = t_69 * cos_i;
    let t_109 = t_108 * t_108;
    let t_110 = t_106 * t_106 + t_109;
    let t_111 = select(4.0 * (t_66 * t_67) / t_75, 1.0, t_73 <= 0.0);
    return fresnel_boundary(min(t_76, 1.0), min(t_76 * ((t_107 * t_107 + t_109) / t_110), 1.0),
            min(t_111, 1.0), min(t_111 + t_76 * (4.0 * (t_77 * t_78) / t_110), 1.0));
}

// ---- approximations ------------------------------------------------------------------------------------------

// Schlick's approximation.
//
//   F = f0 + (1 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering
fn schlick(f0: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}

fn schlick_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}

fn schlick_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_rgb(f0, incidence_cosine(normal, direction));
}

// Schlick's approximation with any reflectance at grazing incidence.
//
//   F = f0 + (f90 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994; Real-Time Rendering, 4th ed., eq. 9.18
fn schlick_f90(f0: f32, f90: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}

fn schlick_f90_dir(f0: f32, f90: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_f90(f0, f90, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_f90_rgb(f0: vec3f, f90: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (f90 - f0) * (m2 * m2 * m);
}

fn schlick_f90_rgb_dir(f0: vec3f, f90: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_f90_rgb(f0, f90, incidence_cosine(normal, direction));
}

// Schlick's approximation with the power left free.
//
//   F = f0 + (f90 - f0) x^power, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.123, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    13 operations
// source  Real-Time Rendering, 4th ed., eq. 9.18
fn schlick_power(f0: f32, f90: f32, power: f32, cos_i: f32) -> f32 {
    return f0 + (f90 - f0) * pow(1.0 - cos_i, power);
}

fn schlick_power_dir(f0: f32, f90: f32, power: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_power(f0, f90, power, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_power_rgb(f0: vec3f, f90: vec3f, power: vec3f, cos_i: f32) -> vec3f {
    return f0 + (f90 - f0) * pow(vec3f(1.0 - cos_i), power);
}

fn schlick_power_rgb_dir(f0: vec3f, f90: vec3f, power: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_power_rgb(f0, f90, power, incidence_cosine(normal, direction));
}

// Schlick's approximation written in n and k.
//
//   F = ((n - 1)^2 + 4 n x^5 + k^2) / ((n + 1)^2 + k^2), x = 1 - cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.255, certified: n in [0.1, 4], k in [1, 8]
// cost    19 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
fn schlick_nk(n: f32, k: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let m2 = m * m;
    let n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2), 1.0);
}

fn schlick_nk_dir(n: f32, k: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_nk(n, k, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_nk_rgb(n: vec3f, k: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let m2 = m * m;
    let n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            vec3f(1.0));
}

fn schlick_nk_rgb_dir(n: vec3f, k: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_nk_rgb(n, k, incidence_cosine(normal, direction));
}

// Schlick's approximation from inside a denser medium.
//
//   F = schlick(f0, cos_t), f0 = ((1 - eta) / (1 + eta))^2; 1 beyond the critical angle
//
// eta     n_t / n_i, [0.01, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified: 1 / eta in [1.3, 2.5], from inside
// cost    28 operations
// source  Lagarde 2013, Memo on Fresnel equations
fn schlick_internal(eta: f32, cos_i: f32) -> f32 {
    let eta_minus_1 = eta - 1.0;
    let eta_plus_1 = eta + 1.0;
    let t = eta_minus_1 / eta_plus_1;
    let f0 = t * t;
    let g2 = eta_minus_1 * eta_plus_1 + cos_i * cos_i;
    let cos_t = select(min(sqrt(g2) / eta, 1.0), 0.0, g2 <= 0.0);
    let m = 1.0 - cos_t;
    let m2 = m * m;
    return f0 + (1.0 - f0) * (m2 * m2 * m);
}

fn schlick_internal_dir(eta: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_internal(eta, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_internal_rgb(eta: vec3f, cos_i: f32) -> vec3f {
    return vec3f(schlick_internal(eta.x, cos_i), schlick_internal(eta.y, cos_i),
            schlick_internal(eta.z, cos_i));
}

fn schlick_internal_rgb_dir(eta: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return schlick_internal_rgb(eta, incidence_cosine(normal, direction));
}

// Schlick's curve by a spherical Gaussian.
//
//   F = f0 + (1 - f0) 2^((-5.55473 cos_i - 6.98316) cos_i)
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0846, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    10 operations
// source  Lagarde 2012, Spherical Gaussian approximation for Blinn-Phong, Phong and Fresnel
fn spherical_gaussian(f0: f32, cos_i: f32) -> f32 {
    let p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}

fn spherical_gaussian_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return spherical_gaussian(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn spherical_gaussian_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let p = -(5.55473 * cos_i + 6.98316) * cos_i;
    return f0 + (1.0 - f0) * exp2(p);
}

fn spherical_gaussian_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return spherical_gaussian_rgb(f0, incidence_cosine(normal, direction));
}

// A curve found by symbolic regression.
//
//   F = f0 + (x - f0) x^4, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0708, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    6 operations
// source  photometric.io, Improving Schlick's Approximation
fn photometric(f0: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (m - f0) * (m2 * m2);
}

fn photometric_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return photometric(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn photometric_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return f0 + (m - f0) * (m2 * m2);
}

fn photometric_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return photometric_rgb(f0, incidence_cosine(normal, direction));
}

// Two powers at Schlick's cost, better on dielectrics.
//
//   F = f0 + x^4 ((a - f0) + (1 - a) x^4), a = 0.55, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0363, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    8 operations
// source  this library
fn powers_4_8(f0: f32, cos_i: f32) -> f32 {
    let one_minus_cos_i = 1.0 - cos_i;
    let t = one_minus_cos_i * one_minus_cos_i;
    let m4 = t * t;
    return f0 + m4 * (0.55 - f0 + 0.45 * m4);
}

fn powers_4_8_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_4_8(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_4_8_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let one_minus_cos_i = 1.0 - cos_i;
    let t = one_minus_cos_i * one_minus_cos_i;
    let m4 = t * t;
    return f0 + m4 * (0.55 - f0 + 0.45 * m4);
}

fn powers_4_8_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_4_8_rgb(f0, incidence_cosine(normal, direction));
}

// Two powers, less than half of Schlick's error on dielectrics.
//
//   F = f0 + x^3 ((a - f0) + (1 - a) x^6), a = max(0.46, f0), x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0328, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    13 operations
// source  this library
fn powers_3_9(f0: f32, cos_i: f32) -> f32 {
    let a = max(0.46, f0);
    let m = 1.0 - cos_i;
    let m3 = m * m * m;
    return saturate(f0 + m3 * (a - f0 + (1.0 - a) * (m3 * m3)));
}

fn powers_3_9_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_3_9(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_3_9_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let a = max(vec3f(0.46), f0);
    let m = 1.0 - cos_i;
    let m3 = m * m * m;
    return saturate(f0 + m3 * (a - f0 + (1.0 - a) * (m3 * m3)));
}

fn powers_3_9_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_3_9_rgb(f0, incidence_cosine(normal, direction));
}

// Three powers with coefficients in sqrt(f0), a tenth of Schlick's error on dielectrics.
//
//   F = f0 + y (p + y (q + y r)), y = (1 - cos_i)^3, p and q linear in sqrt(f0) and f0,
//   p + q + r = 1 - f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.00713, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    27 operations
// source  this library
fn powers_3_6_9(f0: f32, cos_i: f32) -> f32 {
    let s = sqrt(f0 + 8.271806e-25);
    let p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    let q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    let r = 1.0 - f0 - p - q;
    let m = 1.0 - cos_i;
    let y = m * m * m;
    return saturate(f0 + y * (p + y * (q + y * r)));
}

fn powers_3_6_9_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_3_6_9(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_3_6_9_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let s = sqrt(f0 + 8.271806e-25);
    let p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    let q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    let r = 1.0 - f0 - p - q;
    let m = 1.0 - cos_i;
    let y = m * m * m;
    return saturate(f0 + y * (p + y * (q + y * r)));
}

fn powers_3_6_9_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_3_6_9_rgb(f0, incidence_cosine(normal, direction));
}

// The rim factor, as a stand-in for reflectance.
//
//   F = 1 - cos_i
//
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.542, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    1 operations
// source  Wloka 2002, Fresnel Reflection, fig. 4
fn one_minus_cos(cos_i: f32) -> f32 {
    return 1.0 - cos_i;
}

fn one_minus_cos_dir(normal: vec3f, direction: vec3f) -> f32 {
    return one_minus_cos(incidence_cosine(normal, direction));
}

// No Fresnel effect.
//
//   F = f0
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.983, certified: eta in [1.3, 2.5], from outside, f0 exact
// cost    0 operations
// source  no Fresnel effect
fn constant(f0: f32, cos_i: f32) -> f32 {
    return f0;
}

fn constant_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return constant(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn constant_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    return f0;
}

fn constant_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return constant_rgb(f0, incidence_cosine(normal, direction));
}

// The classic approximation for metals, without a square root.
//
//   R_s = ((n - c)^2 + k^2) / ((n + c)^2 + k^2),
//   R_p = ((n c - 1)^2 + k^2 c^2) / ((n c + 1)^2 + k^2 c^2)
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0638, certified: n in [0.1, 4], k in [1, 8]
// cost    26 operations
// source  Pharr and Humphreys, Physically Based Rendering; Lagarde 2013
fn air_conductor(n: f32, k: f32, cos_i: f32) -> f32 {
    let k2 = k * k;
    let t = n - cos_i;
    let t_2 = n + cos_i;
    let R_s = (t * t + k2) / (t_2 * t_2 + k2);
    let t_3 = n * cos_i;
    let t_3_minus_1 = t_3 - 1.0;
    let t_4 = k2 * (cos_i * cos_i);
    let t_3_plus_1 = t_3 + 1.0;
    let R_p = (t_3_minus_1 * t_3_minus_1 + t_4) / (t_3_plus_1 * t_3_plus_1 + t_4);
    return (R_s + R_p) / 2.0;
}

fn air_conductor_dir(n: f32, k: f32, normal: vec3f, direction: vec3f) -> f32 {
    return air_conductor(n, k, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn air_conductor_rgb(n: vec3f, k: vec3f, cos_i: f32) -> vec3f {
    let k2 = k * k;
    let t = n - cos_i;
    let t_2 = n + cos_i;
    let R_s = (t * t + k2) / (t_2 * t_2 + k2);
    let t_3 = n * cos_i;
    let t_3_minus_1 = t_3 - 1.0;
    let t_4 = k2 * (cos_i * cos_i);
    let t_3_plus_1 = t_3 + 1.0;
    let R_p = (t_3_minus_1 * t_3_minus_1 + t_4) / (t_3_plus_1 * t_3_plus_1 + t_4);
    return (R_s + R_p) / 2.0;
}

fn air_conductor_rgb_dir(n: vec3f, k: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return air_conductor_rgb(n, k, incidence_cosine(normal, direction));
}

// Schlick's approximation less a term for the dip of metals before grazing incidence.
//
//   F = schlick_nk(n, k) - a c x^alpha, x = 1 - c, c = cos_i
//
// n       index relative to the medium in front, [0.001, 1000]
// k       its imaginary part, [0, 10000]
// a       depth of the dip, about 2 n, [0, 2000]
// alpha   sharpness of the dip, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.045, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    33 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
fn lazanyi(n: f32, k: f32, a: f32, alpha: f32, cos_i: f32) -> f32 {
    let m = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let m2 = m * m;
    let n_plus_1 = n + 1.0;
    return saturate(min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            1.0) - a * cos_i * pow(m, alpha));
}

fn lazanyi_dir(n: f32, k: f32, a: f32, alpha: f32, normal: vec3f, direction: vec3f) -> f32 {
    return lazanyi(n, k, a, alpha, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn lazanyi_rgb(n: vec3f, k: vec3f, a: vec3f, alpha: vec3f, cos_i: f32) -> vec3f {
    let m = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let m2 = m * m;
    let n_plus_1 = n + 1.0;
    return saturate(min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (m2 * m2 * m)) / (n_plus_1 * n_plus_1 + k2),
            vec3f(1.0)) - a * cos_i * pow(vec3f(m), alpha));
}

fn lazanyi_rgb_dir(n: vec3f, k: vec3f, a: vec3f, alpha: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return lazanyi_rgb(n, k, a, alpha, incidence_cosine(normal, direction));
}

// An index from two artist's colours, then the exact equations.
//
//   F = conductor(n, k), n = mix(n_max(r), n_min(r), g), k^2 = ((n + 1)^2 r - (n - 1)^2) / (1 - r)
//
// r       reflectance at normal incidence, [0, 1]
// g       edge tint, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 1e-13, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    99 operations
// source  Gulbrandsen 2014, Artist Friendly Metallic Fresnel
fn gulbrandsen(r: f32, g: f32, cos_i: f32) -> f32 {
    let f0 = min(r, 0.9999) + 8.271806e-25;
    let t = 1.0 + sqrt(f0);
    let t_2 = t * t;
    let one_minus_f0 = 1.0 - f0;
    let n_max = t_2 / one_minus_f0;
    let n_min = one_minus_f0 / (1.0 + f0);
    let n = n_max * (1.0 - g) + n_min * g;
    let k = sqrt(max((n_max - n) * (n - one_minus_f0 / t_2), 0.0) + 8.271806e-25);
    let c2 = cos_i * cos_i;
    let sin2 = 1.0 - c2;
    let s4 = sin2 * sin2;
    let E = (n - 1.0) * (n + 1.0) - k * k; // Re m^2 - 1
    let Z = 2.0 * (n * k); // Im m^2
    let Z2 = Z * Z;
    let t0 = E + c2; // q^2 = t0 + i Z
    let A = sqrt(t0 * t0 + Z2); // |q|^2
    let S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    let u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    let a = select(S, Z, t0 <= 0.0); // u Re q
    let h = 2.0 * (a * cos_i);
    let F = (E * E + Z2) * S; // |c - q|^2 |c + q|^2
    let G_s = (A + c2) * u + h;
    let D_s = max(F + h * G_s, 1.1754944e-38); // |c + q|^4; 0 only for equal media at cos_i = 0
    let R_s = F / D_s;
    let h_p = h * sin2;
    let N = t0 * c2 - s4;
    let M = Z * c2;
    let M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    let B = (N * N + M2) * S; // |q c - s^2|^2 |q c + s^2|^2
    let G_p = (A * c2 + s4) * u + h_p;
    let D_p = B + h_p * G_p; // |q c + s^2|^4
    let R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}

fn gulbrandsen_dir(r: f32, g: f32, normal: vec3f, direction: vec3f) -> f32 {
    return gulbrandsen(r, g, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn gulbrandsen_rgb(r: vec3f, g: vec3f, cos_i: f32) -> vec3f {
    return vec3f(gulbrandsen(r.x, g.x, cos_i), gulbrandsen(r.y, g.y, cos_i), gulbrandsen(r.z, g.z, cos_i));
}

fn gulbrandsen_rgb_dir(r: vec3f, g: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return gulbrandsen_rgb(r, g, incidence_cosine(normal, direction));
}

// Schlick's approximation with a dip, through the reflectance at cos_i = 1/7.
//
//   f0 + (1 - f0) x^5 - b c x^6 through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0517, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    17 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful
fn f82(f0: f32, f82_: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437;
    let b = (at_82 - f82_) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    return saturate(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m));
}

fn f82_dir(f0: f32, f82_: f32, normal: vec3f, direction: vec3f) -> f32 {
    return f82(f0, f82_, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn f82_rgb(f0: vec3f, f82_: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437;
    let b = (at_82 - f82_) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    return saturate(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m));
}

fn f82_rgb_dir(f0: vec3f, f82_: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return f82_rgb(f0, f82_, incidence_cosine(normal, direction));
}

// Schlick's approximation with a dip, given as a fraction of its value at cos_i = 1/7.
//
//   F = f82(f0, tint schlick(f0, 1/7))
//
// f0      reflectance at normal incidence, [0, 1]
// tint    f82 over that of Schlick, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0517, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    18 operations
// source  Kutz, Hasan and Edmondson 2021, Novel aspects of the Adobe Standard Material
fn f82_tint(f0: f32, tint: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437;
    let b = at_82 * (1.0 - tint) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    return saturate(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m));
}

fn f82_tint_dir(f0: f32, tint: f32, normal: vec3f, direction: vec3f) -> f32 {
    return f82_tint(f0, tint, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn f82_tint_rgb(f0: vec3f, tint: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437;
    let b = at_82 * (1.0 - tint) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    let m5 = m2 * m2 * m;
    return saturate(f0 + one_minus_f0 * m5 - b * cos_i * (m5 * m));
}

fn f82_tint_rgb_dir(f0: vec3f, tint: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return f82_tint_rgb(f0, tint, incidence_cosine(normal, direction));
}

// Schlick's approximation with a dip, any power and any reflectance at grazing incidence.
//
//   f0 + (f90 - f0) x^power - b c x^6 through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0184, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    34 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful; MaterialX
fn hoffman(f0: f32, f82: f32, f90: f32, power: f32, cos_i: f32) -> f32 {
    let t = f90 - f0;
    let at_82 = f0 + t * pow(0.85714287, power);
    let b = (at_82 - f82) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return saturate(f0 + t * pow(m, power) - b * cos_i * (m2 * m2 * m2));
}

fn hoffman_dir(f0: f32, f82: f32, f90: f32, power: f32, normal: vec3f, direction: vec3f) -> f32 {
    return hoffman(f0, f82, f90, power, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn hoffman_rgb(f0: vec3f, f82: vec3f, f90: vec3f, power: vec3f, cos_i: f32) -> vec3f {
    let t = f90 - f0;
    let at_82 = f0 + t * pow(vec3f(0.85714287), power);
    let b = (at_82 - f82) * 17.651384;
    let m = 1.0 - cos_i;
    let m2 = m * m;
    return saturate(f0 + t * pow(vec3f(m), power) - b * cos_i * (m2 * m2 * m2));
}

fn hoffman_rgb_dir(f0: vec3f, f82: vec3f, f90: vec3f, power: vec3f, normal: vec3f,
        direction: vec3f) -> vec3f {
    return hoffman_rgb(f0, f82, f90, power, incidence_cosine(normal, direction));
}

// Two powers through f0 and f82.
//
//   f0 + x^4 (p + q x^8) through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0342, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    16 operations
// source  this library
fn powers_4_12(f0: f32, f82: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let rise = one_minus_f0 - (f82 - f0) * 1.8526235;
    let q = rise * 1.4111481;
    let one_minus_cos_i = 1.0 - cos_i;
    let t = one_minus_cos_i * one_minus_cos_i;
    let m4 = t * t;
    return saturate(f0 + m4 * (one_minus_f0 - q + q * (m4 * m4)));
}

fn powers_4_12_dir(f0: f32, f82: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_4_12(f0, f82, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_4_12_rgb(f0: vec3f, f82: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let rise = one_minus_f0 - (f82 - f0) * 1.8526235;
    let q = rise * 1.4111481;
    let one_minus_cos_i = 1.0 - cos_i;
    let t = one_minus_cos_i * one_minus_cos_i;
    let m4 = t * t;
    return saturate(f0 + m4 * (one_minus_f0 - q + q * (m4 * m4)));
}

fn powers_4_12_rgb_dir(f0: vec3f, f82: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_4_12_rgb(f0, f82, incidence_cosine(normal, direction));
}

// Three powers through f0 and f82.
//
//   f0 + c2 x^2 + c8 x^8 + c16 x^16 through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0357, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    23 operations
// source  this library
fn powers_2_8_16(f0: f32, f82: f32, cos_i: f32) -> f32 {
    let rise = 1.0 - f0;
    let dip = f82 - f0;
    let c2 = 1.04343 * dip - 0.2752 * rise;
    let c8 = 1.55944 * dip + 0.45498 * rise;
    let c16 = 0.82022 * rise - 2.60287 * dip;
    let one_minus_cos_i = 1.0 - cos_i;
    let m2 = one_minus_cos_i * one_minus_cos_i;
    let m2_2 = m2 * m2;
    let m8 = m2_2 * m2_2;
    return saturate(f0 + c2 * m2 + m8 * (c8 + c16 * m8));
}

fn powers_2_8_16_dir(f0: f32, f82: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_2_8_16(f0, f82, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_2_8_16_rgb(f0: vec3f, f82: vec3f, cos_i: f32) -> vec3f {
    let rise = 1.0 - f0;
    let dip = f82 - f0;
    let c2 = 1.04343 * dip - 0.2752 * rise;
    let c8 = 1.55944 * dip + 0.45498 * rise;
    let c16 = 0.82022 * rise - 2.60287 * dip;
    let one_minus_cos_i = 1.0 - cos_i;
    let m2 = one_minus_cos_i * one_minus_cos_i;
    let m2_2 = m2 * m2;
    let m8 = m2_2 * m2_2;
    return saturate(f0 + c2 * m2 + m8 * (c8 + c16 * m8));
}

fn powers_2_8_16_rgb_dir(f0: vec3f, f82: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_2_8_16_rgb(f0, f82, incidence_cosine(normal, direction));
}

// ---- artistic ------------------------------------------------------------------------------------------------

// The rim of game shaders.
//
//   F = saturate(bias + scale x^power), x = 1 - cos_i
//
// bias    value at normal incidence, [-10, 10]
// scale   strength of the rim, [-10, 10]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.275, certified: built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    14 operations
// source  Fernando and Kilgard 2003, The Cg Tutorial, ch. 7; Halladay 2014, Fresnel Shading
fn bias_scale_power(bias: f32, scale: f32, power: f32, cos_i: f32) -> f32 {
    return saturate(bias + scale * pow(1.0 - cos_i, power));
}

fn bias_scale_power_dir(bias: f32, scale: f32, power: f32, normal: vec3f, direction: vec3f) -> f32 {
    return bias_scale_power(bias, scale, power, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn bias_scale_power_rgb(bias: vec3f, scale: vec3f, power: vec3f, cos_i: f32) -> vec3f {
    return saturate(bias + scale * pow(vec3f(1.0 - cos_i), power));
}

fn bias_scale_power_rgb_dir(bias: vec3f, scale: vec3f, power: vec3f, normal: vec3f,
        direction: vec3f) -> vec3f {
    return bias_scale_power_rgb(bias, scale, power, incidence_cosine(normal, direction));
}
