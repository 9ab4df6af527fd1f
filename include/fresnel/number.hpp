#pragma once

// The vocabulary of the models, and what a number type must offer to run them.
//
// A model in this library is one function template over its number type T. It is never specialised: the
// float, the 50-digit number, the derivative, the interval, the SIMD batch and the shader text are all the
// same body, instantiated. That works because a body uses these verbs and nothing else:
//
//     + - * /                 between T and T, and between T and an integer literal; - of a T
//     < <= > >=               give a mask, not a bool: for a batch or a symbol there is no single answer
//     select(mask, a, b)      a where the mask holds, otherwise b; both are always evaluated
//     sqrt abs min max        the usual ones; min and max keep a NaN that is their first argument
//     exp2 log2 log pow       pow(x, y) for x >= 0 only
//     let("name", x)          x itself; the name a paper gives it, for number types that print; a third argument
//                             is a remark to stand beside it; "title\n" or "title\nremark" gives a step of the
//                             model its title, for which no comment is needed
//     result_of("f", x, a, b) x itself, which a function f made of a and b; number types that print write a call of f
//     ratio<T, 1, 7>()        the constant 1/7, correctly rounded in every T
//     T(1)                    an integer as a T, where a literal alone would not have the type; of 24 bits at most
//
// Why integer literals only: 0.5 * x silently turns a float model into a double one, and T(0.04) means a
// different number in every T. An integer and a ratio of integers mean the same in all of them.
//
// Why select and no `if`: a batch takes both sides at once, and an interval may straddle the comparison.
// Because both sides are evaluated, a model first makes the *argument* of a dangerous operation safe and
// then selects the result:
//
//     sqrt(select(x < 0, T(1), x))   and afterwards   select(x < 0, limit, result)
//
// and not sqrt(max(x, 0)), whose derivative at a clamped x is 0 / 0.
//
// To add a number type: put it in a namespace of its own, give it implicit construction from int and from nothing else
// (template <class U> number(U) = delete; or a double would be cut to an int; no model needs a default constructor), the
// operators, and functions of these names as friends (argument-dependent lookup finds them). A type whose
// comparisons give bool (float, double, a multiprecision number) needs only the arithmetic: select, min,
// max and let below already serve it. Specialise std::numeric_limits for it as well: conductor_precise asks for its
// digits. A type with fused multiply-adds may have product_error(x, y, x * y), the rounding error of a product, which is
// otherwise computed, to the same bits but where it is below the smallest number. tests/own_number_test.cpp is such a type in fifty lines.

#include <cmath>
#include <type_traits>

namespace fresnel {

using std::abs;
using std::exp2;
using std::log;
using std::log2;
using std::pow;
using std::sqrt;

/// `yes` where the mask holds, otherwise `no`.
template <class T>
constexpr T select(bool mask, T yes, T no) {
    return mask ? yes : no;
}

/// The smaller of the two; a NaN in `a` stays.
template <class T>
constexpr T min(T a, std::type_identity_t<T> b) {
    return select(b < a, b, a);
}

/// The larger of the two; a NaN in `a` stays.
template <class T>
constexpr T max(T a, std::type_identity_t<T> b) {
    return select(a < b, b, a);
}

/// Gives a quantity the name it has in the literature, and says what it is: the identity for numbers.
template <class T>
constexpr T let(const char* /*name*/, T value, const char* /*remark*/ = nullptr) {
    return value;
}

/// Says that a value is what the function of that name makes of the arguments: the identity for numbers.
template <class R, class... Arguments>
constexpr R result_of(const char* /*function*/, R value, const Arguments&... /*arguments*/) {
    return value;
}

/// The constant numerator / denominator. Both fit 24 bits, so that every type rounds it once.
template <class T, int numerator, int denominator>
constexpr T ratio() {
    static_assert(-(1 << 24) < numerator && numerator < (1 << 24), "numerator must fit 24 bits");
    static_assert(0 < denominator && denominator < (1 << 24), "denominator must be positive and fit 24 bits");
    return T(numerator) / T(denominator);
}

/// x limited to [0, 1].
template <class T>
constexpr T saturate(T x) {
    return min(max(x, T(0)), T(1));
}

template <class T>
constexpr T square(T x) {
    return x * x;
}

/// a where t is 0, b where t is 1; exact at a.
template <class T>
constexpr T mix(T a, T b, T t) {
    return a + (b - a) * t;
}

/// 2^-80, which in double changes no number above 2e-8 that it is added to, and gives 0 a root with a finite derivative.
template <class T>
T tiny() {
    return square(square(ratio<T, 1, 1 << 20>()));
}

/// x^5 in three multiplications.
template <class T>
constexpr T pow5(T x) {
    const T x2 = x * x;
    return x2 * x2 * x;
}

} // namespace fresnel
