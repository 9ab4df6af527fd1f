// Compiled once for each instruction set, like src/batch/kernels.cpp and with its definitions; FRESNEL_UNITS is the name
// of the function that gives the result out.

#include "units.hpp"

#include "batch/kernels.hpp"

#include <fresnel/models.hpp>
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

/// Applies f to thirteen values in turn, again and again: enough independent chains for every unit, few enough to stay
/// in sixteen registers; several rounds between two jumps.
template <class F>
FRESNEL_INLINE void repeat(std::size_t count, F f) {
    constexpr std::size_t chains = 13, rounds = 4;
    value x[chains];
    for (std::size_t i = 0; i < chains; ++i)
        x[i] = opaque(0.5f + 0.01f * static_cast<float>(i));
    for (std::size_t done = 0; done < count; done += rounds * chains * FRESNEL_ISA_LANES)
        [&]<std::size_t... i>(std::index_sequence<i...>) {
            ((x[i % chains] = f(x[i % chains])), ...);
        }(std::make_index_sequence<rounds * chains>{});
    for (const value& v : x)
        sink = v[0];
}

// The kernels contract nothing, so there is no multiply-add to time in their arithmetic: a multiplication runs in the
// same unit, as often.
[[gnu::flatten]] void multiply(std::size_t count) {
    const value a = opaque(1.0f);
    repeat(count, [&](const value& x) { return x * a; });
}

[[gnu::flatten]] void division(std::size_t count) {
    const value a = opaque(1.0f);
    repeat(count, [&](const value& x) { return x / a; });
}

[[gnu::flatten]] void root(std::size_t count) {
    repeat(count, [](const value& x) { return sqrt(x); });
}

using few = wide<value, FRESNEL_ISA_POWER_BATCHES>;

/// The same for a function of many operations, which needs the registers itself: few side by side, values in memory, and
/// the processor overlaps the calls.
template <class F>
FRESNEL_INLINE void call_again(std::size_t count, F f) {
    constexpr std::size_t values = 16 * few::size;
    float x[values];
    for (float& lane : x)
        lane = 0.5f;
    for (std::size_t done = 0; done < count; done += few::size) {
        float* const at = x + done % values;
        f(few::load(at)).store(at);
    }
    sink = x[0];
}

[[gnu::flatten]] void binary_exponential(std::size_t count) {
    call_again(count, [](const few& x) { return exp2(-x); });
}

[[gnu::flatten]] void power(std::size_t count) {
    const volatile float hidden = 0.99f;
    const few a = few::broadcast(hidden);
    call_again(count, [&](const few& x) { return pow(x, a); });
}

using block = wide<value, FRESNEL_ISA_BATCHES>;

template <int inputs>
[[gnu::flatten]] void stream_of(const float* const* in, float* out, std::size_t count) {
    const bool past_caches = count >= values_past_caches;
    for (std::size_t i = 0; i < count; i += block::size) {
        block sum = block::load(in[0] + i);
        for (int k = 1; k < inputs; ++k)
            sum = sum + block::load(in[k] + i);
        if (past_caches)
            sum.store_past_caches(out + i);
        else
            sum.store(out + i);
    }
    if (past_caches) lanes::fence();
}

void stream(const float* const* in, int input_count, float* out, std::size_t count) {
    constexpr decltype(&stream_of<1>) of[] = {stream_of<1>, stream_of<2>, stream_of<3>, stream_of<4>,
                                              stream_of<5>};
    of[input_count - 1](in, out, count);
}

#if defined(__AVX__) && !defined(__clang__)

/// A batch whose operations do not wait for each other. Each instruction reads a constant alone; that it takes its
/// operands is what the compiler believes, which therefore keeps it where the model has that operation, drops it where
/// the result does not need it, and holds the same values in registers.
class freed {
public:
    using floats = typename value::floats;
#ifdef __AVX512F__
    using mask = __mmask16;
#else
    using mask = floats;
#endif
    static constexpr int size = value::size;

    freed() = default;
    FRESNEL_INLINE freed(int integer) : freed(known(static_cast<float>(integer))) {}
    static FRESNEL_INLINE freed load(const float* from) {
        freed result;
        __builtin_memcpy(&result.lanes_, from, sizeof result.lanes_);
        return result;
    }
    FRESNEL_INLINE void store(float* to) const { __builtin_memcpy(to, &lanes_, sizeof lanes_); }

    // clang-format off
#define FRESNEL_FREED(result, instruction, ...) asm(instruction : "=v"(result) : "v"(one()), __VA_ARGS__)
    friend FRESNEL_INLINE freed operator-(freed x) { FRESNEL_FREED(x.lanes_, "vandps %1,%1,%0", "v"(x.lanes_)); return x; }
    friend FRESNEL_INLINE freed abs(freed x) { FRESNEL_FREED(x.lanes_, "vandps %1,%1,%0", "v"(x.lanes_)); return x; }
    friend FRESNEL_INLINE freed sqrt(freed x) { FRESNEL_FREED(x.lanes_, "vsqrtps %1,%0", "v"(x.lanes_)); return x; }
    friend FRESNEL_INLINE freed operator+(freed x, freed y) {
        if (x.constant_ && y.constant_) return known(x.constant_ + y.constant_);
        freed z; FRESNEL_FREED(z.lanes_, "vaddps %1,%1,%0", "v"(x.lanes_), "v"(y.lanes_)); return z;
    }
    friend FRESNEL_INLINE freed operator-(freed x, freed y) {
        if (x.constant_ && y.constant_) return known(x.constant_ - y.constant_);
        freed z; FRESNEL_FREED(z.lanes_, "vsubps %1,%1,%0", "v"(x.lanes_), "v"(y.lanes_)); return z;
    }
    friend FRESNEL_INLINE freed operator*(freed x, freed y) {
        if (x.constant_ && y.constant_) return known(x.constant_ * y.constant_);
        if (x.constant_ == 1) return y;
        if (y.constant_ == 1) return x;
        if (x.constant_ == 2) return y + y;
        freed z; FRESNEL_FREED(z.lanes_, "vmulps %1,%1,%0", "v"(x.lanes_), "v"(y.lanes_)); return z;
    }
    friend FRESNEL_INLINE freed operator/(freed x, freed y) {
        if (x.constant_ && y.constant_) return known(x.constant_ / y.constant_);
        if (y.constant_ == 2) return y * x;
        freed z; FRESNEL_FREED(z.lanes_, "vdivps %1,%1,%0", "v"(x.lanes_), "v"(y.lanes_)); return z;
    }
    friend FRESNEL_INLINE freed min(freed x, freed y) { freed z; FRESNEL_FREED(z.lanes_, "vminps %1,%1,%0", "v"(x.lanes_), "v"(y.lanes_)); return z; }
    friend FRESNEL_INLINE freed max(freed x, freed y) { freed z; FRESNEL_FREED(z.lanes_, "vmaxps %1,%1,%0", "v"(x.lanes_), "v"(y.lanes_)); return z; }
#ifdef __AVX512F__
    friend FRESNEL_INLINE mask operator<(freed x, freed y) { mask m; asm("vcmpltps %1,%1,%0" : "=Yk"(m) : "v"(one()), "v"(x.lanes_), "v"(y.lanes_)); return m; }
    friend FRESNEL_INLINE freed select(mask m, freed x, freed y) { freed z; FRESNEL_FREED(z.lanes_, "vblendmps %1,%1,%0%{%2%}", "Yk"(m), "v"(x.lanes_), "v"(y.lanes_)); return z; }
#else
    friend FRESNEL_INLINE mask operator<(freed x, freed y) { mask m; FRESNEL_FREED(m, "vcmpltps %1,%1,%0", "v"(x.lanes_), "v"(y.lanes_)); return m; }
    friend FRESNEL_INLINE freed select(mask m, freed x, freed y) { freed z; FRESNEL_FREED(z.lanes_, "vblendvps %1,%1,%1,%0", "v"(m), "v"(x.lanes_), "v"(y.lanes_)); return z; }
#endif
#undef FRESNEL_FREED
    friend FRESNEL_INLINE mask operator<=(freed x, freed y) { return x < y; }
    friend FRESNEL_INLINE mask operator>(freed x, freed y) { return y < x; }
    friend FRESNEL_INLINE mask operator>=(freed x, freed y) { return y < x; }
    // the models that have these are not measured so
    friend FRESNEL_INLINE freed exp2(freed x) { return x; }
    friend FRESNEL_INLINE freed log2(freed x) { return x; }
    friend FRESNEL_INLINE freed log(freed x) { return x; }
    friend FRESNEL_INLINE freed pow(freed x, freed) { return x; }
    // clang-format on

private:
    static FRESNEL_INLINE floats one() { return 1.0f - floats{}; }
    static FRESNEL_INLINE freed known(float x) {
        freed result;
        result.lanes_ = x - floats{};
        result.constant_ = x;
        return result;
    }

    floats lanes_;
    float constant_ =
        0; ///< not 0: every lane's value, made of integers alone, which a compiler computes itself
};

} // namespace
} // namespace FRESNEL_ISA_NAMESPACE
} // namespace fresnel::bench

template <>
struct std::numeric_limits<fresnel::bench::FRESNEL_ISA_NAMESPACE::freed> : std::numeric_limits<float> {};

namespace fresnel::bench {
namespace FRESNEL_ISA_NAMESPACE {
namespace {

template <class Row>
[[gnu::flatten]] void mix_of(const Row& row, const float* const* in, float* out, std::size_t count) {
    using several = wide<freed, FRESNEL_ISA_BATCHES>;
    constexpr int n = static_cast<int>(std::tuple_size_v<decltype(Row::parameters)>);
    for (std::size_t i = 0; i < count; i += several::size) {
        several x[n + 1];
        for (int k = 0; k <= n; ++k)
            x[k] = several::load(in[k] + i);
        if constexpr (n > 0)
            if (row.parameters[0].name == "n_i") x[0] = 1; // as in the kernel
        [&]<std::size_t... k>(std::index_sequence<k...>) {
            reflectance(row.evaluate(x[k]..., x[n])).store(out + i);
        }(std::make_index_sequence<n>{});
    }
}

void mix(std::string_view model, const float* const* in, float* out, std::size_t count) {
    for_each_model([&](const auto& row) {
        if (row.name == model) mix_of(row, in, out, count);
    });
}

#else
constexpr decltype(unit_kernels::mix) mix = nullptr;
#endif

} // namespace
} // namespace FRESNEL_ISA_NAMESPACE

unit_kernels FRESNEL_UNITS() {
    using namespace FRESNEL_ISA_NAMESPACE;
    return {FRESNEL_ISA_LANES, multiply, division, root, binary_exponential, power, stream, mix};
}

} // namespace fresnel::bench
