#include "inputs.hpp"
#include "oracles.hpp"
#include "tolerances.hpp"

#include <fresnel/models.hpp>
#include <fresnel/types/strict.hpp>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::test {
namespace {

struct expected_row {
    std::string_view name;
    model_kind kind;
    std::vector<std::string_view> parameters;
};

/// The names that scripts rely on, cos_i left out.
const std::vector<expected_row> promised = {
    {"dielectric", model_kind::exact, {"n_i", "n_t"}},
    {"conductor", model_kind::exact, {"n_i", "n_t", "k_t"}},
    {"dielectric_fast", model_kind::exact, {"n_i", "n_t"}},
    {"conductor_fast", model_kind::exact, {"n_i", "n_t", "k_t"}},
    {"conductor_precise", model_kind::exact, {"n_i", "n_t", "k_t"}},
    {"schlick", model_kind::approximation, {"f0"}},
    {"schlick_f90", model_kind::approximation, {"f0", "f90"}},
    {"schlick_power", model_kind::approximation, {"f0", "f90", "power"}},
    {"schlick_nk", model_kind::approximation, {"n", "k"}},
    {"schlick_internal", model_kind::approximation, {"eta"}},
    {"spherical_gaussian", model_kind::approximation, {"f0"}},
    {"photometric", model_kind::approximation, {"f0"}},
    {"powers_4_8", model_kind::approximation, {"f0"}},
    {"powers_3_9", model_kind::approximation, {"f0"}},
    {"powers_3_6_9", model_kind::approximation, {"f0"}},
    {"one_minus_cos", model_kind::approximation, {}},
    {"constant", model_kind::approximation, {"f0"}},
    {"air_conductor", model_kind::approximation, {"n", "k"}},
    {"lazanyi", model_kind::approximation, {"n", "k", "a", "alpha"}},
    {"gulbrandsen", model_kind::approximation, {"r", "g"}},
    {"f82", model_kind::approximation, {"f0", "f82"}},
    {"f82_tint", model_kind::approximation, {"f0", "tint"}},
    {"hoffman", model_kind::approximation, {"f0", "f82", "f90", "power"}},
    {"powers_4_12", model_kind::approximation, {"f0", "f82"}},
    {"powers_2_8_16", model_kind::approximation, {"f0", "f82"}},
    {"bias_scale_power", model_kind::artistic, {"bias", "scale", "power"}},
};

TEST(registry, holds_exactly_the_promised_models) {
    std::set<std::string_view> names, expected;
    for (const expected_row& row : promised)
        expected.insert(row.name);
    for_each_model(
        [&](const auto& row) { EXPECT_TRUE(names.insert(row.name).second) << row.name << " twice"; });
    EXPECT_EQ(names, expected);
}

TEST(registry, gives_every_model_its_promised_kind_and_parameters_in_order) {
    for_each_model([](const auto& row) {
        const auto found = std::ranges::find(promised, row.name, &expected_row::name);
        ASSERT_NE(found, promised.end()) << row.name;
        EXPECT_EQ(row.kind, found->kind) << row.name;
        std::vector<std::string_view> parameters;
        for (const parameter& p : row.parameters)
            parameters.push_back(p.name);
        EXPECT_EQ(parameters, found->parameters) << row.name;
    });
}

TEST(registry, tells_equation_citation_and_domain_of_every_model) {
    for_each_model([](const auto& row) {
        EXPECT_FALSE(row.equation.empty()) << row.name;
        EXPECT_FALSE(row.citation.empty()) << row.name;
        EXPECT_FALSE(row.domain.empty()) << row.name;
        EXPECT_FALSE(row.error.over.empty()) << row.name;
        for (const std::string_view text : {row.equation, row.citation, row.domain})
            EXPECT_TRUE(std::ranges::all_of(text, [](char c) { return c >= ' ' && c <= '~'; })) << row.name;
    });
}

TEST(registry, has_defaults_inside_their_ranges) {
    for_each_model([](const auto& row) {
        for (const parameter& p : row.parameters) {
            EXPECT_LT(p.min, p.max) << row.name << ' ' << p.name;
            EXPECT_LE(p.min, p.default_value) << row.name << ' ' << p.name;
            EXPECT_GE(p.max, p.default_value) << row.name << ' ' << p.name;
            EXPECT_EQ(p.unit, "1") << row.name << ' ' << p.name;
        }
    });
}

/// The reflectance of an exact model, or the value of any other.
template <class T>
T reflectance(const boundary<T>& y) {
    return y.reflectance();
}
template <class T>
T reflectance(const T& y) {
    return y;
}

template <class T>
T as(double x) {
    if constexpr (std::is_same_v<T, strict>)
        return strict::from(x);
    else
        return static_cast<T>(x);
}

template <class T, class Row>
T value(const Row& row, const std::vector<double>& parameters, double cos_i) {
    std::vector<T> values;
    for (const double x : parameters)
        values.push_back(as<T>(x));
    return reflectance(evaluate(row, values, as<T>(cos_i)));
}

/// Ordinary values of a row's parameters: around the defaults, in numbers that float holds.
template <class Row>
std::vector<double> ordinary(const Row& row, random_numbers& random) {
    std::vector<double> result;
    for (const parameter& p : row.parameters) {
        const double low = std::max(p.min, p.default_value / 3);
        const double high = std::min(p.max, std::max(3 * p.default_value, 1.0));
        result.push_back(static_cast<double>(static_cast<float>(random.uniform(low, high))));
    }
    return result;
}

TEST(registry, gives_every_model_one_value_in_every_number_type) {
    for_each_model([](const auto& row) {
        random_numbers random(3);
        for (int i = 0; i < 4000 / thinning; ++i) {
            const std::vector<double> parameters = ordinary(row, random);
            const double c = static_cast<double>(static_cast<float>(random.uniform(0, 1)));
            std::string input = std::string(row.name) + " at cos_i " + digits(c);
            for (const double p : parameters)
                input += ", " + digits(p);

            const double truth = static_cast<double>(value<real50>(row, parameters, c));
            const double wide = value<double>(row, parameters, c);
            // near a critical angle a root halves the digits: sqrt epsilon
            EXPECT_TRUE(within(wide, truth, 1e-7, input));
            EXPECT_TRUE(within(static_cast<double>(value<float>(row, parameters, c)), truth, 2e-3, input));
            EXPECT_TRUE(exactly(value<strict>(row, parameters, c).value(), wide, input));
        }
    });
}

/// Value at the defaults of a row's parameters.
double at_defaults(std::string_view name, std::vector<double> values, double c) {
    double result = -1;
    for_each_model([&](const auto& row) {
        if (row.name != name) return;
        for (std::size_t i = values.size(); i < row.parameters.size(); ++i) {
            EXPECT_TRUE(row.parameters[i].neutral) << name;
            values.push_back(row.parameters[i].default_value);
        }
        result = value<double>(row, values, c);
    });
    return result;
}

TEST(registry, marks_as_neutral_the_defaults_that_change_nothing) {
    for (const double c : {0.0, 0.1, 0.5, 1.0}) {
        EXPECT_EQ(at_defaults("schlick_f90", {0.2}, c), schlick(0.2, c)) << c;
        EXPECT_NEAR(at_defaults("schlick_power", {0.2}, c), schlick(0.2, c), 1e-15) << c;
        EXPECT_EQ(at_defaults("conductor", {1, 1.5}, c), conductor(1.0, 1.5, 0.0, c).reflectance()) << c;
        EXPECT_EQ(at_defaults("schlick_nk", {1.5}, c), schlick_nk(1.5, 0.0, c)) << c;
        EXPECT_EQ(at_defaults("f82_tint", {0.5}, c), schlick(0.5, c)) << c;
        EXPECT_NEAR(at_defaults("hoffman", {0.5, 0.6}, c), f82(0.5, 0.6, c), 1e-14) << c;
        EXPECT_NEAR(at_defaults("bias_scale_power", {}, c), schlick(0.0, c), 1e-15) << c;
    }
}

} // namespace
} // namespace fresnel::test
