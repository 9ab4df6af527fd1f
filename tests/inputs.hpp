#pragma once

// Inputs of the numeric tests: the same on every machine, in classes by what makes a formula lose digits.

#include "tolerances.hpp"

#include <array>
#include <cmath>
#include <cstdint>
#include <string>
#include <string_view>

namespace fresnel::test {

#if defined(__SANITIZE_ADDRESS__)
#define FRESNEL_SANITIZED
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define FRESNEL_SANITIZED
#endif
#endif

#ifdef FRESNEL_SANITIZED
inline constexpr int thinning = 25; // sanitized code is slow: fewer points, never fewer classes
#else
inline constexpr int thinning = 1;
#endif

/// Points in a class of transparent media (six such) and of absorbing ones: over 100,000 for every model.
inline constexpr int transparent_points = 17000 / thinning, absorbing_points = 8000 / thinning;

/// Uniform numbers from a fixed seed (SplitMix64: Steele, Lea and Flood 2014). The distributions of <random>
/// differ between standard libraries.
class random_numbers {
public:
    explicit random_numbers(std::uint64_t seed) : state_(seed) {}

    double uniform(double low, double high) {
        return low + (high - low) * (static_cast<double>(next() >> 11) * 0x1p-53);
    }
    double log_uniform(double low, double high) { return std::exp(uniform(std::log(low), std::log(high))); }
    /// Uniform in its logarithm, of either sign.
    double signed_log_uniform(double low, double high) {
        const double size = log_uniform(low, high);
        return one_in(2) ? size : -size;
    }
    bool one_in(unsigned n) { return next() % n == 0; }

private:
    std::uint64_t next() {
        std::uint64_t z = state_ += 0x9e3779b97f4a7c15;
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
        z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
        return z ^ (z >> 31);
    }
    std::uint64_t state_;
};

/// The arguments of an exact model.
template <class T>
struct incidence {
    T n_i, n_t, k_t, cos_i;

    std::string text() const {
        return "n_i " + digits(n_i) + ", n_t " + digits(n_t) + ", k_t " + digits(k_t) + ", cos_i " +
               digits(cos_i);
    }
};

/// A class of incidences: `draw` gives the next one, in double; `in` rounds it to the type under test.
struct input_class {
    std::string_view name;
    bool transparent; // k_t = 0 throughout
    incidence<double> (*draw)(random_numbers&);
};

inline double ambient(random_numbers& random) { return random.one_in(2) ? 1 : random.uniform(0.5, 3); }

inline double any_cosine(random_numbers& random) {
    if (random.one_in(40)) return 1;
    return random.one_in(4) ? random.log_uniform(1e-7, 1) : random.uniform(1e-7, 1);
}

/// An incidence by its relative index eta + i eta_k. An aggregate, because the order in which the members of a
/// braced list draw their numbers is the same in every compiler, and that of function arguments is not.
struct relative {
    double n_i, eta, eta_k, cos_i;
    operator incidence<double>() const { return {n_i, n_i * eta, n_i * eta_k, cos_i}; }
};

/// A relative index clear of an index match, from the outside or, one time in `inside`, from the inside.
inline double clear_index(random_numbers& random, unsigned inside) {
    return random.one_in(inside) ? random.log_uniform(0.1, 0.95) : random.log_uniform(1.05, 10);
}

/// Every way in which the digits of Fresnel's equations are known to get lost.
inline constexpr std::array input_classes = {
    input_class{"external dielectric", true,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), r.log_uniform(1.05, 10), 0, any_cosine(r)};
                }},
    input_class{"internal dielectric", true,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), r.log_uniform(0.1, 0.95), 0, any_cosine(r)};
                }},
    input_class{"index match", true,
                [](random_numbers& r) -> incidence<double> {
                    const double gap = r.one_in(8) ? 0 : r.signed_log_uniform(1e-9, 0.05);
                    return relative{ambient(r), 1 + gap, 0, any_cosine(r)};
                }},
    input_class{"near TIR", true,
                [](random_numbers& r) -> incidence<double> {
                    const double eta = r.log_uniform(0.1, 0.95);
                    const double angle = std::asin(eta) + r.signed_log_uniform(1e-7, 1e-2);
                    return relative{ambient(r), eta, 0, std::cos(angle)};
                }},
    input_class{"grazing", true,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), clear_index(r, 2), 0, r.log_uniform(1e-7, 1e-2)};
                }},
    input_class{"Brewster", true,
                [](random_numbers& r) -> incidence<double> {
                    const double eta = clear_index(r, 4);
                    const double shift = 1 + r.signed_log_uniform(1e-8, 1e-2);
                    return relative{ambient(r), eta, 0, std::fmin(1, shift / std::sqrt(1 + eta * eta))};
                }},
    input_class{"metals", false,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), r.uniform(0.05, 5), r.uniform(1, 10), any_cosine(r)};
                }},
    input_class{"weak k", false,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), r.log_uniform(1.05, 10), r.log_uniform(1e-6, 0.1),
                                    any_cosine(r)};
                }},
    input_class{"weak k, internal", false,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), r.log_uniform(0.1, 0.95), r.log_uniform(1e-6, 0.1),
                                    any_cosine(r)};
                }},
    input_class{"n << k", false,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), r.log_uniform(0.001, 0.1), r.uniform(0.5, 100),
                                    any_cosine(r)};
                }},
    input_class{"n = k < 1", false,
                [](random_numbers& r) -> incidence<double> {
                    const double n = r.log_uniform(0.1, 1);
                    return relative{ambient(r), n, n * r.uniform(0.8, 1.25), any_cosine(r)};
                }},
    input_class{"index match, weak k", false,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), 1 + r.signed_log_uniform(1e-6, 0.05),
                                    r.log_uniform(1e-6, 0.05), any_cosine(r)};
                }},
    input_class{"huge n, k", false,
                [](random_numbers& r) -> incidence<double> {
                    return relative{ambient(r), r.log_uniform(10, 300), r.log_uniform(10, 3000),
                                    any_cosine(r)};
                }},
};

/// The incidence rounded to the type under test. Transparent media that round to one index are set one unit
/// in the last place apart.
template <class T>
incidence<T> in(const incidence<double>& x) {
    const T n_i = static_cast<T>(x.n_i), n_t = static_cast<T>(x.n_t);
    const bool merged = n_i == n_t && x.k_t == 0;
    return {n_i, merged ? std::nextafter(n_t, static_cast<T>(x.cos_i < 0.5 ? 0 : 1000)) : n_t,
            static_cast<T>(x.k_t), static_cast<T>(x.cos_i)};
}

} // namespace fresnel::test
