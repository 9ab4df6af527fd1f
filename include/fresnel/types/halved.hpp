#pragma once

// A model in two halves, so that two sets of values can be at different steps of it: halved<V, Cut, second> is a V that
// evaluates what stands before a cut, or what stands behind it.
//
// An exact model is a chain of steps that wait for each other, and a processor looks only some hundred operations ahead:
// with few registers, taking the chain for several batches side by side (`wide`) still leaves the divider idle in places.
// A loop that takes the first half for the next values beside the second half for these has a root under way while the
// rest is computed. Both halves are the whole model, instantiated: the first keeps the quantities that the cut names, where
// `let` gives them their names; the second takes them from there, and the compiler leaves out what only led to them. The
// bits are those of V.

#include <fresnel/twofold.hpp>
#include <fresnel/types/simd.hpp>

#include <cstring>
#include <limits>

namespace fresnel {
inline namespace FRESNEL_ISA_NAMESPACE {

/// Where a model is cut: the quantities that its second half takes over, each the only one of its name. None: nowhere.
struct cut {
    int size = 0;
    const char* names[4] = {};
};

/// Their values. Copied one by one, because g++ copies a large struct through integer registers.
template <class V, int n>
struct kept_values {
    V value[n];

    kept_values() = default;
    FRESNEL_INLINE kept_values(const kept_values& other) { *this = other; }
    FRESNEL_INLINE kept_values& operator=(const kept_values& other) {
        each_of<n>([&](int i) FRESNEL_INLINE_LAMBDA { value[i] = other.value[i]; });
        return *this;
    }
};

template <class V, class Cut>
using kept_of = kept_values<V, Cut::place.size>;

/// V behind the vocabulary of number.hpp, in one half of a model that is cut at Cut::place. Every number that is made of the
/// model's arguments knows where their kept values are.
template <class V, class Cut, bool second>
class halved {
public:
    using mask = typename V::mask;
    using kept = kept_of<V, Cut>;

    halved() = default;
    FRESNEL_INLINE halved(const halved& other)
        : halved(other.value_, other.kept_) {} // part by part, as above
    FRESNEL_INLINE halved& operator=(const halved& other) {
        value_ = other.value_;
        kept_ = other.kept_;
        return *this;
    }
    FRESNEL_INLINE halved(int integer) : value_(integer), kept_(nullptr) {}
    template <class U>
    halved(U) = delete; // a float would be cut to an int
    /// An argument of the model.
    FRESNEL_INLINE halved(const V& value, kept& place) : halved(value, &place) {}
    FRESNEL_INLINE const V& value() const { return value_; }

    // clang-format off
    friend FRESNEL_INLINE halved operator-(const halved& x) { return {-x.value_, x.kept_}; }
    friend FRESNEL_INLINE halved operator+(const halved& x, const halved& y) { return {x.value_ + y.value_, either(x, y)}; }
    friend FRESNEL_INLINE halved operator-(const halved& x, const halved& y) { return {x.value_ - y.value_, either(x, y)}; }
    friend FRESNEL_INLINE halved operator*(const halved& x, const halved& y) { return {x.value_ * y.value_, either(x, y)}; }
    friend FRESNEL_INLINE halved operator/(const halved& x, const halved& y) { return {x.value_ / y.value_, either(x, y)}; }
    friend FRESNEL_INLINE halved min(const halved& x, const halved& y) { return {min(x.value_, y.value_), either(x, y)}; }
    friend FRESNEL_INLINE halved max(const halved& x, const halved& y) { return {max(x.value_, y.value_), either(x, y)}; }
    friend FRESNEL_INLINE halved abs(const halved& x) { return {abs(x.value_), x.kept_}; }
    friend FRESNEL_INLINE halved sqrt(const halved& x) { return {sqrt(x.value_), x.kept_}; }
    friend FRESNEL_INLINE mask operator<(const halved& x, const halved& y) { return x.value_ < y.value_; }
    friend FRESNEL_INLINE mask operator<=(const halved& x, const halved& y) { return x.value_ <= y.value_; }
    friend FRESNEL_INLINE mask operator>(const halved& x, const halved& y) { return x.value_ > y.value_; }
    friend FRESNEL_INLINE mask operator>=(const halved& x, const halved& y) { return x.value_ >= y.value_; }
    friend FRESNEL_INLINE halved select(const mask& m, const halved& yes, const halved& no) { return {select(m, yes.value_, no.value_), either(yes, no)}; }
    // clang-format on

    friend FRESNEL_INLINE halved let(const char* name, halved x, const char* /*remark*/ = nullptr) {
        each_of<Cut::place.size>([&](int i) FRESNEL_INLINE_LAMBDA {
            if (std::strcmp(name, Cut::place.names[i]) != 0) return;
            V& place = x.kept_->value[i];
            if constexpr (second)
                x.value_ = place;
            else
                place = x.value_;
        });
        return x;
    }

private:
    FRESNEL_INLINE halved(const V& value, kept* place) : value_(value), kept_(place) {}
    /// A constant has none.
    static FRESNEL_INLINE kept* either(const halved& x, const halved& y) {
        return x.kept_ ? x.kept_ : y.kept_;
    }

    V value_;
    kept* kept_;
};

/// Of a number in twice the digits, its high part is kept.
template <class V, class Cut, bool second>
FRESNEL_INLINE twofold<halved<V, Cut, second>> let(const char* name, twofold<halved<V, Cut, second>> x,
                                                   const char* /*remark*/ = nullptr) {
    x.hi = let(name, x.hi);
    return x;
}

} // namespace FRESNEL_ISA_NAMESPACE
} // namespace fresnel

/// A half has the properties of its number.
template <class V, class Cut, bool second>
struct std::numeric_limits<fresnel::halved<V, Cut, second>> : std::numeric_limits<V> {};
