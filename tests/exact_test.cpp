#include "inputs.hpp"
#include "oracles.hpp"
#include "tolerances.hpp"

#include <fresnel/exact.hpp>
#include <fresnel/geometry.hpp>

#include <gtest/gtest.h>

#include <array>
#include <cstdio>
#include <limits>
#include <string_view>
#include <vector>

namespace fresnel::test {
namespace {

// ---- the five forms, and how far each may be from the truth -----------------------------------------------

enum form : std::size_t {
    dielectric_form,
    dielectric_fast_form,
    conductor_form,
    conductor_fast_form,
    precise_form,
    forms
};

constexpr std::array<const char*, forms> form_names = {"dielectric", "dielectric_fast", "conductor",
                                                       "conductor_fast", "conductor_precise"};

template <class T>
boundary<T> evaluate(std::size_t form, const incidence<T>& x) {
    switch (form) {
    case dielectric_form:
        return dielectric(x.n_i, x.n_t, x.cos_i);
    case dielectric_fast_form:
        return dielectric_fast(x.n_i, x.n_t, x.cos_i);
    case conductor_form:
        return conductor(x.n_i, x.n_t, x.k_t, x.cos_i);
    case conductor_fast_form:
        return conductor_fast(x.n_i, x.n_t, x.k_t, x.cos_i);
    default:
        return conductor_precise(x.n_i, x.n_t, x.k_t, x.cos_i);
    }
}

bool takes(std::size_t form, bool transparent) { return transparent || form >= conductor_form; }

bool is_fast(std::size_t form) { return form == dielectric_fast_form || form == conductor_fast_form; }

template <class T>
boundary<real50> truth(const incidence<T>& x) {
    return oracle::truth(x.n_i, x.n_t, x.k_t, x.cos_i);
}

/// How many times the rounding of m^2 - 1 grows on its way through q^2 = (m^2 - 1) + c^2:
/// 1 + |m^2 - 1| / |q^2|, unbounded at the critical angle, where q is 0.
template <class T>
double condition(const incidence<T>& x) {
    const auto [n_i, n_t, k_t, c] = std::array{static_cast<double>(x.n_i), static_cast<double>(x.n_t),
                                               static_cast<double>(x.k_t), static_cast<double>(x.cos_i)};
    const double k = k_t / n_i;
    const double E = (n_t - n_i) * (n_t + n_i) / (n_i * n_i) - k * k, nk2 = 2 * n_t * k / n_i;
    const double q2 = std::hypot(E + c * c, nk2);
    return q2 > 0 ? 1 + std::hypot(E, nk2) / q2 : std::numeric_limits<double>::infinity();
}

/// Beyond this condition an incidence counts as near its critical angle.
constexpr double near_critical = 100;

double relative_error(double miss, double size) {
    return miss == 0 ? 0 : size > 0 ? miss / size : std::numeric_limits<double>::infinity();
}

/// |actual - expected|; infinite for a NaN, which would otherwise slip through every maximum.
double distance(const real50& actual, const real50& expected) {
    const double miss = static_cast<double>(real50(abs(actual - expected)));
    return std::isnan(miss) ? std::numeric_limits<double>::infinity() : miss;
}

/// Errors of one evaluation, relative; r_p is the error of the amplitude sqrt(R_p) in units of r_s.
struct errors {
    double R, T, R_s, r_p, T_absolute;
    bool transmits; // false under total reflection, where T has no relative error
};

template <class T>
errors compare(const boundary<T>& got, const boundary<real50>& exact) {
    const double R = static_cast<double>(exact.reflectance()),
                 through = static_cast<double>(exact.transmittance());
    const double T_miss = distance(got.transmittance(), exact.transmittance());
    const double r_p_miss = distance(sqrt(real50(got.R_p)), sqrt(exact.R_p));
    return {relative_error(distance(got.reflectance(), exact.reflectance()), R),
            relative_error(T_miss, through),
            relative_error(distance(got.R_s, exact.R_s), static_cast<double>(exact.R_s)),
            relative_error(r_p_miss, static_cast<double>(sqrt(exact.R_s))),
            T_miss,
            through > 0};
}

/// The largest errors of one form in one class.
struct worst {
    double R = 0, T = 0;             // away from the critical angle
    double R_near = 0, T_near = 0;   // near it; T absolute
    double R_unit = 0, T_unit = 0;   // in units of epsilon times the condition, everywhere
    double Rs_unit = 0, rp_unit = 0; // the same, R_s and the amplitude of R_p
    std::string at_R, at_T;

    void take(const errors& e, double epsilon, double condition, const std::string& input) {
        const bool far = condition < near_critical;
        if (far && !(e.R <= R)) R = e.R, at_R = input;
        if (far && !(e.T <= T)) T = e.T, at_T = input;
        if (!far) R_near = std::fmax(R_near, e.R), T_near = std::fmax(T_near, e.T_absolute);
        const double unit = epsilon * condition;
        R_unit = std::fmax(R_unit, e.R / unit), Rs_unit = std::fmax(Rs_unit, e.R_s / unit);
        rp_unit = std::fmax(rp_unit, e.r_p / unit);
        if (e.transmits) T_unit = std::fmax(T_unit, e.T / unit);
    }
};

template <class T>
std::array<worst, forms> measure(const input_class& inputs) {
    constexpr double epsilon = static_cast<double>(std::numeric_limits<T>::epsilon());
    std::array<worst, forms> result;
    random_numbers random(2002);
    const int points = inputs.transparent ? transparent_points : absorbing_points;
    for (int i = 0; i < points; ++i) {
        const incidence<T> x = in<T>(inputs.draw(random));
        const boundary<real50> exact = truth(x);
        for (std::size_t form = 0; form < forms; ++form)
            if (takes(form, inputs.transparent))
                result[form].take(compare(evaluate(form, x), exact), epsilon, condition(x), x.text());
    }
    return result;
}

template <class T>
void print_table(const char* type, const std::vector<std::array<worst, forms>>& table) {
    std::printf("%s, largest relative error of R / of T where the condition is below %g\n%-22s", type,
                near_critical, "");
    for (const char* name : form_names)
        std::printf("%-20s", name);
    for (std::size_t c = 0; c < table.size(); ++c) {
        std::printf("\n%-22s", input_classes[c].name.data());
        for (std::size_t form = 0; form < forms; ++form)
            if (takes(form, input_classes[c].transparent))
                std::printf("%.1e / %-9.1e ", table[c][form].R, table[c][form].T);
            else
                std::printf("%-20s", "-");
    }
    std::printf("\nlargest over all classes, near the critical angle: R relative / T absolute\n%-22s", "");
    for (std::size_t form = 0; form < forms; ++form) {
        double R = 0, T_absolute = 0;
        for (const auto& row : table)
            R = std::fmax(R, row[form].R_near), T_absolute = std::fmax(T_absolute, row[form].T_near);
        std::printf("%.1e / %-9.1e ", R, T_absolute);
    }
    std::printf("\nlargest in units of epsilon times the condition: R, T, R_s, sqrt(R_p)\n%-22s", "");
    for (std::size_t form = 0; form < forms; ++form) {
        worst w;
        for (const auto& row : table) {
            w.R_unit = std::fmax(w.R_unit, row[form].R_unit),
            w.T_unit = std::fmax(w.T_unit, row[form].T_unit);
            w.Rs_unit = std::fmax(w.Rs_unit, row[form].Rs_unit),
            w.rp_unit = std::fmax(w.rp_unit, row[form].rp_unit);
        }
        std::printf("%.2g %.2g %.2g %.2g      ", w.R_unit, w.T_unit, w.Rs_unit, w.rp_unit);
    }
    std::printf("\n");
}

/// The promise that holds everywhere: 8 epsilon in R, R_s and the amplitude of R_p and 4 epsilon in T, each
/// times the condition.
void expect_condition_bound(const std::vector<std::array<worst, forms>>& table) {
    for (std::size_t c = 0; c < table.size(); ++c)
        for (const std::size_t form : {dielectric_form, conductor_form, precise_form}) {
            const worst& w = table[c][form];
            EXPECT_LE(w.R_unit, 8) << form_names[form] << ", " << input_classes[c].name;
            EXPECT_LE(w.Rs_unit, 8) << form_names[form] << ", " << input_classes[c].name;
            EXPECT_LE(w.T_unit, 4) << form_names[form] << ", " << input_classes[c].name;
            EXPECT_LE(w.rp_unit, 8) << form_names[form] << ", " << input_classes[c].name;
        }
}

template <class T>
std::vector<std::array<worst, forms>> measure_all(const char* type) {
    std::vector<std::array<worst, forms>> table;
    for (const input_class& inputs : input_classes)
        table.push_back(measure<T>(inputs));
    print_table<T>(type, table);
    return table;
}

/// What docs/accuracy.md promises in float32 away from the critical angle, by class and form.
struct promise {
    std::array<double, forms> R, T;
};

constexpr double no = std::numeric_limits<double>::infinity(); // no promise, or not a dielectric

constexpr std::array<promise, input_classes.size()> promises = {{
    {{1e-6, 8e-6, 7e-7, 2e-4, 7e-7}, {8e-7, 7e-7, 7e-7, 7e-7, 7e-7}}, // external dielectric
    {{6e-6, 1e-5, 6e-6, 1e-4, 7e-7}, {6e-6, 6e-6, 6e-6, 6e-6, 4e-7}}, // internal dielectric
    {{2e-6, no, 2e-6, no, 9e-7}, {3e-6, no, 3e-6, no, 5e-7}},         // index match
    {{6e-6, 2e-5, 6e-6, 2e-5, 6e-7}, {6e-6, 2e-5, 6e-6, 2e-5, 4e-7}}, // near TIR
    {{1e-6, 6e-7, 5e-7, 5e-7, 6e-7}, {9e-7, 8e-7, 8e-7, 7e-7, 8e-7}}, // grazing
    {{4e-6, 4e-6, 4e-6, 1e-4, 7e-7}, {4e-6, 2e-6, 5e-6, 4e-6, 6e-7}}, // Brewster
    {{no, no, 4e-7, 6e-6, 5e-7}, {no, no, 7e-7, 7e-4, 7e-7}},         // metals
    {{no, no, 7e-7, 2e-4, 7e-7}, {no, no, 7e-7, 7e-7, 7e-7}},         // weak k
    {{no, no, 4e-6, 8e-4, 7e-7}, {no, no, 2e-5, no, 6e-7}},           // weak k, internal
    {{no, no, 3e-7, 4e-4, 3e-7}, {no, no, 8e-7, no, 7e-7}},           // n << k
    {{no, no, 2e-6, 6e-6, 6e-7}, {no, no, 4e-6, 3e-4, 6e-7}},         // n = k < 1
    {{no, no, 2e-6, no, 9e-7}, {no, no, 3e-6, no, 6e-7}},             // index match, weak k
    {{no, no, 5e-7, 3e-6, 5e-7}, {no, no, 8e-7, 2e-3, 7e-7}},         // huge n, k
}};

TEST(exact_forms, float32_errors_stay_within_the_documented_promise_of_each_class) {
    const auto table = measure_all<float>("float32");
    for (std::size_t c = 0; c < table.size(); ++c)
        for (std::size_t form = 0; form < forms; ++form) {
            const worst& w = table[c][form];
            EXPECT_LE(w.R, promises[c].R[form])
                << "R of " << form_names[form] << ", " << input_classes[c].name << ", at " << w.at_R;
            EXPECT_LE(w.T, promises[c].T[form])
                << "T of " << form_names[form] << ", " << input_classes[c].name << ", at " << w.at_T;
            if (is_fast(form)) continue;
            const double at_critical = form == precise_form ? 1e-6 : 0.1;
            EXPECT_LE(w.R_near, at_critical) << form_names[form] << ", " << input_classes[c].name;
            EXPECT_LE(w.T_near, at_critical) << form_names[form] << ", " << input_classes[c].name;
        }
    expect_condition_bound(table);
}

TEST(exact_forms, float32_errors_stay_within_the_promise_where_a_search_found_the_largest) {
    const auto relative = [](auto form, auto... x) {
        const real50 exact = form(real50(x)...).reflectance();
        return std::abs(static_cast<double>(real50(form(x...).reflectance()) / exact - 1));
    };
    const auto fast = [](auto... x) { return dielectric_fast(x...); };
    const auto fast_conductor = [](auto... x) { return conductor_fast(x...); };
    const auto plain = [](auto... x) { return dielectric(x...); };
    EXPECT_LE(relative(fast, 0.5024188756942749f, 0.5278820991516113f, 0.9962047934532166f), 8e-6);
    EXPECT_LE(relative(fast, 2.02724481f, 2.13645816f, 0.999352276f), 8e-6);
    EXPECT_LE(relative(fast_conductor, 1.0120315551757812f, 1.062668800354004f, 0.0f, 0.9912281036376953f),
              2e-4);
    EXPECT_LE(relative(fast_conductor, 0.9889167547225952f, 0.04954538866877556f, 9.844799995422363f,
                       0.07710164040327072f),
              6e-6);
    EXPECT_LE(relative(plain, 2.0669026374816895f, 0.2082604467868805f, 0.9949108958244324f), 0.1)
        << "at a critical angle";
    const auto absorbing = [](auto... x) { return conductor(x...); };
    EXPECT_GE(relative(absorbing, 1.0f, 0.101350002f, 1e-6f, 0.994850874f), 1e-2) << "of small k_t too";
    EXPECT_LE(relative(absorbing, 1.0f, 0.104500003f, 1e-3f, 0.994521797f), 3e-4);
}

TEST(exact_forms, float64_errors_stay_below_1e_12_away_from_the_critical_angle) {
    const auto table = measure_all<double>("float64");
    for (std::size_t c = 0; c < table.size(); ++c)
        for (const std::size_t form : {dielectric_form, conductor_form, precise_form}) {
            const worst& w = table[c][form];
            EXPECT_LE(w.R, tolerance::reference) << form_names[form] << " at " << w.at_R;
            EXPECT_LE(w.T, tolerance::reference) << form_names[form] << " at " << w.at_T;
        }
    expect_condition_bound(table);
}

// ---- the whole domain of the registry, its corners included -----------------------------------------------

template <class T>
T one_of(random_numbers& random, std::initializer_list<T> choices) {
    return choices.begin()[static_cast<std::size_t>(random.uniform(0, static_cast<double>(choices.size())))];
}

/// Small and large numbers that arithmetic treats specially, beside ordinary ones.
template <class T>
incidence<T> hostile(random_numbers& random) {
    using limits = std::numeric_limits<T>;
    const auto draw = [&](double low, double high) { return static_cast<T>(random.log_uniform(low, high)); };
    const T n_i = one_of<T>(random, {1, draw(0.01, 100), draw(0.5, 3), T(0.01), 100});
    const T n_t = one_of<T>(random, {n_i, std::nextafter(n_i, T(0)), std::nextafter(n_i, T(2000)),
                                     draw(0.001, 1000), draw(0.5, 3), T(0.001), 1000});
    const T k_t = one_of<T>(random, {0, 0, limits::denorm_min(), limits::min(), T(1e-30), T(1e-20), T(1e-10),
                                     draw(1e-8, 10000), draw(0.1, 10), 10000});
    const T cos_i = one_of<T>(random, {0, 1, limits::denorm_min(), limits::min(), T(1e-30), T(1e-20),
                                       T(1e-15), T(1e-10), limits::epsilon(), 1 - limits::epsilon() / 2,
                                       static_cast<T>(random.uniform(0, 1))});
    return {n_i, n_t, k_t, cos_i};
}

/// x with one argument replaced, counted n_i, n_t, cos_i, k_t.
template <class T>
incidence<T> with(incidence<T> x, int argument, T value) {
    (argument == 0 ? x.n_i : argument == 1 ? x.n_t : argument == 2 ? x.cos_i : x.k_t) = value;
    return x;
}

/// k_t so small that its cube is lost: at grazing incidence and an index match the digits go with it.
template <class T>
bool faint(const incidence<T>& x) {
    return x.k_t > 0 && x.k_t < 1000 * std::cbrt(negligible<T>()) * std::fmax(x.n_i, T(1));
}

constexpr int hostile_points = 100000 / thinning;

/// Calls law(form, input, result) on hostile inputs of every form that takes them.
template <class T, class Law>
void on_hostile_inputs(Law law) {
    random_numbers random(1823);
    for (int i = 0; i < hostile_points; ++i) {
        const incidence<T> x = hostile<T>(random);
        for (std::size_t form = 0; form < forms && !testing::Test::HasFailure(); ++form)
            if (takes(form, x.k_t == 0)) law(form, x, evaluate(form, x));
    }
}

template <class T>
struct exact_forms_of : testing::Test {};
using machine_types = testing::Types<float, double>;
TYPED_TEST_SUITE(exact_forms_of, machine_types);

template <class T>
bool in_unit_interval(T x) {
    return x >= 0 && x <= 1;
}

TYPED_TEST(exact_forms_of, never_leave_0_to_1_and_are_never_nan) {
    on_hostile_inputs<TypeParam>([](std::size_t form, const auto& x, const auto& y) {
        EXPECT_TRUE(in_unit_interval(y.R_s) && in_unit_interval(y.R_p) && in_unit_interval(y.T_s) &&
                    in_unit_interval(y.T_p))
            << form_names[form] << " at " << x.text() << "\nR_s " << digits(y.R_s) << ", R_p "
            << digits(y.R_p) << ", T_s " << digits(y.T_s) << ", T_p " << digits(y.T_p);
    });
}

TYPED_TEST(exact_forms_of, reflect_and_transmit_all_that_arrives) {
    on_hostile_inputs<TypeParam>([](std::size_t form, const auto& x, const auto& y) {
        if (is_fast(form) || faint(x)) return;
        const TypeParam allowed =
            2 * TypeParam(tolerance::identity) * std::numeric_limits<TypeParam>::epsilon();
        EXPECT_TRUE(within<TypeParam>(y.R_s + y.T_s, 1, allowed,
                                      std::string(form_names[form]) + " s at " + x.text()));
        EXPECT_TRUE(within<TypeParam>(y.R_p + y.T_p, 1, allowed,
                                      std::string(form_names[form]) + " p at " + x.text()));
    });
}

TYPED_TEST(exact_forms_of, reflect_exactly_nothing_between_equal_media) {
    on_hostile_inputs<TypeParam>([](std::size_t form, const auto& x, const auto& y) {
        if (x.n_i != x.n_t || x.k_t != 0 || form == dielectric_fast_form) return;
        if (form == conductor_fast_form && x.cos_i < TypeParam(1e-7f)) return; // c^4 underflows in float32
        const std::string input = std::string(form_names[form]) + " at " + x.text();
        EXPECT_TRUE(exactly<TypeParam>(y.R_s, 0, input));
        EXPECT_TRUE(exactly<TypeParam>(y.R_p, 0, input));
        if (is_fast(form)) return;
        EXPECT_TRUE(exactly<TypeParam>(y.T_s, 1, input));
        EXPECT_TRUE(exactly<TypeParam>(y.T_p, 1, input));
    });
}

TYPED_TEST(exact_forms_of, reflect_exactly_everything_at_grazing_incidence_unless_the_media_are_equal) {
    on_hostile_inputs<TypeParam>([](std::size_t form, const auto& x, const auto& y) {
        if (x.cos_i != 0 || is_fast(form) || faint(x) || (x.n_i == x.n_t && x.k_t == 0)) return;
        const std::string input = std::string(form_names[form]) + " at " + x.text();
        EXPECT_TRUE(exactly<TypeParam>(y.R_s, 1, input));
        EXPECT_TRUE(exactly<TypeParam>(y.R_p, 1, input));
        EXPECT_TRUE(exactly<TypeParam>(y.T_s, 0, input));
        EXPECT_TRUE(exactly<TypeParam>(y.T_p, 0, input));
    });
}

TYPED_TEST(exact_forms_of, keep_the_digits_of_a_faint_transmittance) {
    random_numbers random(1873);
    for (int i = 0; i < hostile_points / 20; ++i) {
        incidence<TypeParam> x = hostile<TypeParam>(random);
        x.k_t = 0, x.cos_i = static_cast<TypeParam>(random.log_uniform(1e-30, 1e-5));
        if (x.n_i == x.n_t || condition(x) > near_critical) continue;
        const boundary<real50> exact = truth(x);
        const double epsilon = static_cast<double>(std::numeric_limits<TypeParam>::epsilon());
        for (const std::size_t form : {dielectric_form, conductor_form, precise_form})
            ASSERT_LE(compare(evaluate(form, x), exact).T, 4 * epsilon * condition(x))
                << form_names[form] << " at " << x.text();
    }
}

TYPED_TEST(exact_forms_of, pass_a_nan_on_from_any_argument) {
    on_hostile_inputs<TypeParam>([](std::size_t form, const auto& x, const auto&) {
        for (int argument = 0; argument < (form < conductor_form ? 3 : 4); ++argument) {
            const auto poisoned = with(x, argument, std::numeric_limits<TypeParam>::quiet_NaN());
            const boundary<TypeParam> y = evaluate(form, poisoned);
            EXPECT_TRUE(std::isnan(y.R_s) && std::isnan(y.R_p) && std::isnan(y.T_s) && std::isnan(y.T_p))
                << form_names[form] << " at " << poisoned.text() << "\nR_s " << digits(y.R_s) << ", R_p "
                << digits(y.R_p) << ", T_s " << digits(y.T_s) << ", T_p " << digits(y.T_p);
        }
    });
}

TYPED_TEST(exact_forms_of, answer_an_infinity_with_nan_or_the_limit) {
    on_hostile_inputs<TypeParam>([](std::size_t form, const auto& x, const auto&) {
        for (int argument = 0; argument < (form < conductor_form ? 3 : 4); ++argument) {
            const auto endless = with(x, argument, std::numeric_limits<TypeParam>::infinity());
            const boundary<TypeParam> y = evaluate(form, endless);
            const bool no_boundary = endless.n_i == endless.n_t && endless.k_t == 0 && argument == 2;
            const TypeParam R = y.reflectance(), T = y.transmittance();
            EXPECT_TRUE((std::isnan(R) && std::isnan(T)) || (argument != 2 && R == 1 && T == 0) ||
                        (no_boundary && R == 0 && T == 1))
                << form_names[form] << " at " << endless.text() << "\nR " << digits(R) << ", T " << digits(T);
        }
    });
}

// ---- laws that tie the forms to each other ----------------------------------------------------------------

/// Calls law(input) on `points` ordinary inputs of every class.
template <class T, class Law>
void on_every_class(int points, Law law) {
    for (const input_class& inputs : input_classes) {
        random_numbers random(1982);
        for (int i = 0; i < points / thinning + 1 && !testing::Test::HasFailure(); ++i)
            law(inputs, in<T>(inputs.draw(random)));
    }
}

TEST(exact_forms, agree_with_the_truth_to_1e_40_in_50_digits) {
    on_every_class<double>(500, [](const input_class& inputs, const incidence<double>& x) {
        const incidence<real50> wide = {x.n_i, x.n_t, x.k_t, x.cos_i};
        const boundary<real50> exact = truth(x);
        for (std::size_t form = 0; form < forms; ++form) {
            if (!takes(form, inputs.transparent)) continue;
            const boundary<real50> y = evaluate(form, wide);
            const std::string input = std::string(form_names[form]) + " at " + x.text();
            // the fast forms keep what 60 digits leave after their cancellations
            const double allowed = is_fast(form) ? 1e-25 : tolerance::printed_form;
            EXPECT_TRUE(within_relative(y.reflectance(), exact.reflectance(), allowed, input));
            EXPECT_TRUE(within_relative(y.transmittance(), exact.transmittance(), allowed, input));
        }
    });
}

TEST(exact_forms, reflect_everything_where_the_critical_angle_is_normal_incidence_to_rounding) {
    for (const float n_i : {100.0f, 99.99999f, 30.0f})
        for (const float k_t : {0.0f, 1e-18f, 1e-12f}) {
            const boundary<float> R = conductor(n_i, 0.001f, k_t, 1.0f);
            EXPECT_GT(R.R_s, 0.9f) << n_i << " " << k_t;
            EXPECT_EQ(R.R_s, R.R_p) << n_i << " " << k_t;
            EXPECT_LE(R.R_s, 1.0f);
        }
    EXPECT_GT(dielectric(100.0f, 0.001f, 1.0f).reflectance(), 0.9f);
    EXPECT_GT(conductor(100.0, 1e-3, 0.0, 1.0).reflectance(), 0.9);
}

TEST(exact_forms, conductor_without_absorption_is_the_dielectric) {
    on_every_class<float>(20000, [](const input_class& inputs, const incidence<float>& x) {
        if (!inputs.transparent) return;
        const boundary<float> metal = conductor(x.n_i, x.n_t, 0.0f, x.cos_i),
                              glass = dielectric(x.n_i, x.n_t, x.cos_i);
        const float allowed = 16 * std::numeric_limits<float>::epsilon() * static_cast<float>(condition(x));
        EXPECT_TRUE(
            within(metal.reflectance(), glass.reflectance(), allowed * glass.reflectance(), x.text()));
        EXPECT_TRUE(
            within(metal.transmittance(), glass.transmittance(), allowed * glass.transmittance(), x.text()));
    });
}

TEST(exact_forms, reflect_alike_from_both_sides_of_a_transparent_surface) {
    on_every_class<double>(500, [](const input_class& inputs, const incidence<double>& x) {
        const real50 n_i = x.n_i, n_t = x.n_t, c = x.cos_i;
        const real50 cos_t = refracted_cosine(real50(n_t / n_i), c);
        if (!inputs.transparent || cos_t <= 0) return;
        const boundary<real50> there = dielectric(n_i, n_t, c), back = dielectric(n_t, n_i, cos_t);
        EXPECT_TRUE(within_relative(back.R_s, there.R_s, 1e-25, x.text()));
        EXPECT_TRUE(within(back.R_p, there.R_p, 1e-25 * there.R_s, x.text()));
        EXPECT_TRUE(within_relative(back.T_p, there.T_p, 1e-25, x.text()));
    });
}

TEST(exact_forms, square_r_s_to_r_p_at_45_degrees) {
    const real50 c = sqrt(real50(1) / 2);
    for (const double k : {0.0, 0.5, 3.0, 40.0})
        for (const double n : {0.15, 0.4, 1.0, 1.5, 2.42, 30.0}) {
            const boundary<real50> y = conductor(real50(1), real50(n), real50(k), c);
            EXPECT_TRUE(
                within(y.R_p, y.R_s * y.R_s, tolerance::printed_form, digits(n) + " + i " + digits(k)));
        }
}

TEST(exact_forms, keep_r_p_at_zero_at_brewsters_angle) {
    for (const double eta : {0.2, 0.7, 1.0001, 1.33, 1.5, 2.42, 9.0}) {
        const real50 c = 1 / sqrt(1 + real50(eta) * real50(eta));
        EXPECT_TRUE(
            within(dielectric(real50(1), real50(eta), c).R_p, 0, tolerance::printed_form, digits(eta)));
        const double R_p = dielectric(1.0, eta, static_cast<double>(c)).R_p;
        EXPECT_TRUE(within(R_p, 0.0, 1e-27, digits(eta)));
    }
}

TEST(exact_forms, reflect_everything_beyond_the_critical_angle) {
    for (const float eta : {0.2f, 0.5f, 1 / 1.5f, 0.9f, 0.999f}) {
        const float critical = std::sqrt((1 - eta) * (1 + eta));
        for (const float c : {0.0f, 1e-20f, 0.3f * critical, 0.99f * critical, 0.9999f * critical}) {
            const std::string input = "eta " + digits(eta) + ", cos " + digits(c);
            for (const boundary<float>& y : {dielectric(1.0f, eta, c), dielectric_fast(1.0f, eta, c),
                                             conductor_precise(1.0f, eta, 0.0f, c)}) {
                EXPECT_TRUE(exactly(y.reflectance(), 1.0f, input));
                EXPECT_TRUE(exactly(y.transmittance(), 0.0f, input));
            }
        }
    }
}

TEST(exact_forms, meet_the_closed_form_at_normal_incidence) {
    on_every_class<double>(2000, [](const input_class&, const incidence<double>& x) {
        const double f0 = normal_reflectance(x.n_i, x.n_t, x.k_t);
        const incidence<double> straight = {x.n_i, x.n_t, x.k_t, 1};
        if (condition(straight) > near_critical) return;
        EXPECT_TRUE(within_relative(conductor(x.n_i, x.n_t, x.k_t, 1.0).reflectance(), f0, 1e-13, x.text()));
    });
}

// ---- amplitudes -------------------------------------------------------------------------------------------

real50 amplitude_distance(const complex<real50>& z, const complex<real50>& w) { return sqrt(norm(z - w)); }

TEST(boundary_amplitudes, agree_with_snell_and_fresnel_in_complex_numbers_to_1e_40) {
    on_every_class<double>(500, [](const input_class&, const incidence<double>& x) {
        const incidence<real50> w = {x.n_i, x.n_t, x.k_t, x.cos_i};
        const amplitudes<real50> got = boundary_amplitudes(w.n_i, w.n_t, w.k_t, w.cos_i);
        const oracle::plain_amplitudes<real50> expected = oracle::amplitudes(w.n_i, w.n_t, w.k_t, w.cos_i);
        const real50 allowed = tolerance::printed_form;
        EXPECT_LE(amplitude_distance(got.r_s, expected.r_s), allowed) << x.text();
        EXPECT_LE(amplitude_distance(got.r_p, expected.r_p), allowed) << x.text();
        EXPECT_LE(amplitude_distance(got.t_s, expected.t_s), allowed) << x.text();
        EXPECT_LE(amplitude_distance(got.t_p, expected.t_p), allowed * (1 + sqrt(norm(expected.t_p))))
            << x.text();
    });
}

TEST(boundary_amplitudes, square_to_the_reflectance) {
    on_every_class<double>(2000, [](const input_class&, const incidence<double>& x) {
        const amplitudes<double> r = boundary_amplitudes(x.n_i, x.n_t, x.k_t, x.cos_i);
        const boundary<double> R = conductor(x.n_i, x.n_t, x.k_t, x.cos_i);
        const double allowed =
            2 * condition(x) * tolerance::identity * std::numeric_limits<double>::epsilon() * R.R_s;
        EXPECT_TRUE(within<double>(norm(r.r_s), R.R_s, allowed, x.text()));
        EXPECT_TRUE(within<double>(norm(r.r_p), R.R_p, allowed, x.text()));
    });
}

TEST(boundary_amplitudes, are_0_and_1_between_equal_media_at_every_angle) {
    for (const double c : {0.0, 1e-300, 1e-30, 1e-8, 0.3, 1.0}) {
        const amplitudes<double> x = boundary_amplitudes(1.7, 1.7, 0.0, c);
        EXPECT_EQ(norm(x.r_s), 0) << c;
        EXPECT_EQ(norm(x.r_p), 0) << c;
        EXPECT_TRUE(same(x.t_s.re, 1.0, digits(c)));
        EXPECT_TRUE(same(x.t_p.re, 1.0, digits(c)));
    }
}

TEST(boundary_amplitudes, change_only_the_sign_of_r_p_between_the_conventions) {
    const amplitudes<double> verdet = boundary_amplitudes(1.0, 0.2, 3.0, 0.4), fresnel = opposite_p(verdet);
    EXPECT_TRUE(exactly(fresnel.r_p.re, -verdet.r_p.re, "r_p"));
    EXPECT_TRUE(exactly(fresnel.r_p.im, -verdet.r_p.im, "r_p"));
    EXPECT_TRUE(exactly(fresnel.r_s.re, verdet.r_s.re, "r_s"));
    EXPECT_TRUE(exactly(fresnel.t_p.re, verdet.t_p.re, "t_p"));
    const amplitudes<double> twice = opposite_p(fresnel);
    EXPECT_TRUE(exactly(twice.r_p.re, verdet.r_p.re, "r_p"));
}

// ---- geometry ---------------------------------------------------------------------------------------------

TEST(geometry, eta_from_f0_inverts_the_reflectance_at_normal_incidence) {
    random_numbers random(1);
    for (int i = 0; i < 2000; ++i) {
        const real50 eta = 1 + real50(random.log_uniform(1e-3, 100));
        const real50 f0 = normal_reflectance(real50(1), eta, real50(0));
        EXPECT_TRUE(within_relative(eta_from_f0(f0), eta, tolerance::printed_form, digits(eta)));
        EXPECT_TRUE(within_relative(sin_critical(f0), real50(1 / eta), tolerance::printed_form, digits(eta)));
    }
    EXPECT_EQ(eta_from_f0(0.0), 1);
    EXPECT_EQ(sin_critical(0.0), 1);
    EXPECT_EQ(sin_critical(1.0), 0);
    EXPECT_NEAR(eta_from_f0(0.04), 1.5, 1e-15);
}

TEST(geometry, refracted_cosine_obeys_snells_law) {
    random_numbers random(2);
    for (int i = 0; i < 2000; ++i) {
        const double eta = random.log_uniform(0.1, 10), c = random.uniform(0, 1);
        const double cos_t = refracted_cosine(eta, c);
        const double sin2_i = (1 - c) * (1 + c), sin2_t = (1 - cos_t) * (1 + cos_t);
        const double excess = sin2_i - eta * eta * sin2_t, allowed = 1e-15 * (1 + eta * eta);
        EXPECT_TRUE(std::abs(excess) <= allowed || (cos_t <= 0 && excess > 0))
            << eta << ' ' << c << ' ' << excess;
    }
}

TEST(geometry, refracted_cosine_keeps_its_digits_at_grazing_incidence_and_near_an_index_match) {
    random_numbers random(3);
    for (int i = 0; i < 20000 / thinning; ++i) {
        const float eta = static_cast<float>(1 + random.log_uniform(1e-7, 9));
        const float c = static_cast<float>(random.log_uniform(1e-7, 1));
        const float cos_t = refracted_cosine(eta, c);
        EXPECT_TRUE(within_relative(cos_t, static_cast<float>(refracted_cosine(real50(eta), real50(c))), 4e-7,
                                    digits(eta) + ", " + digits(c)));
        EXPECT_LE(cos_t, 1.0f) << eta << ' ' << c;
        EXPECT_EQ(refracted_cosine(1.0f, c), c);
    }
}

TEST(geometry, refracted_cosine_is_0_and_never_nan_beyond_the_critical_angle) {
    for (const float c : {0.0f, 0.1f, 0.5f, 0.7453559f})
        EXPECT_TRUE(exactly(refracted_cosine(1 / 1.5f, c), 0.0f, digits(c)));
}

} // namespace
} // namespace fresnel::test
