#pragma once

#include "emit/verify.hpp"

#include <cmath>
#include <limits>
#include <memory>

namespace fresnel::emit {

/// What a value was made from.
struct encounter {
    bool subnormal = false; ///< a number that devices may take for 0
    bool open = false;      ///< a NaN, or pow outside its domain

    void operator+=(const encounter& other) {
        subnormal |= other.subnormal;
        open |= other.open;
    }
    void operator+=(float x) {
        subnormal |= (x != 0) & (std::abs(x) < std::numeric_limits<float>::min());
        open |= x != x;
    }
};

/// A case's values by the float model in C++, and what their evaluation meets.
class model_values {
public:
    /// The case must outlive it.
    explicit model_values(const verify_case& c);
    ~model_values();
    model_values(const model_values&) = delete;
    model_values& operator=(const model_values&) = delete;

    /// x: one row of inputs; y: its results.
    encounter evaluate(const float* x, float* y);

private:
    class evaluator;
    std::unique_ptr<evaluator> own_;
};

} // namespace fresnel::emit
