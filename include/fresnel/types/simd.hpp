#pragma once

// Several floats that are computed with as one: batch<float, N> runs a model on N values at a time.
//
// The lanes are a GNU vector (g++, clang: SSE, AVX, AVX-512, NEON, WebAssembly) or, where a compiler has none or
// FRESNEL_NO_VECTOR_EXTENSIONS is defined, an array and loops over it. Both give the same bits: every operation
// is one IEEE operation per lane, in the order the model writes it, provided that the compiler neither contracts
// (-ffp-contract=off) nor re-associates. batch<float, 1> is the scalar path, from the same source.
//
// exp2, log2, log and pow are polynomials of ours, the same in every width, because no two math libraries round
// these alike. Largest errors, measured against 60 digits by tests/simd_test.cpp:
//   exp2   1.25 ulp   every x; a result below 2^-126 is rounded once more, to a denormal
//   log2   0.6 ulp    every x > 0, denormals included; -infinity at 0, NaN below
//   log    0.6 ulp    as log2
//   pow    1.5 ulp    x >= 0, every y; a result below 2^-126 as exp2's
// A NaN stays a NaN; its sign and payload are not promised.
//
// One program may hold this code compiled for several instruction sets. An inline function with one name and
// several meanings would then be merged by the linker, and AVX-512 code run where there is none. Each such
// translation unit therefore names a namespace of its own in FRESNEL_ISA_NAMESPACE before it includes this file;
// what it instantiates carries the name, being made of its batch.

#include <fresnel/number.hpp>

#include <cstdint>
#include <cstring>
#include <limits>
#include <utility>

#ifndef FRESNEL_ISA_NAMESPACE
#define FRESNEL_ISA_NAMESPACE isa_default
#endif

#if defined(__GNUC__)
#define FRESNEL_INLINE inline __attribute__((always_inline))
#define FRESNEL_INLINE_LAMBDA __attribute__((always_inline))
#else
#define FRESNEL_INLINE inline
#define FRESNEL_INLINE_LAMBDA
#define FRESNEL_NO_VECTOR_EXTENSIONS
#endif

// the rounding error of a product in one operation, where the instruction set has it
#if defined(__FMA__) || defined(__ARM_FEATURE_FMA)
#define FRESNEL_FUSED
#endif

// g++ 12 has no packed square root but the intrinsics, and without them it makes a minimum of a comparison and a blend
#if defined(__GNUC__) && !defined(__clang__) && defined(__SSE2__) && !defined(FRESNEL_NO_VECTOR_EXTENSIONS)
#include <immintrin.h>
#define FRESNEL_INTRINSICS
#endif

namespace fresnel {
inline namespace FRESNEL_ISA_NAMESPACE {

/// Calls f(0), f(1), ..., f(n - 1). Not a loop, which g++ would keep, and in memory what it runs over.
template <int n, class F>
FRESNEL_INLINE void each_of(F f) {
    [&]<int... i>(std::integer_sequence<int, i...>)
        FRESNEL_INLINE_LAMBDA { (f(i), ...); }(std::make_integer_sequence<int, n>{});
}

namespace lanes {

// ---- storage: what the batch below is made of -------------------------------------------------------------

/// N elements as an array, with the operators of a GNU vector: comparisons give -1 or 0 in each lane.
template <class E, int N>
struct array {
    E lane[N];

    FRESNEL_INLINE E operator[](int i) const { return lane[i]; }
    FRESNEL_INLINE E& operator[](int i) { return lane[i]; }
};

template <class R, class E, int N, class F>
FRESNEL_INLINE array<R, N> each(array<E, N> a, array<E, N> b, F f) {
    array<R, N> result;
    for (int i = 0; i < N; ++i)
        result.lane[i] = f(a.lane[i], b.lane[i]);
    return result;
}

// clang-format off
template <class E, int N>
FRESNEL_INLINE array<E, N> operator-(array<E, N> a) { return each<E>(a, a, [](E x, E) { return -x; }); }
template <class E, int N>
FRESNEL_INLINE array<E, N> operator+(array<E, N> a, array<E, N> b) { return each<E>(a, b, [](E x, E y) { return x + y; }); }
template <class E, int N>
FRESNEL_INLINE array<E, N> operator-(array<E, N> a, array<E, N> b) { return each<E>(a, b, [](E x, E y) { return x - y; }); }
template <class E, int N>
FRESNEL_INLINE array<E, N> operator*(array<E, N> a, array<E, N> b) { return each<E>(a, b, [](E x, E y) { return x * y; }); }
template <class E, int N>
FRESNEL_INLINE array<E, N> operator/(array<E, N> a, array<E, N> b) { return each<E>(a, b, [](E x, E y) { return x / y; }); }
template <class E, int N>
FRESNEL_INLINE array<E, N> operator&(array<E, N> a, array<E, N> b) { return each<E>(a, b, [](E x, E y) { return x & y; }); }
template <class E, int N>
FRESNEL_INLINE array<E, N> operator|(array<E, N> a, array<E, N> b) { return each<E>(a, b, [](E x, E y) { return x | y; }); }
template <class E, int N>
FRESNEL_INLINE array<E, N> operator<<(array<E, N> a, int n) { return each<E>(a, a, [n](E x, E) { return x << n; }); }
template <class E, int N>
FRESNEL_INLINE array<E, N> operator>>(array<E, N> a, int n) { return each<E>(a, a, [n](E x, E) { return x >> n; }); }
template <class E, int N>
FRESNEL_INLINE array<int, N> operator<(array<E, N> a, array<E, N> b) { return each<int>(a, b, [](E x, E y) { return -(x < y); }); }
template <class E, int N>
FRESNEL_INLINE array<int, N> operator<=(array<E, N> a, array<E, N> b) { return each<int>(a, b, [](E x, E y) { return -(x <= y); }); }
template <class E, int N>
FRESNEL_INLINE array<int, N> operator==(array<E, N> a, array<E, N> b) { return each<int>(a, b, [](E x, E y) { return -(x == y); }); }
// clang-format on

/// The same value in every lane of a zero.
template <class E, int N>
FRESNEL_INLINE array<E, N> broadcast(E x, array<E, N> zero) {
    for (E& lane : zero.lane)
        lane = x;
    return zero;
}

/// `a` where the mask holds, otherwise `b`.
template <int N>
FRESNEL_INLINE array<float, N> blend(array<int, N> mask, array<float, N> a, array<float, N> b) {
    for (int i = 0; i < N; ++i)
        b.lane[i] = mask.lane[i] ? a.lane[i] : b.lane[i];
    return b;
}

template <int N>
FRESNEL_INLINE array<float, N> root(array<float, N> a) {
    for (int i = 0; i < N; ++i)
        a.lane[i] = sqrt(a.lane[i]);
    return a;
}

/// The types of N lanes.
template <int N>
struct storage {
    using floats = array<float, N>;
    using masks = array<int, N>;
    using words = array<std::uint32_t, N>;
};

#ifndef FRESNEL_NO_VECTOR_EXTENSIONS

// A single lane stays an array: no compiler makes scalar code of a vector of one.
template <int N>
    requires(N > 1)
struct storage<N> {
    typedef float floats __attribute__((vector_size(N * sizeof(float))));
    typedef std::int32_t masks __attribute__((vector_size(N * sizeof(float))));
    typedef std::uint32_t words __attribute__((vector_size(N * sizeof(float))));
};

// not lane by lane, which g++ keeps; subtracting 0 changes no x
template <class E, class Lanes>
FRESNEL_INLINE Lanes broadcast(E x, Lanes zero) {
    return x - zero;
}

template <class Mask, class Floats>
FRESNEL_INLINE Floats blend(Mask mask, Floats a, Floats b) {
    return mask ? a : b;
}

template <class Floats>
FRESNEL_INLINE Floats root(Floats a) {
#if defined(FRESNEL_INTRINSICS) && defined(__AVX512F__)
    if constexpr (sizeof(Floats) == 64) return Floats(_mm512_maskz_sqrt_ps(0xffff, __m512(a)));
#endif
#if defined(FRESNEL_INTRINSICS) && defined(__AVX__)
    if constexpr (sizeof(Floats) == 32) return Floats(_mm256_sqrt_ps(__m256(a)));
#endif
#ifdef FRESNEL_INTRINSICS
    if constexpr (sizeof(Floats) == 16) return Floats(_mm_sqrt_ps(__m128(a)));
#endif
#if defined(__clang__)
    return __builtin_elementwise_sqrt(a);
#else
    for (unsigned i = 0; i < sizeof(Floats) / sizeof(float); ++i)
        a[i] = __builtin_sqrtf(a[i]);
    return a;
#endif
}

#endif

#if defined(FRESNEL_INTRINSICS) && defined(__AVX512F__)

/// The root of m in [0.5, 2), rounded correctly, from y, which is within 2^-13 of 1 / sqrt(m). Markstein 1990,
/// "Computation of elementary functions on the IBM RISC System/6000 processor": a step of Newton's for the root g and for
/// half its reciprocal h, then one for g with a remainder that a fused multiply-add gives exactly.
FRESNEL_INLINE __m512 refined_root(__m512 m, __m512 y) {
    const __m512 half = _mm512_set1_ps(0.5f);
    const __m512 g0 = m * y, h0 = half * y;
    const __m512 r = _mm512_fnmadd_ps(g0, h0, half);
    const __m512 g = _mm512_fmadd_ps(g0, r, g0), h = _mm512_fmadd_ps(h0, r, h0);
    return _mm512_fmadd_ps(_mm512_fnmadd_ps(g, g, m), h, g);
}

/// `root` without the divider, bit for bit: a test takes all 2^32 floats.
FRESNEL_INLINE __m512 root_by_products(__m512 a) {
    const __m512 half = _mm512_set1_ps(0.5f);
    const __m512 m = _mm512_maskz_getmant_ps(0xffff, a, _MM_MANT_NORM_p5_2, _MM_MANT_SIGN_nan);
    const __m512 e = _mm512_fmadd_ps(_mm512_maskz_getexp_ps(0xffff, a), half, half); // rounded down by scalef
    const __m512 root = refined_root(m, _mm512_maskz_rsqrt14_ps(0xffff, m));
    const __m512i special = _mm512_set1_epi32(0x30100); // 0 stays, with its sign; none of -infinity
    return _mm512_fixupimm_ps(_mm512_maskz_scalef_ps(0xffff, root, e), a, special, 0);
}

#endif

/// a < b ? a : b in each lane: `b` where they are equal or one is a NaN, as the processor's own minimum.
template <class Floats>
FRESNEL_INLINE Floats smaller(Floats a, Floats b) {
#if defined(FRESNEL_INTRINSICS) && defined(__AVX512F__)
    if constexpr (sizeof(Floats) == 64) return Floats(_mm512_maskz_min_ps(0xffff, __m512(a), __m512(b)));
#endif
#if defined(FRESNEL_INTRINSICS) && defined(__AVX__)
    if constexpr (sizeof(Floats) == 32) return Floats(_mm256_min_ps(__m256(a), __m256(b)));
#endif
#ifdef FRESNEL_INTRINSICS
    if constexpr (sizeof(Floats) == 16) return Floats(_mm_min_ps(__m128(a), __m128(b)));
#endif
    return blend(a < b, a, b);
}

/// a > b ? a : b likewise.
template <class Floats>
FRESNEL_INLINE Floats larger(Floats a, Floats b) {
#if defined(FRESNEL_INTRINSICS) && defined(__AVX512F__)
    if constexpr (sizeof(Floats) == 64) return Floats(_mm512_maskz_max_ps(0xffff, __m512(a), __m512(b)));
#endif
#if defined(FRESNEL_INTRINSICS) && defined(__AVX__)
    if constexpr (sizeof(Floats) == 32) return Floats(_mm256_max_ps(__m256(a), __m256(b)));
#endif
#ifdef FRESNEL_INTRINSICS
    if constexpr (sizeof(Floats) == 16) return Floats(_mm_max_ps(__m128(a), __m128(b)));
#endif
    return blend(b < a, a, b);
}

#ifdef FRESNEL_FUSED

/// a b + c, rounded once.
template <class Floats>
FRESNEL_INLINE Floats fused(Floats a, Floats b, Floats c) {
#if defined(FRESNEL_INTRINSICS) && defined(__AVX512F__)
    if constexpr (sizeof(Floats) == 64) return Floats(_mm512_fmadd_ps(__m512(a), __m512(b), __m512(c)));
#endif
#ifdef FRESNEL_INTRINSICS
    if constexpr (sizeof(Floats) == 32) return Floats(_mm256_fmadd_ps(__m256(a), __m256(b), __m256(c)));
    if constexpr (sizeof(Floats) == 16) return Floats(_mm_fmadd_ps(__m128(a), __m128(b), __m128(c)));
#endif
#if defined(__clang__) && !defined(FRESNEL_NO_VECTOR_EXTENSIONS)
    if constexpr (sizeof(Floats) > sizeof(float)) return __builtin_elementwise_fma(a, b, c);
#endif
    for (unsigned i = 0; i < sizeof(Floats) / sizeof(float); ++i)
        a[i] = __builtin_fmaf(a[i], b[i], c[i]);
    return a;
}

#endif

template <class Floats>
FRESNEL_INLINE void store_past_caches(const Floats& a, float* to) {
#ifdef FRESNEL_INTRINSICS
#ifdef __AVX512F__
    if constexpr (sizeof(Floats) == 64) return _mm512_stream_ps(to, __m512(a));
#endif
#ifdef __AVX__
    if constexpr (sizeof(Floats) == 32) return _mm256_stream_ps(to, __m256(a));
#endif
    if constexpr (sizeof(Floats) == 16) return _mm_stream_ps(to, __m128(a));
#endif
    std::memcpy(to, &a, sizeof a);
}

FRESNEL_INLINE void fence() {
#ifdef FRESNEL_INTRINSICS
    _mm_sfence();
#endif
}

} // namespace lanes

// ---- the number type --------------------------------------------------------------------------------------

/// The result of a comparison: holds or not, in each lane.
template <int N>
struct batch_mask {
    typename lanes::storage<N>::masks lanes;

    bool operator[](int i) const { return lanes[i] != 0; }
    friend FRESNEL_INLINE batch_mask operator&(batch_mask a, batch_mask b) { return {a.lanes & b.lanes}; }
    friend FRESNEL_INLINE batch_mask operator|(batch_mask a, batch_mask b) { return {a.lanes | b.lanes}; }
};

template <class T, int N>
class batch;

/// N floats behind the vocabulary of number.hpp. N is a power of two.
template <int N>
class batch<float, N> {
public:
    using mask = batch_mask<N>;
    using floats = typename lanes::storage<N>::floats;
    using words = typename lanes::storage<N>::words;
    static constexpr int size = N;

    batch() = default;
    FRESNEL_INLINE batch(int integer) : batch(broadcast(static_cast<float>(integer))) {}
    template <class U>
    batch(U) = delete; // a float would be cut to an int; `broadcast` takes one
    explicit FRESNEL_INLINE batch(floats lanes) : lanes_(lanes) {}

    /// The same value in every lane.
    static FRESNEL_INLINE batch broadcast(float x) { return batch(lanes::broadcast<float>(x, floats{})); }
    /// N values from memory, of any alignment.
    static FRESNEL_INLINE batch load(const float* from) {
        floats result;
        std::memcpy(&result, from, sizeof result);
        return batch(result);
    }
    FRESNEL_INLINE void store(float* to) const { std::memcpy(to, &lanes_, sizeof lanes_); }
    /// The same for results that no cache could keep, which spares reading what they replace. `to` is a multiple of
    /// their size; lanes::fence() makes them visible to other threads.
    FRESNEL_INLINE void store_past_caches(float* to) const { lanes::store_past_caches(lanes_, to); }
    FRESNEL_INLINE float operator[](int i) const { return lanes_[i]; }

    friend FRESNEL_INLINE batch operator-(batch x) { return batch(-x.lanes_); }
    friend FRESNEL_INLINE batch operator+(batch x, batch y) { return batch(x.lanes_ + y.lanes_); }
    friend FRESNEL_INLINE batch operator-(batch x, batch y) { return batch(x.lanes_ - y.lanes_); }
    friend FRESNEL_INLINE batch operator*(batch x, batch y) { return batch(x.lanes_ * y.lanes_); }
    friend FRESNEL_INLINE batch operator/(batch x, batch y) { return batch(x.lanes_ / y.lanes_); }

    friend FRESNEL_INLINE mask operator<(batch x, batch y) { return {x.lanes_ < y.lanes_}; }
    friend FRESNEL_INLINE mask operator<=(batch x, batch y) { return {x.lanes_ <= y.lanes_}; }
    friend FRESNEL_INLINE mask operator>(batch x, batch y) { return y < x; }
    friend FRESNEL_INLINE mask operator>=(batch x, batch y) { return y <= x; }
    friend FRESNEL_INLINE mask equal(batch x, batch y) { return {x.lanes_ == y.lanes_}; }

    friend FRESNEL_INLINE batch select(mask m, batch yes, batch no) {
        return batch(lanes::blend(m.lanes, yes.lanes_, no.lanes_));
    }
    friend FRESNEL_INLINE batch min(batch x, batch y) { return batch(lanes::smaller(y.lanes_, x.lanes_)); }
    friend FRESNEL_INLINE batch max(batch x, batch y) { return batch(lanes::larger(y.lanes_, x.lanes_)); }
    friend FRESNEL_INLINE batch abs(batch x) { return with_bits(bits(x) & word(0x7fffffff)); }
    friend FRESNEL_INLINE batch sqrt(batch x) { return batch(lanes::root(x.lanes_)); }
#if defined(FRESNEL_INTRINSICS) && defined(__AVX512F__)
    /// `sqrt` by the units of multiplications.
    friend FRESNEL_INLINE batch root_by_products(batch x)
        requires(N == 16)
    {
        return batch(floats(lanes::root_by_products(__m512(x.lanes_))));
    }
#endif
#ifdef FRESNEL_FUSED
    friend FRESNEL_INLINE batch fused_error(batch x, batch y, batch product) {
        return batch(lanes::fused(x.lanes_, y.lanes_, -product.lanes_));
    }
#endif

    /// The lanes' bit patterns, and back.
    friend FRESNEL_INLINE words bits(batch x) {
        words result;
        std::memcpy(&result, &x.lanes_, sizeof result);
        return result;
    }
    static FRESNEL_INLINE batch with_bits(words x) {
        batch result;
        std::memcpy(&result.lanes_, &x, sizeof x);
        return result;
    }
    static FRESNEL_INLINE words word(std::uint32_t x) { return lanes::broadcast<std::uint32_t>(x, words{}); }

private:
    floats lanes_;
};

// ---- exponential and logarithm ----------------------------------------------------------------------------

/// A value as an unevaluated sum, its low part below the last place of the high one.
template <class V>
struct batch_sum {
    V high, low;
};

template <int N>
FRESNEL_INLINE batch<float, N> fill(float x) {
    return batch<float, N>::broadcast(x);
}

/// x in two parts of 12 bits each, whose products are exact.
template <int N>
FRESNEL_INLINE batch_sum<batch<float, N>> split(batch<float, N> x) {
    using V = batch<float, N>;
    const V high = V::with_bits(bits(x) & V::word(0xfffff000));
    return {high, x - high};
}

/// x y without rounding error.
template <int N>
FRESNEL_INLINE batch_sum<batch<float, N>> exact_product(batch<float, N> x, batch<float, N> y) {
    const batch<float, N> product = x * y;
#ifdef FRESNEL_FUSED
    return {product, fused_error(x, y, product)};
#else
    const auto [x1, x2] = split(x);
    const auto [y1, y2] = split(y);
    return {product, (((x1 * y1 - product) + x1 * y2) + x2 * y1) + x2 * y2};
#endif
}

/// x + y without rounding error, for |x| >= |y| or x = 0.
template <int N>
FRESNEL_INLINE batch_sum<batch<float, N>> fast_sum(batch<float, N> x, batch<float, N> y) {
    const batch<float, N> sum = x + y;
    return {sum, y - (sum - x)};
}

/// 2^k for an integer k in [-126, 127], by its exponent bits.
template <int N>
FRESNEL_INLINE batch<float, N> power_of_two(batch<float, N> k) {
    using V = batch<float, N>;
    const V magic = fill<N>(12582912); // 1.5 2^23: k appears in its last bits
    return V::with_bits((bits(k + magic) + V::word(127)) << 23);
}

/// 2^(high + low), |low| far below 1: the integer part into the exponent, the rest by a polynomial.
template <int N>
FRESNEL_INLINE batch<float, N> exp2_of_sum(batch_sum<batch<float, N>> x) {
    using V = batch<float, N>;
    const V magic = fill<N>(12582912);
    const V high = min(max(x.high, V(-151)), V(129)); // 0 and infinity begin before these ends
    const V n = (high + magic) - magic;
    const V g = (high - n) + x.low; // [-1/2, 1/2]

    // (2^g - 1) / g at the Chebyshev points of [-1/2, 1/2]: relative error of 2^g 4e-9
    V q = fill<N>(1.54531828e-4f);
    q = q * g + fill<N>(1.339088633e-3f);
    q = q * g + fill<N>(9.618082519e-3f);
    q = q * g + fill<N>(5.5503570711e-2f);
    q = q * g + fill<N>(0.240226507606f);
    q = q * g + fill<N>(0.693147188035f);

    // in two factors, since 2^n may be a denormal or infinite where 2^(n + g) is not
    const V half = (n * fill<N>(0.5f) + magic) - magic;
    return (1 + g * q) * power_of_two(half) * power_of_two(n - half);
}

/// log2 x for a positive finite x, its relative error about 2^-33.
///
///   x = 2^e m, m in [sqrt(1/2), sqrt(2))     s = (m - 1) / (m + 1)
///   log2 m = K s + s^3 q(s^2), K = 2 / ln 2
template <int N>
FRESNEL_INLINE batch_sum<batch<float, N>> log2_as_sum(batch<float, N> x) {
    using V = batch<float, N>;
    // exponent and mantissa; a denormal is scaled first
    const auto small = x < fill<N>(0x1p-126f);
    const V scaled = select(small, x * fill<N>(0x1p24f), x);
    const auto u = bits(scaled) + V::word(0x3f800000 - 0x3f3504f3); // sqrt(1/2) is 0x3f3504f3
    const V biased = V::with_bits((u >> 23) | V::word(0x4b000000)); // 2^23 + e + 127
    const V e = biased - select(small, fill<N>(8388608 + 127 + 24), fill<N>(8388608 + 127));
    const V m = V::with_bits((u & V::word(0x007fffff)) + V::word(0x3f3504f3));

    // s = r / (m + 1) with the rounding of m + 1 and of the quotient in s_low
    const V r = m - 1;
    const V d = m + 1;
    const V d_low = m - (d - 1);
    const V inv_d = 1 / d;
    const V s = r * inv_d;
    const auto sd = exact_product(s, d);
    const V s_low = (((r - sd.high) - sd.low) - s * d_low) * inv_d;

    // q = q3 + z tail at the Chebyshev points of [0, 0.0295]: relative error of log2 m 2e-11
    const V z = s * s;
    V tail = fill<N>(0.336589148634f);
    tail = tail * z + fill<N>(0.411901215217f);
    tail = tail * z + fill<N>(0.577079774668f);

    // log2 m = s (K + z q3 + z^2 tail); the cubic term is a hundredth of the first, and its rounding would still
    // cost pow 3 ulp
    const V q3 = fill<N>(0.961796692307f);
    const auto zz = exact_product(s, s);
    const auto zq = exact_product(zz.high, q3);
    const auto inner = fast_sum(zq.high, z * z * tail);
    const auto cubic = exact_product(s, inner.high);
    const V cubic_low = cubic.low + s * (inner.low + (zq.low + zz.low * q3));

    const V K = fill<N>(2.885390043f), K_low = fill<N>(3.851926e-8f);
    const auto linear = exact_product(s, K);
    const V linear_low = linear.low + (s * K_low + s_low * (K + K * z));
    const auto log_m = fast_sum(linear.high, cubic.high);
    const auto sum = fast_sum(e, log_m.high);
    return fast_sum(sum.high, sum.low + (log_m.low + (linear_low + cubic_low)));
}

/// The logarithm where it is not finite: -infinity at 0, NaN below and for NaN, infinity at infinity.
template <int N>
FRESNEL_INLINE batch<float, N> with_log_limits(batch<float, N> x, batch<float, N> finite) {
    constexpr float infinity = std::numeric_limits<float>::infinity();
    using V = batch<float, N>;
    const V above = select(x < fill<N>(infinity), finite, x);
    const V nan = fill<N>(std::numeric_limits<float>::quiet_NaN());
    return select(x <= 0, select(x < 0, nan, fill<N>(-infinity)), above);
}

/// x y for a sum x, to a relative 2^-32 or so; the low part is dropped where the product is large or not a number.
template <int N>
FRESNEL_INLINE batch_sum<batch<float, N>> times(batch_sum<batch<float, N>> x, batch<float, N> y) {
    using V = batch<float, N>;
    const auto product = exact_product(x.high, y);
    const V low = product.low + x.low * y;
    return {product.high, select(abs(product.high) < 1000, low, V(0))};
}

template <int N>
FRESNEL_INLINE batch<float, N> exp2(batch<float, N> x) {
    return exp2_of_sum(batch_sum<batch<float, N>>{x, 0});
}

template <int N>
FRESNEL_INLINE batch<float, N> log2(batch<float, N> x) {
    return with_log_limits(x, log2_as_sum(x).high);
}

template <int N>
FRESNEL_INLINE batch<float, N> log(batch<float, N> x) {
    const auto binary = log2_as_sum(x);
    const auto [high, low] = times(binary, fill<N>(0.693147182f)); // ln 2, and what that lacks
    return with_log_limits(x, high + (low + binary.high * fill<N>(-1.904654212e-9f)));
}

/// x^y for x >= 0; 1 for x = 1 or y = 0, whatever the other is; NaN for x < 0.
template <int N>
FRESNEL_INLINE batch<float, N> pow(batch<float, N> x, batch<float, N> y) {
    const auto [high, low] = log2_as_sum(x);
    const auto power = exp2_of_sum(times({with_log_limits(x, high), low}, y));
    return select(equal(x, 1) | equal(y, 0), batch<float, N>(1), power);
}

} // namespace FRESNEL_ISA_NAMESPACE
} // namespace fresnel

/// A batch has the properties of its element.
template <class T, int N>
struct std::numeric_limits<fresnel::batch<T, N>> : std::numeric_limits<T> {};
