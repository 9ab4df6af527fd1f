// Fresnel reflectance in WGSL.
// Made by `fresnel shader --all --lang wgsl`; do not edit.
//
// eta = n_t / n_i, the index behind the surface over the one in front; complex: n + i k.
// cos_i is the cosine of incidence, in [0, 1]. In the equations c is cos_i, s is sin_i and
// x is 1 - c; _s and _p are the polarisations across and along the plane of incidence.
// Directions are unit vectors and point away from the surface; the one beside the normal is
// yours: the view, the light or the half vector with either.
// Reflectance is of unpolarised light and lies in [0, 1]. RGB values are linear.
//
// A module takes one such text, since WGSL has no preprocessor: name all models in one call.

// The cosine between two directions, 0 where they lie on opposite sides.
//
// normal    unit
// direction where the light comes from, or the eye is; unit, on the side of normal
fn incidence_cosine(normal: vec3f, direction: vec3f) -> f32 {
    return saturate(dot(normal, direction));
}

struct fresnel_boundary {
    R_s: f32, // reflected, polarised across and along the plane of incidence
    R_p: f32,
    T_s: f32, // transmitted
    T_p: f32,
}

// ---- directions, angles and indices --------------------------------------------------------------------------

// The mirror direction, on the side of normal.
//
//   r = 2 (n . v) n - v
//
// direction where the light comes from, or the eye is; unit, on the side of normal
// normal    unit
fn reflected_direction(direction: vec3f, normal: vec3f) -> vec3f {
    let d = 2.0 * dot(normal, direction);
    return d * normal - direction;
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
    let r = (eta - 1.0) / (eta + 1.0); // amplitude
    return r * r;
}

// The relative index above 1 that has this f0.
//
//   eta = (1 + sqrt f0) / (1 - sqrt f0) = (1 + sqrt f0)^2 / (1 - f0)
//
// f0        reflectance at normal incidence, [0, 1)
fn eta_from_f0(f0: f32) -> f32 {
    let p = 1.0 + sqrt(f0);
    return p * p / (1.0 - f0);
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
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return a0 + (1.0 - a0) * (x2 * x2 * x);
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

// ---- twice the digits ----------------------------------------------------------------------------------------

// a + b without rounding error: x is the rounded sum, y what it lacks (Knuth 1969).
// Right only where the compiler does not rearrange: no fast math, precise where the language has it.
fn two_sum(a: f32, b: f32) -> vec2f {
    let sum = a + b;
    let b_part = sum - a;
    return vec2f(sum, a - (sum - b_part) + (b - b_part));
}

// a = x + y, half of its digits in each, so that products of halves are exact (Veltkamp 1968).
fn halves(a: f32) -> vec2f {
    let scaled = 4097.0 * a;
    let hi = scaled - (scaled - a);
    return vec2f(hi, a - hi);
}

// a b without rounding error: x is the rounded product, y what it lacks (Dekker 1971).
fn two_product(a: f32, b: f32) -> vec2f {
    let product = a * b;
    let p = halves(a);
    let q = halves(b);
    let over = p.x * q.y;
    let under = p.y * q.x;
    let error = p.x * q.x - product + over + under + p.y * q.y;
    return vec2f(product, error);
}

// a + b, where each number is a sum x + y with twice the digits of a float.
fn twofold_sum(a: vec2f, b: vec2f) -> vec2f {
    let s = two_sum(a.x, b.x);
    let t = two_sum(a.y, b.y);
    let u = two_sum(s.x, s.y + t.x);
    return two_sum(u.x, u.y + t.y);
}

// a - b of such numbers.
fn twofold_difference(a: vec2f, b: vec2f) -> vec2f {
    return twofold_sum(a, -b);
}

// a b of such numbers.
fn twofold_product(a: vec2f, b: vec2f) -> vec2f {
    let p = two_product(a.x, b.x);
    return two_sum(p.x, p.y + (a.x * b.y + a.y * b.x));
}

// ---- exact ---------------------------------------------------------------------------------------------------

// Exact reflectance between two transparent media, accurate in float but at the critical angle.
//
//   R_s = E^2 / (E^2 + 4 c g (g + c)^2), R_p = R_s ((c g - s^2) / (c g + s^2))^2, E = eta^2 - 1,
//   g^2 = E + c^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 1e-1 at a critical angle
// cost    37 operations
// source  Fresnel 1823
fn dielectric(n_i: f32, n_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let s2 = n_i * (1.0 - cos_i * cos_i);
    let E = (n_t - n_i) * (n_t + n_i); // n_t^2 - n_i^2

    // Snell
    let g2 = E + c * c; // below 0 beyond the critical angle
    let g = sqrt(max(g2, 1.1754944e-38)); // n_t cos_t; beyond it so small that R is 1

    // s-polarised, across the plane of incidence
    let E2 = E * E;
    let cg = c * g;
    let a = 2.0 * (g + c);
    let a2 = a * a;
    let D_s = max(E2 + cg * a2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    let R_s = E2 / D_s;

    // p-polarised, along it
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
    let E = (n_t - n_i) * (n_t + n_i); // n_t^2 - n_i^2

    // Snell
    let g2 = E + c * c; // below 0 beyond the critical angle
    let g = sqrt(max(g2, vec3f(1.1754944e-38))); // n_t cos_t; beyond it so small that R is 1

    // s-polarised, across the plane of incidence
    let E2 = E * E;
    let cg = c * g;
    let a = 2.0 * (g + c);
    let a2 = a * a;
    let D_s = max(E2 + cg * a2, vec3f(1.1754944e-38)); // 0 only for equal media at cos_i = 0
    let R_s = E2 / D_s;

    // p-polarised, along it
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
    let E = (n_t - n_i) * (n_t + n_i); // n_t^2 - n_i^2

    // Snell
    let g2 = E + c * c; // below 0 beyond the critical angle
    let g = sqrt(max(g2, 1.1754944e-38)); // n_t cos_t; beyond it so small that R is 1

    // s-polarised, across the plane of incidence
    let E2 = E * E;
    let cg = c * g;
    let a = 2.0 * (g + c);
    let a2 = a * a;
    let D_s = max(E2 + cg * a2, 1.1754944e-38); // 0 only for equal media at cos_i = 0
    let R_s = E2 / D_s;

    // p-polarised, along it
    let x = cos_i * g;
    let b = x + s2;
    let q = (x - s2) / b;
    let R_p = R_s * (q * q);

    // transmitted
    let through_s = select(cg * (a2 / D_s), 0.0, g2 <= 0.0);
    let through_p = select(4.0 * (x * s2) / (b * b), 0.0, g2 <= 0.0);
    let T_s = select(through_s, 1.0 - R_s, E2 <= 0.0);
    let T_p = T_s + R_s * through_p;
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}

// Exact reflectance of an absorbing medium seen from a transparent one, accurate in float but at the critical angle.
//
//   R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 2e-6, up to 1e-1 at a critical angle of small k_t
// cost    67 operations
// source  Born and Wolf 1999, Principles of Optics, sec. 14.2
fn conductor(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> f32 {
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let s4 = s2 * s2;

    // Snell
    let E = (n_t - n_i) * (n_t + n_i) - k_t * k_t; // Re m^2 - n_i^2, m the complex index
    let Z = 2.0 * (n_t * k_t); // Im m^2
    let Z2 = Z * Z;
    let t0 = E + c2; // q^2 = t0 + i Z
    let A = sqrt(t0 * t0 + Z2); // |q|^2
    let S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    let u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    let a = select(S, Z, t0 <= 0.0); // u Re q

    // s-polarised, across the plane of incidence
    let h = 2.0 * (a * c);
    let F = (E * E + Z2) * S; // S |c - q|^2 |c + q|^2
    let G_s = (A + c2) * u + h;
    let D_s = max(F + h * G_s, 1.1754944e-38); // S |c + q|^4; 0 only for equal media at cos_i = 0
    let R_s = F / D_s;

    // p-polarised, along it
    let h_p = h * sin2;
    let N = t0 * cos2 - s4;
    let M = Z * cos2;
    let M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    let B = (N * N + M2) * S; // S |q c - s^2|^2 |q c + s^2|^2
    let G_p = (A * cos2 + s4) * u + h_p;
    let D_p = B + h_p * G_p; // S |q c + s^2|^4
    let R_p = R_s * (B / D_p);
    return (R_s + R_p) / 2.0;
}

fn conductor_dir(n_i: f32, n_t: f32, k_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return conductor(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn conductor_rgb(n_i: f32, n_t: vec3f, k_t: vec3f, cos_i: f32) -> vec3f {
    return vec3f(conductor(n_i, n_t.x, k_t.x, cos_i),
                 conductor(n_i, n_t.y, k_t.y, cos_i),
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

    // Snell
    let E = (n_t - n_i) * (n_t + n_i) - k_t * k_t; // Re m^2 - n_i^2, m the complex index
    let Z = 2.0 * (n_t * k_t); // Im m^2
    let Z2 = Z * Z;
    let t0 = E + c2; // q^2 = t0 + i Z
    let A = sqrt(t0 * t0 + Z2); // |q|^2
    let S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    let u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    let a = select(S, Z, t0 <= 0.0); // u Re q

    // s-polarised, across the plane of incidence
    let h = 2.0 * (a * c);
    let F = (E * E + Z2) * S; // S |c - q|^2 |c + q|^2
    let G_s = (A + c2) * u + h;
    let D_s = max(F + h * G_s, 1.1754944e-38); // S |c + q|^4; 0 only for equal media at cos_i = 0
    let R_s = F / D_s;

    // p-polarised, along it
    let h_p = h * sin2;
    let N = t0 * cos2 - s4;
    let M = Z * cos2;
    let M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    let B = (N * N + M2) * S; // S |q c - s^2|^2 |q c + s^2|^2
    let G_p = (A * cos2 + s4) * u + h_p;
    let D_p = B + h_p * G_p; // S |q c + s^2|^4
    let R_p = R_s * (B / D_p);

    // transmitted
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
// error   rounding only, in float relative 8e-6 for eta > 1.05, no digit left at 1 +- 1e-6
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
    return vec3f(dielectric_fast(n_i, n_t.x, cos_i),
                 dielectric_fast(n_i, n_t.y, cos_i),
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
    let through_s = w / (a * a);
    let through_p = w * sin2 / (b * b);
    let T_s = select(through_s, 0.0, g2 <= 0.0);
    let T_p = select(through_s + r2 * through_p, 0.0, g2 <= 0.0);
    return fresnel_boundary(R_s, R_p, min(T_s, 1.0), min(T_p, 1.0));
}

// Exact reflectance of an absorbing medium in the fewest operations.
//
//   R_s = (t1 - t2) / (t1 + t2), R_p = R_s (t3 - t4) / (t3 + t4), t1 = A + c^2, t2 = 2 a c,
//   t3 = A c^2 + s^4, t4 = t2 s^2, A = a^2 + b^2, (a + i b)^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 6e-6 for metals, 2e-4 for dielectrics, no digit left near an index match
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
//   R_s = |c - q|^2 / |c + q|^2, R_p = R_s |q c - s^2|^2 / |q c + s^2|^2, q^2 = (n + i k)^2 - s^2
//
// n_i     index in front of the surface, [0.01, 100]
// n_t     index behind it, [0.001, 1000]
// k_t     its imaginary part, [0, 10000]
// cos_i   cosine of incidence, [0, 1]
// error   rounding only, in float relative 1e-6 in R, absolute 1e-6 in T
// cost    304 operations
// source  Born and Wolf 1999; Knuth 1969; Dekker 1971
fn conductor_precise(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> f32 {
    let s2 = (1.0 - cos_i) * (1.0 + cos_i);

    // what cancels, in twice the digits
    let n2 = two_product(n_t, n_t);
    let k2 = two_product(k_t, k_t);
    let i2 = two_product(n_i, n_i);
    let c2 = two_product(cos_i, cos_i);
    let m2 = twofold_difference(n2, k2); // Re m^2, m = n_t + i k_t
    let E = twofold_difference(m2, i2);
    let p2 = twofold_product(i2, c2); // (n_i cos_i)^2
    let q2 = twofold_sum(E, p2); // Re q^2, q^2 = m^2 - (n_i sin_i)^2
    let sum2 = twofold_sum(n2, i2);
    let product = twofold_product(c2, sum2);
    let N = twofold_difference(product, i2); // 0 at Brewster's angle where k_t = 0

    // q = a + i b, which is m cos_t; lengths in units of 1 / n_i
    let c = n_i * cos_i;
    let nk = n_t * k_t; // Im q^2 / 2
    let size = abs(q2.x);
    let A = max(sqrt(q2.x * q2.x + 4.0 * (nk * nk)), size); // |q|^2
    let larger = sqrt((A + size) / 2.0); // of |Re q| and |Im q|
    let smaller = nk / select(1.0, larger, larger > 0.0);
    let a = select(larger, smaller, q2.x <= 0.0); // Re q
    let b = select(smaller, larger, q2.x <= 0.0); // Im q
    let b2 = b * b;

    // s-polarised; d is a - c, exact near an index match as well
    let a_minus_c = a - c;
    let a_plus_c = a + c;
    let d = select(a_minus_c, (E.x + b2) / a_plus_c, max(2.0 * abs(a_minus_c), b) < c);
    let D_s = a_plus_c * a_plus_c + b2;
    let D = select(D_s, 1.0, D_s <= 0.0); // 0 only for equal media at cos_i = 0
    let N_s = d * d + b2;
    let R_s = N_s / D;

    // p-polarised; nu is a cos_i - n_i sin_i^2, exact near Brewster's angle as well
    let is2 = n_i * s2;
    let ac = a * cos_i;
    let bc = b * cos_i;
    let bc2 = bc * bc;
    let difference = ac - is2;
    let total = ac + is2;
    let sum = select(total, 1.0, total <= 0.0);
    let exact = (N.x + c2.x * (b2 - k2.x)) / sum;
    let nu = select(difference, exact, max(2.0 * abs(difference) - is2, 2.0 * b - n_i) < 0.0);
    let P = sum * sum + bc2;
    let R_p = R_s * ((nu * nu + bc2) / P);
    return (min(R_s, 1.0) + min(R_p, 1.0)) / 2.0;
}

fn conductor_precise_dir(n_i: f32, n_t: f32, k_t: f32, normal: vec3f, direction: vec3f) -> f32 {
    return conductor_precise(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn conductor_precise_rgb(n_i: f32, n_t: vec3f, k_t: vec3f, cos_i: f32) -> vec3f {
    return vec3f(conductor_precise(n_i, n_t.x, k_t.x, cos_i),
                 conductor_precise(n_i, n_t.y, k_t.y, cos_i),
                 conductor_precise(n_i, n_t.z, k_t.z, cos_i));
}

fn conductor_precise_rgb_dir(n_i: f32, n_t: vec3f, k_t: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return conductor_precise_rgb(n_i, n_t, k_t, incidence_cosine(normal, direction));
}

// Reflectances and transmittances of both polarisations.
fn conductor_precise_boundary(n_i: f32, n_t: f32, k_t: f32, cos_i: f32) -> fresnel_boundary {
    let s2 = (1.0 - cos_i) * (1.0 + cos_i);

    // what cancels, in twice the digits
    let n2 = two_product(n_t, n_t);
    let k2 = two_product(k_t, k_t);
    let i2 = two_product(n_i, n_i);
    let c2 = two_product(cos_i, cos_i);
    let m2 = twofold_difference(n2, k2); // Re m^2, m = n_t + i k_t
    let E = twofold_difference(m2, i2);
    let p2 = twofold_product(i2, c2); // (n_i cos_i)^2
    let q2 = twofold_sum(E, p2); // Re q^2, q^2 = m^2 - (n_i sin_i)^2
    let sum2 = twofold_sum(n2, i2);
    let product = twofold_product(c2, sum2);
    let N = twofold_difference(product, i2); // 0 at Brewster's angle where k_t = 0

    // q = a + i b, which is m cos_t; lengths in units of 1 / n_i
    let c = n_i * cos_i;
    let nk = n_t * k_t; // Im q^2 / 2
    let size = abs(q2.x);
    let A = max(sqrt(q2.x * q2.x + 4.0 * (nk * nk)), size); // |q|^2
    let larger = sqrt((A + size) / 2.0); // of |Re q| and |Im q|
    let smaller = nk / select(1.0, larger, larger > 0.0);
    let a = select(larger, smaller, q2.x <= 0.0); // Re q
    let b = select(smaller, larger, q2.x <= 0.0); // Im q
    let b2 = b * b;

    // s-polarised; d is a - c, exact near an index match as well
    let a_minus_c = a - c;
    let a_plus_c = a + c;
    let d = select(a_minus_c, (E.x + b2) / a_plus_c, max(2.0 * abs(a_minus_c), b) < c);
    let D_s = a_plus_c * a_plus_c + b2;
    let D = select(D_s, 1.0, D_s <= 0.0); // 0 only for equal media at cos_i = 0
    let N_s = d * d + b2;
    let R_s = N_s / D;
    let T_s = select(4.0 * (a * c) / D, 1.0, N_s <= 0.0);

    // p-polarised; nu is a cos_i - n_i sin_i^2, exact near Brewster's angle as well
    let is2 = n_i * s2;
    let ac = a * cos_i;
    let bc = b * cos_i;
    let bc2 = bc * bc;
    let difference = ac - is2;
    let total = ac + is2;
    let sum = select(total, 1.0, total <= 0.0);
    let exact = (N.x + c2.x * (b2 - k2.x)) / sum;
    let nu = select(difference, exact, max(2.0 * abs(difference) - is2, 2.0 * b - n_i) < 0.0);
    let P = sum * sum + bc2;
    let R_p = R_s * ((nu * nu + bc2) / P);
    let T_p = T_s + R_s * (4.0 * (ac * is2) / P);
    return fresnel_boundary(min(R_s, 1.0), min(R_p, 1.0), min(T_s, 1.0), min(T_p, 1.0));
}

// ---- approximations ------------------------------------------------------------------------------------------

// Schlick's approximation.
//
//   F = f0 + (1 - f0) x^5, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0824, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994, An Inexpensive BRDF Model for Physically-based Rendering
fn schlick(f0: f32, cos_i: f32) -> f32 {
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

fn schlick_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
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
// error   at most 0.0824, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    7 operations
// source  Schlick 1994; Real-Time Rendering, 4th ed., eq. 9.18
fn schlick_f90(f0: f32, f90: f32, cos_i: f32) -> f32 {
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return f0 + (f90 - f0) * (x2 * x2 * x);
}

fn schlick_f90_dir(f0: f32, f90: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_f90(f0, f90, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_f90_rgb(f0: vec3f, f90: vec3f, cos_i: f32) -> vec3f {
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return f0 + (f90 - f0) * (x2 * x2 * x);
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
// error   at most 0.0968, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    13 operations
// source  Real-Time Rendering, 4th ed., eq. 9.18
fn schlick_power(f0: f32, f90: f32, power: f32, cos_i: f32) -> f32 {
    let rise = f90 - f0;
    return f0 + rise * pow(1.0 - cos_i, power);
}

fn schlick_power_dir(f0: f32, f90: f32, power: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_power(f0, f90, power, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_power_rgb(f0: vec3f, f90: vec3f, power: vec3f, cos_i: f32) -> vec3f {
    let rise = f90 - f0;
    return f0 + rise * pow(vec3f(1.0 - cos_i), power);
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
// error   at most 0.256, certified for n in [0.1, 4], k in [1, 8]
// cost    19 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
fn schlick_nk(n: f32, k: f32, cos_i: f32) -> f32 {
    let x = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let x2 = x * x;
    let n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2), 1.0);
}

fn schlick_nk_dir(n: f32, k: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_nk(n, k, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_nk_rgb(n: vec3f, k: vec3f, cos_i: f32) -> vec3f {
    let x = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let x2 = x * x;
    let n_plus_1 = n + 1.0;
    return min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2),
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
// error   at most 0.0824, certified for 1 / eta in [1.3, 2.5], from inside
// cost    28 operations
// source  Lagarde 2013, Memo on Fresnel equations
fn schlick_internal(eta: f32, cos_i: f32) -> f32 {
    let eta_minus_1 = eta - 1.0;
    let eta_plus_1 = eta + 1.0;
    let r = eta_minus_1 / eta_plus_1; // amplitude
    let f0 = r * r;
    let g2 = eta_minus_1 * eta_plus_1 + cos_i * cos_i;
    let cos_t = select(min(sqrt(g2) / eta, 1.0), 0.0, g2 <= 0.0);
    let x = 1.0 - cos_t;
    let x2 = x * x;
    return f0 + (1.0 - f0) * (x2 * x2 * x);
}

fn schlick_internal_dir(eta: f32, normal: vec3f, direction: vec3f) -> f32 {
    return schlick_internal(eta, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn schlick_internal_rgb(eta: vec3f, cos_i: f32) -> vec3f {
    return vec3f(schlick_internal(eta.x, cos_i),
                 schlick_internal(eta.y, cos_i),
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
// error   at most 0.0847, certified for eta in [1.3, 2.5], from outside, f0 exact
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
// error   at most 0.0708, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    6 operations
// source  photometric.io, Improving Schlick's Approximation
fn photometric(f0: f32, cos_i: f32) -> f32 {
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return f0 + (x - f0) * (x2 * x2);
}

fn photometric_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return photometric(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn photometric_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return f0 + (x - f0) * (x2 * x2);
}

fn photometric_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return photometric_rgb(f0, incidence_cosine(normal, direction));
}

// Two powers for one operation more than Schlick, better on dielectrics.
//
//   F = f0 + x^4 ((a - f0) + (1 - a) x^4), a = 0.55, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0363, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    8 operations
// source  this library
fn powers_4_8(f0: f32, cos_i: f32) -> f32 {
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x4 = x2 * x2;
    return f0 + x4 * (0.55 - f0 + 0.45 * x4);
}

fn powers_4_8_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_4_8(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_4_8_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x4 = x2 * x2;
    return f0 + x4 * (0.55 - f0 + 0.45 * x4);
}

fn powers_4_8_rgb_dir(f0: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_4_8_rgb(f0, incidence_cosine(normal, direction));
}

// Two powers, less than half of Schlick's error on dielectrics.
//
//   F = f0 + x^3 max((1 - f0) - 0.54 (1 - x^6), 0), x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0328, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    12 operations
// source  this library
fn powers_3_9(f0: f32, cos_i: f32) -> f32 {
    let x = 1.0 - cos_i;
    let x3 = x * x * x;
    let rise = saturate(1.0 - f0 - 0.54 * (1.0 - x3 * x3)); // saturate is free on GPUs
    return f0 + x3 * rise;
}

fn powers_3_9_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_3_9(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_3_9_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let x = 1.0 - cos_i;
    let x3 = x * x * x;
    let rise = saturate(1.0 - f0 - 0.54 * (1.0 - x3 * x3)); // saturate is free on GPUs
    return f0 + x3 * rise;
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
// error   at most 0.00713, certified for eta in [1.3, 2.5], from outside, f0 exact
// cost    27 operations
// source  this library
fn powers_3_6_9(f0: f32, cos_i: f32) -> f32 {
    let s = sqrt(f0 + 8.271806e-25); // 2^-80 keeps the slope at f0 = 0 finite
    let p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    let q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    let r = 1.0 - f0 - p - q;
    let x = 1.0 - cos_i;
    let y = x * x * x;
    return saturate(f0 + y * (p + y * (q + y * r)));
}

fn powers_3_6_9_dir(f0: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_3_6_9(f0, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_3_6_9_rgb(f0: vec3f, cos_i: f32) -> vec3f {
    let s = sqrt(f0 + 8.271806e-25); // 2^-80 keeps the slope at f0 = 0 finite
    let p = 2.90623 * s - 0.02379 - 4.78491 * f0;
    let q = 0.43137 - 0.58931 * s - 2.31299 * f0;
    let r = 1.0 - f0 - p - q;
    let x = 1.0 - cos_i;
    let y = x * x * x;
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
// error   at most 0.543, certified for eta in [1.3, 2.5], from outside, f0 exact
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
// error   at most 0.983, certified for eta in [1.3, 2.5], from outside, f0 exact
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
// error   at most 0.0639, certified for n in [0.1, 4], k in [1, 8]
// cost    26 operations
// source  Pharr and Humphreys, Physically Based Rendering; Lagarde 2013
fn air_conductor(n: f32, k: f32, cos_i: f32) -> f32 {
    let k2 = k * k;
    let n_minus_c = n - cos_i;
    let n_plus_c = n + cos_i;
    let R_s = (n_minus_c * n_minus_c + k2) / (n_plus_c * n_plus_c + k2);
    let nc = n * cos_i;
    let kc2 = k2 * (cos_i * cos_i);
    let nc_minus_1 = nc - 1.0;
    let nc_plus_1 = nc + 1.0;
    let R_p = (nc_minus_1 * nc_minus_1 + kc2) / (nc_plus_1 * nc_plus_1 + kc2);
    return (R_s + R_p) / 2.0;
}

fn air_conductor_dir(n: f32, k: f32, normal: vec3f, direction: vec3f) -> f32 {
    return air_conductor(n, k, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn air_conductor_rgb(n: vec3f, k: vec3f, cos_i: f32) -> vec3f {
    let k2 = k * k;
    let n_minus_c = n - cos_i;
    let n_plus_c = n + cos_i;
    let R_s = (n_minus_c * n_minus_c + k2) / (n_plus_c * n_plus_c + k2);
    let nc = n * cos_i;
    let kc2 = k2 * (cos_i * cos_i);
    let nc_minus_1 = nc - 1.0;
    let nc_plus_1 = nc + 1.0;
    let R_p = (nc_minus_1 * nc_minus_1 + kc2) / (nc_plus_1 * nc_plus_1 + kc2);
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
// error   at most 0.0451, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    33 operations
// source  Lazanyi and Szirmay-Kalos 2005, Fresnel Term Approximations for Metals
fn lazanyi(n: f32, k: f32, a: f32, alpha: f32, cos_i: f32) -> f32 {
    let x = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let x2 = x * x;
    let n_plus_1 = n + 1.0;
    let F = min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2), 1.0);
    return saturate(F - a * cos_i * pow(x, alpha));
}

fn lazanyi_dir(n: f32, k: f32, a: f32, alpha: f32, normal: vec3f, direction: vec3f) -> f32 {
    return lazanyi(n, k, a, alpha, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn lazanyi_rgb(n: vec3f, k: vec3f, a: vec3f, alpha: vec3f, cos_i: f32) -> vec3f {
    let x = 1.0 - cos_i;
    let n_minus_1 = n - 1.0;
    let k2 = k * k;
    let x2 = x * x;
    let n_plus_1 = n + 1.0;
    let F = min((n_minus_1 * n_minus_1 + k2 + 4.0 * n * (x2 * x2 * x)) / (n_plus_1 * n_plus_1 + k2),
            vec3f(1.0));
    return saturate(F - a * cos_i * pow(vec3f(x), alpha));
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
// error   rounding only, in float 3e-7 for r in [0.02, 0.99]
// cost    96 operations
// source  Gulbrandsen 2014, Artist Friendly Metallic Fresnel
fn gulbrandsen(r: f32, g: f32, cos_i: f32) -> f32 {
    let f0 = min(r, 0.9999) + 8.271806e-25; // 2^-80 keeps its root's slope finite
    let root = sqrt(f0);
    let one_minus_f0 = 1.0 - f0;
    let one_plus_f0 = 1.0 + f0;
    let one_plus_root = 1.0 + root;
    let one_minus_root = 1.0 - root;

    // indices, all times 1 - f0^2
    let n_i = one_minus_f0 * one_plus_f0;
    let n_max = one_plus_root * one_plus_root * one_plus_f0;
    let n_min = one_minus_f0 * one_minus_f0;
    let n_0 = one_minus_root * one_minus_root * one_plus_f0; // 1 / n_max; k is 0 at both
    let n = n_max * (1.0 - g) + n_min * g;
    let k = sqrt(max((n_max - n) * (n - n_0), 0.0) + 8.271806e-25);
    let c = n_i * cos_i;
    let c2 = c * c;
    let cos2 = cos_i * cos_i;
    let sin2 = 1.0 - cos2;
    let s2 = n_i * sin2;
    let s4 = s2 * s2;

    // Snell
    let E = (n - n_i) * (n + n_i) - k * k; // Re m^2 - n_i^2, m the complex index
    let Z = 2.0 * (n * k); // Im m^2
    let Z2 = Z * Z;
    let t0 = E + c2; // q^2 = t0 + i Z
    let A = sqrt(t0 * t0 + Z2); // |q|^2
    let S = max(A + abs(t0), 8.881784e-16); // 0 only at the critical angle
    let u = sqrt(2.0 * S); // twice the larger of Re q and Im q
    let a = select(S, Z, t0 <= 0.0); // u Re q

    // s-polarised, across the plane of incidence
    let h = 2.0 * (a * c);
    let F = (E * E + Z2) * S; // S |c - q|^2 |c + q|^2
    let G_s = (A + c2) * u + h;
    let D_s = max(F + h * G_s, 1.1754944e-38); // S |c + q|^4; 0 only for equal media at cos_i = 0
    let R_s = F / D_s;

    // p-polarised, along it
    let h_p = h * sin2;
    let N = t0 * cos2 - s4;
    let M = Z * cos2;
    let M2 = M * M + 8.4703295e-22; // above 0, so that D_p is
    let B = (N * N + M2) * S; // S |q c - s^2|^2 |q c + s^2|^2
    let G_p = (A * cos2 + s4) * u + h_p;
    let D_p = B + h_p * G_p; // S |q c + s^2|^4
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
//   F = f0 + (1 - f0) x^5 - b c x^6, through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0406, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    17 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful
fn f82(f0: f32, f82_: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    let b = (at_82 - f82_) * 17.651384; // divided by c x^6 at cos_i = 1/7
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x5 = x2 * x2 * x;
    return saturate(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x));
}

fn f82_dir(f0: f32, f82_: f32, normal: vec3f, direction: vec3f) -> f32 {
    return f82(f0, f82_, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn f82_rgb(f0: vec3f, f82_: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    let b = (at_82 - f82_) * 17.651384; // divided by c x^6 at cos_i = 1/7
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x5 = x2 * x2 * x;
    return saturate(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x));
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
// error   at most 0.0451, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    18 operations
// source  Kutz, Hasan and Edmondson 2021, Novel aspects of the Adobe Standard Material
fn f82_tint(f0: f32, tint: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    let b = at_82 * (1.0 - tint) * 17.651384; // divided by c x^6 at cos_i = 1/7
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x5 = x2 * x2 * x;
    return saturate(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x));
}

fn f82_tint_dir(f0: f32, tint: f32, normal: vec3f, direction: vec3f) -> f32 {
    return f82_tint(f0, tint, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn f82_tint_rgb(f0: vec3f, tint: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let at_82 = f0 + one_minus_f0 * 0.46266437; // Schlick's curve at cos_i = 1/7: x^5 is (6/7)^5
    let b = at_82 * (1.0 - tint) * 17.651384; // divided by c x^6 at cos_i = 1/7
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x5 = x2 * x2 * x;
    return saturate(f0 + one_minus_f0 * x5 - b * cos_i * (x5 * x));
}

fn f82_tint_rgb_dir(f0: vec3f, tint: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return f82_tint_rgb(f0, tint, incidence_cosine(normal, direction));
}

// Schlick's approximation with a dip, any power and any reflectance at grazing incidence.
//
//   F = f0 + (f90 - f0) x^power - b c x^6, through f82 at c = 1/7, x = 1 - c, c = cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// f90     reflectance at grazing incidence, [0, 1]
// power   sharpness of the rise, [0.1, 1000]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0185, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    34 operations
// source  Hoffman 2019, Fresnel Equations Considered Harmful; MaterialX
fn hoffman(f0: f32, f82: f32, f90: f32, power: f32, cos_i: f32) -> f32 {
    let rise = f90 - f0;
    let at_82 = f0 + rise * pow(0.85714287, power); // at cos_i = 1/7: x is 6/7
    let b = (at_82 - f82) * 17.651384; // divided by c x^6 at cos_i = 1/7
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return saturate(f0 + rise * pow(x, power) - b * cos_i * (x2 * x2 * x2));
}

fn hoffman_dir(f0: f32, f82: f32, f90: f32, power: f32, normal: vec3f, direction: vec3f) -> f32 {
    return hoffman(f0, f82, f90, power, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn hoffman_rgb(f0: vec3f, f82: vec3f, f90: vec3f, power: vec3f, cos_i: f32) -> vec3f {
    let rise = f90 - f0;
    let at_82 = f0 + rise * pow(vec3f(0.85714287), power); // at cos_i = 1/7: x is 6/7
    let b = (at_82 - f82) * 17.651384; // divided by c x^6 at cos_i = 1/7
    let x = 1.0 - cos_i;
    let x2 = x * x;
    return saturate(f0 + rise * pow(vec3f(x), power) - b * cos_i * (x2 * x2 * x2));
}

fn hoffman_rgb_dir(f0: vec3f, f82: vec3f, f90: vec3f, power: vec3f, normal: vec3f,
        direction: vec3f) -> vec3f {
    return hoffman_rgb(f0, f82, f90, power, incidence_cosine(normal, direction));
}

// Two powers through f0 and f82.
//
//   F = f0 + x^4 (p + q x^8), through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0216, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    16 operations
// source  this library
fn powers_4_12(f0: f32, f82: f32, cos_i: f32) -> f32 {
    let one_minus_f0 = 1.0 - f0;
    let rise = one_minus_f0 - (f82 - f0) * 1.8526235; // 1 / x^4 at cos_i = 1/7: (7/6)^4
    let q = rise * 1.4111481; // 1 / (1 - x^8) there
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x4 = x2 * x2;
    return saturate(f0 + x4 * (one_minus_f0 - q + q * (x4 * x4)));
}

fn powers_4_12_dir(f0: f32, f82: f32, normal: vec3f, direction: vec3f) -> f32 {
    return powers_4_12(f0, f82, incidence_cosine(normal, direction));
}

// The same for three channels, which share the angle.
fn powers_4_12_rgb(f0: vec3f, f82: vec3f, cos_i: f32) -> vec3f {
    let one_minus_f0 = 1.0 - f0;
    let rise = one_minus_f0 - (f82 - f0) * 1.8526235; // 1 / x^4 at cos_i = 1/7: (7/6)^4
    let q = rise * 1.4111481; // 1 / (1 - x^8) there
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x4 = x2 * x2;
    return saturate(f0 + x4 * (one_minus_f0 - q + q * (x4 * x4)));
}

fn powers_4_12_rgb_dir(f0: vec3f, f82: vec3f, normal: vec3f, direction: vec3f) -> vec3f {
    return powers_4_12_rgb(f0, f82, incidence_cosine(normal, direction));
}

// Three powers through f0 and f82.
//
//   F = f0 + c2 x^2 + c8 x^8 + c16 x^16, through f82 at cos_i = 1/7, x = 1 - cos_i
//
// f0      reflectance at normal incidence, [0, 1]
// f82     reflectance at cos_i = 1/7, 81.8 degrees, [0, 1]
// cos_i   cosine of incidence, [0, 1]
// error   at most 0.0358, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
// cost    23 operations
// source  this library
fn powers_2_8_16(f0: f32, f82: f32, cos_i: f32) -> f32 {
    let rise = 1.0 - f0;
    let dip = f82 - f0;
    let c2 = 1.04343 * dip - 0.2752 * rise;
    let c8 = 1.55944 * dip + 0.45498 * rise;
    let c16 = 0.82022 * rise - 2.60287 * dip;
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x4 = x2 * x2;
    let x8 = x4 * x4;
    return saturate(f0 + c2 * x2 + x8 * (c8 + c16 * x8));
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
    let x = 1.0 - cos_i;
    let x2 = x * x;
    let x4 = x2 * x2;
    let x8 = x4 * x4;
    return saturate(f0 + c2 * x2 + x8 * (c8 + c16 * x8));
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
// error   at most 0.147, certified for measured built-in metals but caesium, at 450, 550 and 650 nm, parameters fitted
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
