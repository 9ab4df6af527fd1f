#pragma once

#include "conform/binding.hpp"

#include <random>

namespace fresnel::conform {

/// Inputs for a function, the same in every run.
class sampler {
public:
    /// Throws bad_input where a range of the request is none of the model's.
    sampler(const conform_request& wanted, const binding& bound);

    /// In [0, 1] of cos_i: edges, critical and Brewster angles, random values.
    std::vector<sample> inside(std::size_t n);
    /// A rounding error outside of [0, 1]; of directions, anywhere behind the surface.
    std::vector<sample> beyond(std::size_t n);
    /// Sweeps of the angle in even steps from grazing to normal incidence, each with parameters of its own.
    std::vector<sample> sweeps(std::size_t count, std::size_t steps);

private:
    struct column {
        float low, high;
        std::vector<float> edges;
        bool varies, per_channel;
    };
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_() % n); }
    float uniform(float lo, float hi);
    float value(const column& c, bool edge);
    sample parameters(bool edge);
    double special_cosine(const sample& s);

    const binding& bound_;
    std::vector<column> columns_;
    std::mt19937 engine_{20240917};
};

/// The same sample at another angle; its directions turned so that their cosine is what cos_i then says.
sample turned(sample s, double cos_i);

} // namespace fresnel::conform
