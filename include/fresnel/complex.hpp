#pragma once

#include <fresnel/number.hpp>

namespace fresnel {

/// A complex number over any number type; std::complex is only specified for float, double and long double.
template <class T>
struct complex {
    T re, im;
};

template <class T>
constexpr complex<T> operator-(complex<T> z) {
    return {-z.re, -z.im};
}

template <class T>
constexpr complex<T> operator+(complex<T> z, complex<T> w) {
    return {z.re + w.re, z.im + w.im};
}

template <class T>
constexpr complex<T> operator-(complex<T> z, complex<T> w) {
    return {z.re - w.re, z.im - w.im};
}

template <class T>
constexpr complex<T> operator*(complex<T> z, complex<T> w) {
    return {z.re * w.re - z.im * w.im, z.re * w.im + z.im * w.re};
}

/// |z|^2
template <class T>
constexpr T norm(complex<T> z) {
    return z.re * z.re + z.im * z.im;
}

template <class T>
constexpr complex<T> operator/(complex<T> z, complex<T> w) {
    const T w2 = norm(w);
    return {(z.re * w.re + z.im * w.im) / w2, (z.im * w.re - z.re * w.im) / w2};
}

} // namespace fresnel
