// The root that AVX-512 kernels take of some batches beside the divider is the correctly rounded one.

#include "inputs.hpp"

#include <gtest/gtest.h>

#include <bit>
#include <cmath>
#include <cstdint>
#include <vector>

namespace fresnel::test {

long wrong_roots(unsigned long first, unsigned long last, unsigned long step);
long wrong_refined_roots(float m, float error);

namespace {

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__)

bool available() { return __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("fma"); }

constexpr unsigned long sixteen = 16 * (thinning > 1 ? 4 * thinning + 1 : 1);

TEST(root_by_products, is_the_dividers_of_every_float) {
    if (!available()) GTEST_SKIP() << "skipped: no AVX-512";
    EXPECT_EQ(wrong_roots(0, 1ul << 32, sixteen), 0);
}

/// The m in [0.5, 2) whose root is within a relative 2^-41 of halfway between two floats. Of the others no estimate within
/// 2^-13 can end in a wrong root: both errors that the last step multiplies are below 2^-22.
std::vector<float> nearly_halfway() {
    std::vector<float> found;
    for (std::uint32_t bits = 0x3f000000; bits < 0x40000000; ++bits) {
        // as integers: root r in [2^23, 2^24), square r^2 + r + j, halfway at j = 1/4
        const float m = std::bit_cast<float>(bits);
        const double square = std::ldexp(m, m < 1 ? 48 : 46);
        const double r = std::floor(std::sqrt(square)), j = std::fma(-r, r, square) - r;
        if (std::abs(j - 0.25) < 2 * r * r * 0x1p-41) found.push_back(m);
    }
    return found;
}

TEST(root_by_products, does_not_rest_on_one_processors_estimate) {
    if (!available()) GTEST_SKIP() << "skipped: no AVX-512";
    const std::vector<float> hardest = nearly_halfway();
    EXPECT_GT(hardest.size(), 100u);
    long seen = 0;
    for (const float m : hardest) {
        EXPECT_EQ(wrong_refined_roots(m, 0x1p-13f), 0) << m;
        seen += wrong_refined_roots(m, 0x1p-9f);
    }
    EXPECT_GT(seen, 0); // a worse estimate would be
}

#else

TEST(root_by_products, is_the_dividers_of_every_float) {
    GTEST_SKIP() << "skipped: this compiler or machine has none";
}

#endif

} // namespace
} // namespace fresnel::test
