// Fits: the parameters of each model that are closest to a curve.

#include "analysis/compare.hpp"

#include "error.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

namespace {

using namespace fresnel;

// A channel whose curve is a model's own: fitting that model must find its parameters again.
channel made_by(std::string_view model, const parameters& values) {
    channel one{{}, {}, {}, 0, 0, 1};
    for (int i = 0; i <= 360; ++i) {
        one.theta_deg.push_back(0.25 * i);
        one.cos_i.push_back(cosine_of_degrees(one.theta_deg.back()));
    }
    one.R = evaluate(model, values, one.cos_i);
    one.f0 = evaluate(model, values, {1})[0];
    one.f82 = evaluate(model, values, {ratio<double, 1, 7>()})[0];
    return one;
}

TEST(fit, finds_the_parameters_that_made_a_curve) {
    const std::vector<std::pair<const char*, parameters>> cases = {
        {"schlick", {0.3}},           {"schlick_f90", {0.04, 0.6}}, {"schlick_power", {0.5, 1, 7.5}},
        {"f82", {0.55, 0.6}},         {"f82_tint", {0.55, 0.8}},    {"hoffman", {0.55, 0.6, 1, 4}},
        {"powers_4_12", {0.55, 0.6}}, {"gulbrandsen", {0.55, 0.4}}, {"bias_scale_power", {0.1, 0.7, 3}},
        {"dielectric", {1, 1.7}},     {"dielectric", {1, 0.6}},     {"schlick_internal", {0.6}},
    };
    for (const auto& [model, values] : cases) {
        const parameters found = fit(model, made_by(model, values));
        ASSERT_EQ(found.size(), values.size()) << model;
        for (std::size_t i = 0; i < found.size(); ++i)
            EXPECT_NEAR(found[i], values[i], 1e-6) << model << " " << i;
    }
}

// Lazanyi's n and k are not determined by the curve, but the curve is.
TEST(fit, of_lazanyi_follows_a_curve_that_lazanyi_made) {
    const edge_tint index = index_of(0.6, 0.3);
    const channel one = made_by("lazanyi", {index.n, index.k, 1.5, 7});
    const parameters found = fit("lazanyi", one);
    EXPECT_NEAR(found[2], 1.5, 1e-4);
    EXPECT_NEAR(found[3], 7, 1e-4);
    const std::vector<double> again = evaluate("lazanyi", found, one.cos_i);
    for (std::size_t i = 0; i < again.size(); ++i)
        EXPECT_NEAR(again[i], one.R[i], 1e-6);
}

TEST(fit, keeps_every_parameter_inside_its_registry_range) {
    for (const char* name : {"gold", "caesium", "silicon", "diamond", "vacuum", "air"}) {
        const comparison result = compare(*find_material(name), color_space::srgb, 1);
        for (const model_fit& m : result.models) {
            const std::span<const parameter> wanted = find_model<double>(m.name).parameters;
            for (const parameters& values : m.values)
                for (std::size_t i = 0; i < values.size(); ++i) {
                    EXPECT_GE(values[i], wanted[i].min) << name << " " << m.name << " " << wanted[i].name;
                    EXPECT_LE(values[i], wanted[i].max) << name << " " << m.name << " " << wanted[i].name;
                }
        }
    }
}

double squares(std::string_view model, const parameters& values, const channel& exact) {
    const std::vector<double> R = evaluate(model, values, exact.cos_i);
    double sum = 0;
    for (std::size_t i = 0; i < R.size(); ++i)
        sum += square(R[i] - exact.R[i]);
    return sum;
}

/// The channels of every seventh built-in material, the whole of each curve.
std::vector<channel> some_channels() {
    std::vector<channel> channels;
    for (std::size_t m = 0; m < builtin_materials().size(); m += 7) {
        const comparison of = compare(builtin_materials()[m], color_space::srgb, 1);
        for (std::size_t i = 0; i < 3; ++i)
            channels.push_back(channel_of(of.exact, of.colour.f0, of.colour.f82, 1, i));
    }
    return channels;
}

/// Checks that no parameters of the scan, a function of u in [0, 1], beat those that the fit found.
void expect_best(std::string_view model, const channel& exact, const parameters& found,
                 const std::function<parameters(double u)>& scan) {
    constexpr int steps = 128;
    const double least = squares(model, found, exact);
    for (int i = 0; i <= steps; ++i) {
        const parameters other = scan(static_cast<double>(i) / steps);
        ASSERT_LE(least, squares(model, other, exact) * (1 + 1e-6) + 1e-20)
            << model << " f0 " << exact.f0 << ", found " << found.back() << ", better " << other.back();
    }
}

TEST(fit, is_never_worse_than_a_scan_of_what_is_free) {
    for (const channel& one : some_channels()) {
        const edge_tint tint = fit_gulbrandsen(one);
        const double f0 = std::clamp(one.f0, 0.0, 1.0), f82 = std::clamp(one.f82, 0.0, 1.0);
        const auto check = [&](std::string_view model, const std::function<parameters(double)>& scan) {
            expect_best(model, one, fit(model, one, tint), scan);
        };
        check("schlick_power", [&](double u) { return parameters{f0, 1, std::exp2(8 * u - 3)}; });
        check("schlick_f90", [&](double u) { return parameters{f0, u}; });
        check("hoffman", [&](double u) { return parameters{f0, f82, 1, std::exp2(8 * u - 3)}; });
        check("gulbrandsen", [&](double u) { return parameters{f0, 1 - std::exp2(-30 * u)}; });
        const double n_max = (1 + std::sqrt(f0)) / (1 - std::sqrt(f0));
        if (f0 < 0.999)
            check("gulbrandsen", [&](double u) {
                const double n_min = (1 - f0) / (1 + f0), n = n_min * std::pow(n_max / n_min, u);
                return parameters{f0, std::clamp((n_max - n) / (n_max - n_min), 0.0, 1.0)};
            });
    }
}

// Given alpha, the best a of Lazanyi's term is a projection, but for the clamp to [0, 1] of the whole.
TEST(fit, of_lazanyi_is_never_worse_than_a_scan) {
    for (const channel& one : some_channels()) {
        const edge_tint tint = fit_gulbrandsen(one);
        expect_best("lazanyi", one, fit("lazanyi", one, tint), [&](double u) {
            const double alpha = std::exp2(12 * u - 3);
            double dot = 0, norm = 0;
            for (std::size_t i = 0; i < one.R.size(); ++i) {
                const double c = one.cos_i[i], term = c * std::pow(1 - c, alpha);
                dot += (schlick_nk(tint.n, tint.k, c) - one.R[i]) * term, norm += square(term);
            }
            return parameters{tint.n, tint.k, std::clamp(dot / norm, 0.0, 2000.0), alpha};
        });
    }
}

// Given the power, the best bias and scale are those of a line.
TEST(fit, of_bias_and_scale_is_never_worse_than_a_scan) {
    for (const channel& one : some_channels()) {
        expect_best("bias_scale_power", one, fit("bias_scale_power", one), [&](double u) {
            const double power = std::exp2(8 * u - 3), count = static_cast<double>(one.R.size());
            double x = 0, y = 0, xx = 0, xy = 0;
            for (std::size_t i = 0; i < one.R.size(); ++i) {
                const double term = std::pow(1 - one.cos_i[i], power);
                x += term, y += one.R[i], xx += term * term, xy += term * one.R[i];
            }
            const double scale = std::clamp((xy - x * y / count) / (xx - x * x / count), -10.0, 10.0);
            return parameters{std::clamp((y - scale * x) / count, -10.0, 10.0), scale, power};
        });
    }
}

TEST(fit, of_f82_is_closer_in_the_mean_than_the_exact_f82) {
    int closer = 0;
    for (const channel& one : some_channels())
        for (const std::string_view model : {"f82", "powers_4_12", "powers_2_8_16"}) {
            const parameters found = fit_f82(model, one);
            expect_best(model, one, found, [&](double u) { return parameters{found[0], u}; });
            closer += squares(model, found, one) < 0.99 * squares(model, fit(model, one), one) ? 1 : 0;
        }
    EXPECT_GT(closer, 30);
    EXPECT_THROW(fit_f82("schlick", some_channels()[0]), bad_input);
}

} // namespace
