#pragma once

// A value with its derivatives: each model, run on duals, differentiates itself exactly, to rounding.
//
//     using d = dual<double, 2>;
//     const d R = schlick(d::variable(0.04, 0), d::variable(0.5, 1));
//     R.value, R.d[0] (by f0), R.d[1] (by cos_i)
//
// The rules hold on both sides of a select, because both are evaluated: where a model guards the argument of a
// root or a quotient, the guarded side is a constant, its derivative 0, and no 0 / 0 arises on the other.
//
// Infinite derivatives that are true, and where: the square root at a critical angle; sqrt f0 at f0 = 0 in
// inner_eta_from_f0, in immersed and in what is made of them, NaN where two of them meet; x^power at x = 0 for a power below 1. At a kink (a clamp, max) the derivative
// is that of the side that is returned, but where rounding alone may have taken a value past a constant other than 0, as
// at cos_i = 0, that of the value. So where a clamp begins just there (f82 = 1 at cos_i = 0) it is the slope without the
// clamp, be it infinite. Where a
// value has lost its digits its derivative has too: of the fast exact models near an index match and, by a k_t below
// 1e-8, beyond the critical angle; of gulbrandsen at r = 0 in float. Between equal media at cos_i = 0 R jumps, and
// conductor_precise gives NaN; schlick_internal, whose slope there is -5, gives 0.

#include <fresnel/number.hpp>

#include <array>
#include <limits>
#include <type_traits>

namespace fresnel {

/// A number of type T and its derivatives by N variables.
template <class T, int N>
struct dual {
    T value{};
    std::array<T, N> d{};

    dual() = default;
    constexpr dual(int integer) : value(T(integer)) { d.fill(T(0)); }
    template <class U>
    dual(U) = delete; // a double would be cut to an int; `constant` and `variable` take a T

    /// A value that depends on no variable.
    static dual constant(T value) {
        dual x(0);
        x.value = value;
        return x;
    }
    /// The variable of that index, [0, N).
    static dual variable(T value, int index) {
        dual x = constant(value);
        x.d[static_cast<std::size_t>(index)] = T(1);
        return x;
    }

    friend dual operator-(const dual& x) { return chain(-x.value, x, T(-1)); }
    friend dual operator+(const dual& x, const dual& y) { return chain(x.value + y.value, x, T(1), y, T(1)); }
    friend dual operator-(const dual& x, const dual& y) {
        return chain(x.value - y.value, x, T(1), y, T(-1));
    }
    friend dual operator*(const dual& x, const dual& y) {
        dual product = chain(x.value * y.value, x, y.value, y, x.value);
        if constexpr (std::is_floating_point_v<T>)
            if (product.value == 0)
                for (std::size_t i = 0; i < N; ++i)
                    if ((x.value == 0 && x.d[i] == 0) || (y.value == 0 && y.d[i] == 0))
                        product.d[i] = 0; // 0 times an infinite slope
        return product;
    }
    friend dual operator/(const dual& x, const dual& y) {
        const T quotient = x.value / y.value;
        dual result = constant(quotient);
        for (std::size_t i = 0; i < N; ++i)
            result.d[i] = (x.d[i] - product(y.d[i], quotient)) / y.value;
        if constexpr (std::is_floating_point_v<T>)
            if (quotient == 0)
                for (std::size_t i = 0; i < N; ++i)
                    if (x.d[i] == 0) result.d[i] = 0; // 0 over an infinite slope
        return result;
    }

    friend auto operator<(const dual& x, const dual& y) { return x.value < y.value; }
    friend auto operator<=(const dual& x, const dual& y) { return x.value <= y.value; }
    friend auto operator>(const dual& x, const dual& y) { return x.value > y.value; }
    friend auto operator>=(const dual& x, const dual& y) { return x.value >= y.value; }

    friend dual select(const decltype(T(0) < T(0))& mask, const dual& yes, const dual& no) {
        dual result = constant(select_component(mask, yes.value, no.value));
        for (std::size_t i = 0; i < N; ++i)
            result.d[i] = select_component(mask, yes.d[i], no.d[i]);
        return result;
    }
    friend dual min(const dual& x, const dual& y) { return -max(-x, -y); }
    friend dual max(const dual& x, const dual& y) {
        // of intervals that overlap, the slope is one of the two
        if constexpr (!std::is_arithmetic_v<T> && requires { overlap(x.value, y.value); })
            if (overlap(x.value, y.value)) {
                dual result = constant(max(x.value, y.value));
                for (std::size_t i = 0; i < N; ++i)
                    result.d[i] = hull(x.d[i], y.d[i]);
                return result;
            }
        dual result = select(x < y, y, x);
        if constexpr (std::is_floating_point_v<T>)
            if (is_constant(x) != is_constant(y) && differ_by_rounding(x.value, y.value))
                result.d = is_constant(x) ? y.d : x.d;
        return result;
    }
    /// At 0 the slope of -x, as models choose between sides by <= 0.
    friend dual abs(const dual& x) { return select(x <= dual(0), -x, x); }

    friend dual sqrt(const dual& x) {
        using fresnel::sqrt;
        const T root = sqrt(x.value);
        dual result = constant(root);
        for (std::size_t i = 0; i < N; ++i) // a constant stays one, also at 0
            result.d[i] = x.d[i] == T(0) ? T(0) : x.d[i] / (2 * root);
        return result;
    }
    friend dual exp2(const dual& x) {
        using fresnel::exp2;
        using fresnel::log;
        const T power = exp2(x.value);
        return chain(power, x, power * log(T(2)));
    }
    friend dual log(const dual& x) {
        using fresnel::log;
        return chain(log(x.value), x, 1 / x.value);
    }
    friend dual log2(const dual& x) {
        using fresnel::log;
        using fresnel::log2;
        return chain(log2(x.value), x, 1 / (x.value * log(T(2))));
    }
    /// x >= 0; at x = 0 the derivative by y is 0, the limit for y > 0.
    friend dual pow(const dual& x, const dual& y) {
        using fresnel::log;
        using fresnel::pow;
        const T power = pow(x.value, y.value);
        const bool zero = x.value == T(0);
        const T dx = is_constant(x) || y.value == T(0) ? T(0) : y.value * pow(x.value, y.value - 1);
        const T dy = zero || is_constant(y) ? T(0) : power * log(x.value);
        return chain(power, x, dx, y, dy);
    }

private:
    static T select_component(const decltype(T(0) < T(0))& mask, const T& yes, const T& no) {
        using fresnel::select;
        return select(mask, yes, no);
    }
    static bool is_constant(const dual& x) {
        for (std::size_t i = 0; i < N; ++i)
            if (!(x.d[i] == T(0))) return false;
        return true;
    }
    static bool differ_by_rounding(const T& x, const T& y) {
        const T distance = x < y ? y - x : x - y;
        return distance <= 32 * std::numeric_limits<T>::epsilon() * (x < T(0) ? -x : x);
    }
    // The chain rule; a derivative of 0 stays 0 whatever its factor.
    static T product(const T& derivative, const T& factor) {
        return derivative == T(0) ? T(0) : derivative * factor;
    }
    static dual chain(T value, const dual& x, T dx) {
        dual result = constant(value);
        for (std::size_t i = 0; i < N; ++i)
            result.d[i] = product(x.d[i], dx);
        return result;
    }
    static dual chain(T value, const dual& x, T dx, const dual& y, T dy) {
        dual result = constant(value);
        for (std::size_t i = 0; i < N; ++i)
            result.d[i] = product(x.d[i], dx) + product(y.d[i], dy);
        return result;
    }
};

} // namespace fresnel

template <class T, int N>
struct std::numeric_limits<fresnel::dual<T, N>> : std::numeric_limits<T> {};
