#pragma once

// The tolerances of the tests, each with the reason for its size, and the comparison that reports a miss.

#include <fresnel/number.hpp>

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>

namespace fresnel::tolerance {

/// Two ways to the same number in one arithmetic: a few roundings apart. In units of the last place.
inline constexpr double identity = 8;

/// float64 against 50 digits, relative: room for the condition of a formula, not for a wrong one.
inline constexpr double reference = 1e-12;

/// A published formula against our model, both at 60 digits, relative.
inline constexpr double printed_form = 1e-40;

} // namespace fresnel::tolerance

namespace fresnel::test {

/// `x` with every digit that T has.
template <class T>
std::string digits(const T& x) {
    if constexpr (std::is_floating_point_v<T>) {
        char text[40];
        std::snprintf(text, sizeof text, "%.*g", std::numeric_limits<T>::max_digits10,
                      static_cast<double>(x));
        return text;
    } else {
        return x.str(50, std::ios_base::scientific);
    }
}

/// |actual - expected| <= allowed; the message shows the input, both numbers and their distance. A NaN fails.
template <class T>
testing::AssertionResult within(T actual, std::type_identity_t<T> expected, std::type_identity_t<T> allowed,
                                const std::string& input) {
    using std::abs;
    const T miss = abs(actual - expected);
    if (miss <= allowed) return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "input    " << input << "\nexpected " << digits(expected) << "\nactual   " << digits(actual)
           << "\nmiss     " << digits(miss) << "\nallowed  " << digits(allowed);
}

/// Relative form of `within`.
template <class T>
testing::AssertionResult within_relative(T actual, std::type_identity_t<T> expected, double relative,
                                         const std::string& input) {
    using std::abs;
    return within(actual, expected, T(relative) * abs(expected), input);
}

/// Equal to a few units in the last place of the larger of the two and `scale`.
template <class T>
testing::AssertionResult same(T actual, std::type_identity_t<T> expected, const std::string& input,
                              std::type_identity_t<T> scale = 0) {
    const T size = std::max({std::abs(actual), std::abs(expected), scale});
    const T unit = size * std::numeric_limits<T>::epsilon();
    return within(actual, expected, T(tolerance::identity) * unit, input);
}

/// Equal bit for bit, the sign of zero included.
template <class T>
testing::AssertionResult exactly(T actual, std::type_identity_t<T> expected, const std::string& input) {
    if (actual == expected && std::signbit(actual) == std::signbit(expected))
        return testing::AssertionSuccess();
    return testing::AssertionFailure()
           << "input    " << input << "\nexpected " << digits(expected) << "\nactual   " << digits(actual);
}

} // namespace fresnel::test
