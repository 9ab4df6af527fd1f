#pragma once

// A float32 computation beside the real one: each model, run on this type, bounds its own rounding error.
//
//     const rounding R = schlick(rounding(0, 1), rounding(0, 0.5));
//     R.error          the float model is certainly that near to the real one, for every float f0 and cos_i in there
//
// `real` and `machine` hold the two results, `error` bounds their distance for the same arguments: what the operands
// bring, by the mean value theorem and so without neglected terms, and half a unit of the last place more. A
// difference of floats within a factor of two adds nothing (Sterbenz 1974, "Floating-Point Computation"), a factor that
// is a power of two half the least subnormal. Rounding to nearest, no contraction, no overflow.
//
// The two computations must take the same way: a comparison that only one of them might pass throws undecided, and so
// does a root, logarithm or power of what float may have below 0. min, max and abs need no such answer.

#include <fresnel/number.hpp>
#include <fresnel/types/interval.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace fresnel {

/// See the top of this file.
struct rounding {
    struct undecided : std::runtime_error {
        undecided()
            : runtime_error("rounding: float and real results may lie on two sides of a comparison or of 0") {
        }
    };

    interval real, machine;
    double error = 0;

    rounding() = default;
    rounding(int integer)
        : real(integer), machine(nearest(integer)), error(std::abs(integer - nearest(integer))) {}
    template <class U>
    rounding(U) = delete; // a double would be cut to an int; rounding(x, x) takes a float
    /// Every float from lo to hi, itself without error.
    rounding(double lo, double hi) : real(interval::between(lo, hi)), machine(real) {}

    friend rounding operator-(const rounding& x) { return {-x.real, -x.machine, x.error}; }
    friend rounding operator+(const rounding& x, const rounding& y) {
        return rounded(x.real + y.real, x.machine + y.machine, x.error + y.error,
                       zero(x) || zero(y) || close(x.machine, -y.machine));
    }
    friend rounding operator-(const rounding& x, const rounding& y) { return x + -y; }
    friend rounding operator*(const rounding& x, const rounding& y) {
        const double brought = times(y.error, x.machine.magnitude()) + times(x.error, y.real.magnitude());
        const bool scaled = power_of_two(x) || power_of_two(y);
        return rounded(x.real * y.real, x.machine * y.machine, brought + (scaled ? subnormal : 0), scaled);
    }
    friend rounding operator/(const rounding& x, const rounding& y) {
        const interval quotient = x.real / y.real;
        const double brought = (x.error + times(y.error, quotient.magnitude())) / y.machine.mignitude();
        const bool scaled = power_of_two(y);
        return rounded(quotient, x.machine / y.machine, brought + (scaled ? subnormal : 0), scaled);
    }

    friend bool operator<(const rounding& x, const rounding& y) {
        const interval a = hull(x.real, x.machine), b = hull(y.real, y.machine);
        if (a.hi >= b.lo && a.lo < b.hi) throw undecided();
        return a.hi < b.lo;
    }
    friend bool operator>(const rounding& x, const rounding& y) { return y < x; }
    friend bool operator<=(const rounding& x, const rounding& y) { return !(y < x); }
    friend bool operator>=(const rounding& x, const rounding& y) { return !(x < y); }

    friend rounding max(const rounding& x, const rounding& y) {
        const interval a = hull(x.real, x.machine), b = hull(y.real, y.machine);
        if (a.hi <= b.lo || b.hi <= a.lo) return a.hi <= b.lo ? y : x;
        return {max(x.real, y.real), max(x.machine, y.machine), std::max(x.error, y.error)};
    }
    friend rounding min(const rounding& x, const rounding& y) { return -max(-x, -y); }
    friend rounding abs(const rounding& x) { return max(x, -x); }

    friend rounding sqrt(const rounding& x) {
        require_not_negative(x);
        const interval of_real = sqrt(x.real), of_machine = sqrt(x.machine);
        return rounded(of_real, of_machine, x.error / (of_real.lo + of_machine.lo));
    }
    friend rounding exp2(const rounding& x) {
        const interval both = exp2(hull(x.real, x.machine));
        return from_library(exp2(x.real), exp2(x.machine), times(x.error, both.hi * 0.6931471806));
    }
    friend rounding log(const rounding& x) {
        require_not_negative(x);
        return from_library(log(x.real), log(x.machine), x.error / hull(x.real, x.machine).lo);
    }
    friend rounding log2(const rounding& x) {
        require_not_negative(x);
        return from_library(log2(x.real), log2(x.machine),
                            1.4426950409 * x.error / hull(x.real, x.machine).lo);
    }
    friend rounding pow(const rounding& x, const rounding& y) {
        require_not_negative(x);
        const interval a = hull(x.real, x.machine), b = hull(y.real, y.machine);
        const interval by_x = b * pow(a, b - interval(1)), by_y = pow(a, b) * log(a);
        return from_library(pow(x.real, y.real), pow(x.machine, y.machine),
                            times(x.error, by_x.magnitude()) + times(y.error, by_y.magnitude()));
    }

private:
    rounding(interval r, interval m, double e) : real(r), machine(m), error(e) {}

    static constexpr double subnormal = 0x1p-150; // half the least

    static void require_not_negative(const rounding& x) {
        if (x.machine.lo < 0) throw undecided();
    }
    static bool zero(const rounding& x) { return x.machine == interval(0); }
    static bool power_of_two(const rounding& x) {
        int exponent = 0;
        return x.machine.lo == x.machine.hi && std::abs(std::frexp(x.machine.lo, &exponent)) == 0.5;
    }
    // Sterbenz: x - y is a float.
    static bool close(const interval& x, const interval& y) {
        return x.lo > 0 ? x.hi <= 2 * y.lo && y.hi <= 2 * x.lo
                        : x.hi < 0 && x.lo >= 2 * y.hi && y.lo >= 2 * x.hi;
    }
    static double times(double error, double slope) { return error == 0 ? 0 : error * slope; }

    // Through memory: g++ 12 drops double to float to double where it makes vectors of a pair of them.
    static double nearest(double x) {
        const volatile float narrow = static_cast<float>(x);
        return static_cast<double>(narrow) + 0.0; // never -0
    }
    // Of anything whose size rounds to at most x >= 0, a float.
    static double half_unit(double x) {
        if (x == 0) return subnormal;
        int exponent = 0;
        const bool power = std::frexp(x, &exponent) == 0.5;
        return std::max(std::ldexp(1, exponent - (power ? 26 : 25)), subnormal);
    }
    // The result of one operation: `propagated` from its operands, and its own rounding.
    static rounding rounded(const interval& real, const interval& before, double propagated,
                            bool exact = false) {
        const interval machine = interval::between(nearest(before.lo), nearest(before.hi));
        const double most = machine.magnitude();
        const double own = std::max(half_unit(most), before.magnitude() - most);
        return within(real, machine, propagated + (exact ? 0 : own));
    }
    // The library's functions are taken to be within two units of the last place.
    static rounding from_library(const interval& real, const interval& before, double propagated) {
        const double own = 4 * half_unit(2 * before.magnitude());
        return within(real, before + interval::between(-own, own), propagated + own);
    }
    // The two results are also no further apart than their intervals, should the error be larger, or 0 / 0.
    static rounding within(const interval& real, const interval& machine, double error) {
        const double apart = std::max(machine.hi - real.lo, real.hi - machine.lo);
        const double least = error < apart ? error : apart;
        return {real, machine, least * (1 + 0x1p-40)}; // it is of a few sums and products of positive doubles
    }
};

} // namespace fresnel

template <>
struct std::numeric_limits<fresnel::rounding> : std::numeric_limits<float> {};
