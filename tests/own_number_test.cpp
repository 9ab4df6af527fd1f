// A number type of a reader's own, written against the words of number.hpp alone: it counts what it does.

#include <fresnel/models.hpp>

#include <gtest/gtest.h>

#include <cmath>

namespace mine {

struct counted {
    static inline int operations = 0;
    double value = 0;

    counted(int integer) : value(integer) {}
    static counted from(double x) {
        counted result(0);
        return ++operations, result.value = x, result;
    }
    friend counted operator-(counted a) { return from(-a.value); }
    friend counted operator+(counted a, counted b) { return from(a.value + b.value); }
    friend counted operator-(counted a, counted b) { return from(a.value - b.value); }
    friend counted operator*(counted a, counted b) { return from(a.value * b.value); }
    friend counted operator/(counted a, counted b) { return from(a.value / b.value); }
    friend bool operator<(counted a, counted b) { return a.value < b.value; }
    friend bool operator>(counted a, counted b) { return a.value > b.value; }
    friend bool operator<=(counted a, counted b) { return a.value <= b.value; }
    friend bool operator>=(counted a, counted b) { return a.value >= b.value; }
    friend counted abs(counted a) { return from(std::abs(a.value)); }
    friend counted sqrt(counted a) { return from(std::sqrt(a.value)); }
    friend counted exp2(counted a) { return from(std::exp2(a.value)); }
    [[maybe_unused]] friend counted log2(counted a) { return from(std::log2(a.value)); }
    friend counted pow(counted a, counted b) { return from(std::pow(a.value, b.value)); }
};

TEST(own_number_type, runs_every_model_that_never_heard_of_it) {
    fresnel::for_each_model([](const auto& row) {
        std::vector<counted> values;
        std::vector<double> plain;
        for (const fresnel::parameter& p : row.parameters)
            plain.push_back(p.default_value), values.push_back(counted::from(p.default_value));
        counted::operations = 0;
        const auto own = evaluate(row, values, counted::from(0.3));
        const auto usual = evaluate(row, plain, 0.3);
        if constexpr (requires { own.R_s; })
            EXPECT_EQ(own.reflectance().value, usual.reflectance()) << row.name;
        else
            EXPECT_EQ(own.value, usual) << row.name;
        EXPECT_GT(counted::operations, 0) << row.name;
    });
}

} // namespace mine

template <>
struct std::numeric_limits<mine::counted> : std::numeric_limits<double> {
}; // conductor_precise asks for the digits
