#include "analysis/model_table.hpp"

#include "analysis/multi.hpp"
#include "error.hpp"

#include <fresnel/types/sym.hpp>

#include <fmt/format.h>

namespace fresnel {

namespace {

template <class T>
boundary<T> as_boundary(boundary<T> exact) {
    return exact;
}

template <class T>
boundary<T> as_boundary(T reflectance) {
    return {reflectance, reflectance, 1 - reflectance, 1 - reflectance};
}

// Each row's callable is known at compile time by its place in the registry, so a plain function pointer can
// stand for it.
template <class T, std::size_t i>
boundary<T> evaluate_row(const T* parameters, T cos_i) {
    return as_boundary<T>(evaluate(std::get<i>(registry), parameters, cos_i));
}

template <class T, std::size_t i>
model_row<T> make_row() {
    constexpr const auto& row = std::get<i>(registry);
    return {row.name,     row.kind,   row.summary, row.equation,       row.parameters,
            row.citation, row.domain, row.error,   &evaluate_row<T, i>};
}

template <class T>
std::vector<model_row<T>> make_table() {
    return []<std::size_t... i>(std::index_sequence<i...>) {
        return std::vector<model_row<T>>{make_row<T, i>()...};
    }(std::make_index_sequence<std::tuple_size_v<decltype(registry)>>{});
}

} // namespace

template <class T>
const std::vector<model_row<T>>& model_table() {
    static const std::vector<model_row<T>> table = make_table<T>();
    return table;
}

template <class T>
const model_row<T>& find_model(std::string_view name) {
    for (const model_row<T>& row : model_table<T>())
        if (row.name == name) return row;
    std::vector<std::string> names;
    for (const model_row<T>& row : model_table<T>())
        names.emplace_back(row.name);
    throw bad_input(
        fmt::format("model '{}' is unknown{}; `fresnel models` lists them", name, did_you_mean(name, names)));
}

template const std::vector<model_row<float>>& model_table();
template const std::vector<model_row<double>>& model_table();
template const std::vector<model_row<real50>>& model_table();
template const std::vector<model_row<sym>>& model_table();
template const model_row<float>& find_model(std::string_view);
template const model_row<double>& find_model(std::string_view);
template const model_row<real50>& find_model(std::string_view);
template const model_row<sym>& find_model(std::string_view);

void check_range(const parameter& p, double value) {
    if (value >= p.min && value <= p.max) return;
    throw bad_input(fmt::format("{} = {}: must be in [{}, {}]", p.name, value, p.min, p.max));
}

std::string_view to_string(model_kind kind) {
    switch (kind) {
    case model_kind::exact:
        return "exact";
    case model_kind::approximation:
        return "approximation";
    case model_kind::artistic:
        return "artistic";
    }
    return "";
}

} // namespace fresnel
