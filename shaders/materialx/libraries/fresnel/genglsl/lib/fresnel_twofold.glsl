// a + b without rounding error: x is the rounded sum, y what it lacks (Knuth 1969).
// Right only where the compiler does not rearrange: no fast math, precise where the language has it.
vec2 two_sum(float a, float b) {
    float sum = a + b;
    float b_part = sum - a;
    return vec2(sum, a - (sum - b_part) + (b - b_part));
}

// a = x + y, half of its digits in each, so that products of halves are exact (Veltkamp 1968).
vec2 halves(float a) {
    float scaled = 4097.0 * a;
    float hi = scaled - (scaled - a);
    return vec2(hi, a - hi);
}

// a b without rounding error: x is the rounded product, y what it lacks (Dekker 1971).
vec2 two_product(float a, float b) {
    float product = a * b;
    vec2 p = halves(a);
    vec2 q = halves(b);
    float over = p.x * q.y;
    float under = p.y * q.x;
    float error = p.x * q.x - product + over + under + p.y * q.y;
    return vec2(product, error);
}

// a + b, where each number is a sum x + y with twice the digits of a float.
vec2 twofold_sum(vec2 a, vec2 b) {
    vec2 s = two_sum(a.x, b.x);
    vec2 t = two_sum(a.y, b.y);
    vec2 u = two_sum(s.x, s.y + t.x);
    return two_sum(u.x, u.y + t.y);
}

// a - b of such numbers.
vec2 twofold_difference(vec2 a, vec2 b) {
    return twofold_sum(a, -b);
}

// a b of such numbers.
vec2 twofold_product(vec2 a, vec2 b) {
    vec2 p = two_product(a.x, b.x);
    return two_sum(p.x, p.y + (a.x * b.y + a.y * b.x));
}
