#pragma once

// The number that keeps models honest: it does what number.hpp promises to a model and nothing more.
//
// A model that compiles with `strict` uses integers only, asks no comparison for a bool and calls no function
// of the standard library by its full name, so that every other number type can run it too. What it refuses,
// and the compiler's words for it, is tested pattern by pattern in tests/compile_fail.

#include <fresnel/number.hpp>

#include <limits>

namespace fresnel::only {

class number;

/// The result of a comparison. It has no conversion to bool: select(mask, a, b) takes the place of `if`, `?:`
/// and std::max.
class mask {
public:
    explicit constexpr mask(bool holds) : holds_(holds) {}

private:
    bool holds_;
    friend constexpr number select(mask m, number yes, number no);
    friend void select(mask m, int yes, int no) = delete;
};

/// A double behind the vocabulary of number.hpp, made from an int or from ratio<T, a, b>().
class number {
public:
    constexpr number(int integer) : value_(integer) {}
    template <class T>
    constexpr number(T) = delete; // integers and ratio<T, numerator, denominator>() only

    /// A measured value on its way in: for tests and callers, never for a model.
    static constexpr number from(double value) {
        number x(0);
        x.value_ = value;
        return x;
    }
    constexpr double value() const { return value_; }

    friend constexpr number operator-(number x) { return from(-x.value_); }
    friend constexpr number operator+(number x, number y) { return from(x.value_ + y.value_); }
    friend constexpr number operator-(number x, number y) { return from(x.value_ - y.value_); }
    friend constexpr number operator*(number x, number y) { return from(x.value_ * y.value_); }
    friend constexpr number operator/(number x, number y) { return from(x.value_ / y.value_); }

    friend constexpr mask operator<(number x, number y) { return mask(x.value_ < y.value_); }
    friend constexpr mask operator<=(number x, number y) { return mask(x.value_ <= y.value_); }
    friend constexpr mask operator>(number x, number y) { return mask(x.value_ > y.value_); }
    friend constexpr mask operator>=(number x, number y) { return mask(x.value_ >= y.value_); }

    friend constexpr number select(mask m, number yes, number no) { return m.holds_ ? yes : no; }
    friend constexpr number min(number x, number y) { return select(y < x, y, x); }
    friend constexpr number max(number x, number y) { return select(x < y, y, x); }

    friend number abs(number x) { return from(std::abs(x.value_)); }
    friend number sqrt(number x) { return from(std::sqrt(x.value_)); }
    friend number exp2(number x) { return from(std::exp2(x.value_)); }
    friend number log2(number x) { return from(std::log2(x.value_)); }
    friend number log(number x) { return from(std::log(x.value_)); }
    friend number pow(number x, number y) { return from(std::pow(x.value_, y.value_)); }

    // with an integer, float and double take another function than a number type's: write T(0), T(5)
    friend number select(mask m, number yes, int no) = delete;
    friend number select(mask m, int yes, number no) = delete;
    friend number min(number x, int y) = delete;
    friend number min(int x, number y) = delete;
    friend number max(number x, int y) = delete;
    friend number max(int x, number y) = delete;
    friend number pow(number x, int y) = delete;
    friend number pow(int x, number y) = delete;

private:
    double value_;
};

} // namespace fresnel::only

namespace fresnel {
using strict = only::number;
}

template <>
struct std::numeric_limits<fresnel::strict> : std::numeric_limits<double> {};
