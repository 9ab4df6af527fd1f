// Compiled once for each instruction set, like src/batch/kernels.cpp and with its definitions; FRESNEL_UNITS is the name
// of the function that gives the result out.

#include "units.hpp"

#include <fresnel/types/wide.hpp>

namespace fresnel::bench {
namespace FRESNEL_ISA_NAMESPACE {
namespace {

using value = batch<float, FRESNEL_ISA_LANES>;

// A register that the compiler knows nothing about, so that no operation on it is folded, hoisted or dropped.
#if defined(__aarch64__)
#define FRESNEL_OPAQUE "+w"
#else
#define FRESNEL_OPAQUE "+v"
#endif

FRESNEL_INLINE void touch(value& x) {
    if constexpr (FRESNEL_ISA_LANES == 1) {
        float lane = x[0];
        asm volatile("" : FRESNEL_OPAQUE(lane));
        x = value::load(&lane);
    } else {
        value::floats lanes;
        x.store(reinterpret_cast<float*>(&lanes));
        asm volatile("" : FRESNEL_OPAQUE(lanes));
        x = value(lanes);
    }
}

/// Runs f on eight values in turn, each result thrown away where the compiler does not see it.
template <class F>
FRESNEL_INLINE void repeat(std::size_t count, F f) {
    value x[8];
    for (value& v : x) {
        v = value::broadcast(1.25f);
        touch(v);
    }
    for (std::size_t done = 0; done < count; done += 8 * FRESNEL_ISA_LANES)
        for (value& v : x) {
            touch(v);
            value result = f(v);
            touch(result);
        }
}

// two operations a call, neither waiting for the other
void multiply_add(std::size_t count) {
    value a = value::broadcast(1.5f);
    touch(a);
    repeat(count / 2, [&](const value& x) {
        value product = x * a;
        touch(product);
        return x + a;
    });
}

void division(std::size_t count) {
    value a = value::broadcast(1.5f);
    touch(a);
    repeat(count, [&](const value& x) { return x / a; });
}

void root(std::size_t count) {
    repeat(count, [](const value& x) { return sqrt(x); });
}

void binary_exponential(std::size_t count) {
    repeat(count, [](const value& x) { return exp2(x); });
}

void power(std::size_t count) {
    value a = value::broadcast(1.5f);
    touch(a);
    repeat(count, [&](const value& x) { return pow(x, a); });
}

using block = wide<value, FRESNEL_ISA_BATCHES>;

template <int inputs>
void stream_of(const float* const* in, float* out, std::size_t count) {
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
