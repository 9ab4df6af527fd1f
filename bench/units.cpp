// Compiled once for each instruction set, like src/batch/kernels.cpp and with its definitions; FRESNEL_UNITS is the name
// of the function that gives the result out.

#include "units.hpp"

#include <fresnel/types/wide.hpp>

namespace fresnel::bench {
namespace FRESNEL_ISA_NAMESPACE {
namespace {

using value = batch<float, FRESNEL_ISA_LANES>;

/// A value that the compiler does not know, so that nothing computed with it is folded.
FRESNEL_INLINE value opaque(float x) {
    const volatile float hidden = x;
    return value::broadcast(hidden);
}

// What is left after a loop goes here, so that it is not dropped.
volatile float sink;

/// Applies f to ten values in turn, again and again: enough independent chains to fill every unit, few enough to stay in
/// sixteen registers.
template <class F>
FRESNEL_INLINE void repeat(std::size_t count, F f) {
    constexpr int chains = 10;
    value x[chains];
    for (int i = 0; i < chains; ++i)
        x[i] = opaque(0.5f + 0.01f * static_cast<float>(i));
    for (std::size_t done = 0; done < count; done += chains * FRESNEL_ISA_LANES)
        for (value& v : x)
            v = f(v);
    for (const value& v : x)
        sink = v[0];
}

// two operations a call
[[gnu::flatten]] void multiply_add(std::size_t count) {
    const value a = opaque(0.75f), b = opaque(0.25f);
    repeat(count / 2, [&](const value& x) { return x * a + b; });
}

[[gnu::flatten]] void division(std::size_t count) {
    const value a = opaque(1.0f);
    repeat(count, [&](const value& x) { return x / a; });
}

[[gnu::flatten]] void root(std::size_t count) {
    repeat(count, [](const value& x) { return sqrt(x); });
}

[[gnu::flatten]] void binary_exponential(std::size_t count) {
    repeat(count, [](const value& x) { return exp2(-x); });
}

[[gnu::flatten]] void power(std::size_t count) {
    const value a = opaque(0.99f);
    repeat(count, [&](const value& x) { return pow(x, a); });
}

using block = wide<value, FRESNEL_ISA_BATCHES>;

template <int inputs>
[[gnu::flatten]] void stream_of(const float* const* in, float* out, std::size_t count) {
    for (std::size_t i = 0; i < count; i += block::size) {
        block sum = block::load(in[0] + i);
        for (int k = 1; k < inputs; ++k)
            sum = sum + block::load(in[k] + i);
        sum.store(out + i);
    }
}

void stream(const float* const* in, int input_count, float* out, std::size_t count) {
    constexpr decltype(&stream_of<1>) of[] = {stream_of<1>, stream_of<2>, stream_of<3>, stream_of<4>,
                                              stream_of<5>};
    of[input_count - 1](in, out, count);
}

} // namespace
} // namespace FRESNEL_ISA_NAMESPACE

unit_kernels FRESNEL_UNITS() {
    using namespace FRESNEL_ISA_NAMESPACE;
    return {FRESNEL_ISA_LANES, multiply_add, division, root, binary_exponential, power, stream};
}

} // namespace fresnel::bench
