#pragma once

#include "analysis/model_table.hpp"
#include "conform/conform.hpp"
#include "conform/expression.hpp"
#include "conform/program.hpp"
#include "conform/signature.hpp"

#include <fresnel/geometry.hpp>

namespace fresnel::conform {

/// An input of the model: its parameters in each channel, and the angle.
struct sample {
    std::array<std::vector<float>, 3> parameters; ///< by channel, in the order of the registry
    double cos_i = 1;
    vector3<float> normal{0, 0, 1},
        direction{0, 0, 1}; ///< whose cosine cos_i is, where the function takes directions
};

/// How a function's arguments are made from a model's parameters.
class binding {
public:
    /// Picks the overload of the function that fits. Throws bad_input.
    explicit binding(const conform_request& wanted);

    const signature& chosen() const { return chosen_; }
    const std::vector<expression_text>& expressions() const { return expressions_; }
    const model_row<double>& model() const { return *model_; }
    /// Whether it takes directions in place of cos_i.
    bool takes_directions() const { return uses("normal") || uses("direction"); }
    /// Whether parameter i is given to the function.
    bool varies(std::size_t i) const { return varies_[i]; }
    /// Whether parameter i has a value of its own in each channel.
    bool per_channel(std::size_t i) const { return per_channel_[i]; }
    int channels() const;

    /// The function's arguments, one after another.
    std::vector<float> arguments(const sample& s) const;
    /// The cosine that the function is given, or that of its directions, 0 behind the surface.
    double angle(const sample& s) const;
    /// What the model gives, a value for each channel.
    std::vector<double> expected(const sample& s, double cos_i) const;
    /// The text and the call of its function.
    program runnable(const conform_request& wanted) const;

private:
    bool bind(const conform_request& wanted, const signature& s, std::string& why);
    bool uses(std::string_view variable) const;
    void find_variation(const conform_request& wanted);
    double variable(const sample& s, const std::string& name, std::size_t channel) const;

    const model_row<double>* model_;
    signature chosen_;
    std::vector<expression_text> expressions_;
    std::vector<bool> varies_, per_channel_;
};

} // namespace fresnel::conform
