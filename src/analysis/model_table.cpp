#include "analysis/model_table.hpp"

#include "analysis/multi.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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

// Remembers what it was made of, so that the operations a result needs can be counted afterwards; what it does not
// need, a compiler drops. A constant is a number made of integers alone: every compiler folds those, so they are free.
struct counting {
    struct step {
        operation_count cost;
        std::array<std::size_t, 3> operands; ///< indices into steps; 0 is an input
    };
    static inline std::vector<step> steps;

    double value;
    std::size_t made_by = 0;
    bool constant = false;

    counting(int v) : value(v), constant(true) {}
    explicit counting(double v) : value(v) {}

    template <class... Operands>
    static counting made(double v, operation_count cost, Operands... operands) {
        counting result(v);
        result.constant = (operands.constant && ...);
        if (result.constant) return result;
        steps.push_back({cost, {operands.made_by...}});
        result.made_by = steps.size() - 1;
        return result;
    }
    static constexpr operation_count cheap{1, 0, 0, 0, 0}, division{0, 1, 0, 0, 0}, root{0, 0, 1, 0, 0},
        exponential{0, 0, 0, 1, 0}, power{0, 0, 0, 0, 1};

    friend counting operator+(counting a, counting b) { return made(a.value + b.value, cheap, a, b); }
    friend counting operator-(counting a, counting b) { return made(a.value - b.value, cheap, a, b); }
    friend counting operator-(counting a) { return made(-a.value, {}, a); }
    friend counting operator*(counting a, counting b) { return made(a.value * b.value, cheap, a, b); }
    // by a power of two it is a multiplication
    friend counting operator/(counting a, counting b) {
        int exponent = 0;
        const bool exact = b.constant && std::frexp(b.value, &exponent) == 0.5;
        return made(a.value / b.value, exact ? cheap : division, a, b);
    }
    friend counting operator<(counting a, counting b) {
        return made(a.value < b.value ? 1.0 : 0.0, cheap, a, b);
    }
    friend counting operator>(counting a, counting b) { return b < a; }
    friend counting operator<=(counting a, counting b) {
        return made(a.value <= b.value ? 1.0 : 0.0, cheap, a, b);
    }
    friend counting select(counting mask, counting a, counting b) {
        return made(mask.value != 0 ? a.value : b.value, cheap, mask, a, b);
    }
    friend counting min(counting a, counting b) { return made(std::min(a.value, b.value), cheap, a, b); }
    friend counting max(counting a, counting b) { return made(std::max(a.value, b.value), cheap, a, b); }
    friend counting abs(counting a) { return made(std::abs(a.value), {}, a); }
    friend counting sqrt(counting a) { return made(std::sqrt(a.value), root, a); }
    friend counting exp2(counting a) { return made(std::exp2(a.value), exponential, a); }
    [[maybe_unused]] friend counting log2(counting a) { return made(std::log2(a.value), exponential, a); }
    friend counting pow(counting a, counting b) { return made(std::pow(a.value, b.value), power, a, b); }

    // The operations behind one result, each once however often its value is used.
    operation_count needed() const {
        std::vector<bool> wanted(made_by + 1);
        wanted[made_by] = true;
        operation_count sum{};
        for (std::size_t i = made_by; i > 0; --i) {
            if (!wanted[i]) continue;
            sum.cheap += steps[i].cost.cheap, sum.division += steps[i].cost.division;
            sum.root += steps[i].cost.root;
            sum.exponential += steps[i].cost.exponential, sum.power += steps[i].cost.power;
            for (const std::size_t operand : steps[i].operands)
                wanted[operand] = true;
        }
        return sum;
    }
};

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
template const model_row<float>& find_model(std::string_view);
template const model_row<double>& find_model(std::string_view);
template const model_row<real50>& find_model(std::string_view);

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

operation_count count_operations(std::string_view name) {
    const model_row<double>& model = find_model<double>(name);
    counting::steps.assign(1, {});
    std::vector<counting> values;
    for (const parameter& p : model.parameters)
        values.emplace_back(p.default_value);
    operation_count count{};
    for_each_model([&](const auto& row) {
        if (row.name != name) return;
        count = reflectance(evaluate(row, values, counting(0.5))).needed();
    });
    return count;
}

} // namespace fresnel
