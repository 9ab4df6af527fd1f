#pragma once

#include <fresnel/models.hpp>

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

/// A row of the registry that can be picked by name at run time and evaluated as T: float, double, real50 or sym.
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
inline constexpr const parameter& cosine = row::cos_i;

/// Whether it is the index in front, which is one number where the others are RGB.
inline bool is_ambient(const parameter& p) { return p.name == std::string_view("n_i"); }

std::string_view to_string(model_kind kind);

} // namespace fresnel
