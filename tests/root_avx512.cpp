// What root_test.cpp asks of AVX-512, with its flags. No function of the standard library may be called here.

#include <fresnel/types/simd.hpp>

namespace fresnel::test {
namespace {

/// How many lanes of a and b differ in a bit, any NaN as any other.
int differing(__m512 a, __m512 b) {
    const __mmask16 numbers = _mm512_cmp_ps_mask(a, a, _CMP_ORD_Q) | _mm512_cmp_ps_mask(b, b, _CMP_ORD_Q);
    return __builtin_popcount(
        _mm512_mask_cmpneq_epi32_mask(numbers, _mm512_castps_si512(a), _mm512_castps_si512(b)));
}

__m512 sixteen_from(unsigned bits) {
    const __m512i lane = _mm512_setr_epi32(0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13, 14, 15);
    return _mm512_castsi512_ps(_mm512_add_epi32(_mm512_set1_epi32(static_cast<int>(bits)), lane));
}

} // namespace

/// Of the floats whose bits are `first` to `last`, a multiple of 16 apart: how many roots by products are not the divider's.
long wrong_roots(unsigned long first, unsigned long last, unsigned long step) {
    long wrong = 0;
    for (unsigned long bits = first; bits < last; bits += step) {
        const __m512 x = sixteen_from(static_cast<unsigned>(bits));
        wrong += differing(lanes::root_by_products(x), lanes::root(x));
    }
    return wrong;
}

/// The same over [0.5, 2) where the reciprocal root begins with that relative error, beside the processor's own.
long wrong_refined_roots(float error, unsigned long step) {
    long wrong = 0;
    for (unsigned long bits = 0x3f000000; bits < 0x40000000; bits += step) {
        const __m512 m = sixteen_from(static_cast<unsigned>(bits));
        const __m512 start = _mm512_maskz_rsqrt14_ps(0xffff, m) * _mm512_set1_ps(1 + error);
        wrong += differing(lanes::refined_root(m, start), lanes::root(m));
    }
    return wrong;
}

} // namespace fresnel::test
