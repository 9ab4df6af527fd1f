#include "command.hpp"
#include "tolerances.hpp"

#include "analysis/fit.hpp"
#include "analysis/measure.hpp"
#include "analysis/model_table.hpp"
#include "analysis/prove.hpp"
#include "error.hpp"
#include "materials/catalog.hpp"

#include <fresnel/approx.hpp>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace {

using namespace fresnel;

// ---- one index --------------------------------------------------------------------------------------------

class proofs_over_the_index : public testing::TestWithParam<const char*> {};

TEST_P(proofs_over_the_index, are_narrow) {
    const certificate c = prove(GetParam());
    EXPECT_TRUE(c.proved);
    EXPECT_LE(c.absolute.hi - c.absolute.lo, 5e-6);
    EXPECT_LE(c.relative->lo, c.relative->hi);
    ASSERT_EQ(c.at.size(), 2u);
    EXPECT_GE(c.at[0].second, 1.3);
    EXPECT_LE(c.at[0].second, 2.5);
}

TEST_P(proofs_over_the_index, are_of_errors_that_are_attained) {
    const certificate c = prove(GetParam());
    const double eta = c.at[0].second, cos_i = c.at[1].second;
    std::vector<double> values;
    for (const parameter& p : find_model<double>(c.model).parameters)
        values.push_back(values.empty() ? normal_reflectance(1.0, eta, 0.0) : p.default_value);
    const double model = find_model<double>(c.model).evaluate(values.data(), cos_i).reflectance();
    EXPECT_NEAR(std::abs(model - dielectric(1.0, eta, cos_i).reflectance()), c.absolute.lo, 1e-9);
}

INSTANTIATE_TEST_SUITE_P(models, proofs_over_the_index,
                         testing::Values("schlick", "schlick_f90", "spherical_gaussian", "photometric",
                                         "powers_4_8", "powers_3_9", "powers_3_6_9", "one_minus_cos",
                                         "constant"));

TEST(prove, is_never_exceeded_on_a_dense_grid) {
    const certificate c = prove("schlick");
    for (int i = 0; i <= 120; ++i) {
        const double eta = 1.3 + 0.01 * i;
        EXPECT_LE(schlick_error(eta).size(), c.absolute.hi) << eta;
        EXPECT_LE(schlick_relative_error(eta).size(), c.relative->hi) << eta;
    }
}

// ---- n and k ----------------------------------------------------------------------------------------------

class proofs_over_n_and_k : public testing::TestWithParam<const char*> {};

TEST_P(proofs_over_n_and_k, are_narrow_attained_and_never_exceeded) {
    const certificate c = prove(GetParam());
    EXPECT_TRUE(c.proved);
    EXPECT_LE(c.absolute.hi - c.absolute.lo, 5e-6);
    EXPECT_LE(c.relative->hi - c.relative->lo, 1e-4);
    const model_row<double>& row = find_model<double>(c.model);

    const auto exact = [](const auto& x) { return conductor(1.0, x[0], x[1], x[2]).reflectance(); };
    const auto error = [&](const auto& x) {
        return std::abs(row.evaluate(x.data(), x[2]).reflectance() - exact(x));
    };
    ASSERT_EQ(c.at.size(), 3u);
    EXPECT_NEAR(error(std::array{c.at[0].second, c.at[1].second, c.at[2].second}), c.absolute.lo, 1e-12);
    for (int i = 0; i <= 39; ++i)
        for (int j = 0; j <= 35; ++j)
            for (int l = 0; l <= 50; ++l) {
                const std::array x = {0.1 + 0.1 * i, 1 + 0.2 * j, 0.02 * l};
                ASSERT_LE(error(x), c.absolute.hi) << x[0] << " " << x[1] << " " << x[2];
                ASSERT_LE(error(x) / exact(x), c.relative->hi) << x[0] << " " << x[1] << " " << x[2];
            }
}

INSTANTIATE_TEST_SUITE_P(models, proofs_over_n_and_k, testing::Values("schlick_nk", "air_conductor"));

// ---- fitted models ----------------------------------------------------------------------------------------

TEST(prove, of_a_fitted_model_names_the_metal_and_is_its_error) {
    const certificate c = prove("f82");
    EXPECT_TRUE(c.proved);
    EXPECT_LE(c.absolute.hi - c.absolute.lo, 1e-4);
    EXPECT_NE(c.material.find(" nm"), std::string::npos);
    double worst = 0;
    for (const material_sample& m : metal_samples()) {
        const parameters p = fit("f82", channel_of(m.index));
        worst = std::max(worst, largest([&](double x) {
                                    return f82(p[0], p[1], x) -
                                           conductor(1.0, m.index.n, m.index.k, x).reflectance();
                                }).size());
    }
    EXPECT_NEAR(worst, c.absolute.lo, 1e-4);
}

TEST(prove, certifies_each_metal_by_itself_at_a_point_that_attains_it) {
    const certificate c = prove("hoffman");
    const std::vector<material_sample>& samples = metal_samples();
    const model_row<double>& row = find_model<double>("hoffman");
    ASSERT_EQ(c.materials.size(), samples.size());
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const certified_material& m = c.materials[i];
        EXPECT_EQ(m.name, samples[i].name);
        EXPECT_LE(m.absolute.hi - m.absolute.lo, 1e-4);
        EXPECT_LE(m.absolute.hi, c.absolute.hi);
        ASSERT_EQ(m.at.size(), 5u);
        std::vector<double> values;
        for (const auto& [name, value] : m.at)
            values.push_back(value);
        const double exact = conductor(1.0, samples[i].index.n, samples[i].index.k, values[4]).reflectance();
        EXPECT_NEAR(std::abs(row.evaluate(values.data(), values[4]).reflectance() - exact), m.absolute.lo,
                    1e-12)
            << m.name;
    }
}

TEST(prove, holds_gulbrandsen_to_the_rounding_of_its_fits) {
    const certificate c = prove("gulbrandsen");
    EXPECT_TRUE(c.proved);
    EXPECT_LE(c.absolute.hi, find_model<double>("gulbrandsen").error.max);
    EXPECT_EQ(c.materials.size(), metal_samples().size());
}

TEST(prove, certifies_every_built_in_material_with_every_fitted_model) {
    std::vector<material> all;
    for (const material& m : builtin_materials())
        if (normal_reflectance(1.0, index_at(m, 550).n, index_at(m, 550).k) > 1e-3) all.push_back(m);
    ASSERT_GE(all.size(), builtin_materials().size() - 3) << "vacuum and air";
    for (const model_row<double>& row : model_table<double>()) {
        if (!can_fit(row.name)) {
            EXPECT_THROW(prove(row.name, all), bad_input) << row.name;
            continue;
        }
        if (row.error.over != row::metals) continue;
        const certificate c = prove(row.name, all);
        EXPECT_TRUE(c.proved);
        ASSERT_EQ(c.materials.size(), 3 * all.size());
        for (std::size_t i = 0; i < c.materials.size(); ++i) {
            const certified_material& m = c.materials[i];
            EXPECT_EQ(m.name, all[i / 3].name);
            EXPECT_LE(m.absolute.hi - m.absolute.lo, 1e-4) << c.model << " " << m.name;
            EXPECT_LE(m.absolute.hi, c.absolute.hi);
            if (m.absolute.lo == 0) continue; // attained nowhere for certain
            std::vector<double> values;
            for (const auto& [name, value] : m.at)
                values.push_back(value);
            const optical_index index = index_at(all[i / 3], m.wavelength_nm);
            const double exact = conductor(1.0, index.n, index.k, values.back()).reflectance();
            EXPECT_NEAR(std::abs(row.evaluate(values.data(), values.back()).reflectance() - exact),
                        m.absolute.lo, 1e-12)
                << c.model << " " << m.name;
        }
    }
}

TEST(prove, refuses_materials_without_a_boundary_or_with_a_critical_angle) {
    const auto of_index = [](double n, double k) {
        material m;
        m.name = "mine", m.kind = material_kind::spectral;
        m.n = samples{{400, 700}, {n, n}}, m.k = samples{{400, 700}, {k, k}};
        return std::vector{m};
    };
    EXPECT_TRUE(prove("f82", of_index(1.5, 0)).proved);
    EXPECT_TRUE(prove("f82", of_index(0.5, 0.001)).proved);
    for (const auto& [n, k] : {std::pair{1.0, 0.0}, {1.01, 0.0}, {0.5, 0.0}, {-1.5, 0.1}})
        EXPECT_THROW(prove("f82", of_index(n, k)), bad_input) << n << " " << k;
}

TEST(prove, is_what_the_registry_states_rounded_up_to_three_digits) {
    for (const certificate& c : prove_all()) {
        const double stated = find_model<double>(c.model).error.max;
        if (!c.proved) {
            EXPECT_EQ(c.absolute.hi, stated) << c.model;
            continue;
        }
        EXPECT_LE(c.absolute.hi, stated) << c.model;
        EXPECT_LE(c.absolute.hi - c.absolute.lo, 1e-4) << c.model;
        if (stated < 1e-5) continue;
        const double unit = std::pow(10, std::floor(std::log10(stated)) - 2);
        EXPECT_GT(c.absolute.hi, stated - 1.01 * unit) << c.model;
    }
}

// ---- the rest ---------------------------------------------------------------------------------------------

TEST(prove, of_schlick_inside_is_that_of_schlick_outside) {
    const certificate inside = prove("schlick_internal"), outside = prove("schlick");
    EXPECT_TRUE(inside.proved);
    EXPECT_EQ(inside.absolute.hi, outside.absolute.hi);
    const double eta = 1 / inside.at[0].second, cos_t = inside.at[1].second;
    const double cos_i = std::sqrt(1 - eta * eta * (1 - cos_t * cos_t)); // Snell, from inside
    const double error = schlick_internal(eta, cos_i) - dielectric(1.0, eta, cos_i).reflectance();
    EXPECT_NEAR(std::abs(error), inside.absolute.lo, 1e-9);
    for (int i = 0; i <= 120; ++i)
        EXPECT_LE(schlick_internal_error(1 / (1.3 + 0.01 * i)).size(), inside.absolute.hi);
}

TEST(prove, says_whose_relative_error_is_unbounded_near_an_index_match) {
    const auto relative = [](auto model, double eta) {
        const double exact = dielectric(1.0, eta, 0.5).reflectance();
        return std::abs(model(normal_reflectance(1.0, eta, 0.0), 0.5) / exact - 1);
    };
    const auto of_schlick = [](double f0, double c) { return schlick(f0, c); };
    EXPECT_TRUE(prove("schlick").unbounded_near_match);
    EXPECT_GT(relative(of_schlick, 1 + 1e-5), 50 * relative(of_schlick, 1 + 1e-4));

    const auto of_constant = [](double f0, double) { return f0; };
    EXPECT_FALSE(prove("constant").unbounded_near_match);
    EXPECT_LT(relative(of_constant, 1 + 1e-5), 1);
}

TEST(prove, says_where_a_bound_is_measured_only) {
    for (const char* name : {"dielectric", "conductor_fast", "conductor_precise"}) {
        const certificate c = prove(name);
        EXPECT_FALSE(c.proved) << name;
        EXPECT_EQ(c.absolute.hi, find_model<double>(name).error.max);
    }
}

TEST(prove, searches_for_the_rounding_of_float32) {
    EXPECT_LT(prove("schlick").rounding_found, 4e-7);
    EXPECT_GT(prove("schlick").rounding_found, 3e-7);
    EXPECT_LT(prove("conductor_precise").rounding_found, 1e-6);
    EXPECT_GT(prove("dielectric_fast").rounding_found, 1e-4) << "next to an index match";
}

TEST(prove, names_the_inputs_whose_rounding_it_found) {
    for (const char* name : {"conductor", "schlick_f90", "gulbrandsen", "schlick_internal"}) {
        const certificate c = prove(name);
        std::vector<float> narrow;
        std::vector<double> wide;
        for (const auto& [parameter, value] : c.rounding_at)
            narrow.push_back(static_cast<float>(value)), wide.push_back(value);
        const double in_float =
            double(find_model<float>(name).evaluate(narrow.data(), narrow.back()).reflectance());
        const double real = find_model<double>(name).evaluate(wide.data(), wide.back()).reflectance();
        EXPECT_NEAR(std::abs(in_float - real), c.rounding_found, 1e-3 * c.rounding_found) << name;
    }
}

TEST(prove, bounds_the_rounding_of_models_without_comparisons) {
    for (const char* name : {"schlick", "schlick_f90", "schlick_nk", "photometric", "powers_4_8",
                             "powers_3_9", "one_minus_cos", "air_conductor"}) {
        const certificate c = prove(name);
        ASSERT_TRUE(c.rounding_bound.has_value()) << name;
        EXPECT_LE(c.rounding_found, *c.rounding_bound) << name;
        EXPECT_LE(*c.rounding_bound, 2 * c.rounding_found) << name;
    }
    EXPECT_NEAR(*prove("one_minus_cos").rounding_bound / 0x1p-25, 1, 1e-9) << "half a unit of the last place";
    EXPECT_EQ(*prove("constant").rounding_bound, 0);
    for (const char* name : {"schlick_power", "spherical_gaussian", "powers_3_6_9", "bias_scale_power"})
        EXPECT_LE(*prove(name).rounding_bound, 1e-5) << name; // powers and roots, whose slopes have no bound
    EXPECT_FALSE(prove("dielectric").rounding_bound.has_value());
}

class prove_command : public test::command_test {};

TEST_F(prove_command, prints_its_keys) {
    const auto all = json("prove schlick dielectric --json");
    ASSERT_EQ(all.size(), 2u);
    for (const auto& one : all)
        for (const char* key :
             {"model", "domain", "absolute", "relative", "at", "rounding_float32", "rounding_found",
              "rounding_at", "rounding_bound", "materials", "proved", "relative_as_eta_goes_to_1"})
            EXPECT_TRUE(one.contains(key)) << key;
    EXPECT_EQ(all[0]["proved"], true);
    EXPECT_EQ(all[0]["rounding_float32"], all[0]["rounding_bound"]);
    EXPECT_EQ(all[1]["rounding_float32"], all[1]["rounding_found"]);
    EXPECT_EQ(json("models schlick --json")[0]["error"]["basis"], "certified");
    EXPECT_EQ(json("models conductor --json")[0]["error"]["basis"], "measured");
    EXPECT_TRUE(all[1]["relative"].is_null());
    EXPECT_TRUE(all[1]["rounding_bound"].is_null());
    expect_refused("prove schlik", {"schlik", "schlick"});
    EXPECT_EQ(json("prove schlick schlick --json").size(), 1u);
    EXPECT_EQ(json("prove schlick --material gold --material gold --json")[0]["materials"].size(), 3u);
}

TEST_F(prove_command, certifies_a_material_of_the_users_choice) {
    const auto one = json("prove f82 --material silicon --material gold --json");
    ASSERT_EQ(one.size(), 1u);
    EXPECT_EQ(one[0]["domain"], "silicon, gold, at 450, 550 and 650 nm, parameters fitted");
    ASSERT_EQ(one[0]["materials"].size(), 6u);
    EXPECT_EQ(one[0]["materials"][5]["material"], "gold");
    EXPECT_EQ(one[0]["materials"][5]["wavelength_nm"], 650);
    const auto every = json("prove --material n-bk7 --json");
    EXPECT_EQ(every.size(), 20u) << "every approximation but schlick_internal";
    expect_refused("prove conductor --material gold", {"conductor", "approximate"});
    expect_refused("prove f82 --material golld", {"golld", "gold"});
    expect_refused("prove f82 --material vacuum", {"vacuum", "n = 1", "above 1"});
}

} // namespace
