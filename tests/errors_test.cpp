// The error in each registry row, measured again: the same number but for rounding up to three digits.

#include "analysis/curve.hpp"
#include "analysis/fit.hpp"
#include "analysis/measure.hpp"
#include "analysis/multi.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <limits>
#include <random>

namespace {

using namespace fresnel;

constexpr double rounded_up = 0.01; // relative: a unit of the third digit

std::vector<double> cosines() {
    std::vector<double> c;
    for (int i = 0; i <= 4000; ++i)
        c.push_back(square(i / 4000.0)); // denser towards grazing
    return c;
}

// Largest difference of two curves over all angles.
template <class F, class G>
double largest(F model, G exact) {
    static const std::vector<double> all = cosines();
    double worst = 0;
    for (const double c : all)
        worst = std::max(worst, std::abs(model(c) - exact(c)));
    return worst;
}

double over_gems(std::string_view name) {
    const auto evaluate_one = find_model<double>(name).evaluate;
    double worst = 0;
    for (int i = 0; i <= 120; ++i) {
        const double eta = 1.3 + 0.01 * i, f0 = normal_reflectance(1.0, eta, 0.0);
        const std::array<double, 3> values = {f0, 1, 5};
        worst =
            std::max(worst, largest([&](double c) { return evaluate_one(values.data(), c).reflectance(); },
                                    [&](double c) { return dielectric(1.0, eta, c).reflectance(); }));
    }
    return worst;
}

double over_internal_gems() {
    double worst = 0;
    for (int i = 0; i <= 120; ++i) {
        const double eta = 1 / (1.3 + 0.01 * i);
        worst = std::max(worst, largest([&](double c) { return schlick_internal(eta, c); },
                                        [&](double c) { return dielectric(1.0, eta, c).reflectance(); }));
    }
    return worst;
}

double over_box(std::string_view name) {
    const auto evaluate_one = find_model<double>(name).evaluate;
    double worst = 0;
    for (int i = 0; i <= 39; ++i)
        for (int j = 0; j <= 35; ++j) {
            const std::array<double, 2> nk = {0.1 + 0.1 * i, 1 + 0.2 * j};
            worst = std::max(
                worst, largest([&](double c) { return evaluate_one(nk.data(), c).reflectance(); },
                               [&](double c) { return conductor(1.0, nk[0], nk[1], c).reflectance(); }));
        }
    return worst;
}

double over_metals(std::string_view name) {
    double worst = 0;
    for (const material_sample& metal : metal_samples()) {
        const channel one = channel_of(metal.index);
        const std::vector<double> R = evaluate(name, fit(name, one), one.cos_i);
        for (std::size_t i = 0; i < R.size(); ++i)
            worst = std::max(worst, std::abs(R[i] - one.R[i]));
    }
    return worst;
}

// Incidences of every kind: random ones, next to an index match and to the critical angle, grazing, with faint and
// strong absorption.
class incidences {
public:
    std::array<double, 4> next() {
        const double n_i = 0.5 + 2 * unit();
        const double eta =
            unit() < 0.3 ? 1 + (unit() - 0.5) * small() : std::exp((2 * unit() - 1) * std::log(10));
        const double k = unit() < 0.5 ? 0 : n_i * 100 * small();
        const double critical = std::sqrt(std::max((1 - eta) * (1 + eta), 0.0));
        const double how = unit();
        const double c = how < 0.4   ? unit()
                         : how < 0.6 ? small()
                         : how < 0.7 ? 1 - small()
                                     : critical + (unit() - 0.5) * small();
        return {n_i, n_i * eta, k, std::clamp(c, 0.0, 1.0)};
    }

private:
    double unit() { return std::uniform_real_distribution<double>(0, 1)(generator_); }
    double small() { return std::exp2(-44 * unit()); }

    std::mt19937_64 generator_{7};
};

// Whether a row promises its error there.
bool promised(std::string_view over, const std::array<double, 4>& x) {
    const double eta = x[1] / x[0], k = x[2] / x[0];
    const double critical = eta < 1 ? std::sqrt((1 - eta) * (1 + eta)) : -1;
    if (eta < 0.1 || eta > 10) return false;
    if (over == row::everywhere) return true;
    return (k >= 0.1 || std::abs(x[3] - critical) >= 1e-3) &&
           (over != row::apart || k >= 1e-3 || std::abs(eta - 1) >= 1e-3);
}

// Exact models against 50 digits.
double over_rounding(const model_row<double>& model) {
    const model_row<real50>& truth = find_model<real50>(model.name);
    incidences all;
    double worst = 0;
    for (int i = 0; i < 40000; ++i) {
        std::array<double, 4> x = all.next();
        if (model.parameters.size() == 2) x[2] = 0;
        if (!promised(model.error.over, x)) continue;
        const std::array<real50, 3> exact = {real50(x[0]), real50(x[1]), real50(x[2])};
        const double R = model.evaluate(x.data(), x[3]).reflectance();
        worst = std::max(worst, std::abs(static_cast<double>(
                                    R - truth.evaluate(exact.data(), real50(x[3])).reflectance())));
    }
    return worst;
}

double measured(const model_row<double>& row) {
    if (row.kind == model_kind::exact) return over_rounding(row);
    if (row.error.over == row::gems) return over_gems(row.name);
    if (row.error.over == row::inside_gems) return over_internal_gems();
    if (row.error.over == row::box) return over_box(row.name);
    if (row.error.over == row::metals) return over_metals(row.name);
    return std::numeric_limits<double>::quiet_NaN();
}

TEST(errors, every_registry_row_states_the_error_that_is_measured) {
    for (const model_row<double>& row : model_table<double>()) {
        const double error = measured(row);
        std::printf("%-20s %.3g  %s\n", std::string(row.name).c_str(), error,
                    std::string(row.error.over).c_str());
        if (row.error.max < 1e-5) { // rounding: of that size, not that number in every build
            EXPECT_LE(error, row.error.max) << row.name;
            EXPECT_GE(error, row.error.max / 50) << row.name;
        } else {
            EXPECT_LE(error, row.error.max) << row.name;
            EXPECT_GE(error, row.error.max * (1 - rounded_up)) << row.name;
        }
    }
}

} // namespace
