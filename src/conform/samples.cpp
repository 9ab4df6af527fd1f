#include "conform/samples.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fresnel::conform {

namespace {

/// What a parameter is tried over where nothing else is asked for: wide, but where float32 has room for any sensible
/// arrangement of the equations.
std::array<double, 2> usual_range(const parameter& p) {
    if (p.name == "n_i") return {1, 3};
    if (p.name == "n_t" || p.name == "n") return {0.25, 5};
    if (p.name == "k_t" || p.name == "k") return {0, 10};
    if (p.name == "eta") return {0.25, 1};
    if (p.name == "power" || p.name == "alpha") return {1, 10};
    if (p.name == "a") return {0, 2};
    if (p.name == "r") return {0.001, 1}; // at 0 the index is 1, and grazing incidence any value
    if (p.name == "bias") return {-1, 1};
    if (p.name == "scale") return {-2, 2};
    return {p.min, p.max};
}

std::array<double, 2> range_of(const parameter& p, const conform_request& wanted) {
    const auto given = wanted.ranges.find(std::string(p.name));
    if (given == wanted.ranges.end()) return usual_range(p);
    for (const double end : given->second)
        check_range(p, end);
    if (given->second[0] > given->second[1])
        throw bad_input(
            fmt::format("--range {} = {},{}: must rise", p.name, given->second[0], given->second[1]));
    return given->second;
}

} // namespace

sampler::sampler(const conform_request& wanted, const binding& bound) : bound_(bound) {
    const auto& parameters = bound.model().parameters;
    for (const auto& [name, range] : wanted.ranges)
        if (std::none_of(parameters.begin(), parameters.end(),
                         [&](const parameter& p) { return p.name == name; }))
            throw bad_input(fmt::format("--range '{}': {} has no such parameter", name, bound.model().name));
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const parameter& p = parameters[i];
        const auto fixed = wanted.fixed.find(std::string(p.name));
        const double constant = fixed == wanted.fixed.end() ? p.default_value : fixed->second;
        const auto [low, high] = bound.varies(i) ? range_of(p, wanted) : std::array{constant, constant};
        column c{
            static_cast<float>(low), static_cast<float>(high), {}, bound.varies(i), bound.per_channel(i)};
        for (const float x : {c.low, c.high, 0.0f, 1e-4f, 0.04f, 0.5f, 2.0f / 3, 1 - 1e-4f, 1 - 0x1p-24f,
                              1.0f, 1 + 0x1p-23f, 1 + 1e-6f, 1 + 1e-4f, 1.5f, 5.0f})
            if (x >= c.low && x <= c.high) c.edges.push_back(x);
        columns_.push_back(c);
    }
}

float sampler::uniform(float lo, float hi) {
    return lo + (hi - lo) * (static_cast<float>(engine_() >> 8) * 0x1p-24f);
}

float sampler::value(const column& c, bool edge) {
    if (!c.varies) return c.low;
    if (edge) return c.edges[below(static_cast<std::uint32_t>(c.edges.size()))];
    const float near_one = 1 + std::ldexp(uniform(-1, 1), -static_cast<int>(below(20)));
    if (below(8) == 0 && near_one >= c.low && near_one <= c.high) return near_one;
    return uniform(c.low, c.high);
}

sample sampler::parameters(bool edge) {
    sample s;
    for (std::vector<float>& channel : s.parameters)
        channel.reserve(columns_.size());
    for (const column& c : columns_)
        for (std::size_t channel = 0; channel < 3; ++channel)
            s.parameters[channel].push_back(c.per_channel || channel == 0 ? value(c, edge)
                                                                          : s.parameters[0].back());
    const float z = uniform(-1, 1), turn = uniform(0, 6.28f), r = std::sqrt(1 - z * z);
    s.normal = {r * std::cos(turn), r * std::sin(turn), z};
    return s;
}

double sampler::special_cosine(const sample& s) {
    double n = 1.5, n_i = 1;
    const auto& parameters = bound_.model().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        const auto x = static_cast<double>(s.parameters[0][i]);
        if (parameters[i].name == "n_i") n_i = x;
        if (parameters[i].name == "n_t" || parameters[i].name == "n" || parameters[i].name == "eta") n = x;
    }
    const double eta = n / n_i;
    const double at = eta < 1 ? critical_cosine(eta) : brewster_cosine(eta);
    return std::clamp(
        at + static_cast<double>(uniform(-1, 1)) * std::ldexp(1.0, -static_cast<int>(below(24))), 0.0, 1.0);
}

std::vector<sample> sampler::inside(std::size_t n) {
    constexpr std::array edges = {0.0, 0x1p-24, 1e-4, 1.0 / 7, 0.5, 1 - 1e-4, 1 - 0x1p-24, 1.0};
    std::vector<sample> all;
    for (std::size_t i = 0; i < n; ++i) {
        const sample s = parameters(i < n / 4);
        double cos_i = static_cast<double>(uniform(0, 1));
        if (i % 4 == 0) cos_i = edges[below(edges.size())];
        if (i % 8 == 1) cos_i = special_cosine(s);
        all.push_back(turned(s, cos_i));
    }
    return all;
}

std::vector<sample> sampler::beyond(std::size_t n) {
    std::vector<sample> all;
    for (std::size_t i = 0; i < n; ++i) {
        const sample s = parameters(i < n / 2);
        const double off =
            static_cast<double>(uniform(1, 8)) * std::ldexp(1.0, -static_cast<int>(17 + below(7)));
        const bool behind = bound_.takes_directions();
        all.push_back(turned(s, behind ? -static_cast<double>(uniform(0, 1)) : i % 2 == 0 ? 1 + off : -off));
    }
    return all;
}

std::vector<sample> sampler::sweeps(std::size_t count, std::size_t steps) {
    std::vector<sample> all;
    for (std::size_t k = 0; k < count; ++k) {
        const sample s = parameters(false);
        for (std::size_t i = 0; i <= steps; ++i)
            all.push_back(turned(s, static_cast<double>(i) / static_cast<double>(steps)));
    }
    return all;
}

sample turned(sample s, double cos_i) {
    const auto c = static_cast<float>(cos_i);
    const vector3<float> n = s.normal;
    // across the normal: its cross product with the axis that is farthest from it
    const bool x_small = std::abs(n.x) < 0.6f;
    vector3<float> t = x_small ? vector3<float>{0, n.z, -n.y} : vector3<float>{-n.z, 0, n.x};
    t = 1 / std::sqrt(dot(t, t)) * t;
    s.direction = c * n + std::sqrt(std::max(1 - c * c, 0.0f)) * t;
    s.cos_i = static_cast<double>(c);
    return s;
}

} // namespace fresnel::conform
