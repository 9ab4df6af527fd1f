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

/// Of the floats whose bits are `first` to `last`, a multiple of 16 apart: how many roots by products are not the
/// divider's.
long wrong_roots(unsigned long first, unsigned long last, unsigned long step) {
    long wrong = 0;
    for (unsigned long bits = first; bits < last; bits += step) {
        const __m512 x = sixteen_from(static_cast<unsigned>(bits));
        wrong += differing(lanes::root_by_products(x), lanes::root(x));
    }
    return wrong;
}

/// Of all floats within a relative error of 1 / sqrt(m), one of which a processor begins with: how many end in another
/// root of m than the divider's.
long wrong_refined_roots(float m, float error) {
    const float reciprocal = 1 / __builtin_sqrtf(m), low = reciprocal * (1 - error),
                high = reciprocal * (1 + error);
    const unsigned first = __builtin_bit_cast(unsigned, low), last = __builtin_bit_cast(unsigned, high);
    const __m512 many = _mm512_set1_ps(m);
    long wrong = 0;
    for (unsigned bits = first; bits < last; bits += 16)
        wrong += differing(lanes::refined_root(many, sixteen_from(bits)), lanes::root(many));
    return wrong;
}

} // namespace fresnel::test
