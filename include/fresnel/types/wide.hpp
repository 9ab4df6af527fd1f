#pragma once

// Several batches computed with side by side: wide<batch<float, 16>, 4> is 64 floats.
//
// A model is one long chain of operations that wait for each other: two square roots and a division in a row keep a
// processor idle while it has room for other work. Side by side, each step of the chain is taken for all batches
// before the next, and the waiting overlaps. The bits are those of the single batch.

#include <fresnel/types/simd.hpp>

#include <limits>

namespace fresnel {
inline namespace FRESNEL_ISA_NAMESPACE {

/// K of the masks of V.
template <class V, int K>
struct wide_mask {
    typename V::mask part[K];

    friend FRESNEL_INLINE wide_mask operator&(wide_mask a, const wide_mask& b) {
        for (int i = 0; i < K; ++i)
            a.part[i] = a.part[i] & b.part[i];
        return a;
    }
    friend FRESNEL_INLINE wide_mask operator|(wide_mask a, const wide_mask& b) {
        for (int i = 0; i < K; ++i)
            a.part[i] = a.part[i] | b.part[i];
        return a;
    }
};

/// Whether V can take roots by the units of multiplications.
template <class V>
concept has_root_by_products = requires(V a) { root_by_products(a); };

/// K of V behind the vocabulary of number.hpp. Passed by reference: a register holds no more than a part. The last
/// `by_products` of them take their roots by the units of multiplications, where V has such roots: a divider is one, and
/// the others idle while everything waits for it.
template <class V, int K, int by_products = 0>
class wide {
public:
    using mask = wide_mask<V, K>;
    static constexpr int size = K * V::size;

    wide() = default;
    // part by part, because g++ copies a large struct through integer registers
    FRESNEL_INLINE wide(const wide& other) { copy(other); }
    FRESNEL_INLINE wide& operator=(const wide& other) {
        copy(other);
        return *this;
    }
    FRESNEL_INLINE wide(int integer) {
        for (V& part : part_)
            part = V(integer);
    }
    template <class U>
    wide(U) = delete; // a float would be cut to an int; `broadcast` takes one

    /// The same value in every lane.
    static FRESNEL_INLINE wide broadcast(float x) {
        wide result;
        for (V& part : result.part_)
            part = V::broadcast(x);
        return result;
    }
    /// K V::size values from memory, of any alignment.
    static FRESNEL_INLINE wide load(const float* from) {
        wide result;
        each_of<K>([&](int i) { result.part_[i] = V::load(from + i * V::size); });
        return result;
    }
    FRESNEL_INLINE void store(float* to) const {
        each_of<K>([&](int i) { part_[i].store(to + i * V::size); });
    }
    FRESNEL_INLINE void store_past_caches(float* to) const {
        each_of<K>([&](int i) { part_[i].store_past_caches(to + i * V::size); });
    }
    FRESNEL_INLINE float operator[](int i) const { return part_[i / V::size][i % V::size]; }

    friend FRESNEL_INLINE wide operator-(wide x) {
        return each(x, [](const V& a) { return -a; });
    }
    // clang-format off
    friend FRESNEL_INLINE wide operator+(const wide& x, const wide& y) { return each(x, y, [](const V& a, const V& b) { return a + b; }); }
    friend FRESNEL_INLINE wide operator-(const wide& x, const wide& y) { return each(x, y, [](const V& a, const V& b) { return a - b; }); }
    friend FRESNEL_INLINE wide operator*(const wide& x, const wide& y) { return each(x, y, [](const V& a, const V& b) { return a * b; }); }
    friend FRESNEL_INLINE wide operator/(const wide& x, const wide& y) { return each(x, y, [](const V& a, const V& b) { return a / b; }); }
    friend FRESNEL_INLINE wide min(const wide& x, const wide& y) { return each(x, y, [](const V& a, const V& b) { return min(a, b); }); }
    friend FRESNEL_INLINE wide max(const wide& x, const wide& y) { return each(x, y, [](const V& a, const V& b) { return max(a, b); }); }
    friend FRESNEL_INLINE wide pow(const wide& x, const wide& y) { return each(x, y, [](const V& a, const V& b) { return pow(a, b); }); }
    friend FRESNEL_INLINE wide abs(const wide& x) { return each(x, [](const V& a) { return abs(a); }); }
    friend FRESNEL_INLINE wide exp2(const wide& x) { return each(x, [](const V& a) { return exp2(a); }); }
    friend FRESNEL_INLINE wide log2(const wide& x) { return each(x, [](const V& a) { return log2(a); }); }
    friend FRESNEL_INLINE wide log(const wide& x) { return each(x, [](const V& a) { return log(a); }); }

    friend FRESNEL_INLINE mask operator<(const wide& x, const wide& y) { return compare(x, y, [](const V& a, const V& b) { return a < b; }); }
    friend FRESNEL_INLINE mask operator<=(const wide& x, const wide& y) { return compare(x, y, [](const V& a, const V& b) { return a <= b; }); }
    friend FRESNEL_INLINE mask operator>(const wide& x, const wide& y) { return y < x; }
    friend FRESNEL_INLINE mask operator>=(const wide& x, const wide& y) { return y <= x; }
    // clang-format on

    friend FRESNEL_INLINE wide sqrt(const wide& x) {
        wide result;
        each_of<K>([&](int i) {
            if constexpr (has_root_by_products<V>)
                result.part_[i] = i < K - by_products ? sqrt(x.part_[i]) : root_by_products(x.part_[i]);
            else
                result.part_[i] = sqrt(x.part_[i]);
        });
        return result;
    }
    friend FRESNEL_INLINE wide select(const mask& m, const wide& yes, const wide& no) {
        wide result;
        for (int i = 0; i < K; ++i)
            result.part_[i] = select(m.part[i], yes.part_[i], no.part_[i]);
        return result;
    }

private:
    FRESNEL_INLINE void copy(const wide& other) {
        for (int i = 0; i < K; ++i)
            part_[i] = other.part_[i];
    }
    template <class F>
    static FRESNEL_INLINE wide each(const wide& x, F f) {
        wide result;
        for (int i = 0; i < K; ++i)
            result.part_[i] = f(x.part_[i]);
        return result;
    }
    template <class F>
    static FRESNEL_INLINE wide each(const wide& x, const wide& y, F f) {
        wide result;
        for (int i = 0; i < K; ++i)
            result.part_[i] = f(x.part_[i], y.part_[i]);
        return result;
    }
    template <class F>
    static FRESNEL_INLINE mask compare(const wide& x, const wide& y, F f) {
        mask result;
        for (int i = 0; i < K; ++i)
            result.part[i] = f(x.part_[i], y.part_[i]);
        return result;
    }

    V part_[K];
};

} // namespace FRESNEL_ISA_NAMESPACE
} // namespace fresnel

/// A wide number has the properties of its element.
template <class V, int K, int by_products>
struct std::numeric_limits<fresnel::wide<V, K, by_products>> : std::numeric_limits<V> {};
