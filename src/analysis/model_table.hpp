#pragma once

#include <fresnel/models.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

/// A row of the registry that can be picked by name at run time and evaluated as T: float, double or real50.
/// An approximation fills R_s and R_p with its one reflectance, and the transmittances with what is left.
template <class T>
struct model_row {
    std::string_view name;
    model_kind kind;
    std::string_view summary;
    std::string_view equation;
    std::span<const parameter> parameters;
    std::string_view citation;
    std::string_view domain;
    model_error error;
    boundary<T> (*evaluate)(const T* parameters, T cos_i);

    bool polarised() const { return kind == model_kind::exact; }
};

/// Every model, in the order of the registry.
template <class T>
const std::vector<model_row<T>>& model_table();

/// The model of that name; throws bad_input with the nearest name where there is none.
template <class T>
const model_row<T>& find_model(std::string_view name);

/// Checks a value against the parameter's range: throws bad_input that names parameter, value and range.
void check_range(const parameter& p, double value);

/// The argument every model has beside its parameters.
inline constexpr parameter cosine{"cos_i", "1", 0, 1, 1};

std::string_view to_string(model_kind kind);

/// Operations that one unpolarised reflectance needs, counted by running the model on a number that remembers how
/// it was made: + - * comparisons and selections are 1, a division, square root, exp2 or log2 is 4 and a pow 9, the
/// rates of a graphics processor; a change of sign is free. For a model of several channels the caller multiplies.
struct operation_count {
    int cheap, division, root, exponential, power;
    int cost() const { return cheap + 4 * (division + root + exponential) + 9 * power; }
};

operation_count count_operations(std::string_view model);

} // namespace fresnel
