#pragma once

// An interval that certainly holds the real result: each model, run on intervals, proves bounds.
//
// Every operation is rounded outwards. A comparison of two overlapping intervals has no answer; `enclose` then runs
// the model once for each possible answer and returns the hull. Within one run the same comparison always has the
// same answer, so that a model's select of an argument and of the result stay together, and a critical angle inside
// the interval costs two runs instead of the whole range of the root. Two comparisons are the same if both compare the same
// quantities: an interval, its copies, and whatever equals a single number.
//
//     const interval R = enclose([&] { return schlick(interval(0.04), interval::between(0, 0.1)); });
//
// Plain intervals forget that two terms share a variable; `dual<interval, N>` gives slopes, with which a mean value
// form is narrow on small boxes (src/analysis/prove.cpp).

#include <fresnel/number.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <vector>

namespace fresnel {

namespace interval_rounding {

constexpr double infinity = std::numeric_limits<double>::infinity();

// Rump, Zimmermann, Boldo and Melquiond 2009, "Computing predecessor and successor in rounding to nearest": the
// neighbour in double or the one beyond it.
inline double step(double x) {
    constexpr double unit = 0x1p-53 * (1 + 0x1p-52);
    return std::abs(x) * unit + std::numeric_limits<double>::denorm_min();
}
inline double down(double x) {
    if (x == infinity) return std::numeric_limits<double>::max();
    return x == -infinity ? x : x - step(x);
}
inline double up(double x) { return -down(-x); }

/// A number that no other quantity has, on any thread.
inline std::uint64_t new_quantity() {
    static std::atomic<std::uint64_t> threads = 0;
    static thread_local std::uint64_t last = threads.fetch_add(std::uint64_t{1} << 40);
    return ++last;
}

/// What is compared with what: quantities, and their bounds.
struct comparison {
    std::uint64_t a, b;
    double a_lo, a_hi, b_lo, b_hi;
    bool operator==(const comparison&) const = default;
};

/// The answers given to undecided comparisons during one run, and which of them are still to be tried.
struct explorer {
    struct answer {
        comparison of;
        bool value, both_tried;
    };
    std::vector<answer> answers;
    std::size_t used = 0;

    static explorer*& current() {
        static thread_local explorer* active = nullptr;
        return active;
    }

    bool decide(const comparison& this_one) {
        for (std::size_t i = 0; i < used; ++i)
            if (answers[i].of == this_one) return answers[i].value;
        if (used == answers.size()) {
            if (answers.size() > 24) throw std::runtime_error("interval: too many undecided comparisons");
            answers.push_back({this_one, true, false});
        }
        answers[used].of = this_one; // another run has other quantities
        return answers[used++].value;
    }
    // The next combination of answers; false after the last.
    bool next() {
        while (!answers.empty() && answers.back().both_tried)
            answers.pop_back();
        if (answers.empty()) return false;
        answers.back().value = false, answers.back().both_tried = true;
        used = 0;
        return true;
    }
};

} // namespace interval_rounding

/// The real numbers from lo to hi.
struct interval {
    double lo = 0, hi = 0;

    interval() = default;
    constexpr interval(int integer) : lo(integer), hi(integer) {}
    /// A single number.
    constexpr explicit interval(double value) : lo(value), hi(value) {}
    template <class U>
    interval(U) = delete; // a double would be cut to an int where nobody wrote interval(value)
    static interval between(double lo, double hi) {
        interval x;
        x.lo = lo, x.hi = hi;
        if (lo < hi) x.quantity_ = interval_rounding::new_quantity();
        return x;
    }
    static interval entire() { return between(-interval_rounding::infinity, interval_rounding::infinity); }

    double width() const { return hi - lo; }
    double middle() const { return lo + (hi - lo) / 2; }
    /// The largest |x|, and the smallest.
    double magnitude() const { return std::max(std::abs(lo), std::abs(hi)); }
    double mignitude() const { return lo > 0 ? lo : hi < 0 ? -hi : 0; }
    bool contains(double x) const { return lo <= x && x <= hi; }

    friend bool operator==(const interval& x, const interval& y) {
        return x.lo == x.hi && y.lo == y.hi && x.lo == y.lo;
    }

    friend interval operator-(const interval& x) { return between(-x.hi, -x.lo); }
    friend interval operator+(const interval& x, const interval& y) {
        const double least = x.lo + y.lo, most = x.hi + y.hi;
        return std::isnan(least) || std::isnan(most) ? entire() : rounded(least, most);
    }
    friend interval operator-(const interval& x, const interval& y) { return x + -y; }
    friend interval operator*(const interval& x, const interval& y) {
        const double p[4] = {product(x.lo, y.lo), product(x.lo, y.hi), product(x.hi, y.lo),
                             product(x.hi, y.hi)};
        return rounded(*std::min_element(p, p + 4), *std::max_element(p, p + 4));
    }
    friend interval operator/(const interval& x, const interval& y) {
        if (y.lo <= 0 && y.hi >= 0) return entire();
        const double p[4] = {x.lo / y.lo, x.lo / y.hi, x.hi / y.lo, x.hi / y.hi};
        for (const double q : p)
            if (std::isnan(q)) return entire();
        return rounded(*std::min_element(p, p + 4), *std::max_element(p, p + 4));
    }

    friend bool operator<(const interval& x, const interval& y) {
        if (x.hi < y.lo) return true;
        return x.lo < y.hi && undecided(x, y);
    }
    friend bool operator<=(const interval& x, const interval& y) { return !(y < x); }
    friend bool operator>(const interval& x, const interval& y) { return y < x; }
    friend bool operator>=(const interval& x, const interval& y) { return !(x < y); }

    friend interval min(const interval& x, const interval& y) {
        return between(std::min(x.lo, y.lo), std::min(x.hi, y.hi));
    }
    friend interval max(const interval& x, const interval& y) {
        return between(std::max(x.lo, y.lo), std::max(x.hi, y.hi));
    }
    friend interval abs(const interval& x) { return between(x.mignitude(), x.magnitude()); }

    /// Of the part of x that is not negative; so are log2, log and pow.
    friend interval sqrt(const interval& x) {
        using namespace interval_rounding;
        const double least = std::sqrt(std::max(x.lo, 0.0)), most = std::sqrt(std::max(x.hi, 0.0));
        return between(std::max(down(least), 0.0), up(most));
    }
    // The library's functions are taken to be within two units of the last place.
    friend interval exp2(const interval& x) {
        return between(std::max(twice_down(std::exp2(x.lo)), 0.0), twice_up(std::exp2(x.hi)));
    }
    friend interval log2(const interval& x) {
        return between(twice_down(std::log2(std::max(x.lo, 0.0))), twice_up(std::log2(std::max(x.hi, 0.0))));
    }
    friend interval log(const interval& x) {
        return between(twice_down(std::log(std::max(x.lo, 0.0))), twice_up(std::log(std::max(x.hi, 0.0))));
    }
    friend interval pow(const interval& x, const interval& y) {
        const double a = x.lo > 0 ? x.lo : 0, b = x.hi > 0 ? x.hi : 0; // never -0, whose powers are negative
        const double p[4] = {std::pow(a, y.lo), std::pow(a, y.hi), std::pow(b, y.lo), std::pow(b, y.hi)};
        return between(std::max(twice_down(*std::min_element(p, p + 4)), 0.0),
                       twice_up(*std::max_element(p, p + 4)));
    }

private:
    static interval rounded(double lo, double hi) {
        return between(interval_rounding::down(lo), interval_rounding::up(hi));
    }
    static double product(double x, double y) {
        return x == 0 || y == 0 ? 0 : x * y;
    } // 0 times infinity is 0
    static double twice_down(double x) { return interval_rounding::down(interval_rounding::down(x)); }
    static double twice_up(double x) { return interval_rounding::up(interval_rounding::up(x)); }

    static bool undecided(const interval& x, const interval& y) {
        interval_rounding::explorer* const e = interval_rounding::explorer::current();
        if (e == nullptr) throw std::logic_error("interval: an undecided comparison outside enclose()");
        return e->decide({x.quantity_, y.quantity_, x.lo, x.hi, y.lo, y.hi});
    }

    std::uint64_t quantity_ = 0; ///< what copies share; 0 of a single number
};

inline bool overlap(const interval& x, const interval& y) { return x.lo < y.hi && y.lo < x.hi; }

/// The smallest interval that holds both.
inline interval hull(const interval& x, const interval& y) {
    return interval::between(std::min(x.lo, y.lo), std::max(x.hi, y.hi));
}

/// The part that both hold; x where they have none, which rounding alone can make.
inline interval intersection(const interval& x, const interval& y) {
    const interval both = interval::between(std::max(x.lo, y.lo), std::min(x.hi, y.hi));
    return both.lo <= both.hi ? both : x;
}

/// Runs f for every possible answer of its undecided comparisons and calls use(result) for each.
template <class F, class Use>
void for_each_branch(const F& f, const Use& use) {
    interval_rounding::explorer e;
    interval_rounding::explorer* const outer = interval_rounding::explorer::current();
    interval_rounding::explorer::current() = &e;
    try {
        do {
            e.used = 0;
            use(f());
        } while (e.next());
    } catch (...) {
        interval_rounding::explorer::current() = outer;
        throw;
    }
    interval_rounding::explorer::current() = outer;
}

/// The hull of f over every possible answer of its undecided comparisons.
template <class F>
interval enclose(const F& f) {
    interval result;
    bool first = true;
    for_each_branch(f, [&](const interval& one) {
        result = first ? one : hull(result, one);
        first = false;
    });
    return result;
}

} // namespace fresnel

template <>
struct std::numeric_limits<fresnel::interval> : std::numeric_limits<double> {};
