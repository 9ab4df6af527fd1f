// Models in two halves: what the second takes over is what the first kept, and the results are those of the whole.

#include <fresnel/exact.hpp>
#include <fresnel/types/halved.hpp>

#include <gtest/gtest.h>

#include <bit>
#include <random>

namespace {

using namespace fresnel;
using lanes = batch<float, 4>;

struct at_root {
    static constexpr cut place{2, {"sum", "root"}};
};

template <class T>
T distance_and_sum(T x, T y) {
    const T sum = let("sum", x + y);
    const T root = let("root", sqrt(sum * sum + 4 * (x * y)), "of both squares");
    return root * x - sum;
}

template <bool second>
using number = halved<lanes, at_root, second>;

TEST(halved, the_second_half_takes_over_what_the_first_kept) {
    const lanes x = lanes::broadcast(0.3f), y = lanes::broadcast(1.7f);
    kept_of<lanes, at_root> kept;
    distance_and_sum(number<false>(x, kept), number<false>(y, kept));
    const lanes sum = x + y;
    EXPECT_EQ(kept.value[0][2], sum[2]);
    EXPECT_EQ(kept.value[1][2], sqrt(sum * sum + 4 * (x * y))[2]);

    const auto whole = distance_and_sum(x, y);
    EXPECT_EQ(distance_and_sum(number<true>(x, kept), number<true>(y, kept)).value()[2], whole[2]);

    kept.value[0] = 10, kept.value[1] = 100; // nothing is computed again
    EXPECT_EQ(distance_and_sum(number<true>(x, kept), number<true>(y, kept)).value()[2], 100 * x[2] - 10);
}

TEST(halved, copies_of_kept_values_are_apart) {
    kept_of<lanes, at_root> a;
    a.value[0] = 1, a.value[1] = 2;
    kept_of<lanes, at_root> b = a;
    b.value[0] = 3;
    EXPECT_EQ(a.value[0][0], 1);
    EXPECT_EQ(b.value[1][0], 2);
}

/// Both halves of f, which is cut there, against the whole of it: the bits of all four results.
template <class Cut, class F>
void expect_same_bits(const char* name, F f) {
    std::mt19937 random(7);
    const auto draw = [&](float least, float most) {
        return lanes::broadcast(std::uniform_real_distribution<float>(least, most)(random));
    };
    for (int n = 0; n < 1000; ++n) {
        const lanes n_i = n % 2 ? lanes(1) : draw(0.5f, 2), n_t = n % 5 ? draw(0.1f, 4) : n_i,
                    k_t = n % 3 ? draw(0, 10) : lanes(0), cos_i = n % 7 ? draw(0, 1) : lanes(0);
        kept_of<lanes, Cut> kept;
        const auto run = [&]<bool second>() {
            using T = halved<lanes, Cut, second>;
            return f(T(n_i, kept), T(n_t, kept), T(k_t, kept), T(cos_i, kept));
        };
        run.template operator()<false>();
        const auto two = run.template operator()<true>();
        const auto one = f(n_i, n_t, k_t, cos_i);
        const auto bits = [](const lanes& x) { return std::bit_cast<std::uint32_t>(x[0]); };
        ASSERT_EQ(bits(two.R_s.value()), bits(one.R_s)) << name;
        ASSERT_EQ(bits(two.R_p.value()), bits(one.R_p)) << name;
        ASSERT_EQ(bits(two.T_s.value()), bits(one.T_s)) << name;
        ASSERT_EQ(bits(two.T_p.value()), bits(one.T_p)) << name;
    }
}

struct at_A {
    static constexpr cut place{2, {"t0", "A"}};
};

struct of_precise {
    static constexpr cut place{4, {"E", "q2", "N", "A"}};
};

TEST(halved, the_exact_models_keep_their_bits) {
    expect_same_bits<at_A>("conductor", [](auto n_i, auto n_t, auto k_t, auto cos_i) {
        return conductor(n_i, n_t, k_t, cos_i);
    });
    expect_same_bits<at_A>("conductor_fast", [](auto n_i, auto n_t, auto k_t, auto cos_i) {
        return conductor_fast(n_i, n_t, k_t, cos_i);
    });
    expect_same_bits<of_precise>("conductor_precise", [](auto n_i, auto n_t, auto k_t, auto cos_i) {
        return conductor_precise(n_i, n_t, k_t, cos_i);
    });
}

} // namespace
