// The root that AVX-512 kernels take of some batches beside the divider is the correctly rounded one.

#include "inputs.hpp"

#include <gtest/gtest.h>

namespace fresnel::test {

long wrong_roots(unsigned long first, unsigned long last, unsigned long step);
long wrong_refined_roots(float error, unsigned long step);

namespace {

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

bool available() { return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("fma"); }

constexpr unsigned long sixteen = 16 * (thinning > 1 ? 4 * thinning + 1 : 1);

TEST(root_by_products, is_the_dividers_of_every_float) {
    if (!available()) GTEST_SKIP() << "skipped: no AVX-512";
    EXPECT_EQ(wrong_roots(0, 1ul << 32, sixteen), 0);
}

TEST(root_by_products, does_not_rest_on_one_processors_estimate) {
    if (!available()) GTEST_SKIP() << "skipped: no AVX-512";
    for (int i = -16; i <= 16; ++i)
        EXPECT_EQ(wrong_refined_roots(static_cast<float>(i) * 0x1p-18f, sixteen), 0) << i;
    EXPECT_GT(wrong_refined_roots(0x1p-9f, sixteen), 0); // and would be seen to
}

#else

TEST(root_by_products, is_the_dividers_of_every_float) {
    GTEST_SKIP() << "skipped: this compiler or machine has none";
}

#endif

} // namespace
} // namespace fresnel::test
