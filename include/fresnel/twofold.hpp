#pragma once

// Twice the digits: sums and products whose rounding error is kept as a second number beside the rounded result.
// They need an arithmetic that does not re-associate (no -ffast-math).

#include <fresnel/number.hpp>

#include <limits>

namespace fresnel {

/// A value as an unevaluated sum hi + lo, twice the digits of T.
template <class T>
struct twofold {
    T hi, lo;
};

/// a + b without rounding error (Knuth 1969, TAOCP vol. 2, sec. 4.2.2).
template <class T>
twofold<T> two_sum(T a, T b) {
    const T sum = let("sum", a + b);
    const T b_part = let("b_part", sum - a);
    return result_of("two_sum", twofold<T>{sum, (a - (sum - b_part)) + (b - b_part)}, a, b);
}

/// a in two halves of the mantissa, so that products of halves are exact (Veltkamp 1968).
template <class T>
twofold<T> halves(T a) {
    const T factor = T(std::numeric_limits<T>::digits > 24 ? 134217729 : 4097); // 2^27 + 1, 2^12 + 1
    const T t = let("scaled", factor * a);
    const T hi = let("hi", t - (t - a));
    return result_of("halves", twofold<T>{hi, a - hi}, a);
}

/// a b without rounding error, for numbers of 24 or 53 digits, from + - * alone (Dekker 1971) unless T has an operation for
/// it.
template <class T>
twofold<T> two_product(T a, T b) {
    const T product = let("product", a * b);
    if constexpr (requires { product_error(a, b, product); }) return {product, product_error(a, b, product)};
    const twofold<T> p = let("p", halves(a)), q = let("q", halves(b));
    const T over = let("over", p.hi * q.lo); // of a square one and the same, in this order
    const T under = let("under", p.lo * q.hi);
    const T error = let("error", ((p.hi * q.hi - product) + over + under) + p.lo * q.lo);
    return result_of("two_product", twofold<T>{product, error}, a, b);
}

template <class T>
twofold<T> operator+(twofold<T> x, twofold<T> y) {
    const twofold<T> s = let("s", two_sum(x.hi, y.hi)), t = let("t", two_sum(x.lo, y.lo));
    const twofold<T> u = let("u", two_sum(s.hi, s.lo + t.hi));
    return result_of("twofold_sum", two_sum(u.hi, u.lo + t.lo), x, y);
}

template <class T>
twofold<T> operator-(twofold<T> x, twofold<T> y) {
    return result_of("twofold_difference", x + twofold<T>{-y.hi, -y.lo}, x, y);
}

template <class T>
twofold<T> operator*(twofold<T> x, twofold<T> y) {
    const twofold<T> p = let("p", two_product(x.hi, y.hi));
    return result_of("twofold_product", two_sum(p.hi, p.lo + (x.hi * y.lo + x.lo * y.hi)), x, y);
}

} // namespace fresnel
