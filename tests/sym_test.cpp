// Expression graphs: what they hold is the float model, operation by operation.

#include "emit/function.hpp"
#include "emit/printer.hpp"

#include "error.hpp"
#include "inputs.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <bit>
#include <random>

namespace fresnel::test {
namespace {

using emit::function;

/// Computes a graph in float, node by node, in the order in which it stands.
class interpreter {
public:
    interpreter(const function& f, const std::map<std::string, float>& inputs) : value_(f.graph.size()) {
        for (std::uint32_t i = 0; i < f.graph.size(); ++i) {
            const expression& x = f.graph[i];
            if (x.op == operation::input)
                value_[i] = inputs.at(x.name);
            else if (x.op == operation::constant)
                value_[i] = x.value[0];
            else if (x.op == operation::choose)
                value_[i] = value_[x.operands[0]] != 0 ? value_[x.operands[1]] : value_[x.operands[2]];
            else
                value_[i] = fold(x.op, value_[x.operands[0]], arity(x.op) > 1 ? value_[x.operands[1]] : 0.0f);
        }
    }
    float operator[](std::uint32_t node) const { return value_[node]; }

private:
    std::vector<float> value_;
};

/// Parameters and angles: edges, and places between them.
std::vector<std::vector<float>> some_inputs(const model_row<float>& row, int count) {
    std::mt19937 random(7);
    std::vector<std::vector<float>> all;
    for (int i = 0; i < count; ++i) {
        std::vector<float> one;
        for (const parameter& p : row.parameters) {
            const double lo = std::max(p.min, 0.001), hi = std::min(p.max, 10.0);
            const double u = std::uniform_real_distribution<double>(0, 1)(random);
            one.push_back(static_cast<float>(i % 7 == 0 ? p.default_value : lo * std::pow(hi / lo, u)));
        }
        const float edges[] = {0.0f, 1.0f, 1.0f / 7, 1e-6f, 0.999999f};
        one.push_back(i % 3 == 0 ? edges[i / 3 % 5] : std::uniform_real_distribution<float>(0, 1)(random));
        all.push_back(one);
    }
    return all;
}

void expect_bits(float expected, float actual, const std::string& where) {
    if (std::isnan(expected) && std::isnan(actual)) return;
    EXPECT_EQ(std::bit_cast<std::uint32_t>(expected), std::bit_cast<std::uint32_t>(actual))
        << where << ": " << expected << " and " << actual;
}

TEST(sym, graph_of_every_model_computes_the_bits_of_the_float_model) {
    for (const model_row<float>& row : model_table<float>()) {
        const function f = emit::record(row.name);
        for (const std::vector<float>& x : some_inputs(row, 3000)) {
            std::map<std::string, float> inputs = {{"cos_i", x.back()}};
            for (std::size_t i = 0; i < row.parameters.size(); ++i)
                inputs[std::string(row.parameters[i].name)] = x[i];
            const interpreter run(f, inputs);
            const boundary<float> R = row.evaluate(x.data(), x.back());
            expect_bits(row.polarised() ? R.reflectance() : R.R_s, run[f.results[0].node],
                        std::string(row.name));
            if (HasFailure()) return;
        }
    }
}

TEST(sym, graph_of_every_exact_model_computes_the_bits_of_each_polarisation) {
    for (const model_row<float>& row : model_table<float>()) {
        if (!row.polarised()) continue;
        emit::request wanted;
        wanted.boundary = true;
        const function f = emit::record(row.name, wanted);
        for (const std::vector<float>& x : some_inputs(row, 1000)) {
            std::map<std::string, float> inputs = {{"cos_i", x.back()}};
            for (std::size_t i = 0; i < row.parameters.size(); ++i)
                inputs[std::string(row.parameters[i].name)] = x[i];
            const interpreter run(f, inputs);
            const boundary<float> R = row.evaluate(x.data(), x.back());
            expect_bits(R.R_s, run[f.results[0].node], "R_s");
            expect_bits(R.R_p, run[f.results[1].node], "R_p");
            expect_bits(R.T_s, run[f.results[2].node], "T_s");
            expect_bits(R.T_p, run[f.results[3].node], "T_p");
            if (HasFailure()) return;
        }
    }
}

TEST(sym, fixed_parameters_fold_to_the_bits_of_the_float_model) {
    for (const model_row<float>& row : model_table<float>())
        for (const std::vector<float>& x : some_inputs(row, 200)) {
            emit::request wanted;
            for (std::size_t i = 0; i < row.parameters.size(); ++i) {
                const auto value = static_cast<double>(x[i]);
                wanted.fixed[std::string(row.parameters[i].name)] = {value, value, value};
            }
            const function f = emit::record(row.name, wanted);
            ASSERT_EQ(f.arguments.size(), 1u);
            const interpreter run(f, {{"cos_i", x.back()}});
            const boundary<float> R = row.evaluate(x.data(), x.back());
            expect_bits(row.polarised() ? R.reflectance() : R.R_s, run[f.results[0].node],
                        std::string(row.name));
            if (HasFailure()) return;
        }
}

TEST(sym, three_channels_are_the_scalar_function_three_times) {
    for (const model_row<float>& row : model_table<float>()) {
        emit::request wanted;
        wanted.width = 3;
        const function rgb = emit::record(row.name, wanted);
        if (rgb.width() != 3) continue;
        const function split = emit::scalarized(
            rgb, [](std::string_view name, int i) { return std::string(name) + "." + "xyz"[i]; });
        const function scalar = emit::record(row.name);
        for (const std::vector<float>& x : some_inputs(row, 100)) {
            std::map<std::string, float> one = {{"cos_i", x.back()}}, three = one;
            for (std::size_t i = 0; i < row.parameters.size(); ++i) {
                const std::string name(row.parameters[i].name);
                one[name] = three[name] = x[i];
                for (const char c : {'x', 'y', 'z'})
                    three[name + "." + c] = x[i];
            }
            const interpreter a(scalar, one), b(split, three);
            for (const result& r : split.results)
                expect_bits(a[scalar.results[0].node], b[r.node], std::string(row.name));
            if (HasFailure()) return;
        }
    }
}

TEST(sym, same_operation_on_the_same_operands_is_one_node) {
    expression_graph graph;
    const recording scope(graph);
    const sym x = graph.input("x"), y = graph.input("y");
    const sym product = x * y, sum = x + y;
    EXPECT_EQ(product.node(), (y * x).node());
    EXPECT_EQ(sum.node(), (y + x).node());
    EXPECT_NE((x - y).node(), (y - x).node());
    EXPECT_EQ(graph[(y * x).node()].operands[0], x.node()) << "in the order first written";
    EXPECT_EQ(graph.input("x").node(), x.node());
}

TEST(sym, sums_and_products_are_not_rearranged) {
    expression_graph graph;
    const recording scope(graph);
    const sym x = graph.input("x"), y = graph.input("y"), z = graph.input("z");
    EXPECT_NE(((x + y) + z).node(), (x + (y + z)).node());
    EXPECT_NE(((x * y) * z).node(), (x * (y * z)).node());
    EXPECT_NE((x / y).node(), (x * (1 / y)).node());
}

TEST(sym, constants_are_folded_in_float) {
    expression_graph graph;
    const recording scope(graph);
    const sym folded = 1 - ratio<sym, 7, 10>() * ratio<sym, 1, 3>();
    ASSERT_TRUE(graph.is_constant(folded.node()));
    EXPECT_EQ(graph[folded.node()].value[0], 1.0f - 0.7f * (1.0f / 3.0f));
    const sym x = graph.input("x");
    EXPECT_EQ((1 * x).node(), x.node());
    EXPECT_EQ((x + 0).node(), x.node());
    EXPECT_EQ((x - 0).node(), x.node());
    EXPECT_EQ((x / 1).node(), x.node());
    EXPECT_TRUE(graph.is((0 * x).node(), 0));
    EXPECT_NE((0 - x).node(), x.node());
}

TEST(sym, a_call_is_noted_beside_the_operations_that_it_stands_for) {
    expression_graph graph;
    const recording scope(graph);
    const sym x = graph.input("x"), y = graph.input("y");
    const twofold<sym> sum = let("sum", two_sum(x, y));
    const expression hi = graph[sum.hi.node()];
    EXPECT_EQ(hi.op, operation::add);
    const function_call* call = graph.call_of(sum.lo.node());
    ASSERT_NE(call, nullptr);
    EXPECT_EQ(call, graph.call_of(sum.hi.node()));
    EXPECT_EQ(call->function, "two_sum");
    EXPECT_EQ(call->name, "sum");
    EXPECT_EQ(call->arguments, (std::vector<std::vector<std::uint32_t>>{{x.node()}, {y.node()}}));

    const twofold<sym> product = sum * two_product(x, y);
    EXPECT_EQ(graph.call_of(product.hi.node())->function, "twofold_product") << "the outer call, not two_sum";
    EXPECT_EQ(graph.call_of(product.hi.node())->arguments[0],
              (std::vector<std::uint32_t>{sum.hi.node(), sum.lo.node()}));

    const twofold<sym> same = two_sum(x, sym(0));
    EXPECT_EQ(same.hi.node(), x.node());
    EXPECT_EQ(graph.call_of(x.node()), nullptr) << "an input is no result";
}

TEST(sym, operands_stand_before_what_is_made_of_them) {
    for (const model_row<double>& row : model_table<double>()) {
        const function f = emit::record(row.name);
        for (std::uint32_t i = 0; i < f.graph.size(); ++i)
            for (std::size_t k = 0; k < arity(f.graph[i].op); ++k)
                ASSERT_LT(f.graph[i].operands[k], i) << row.name;
    }
}

TEST(sym, a_hundred_thousand_nodes_deep_is_printed_without_recursion) {
    function f;
    f.name = "deep", f.arguments = {{"x", 1, ""}};
    const recording scope(f.graph);
    const sym x = f.graph.input("x");
    sym sum = x;
    for (int i = 0; i < 100000; ++i)
        sum = let("s", sum * x + 1);
    f.results = {{"R", sum.node()}};
    simplify(f);
    const std::string text = emit::print(emit::find_language("glsl"), f);
    EXPECT_NE(text.find("s_99999 ="), std::string::npos);
}

// A function of x, simplified: its text after "return ", and its value at -1, 0 and 4.
void expect_simplified(const std::function<sym(sym)>& body, const std::string& text,
                       std::array<float, 3> values) {
    function f;
    f.name = "guarded", f.arguments = {{"x", 1, ""}};
    const recording scope(f.graph);
    f.results = {{"R", body(f.graph.input("x")).node()}};
    simplify(f);
    const std::string printed = emit::print(emit::find_language("glsl"), f);
    EXPECT_NE(printed.find("return " + text + ";"), std::string::npos) << printed;
    std::size_t i = 0;
    for (const float at : {-1.0f, 0.0f, 4.0f})
        EXPECT_EQ((interpreter(f, {{"x", at}})[f.results[0].node]), values[i++]) << printed << at;
}

TEST(sym, a_branch_that_repeats_its_own_comparison_is_shortened) {
    expect_simplified([](sym x) { return select(x <= 0, sym(2), sqrt(select(x <= 0, sym(1), x))); },
                      "x <= 0.0 ? 2.0 : sqrt(x)", {2, 2, 2});
}

TEST(sym, a_guarded_root_is_the_root_of_a_maximum) {
    expect_simplified([](sym x) { return select(x <= 0, sym(0), sqrt(select(x <= 0, sym(1), x))); },
                      "sqrt(max(x, 0.0))", {0, 0, 2});
    expect_simplified([](sym x) { return select(x <= 1, sym(0), sqrt(x)); }, "x <= 1.0 ? 0.0 : sqrt(x)",
                      {0, 0, 2});
}

TEST(sym, choices_with_a_constant_are_made_once_at_the_end) {
    expect_simplified([](sym x) { return select(x <= 0, sym(1), x * 3) + select(x <= 0, sym(2), x / 3) * 2; },
                      "x <= 0.0 ? 5.0 : x * 3.0 + x / 3.0 * 2.0", {5, 5, 12 + 4.0f / 3 * 2});
    // made outside, this one would be made twice
    expect_simplified([](sym x) { return select(x <= 0, sym(1), x) * x; }, "(x <= 0.0 ? 1.0 : x) * x",
                      {-1, 0, 16});
}

// ---- text -------------------------------------------------------------------------------------------------

std::string returned(const std::function<sym(sym, sym, sym)>& body, std::string_view language = "glsl") {
    function f;
    f.name = "f", f.arguments = {{"a", 1, ""}, {"b", 1, ""}, {"d", 1, ""}};
    const recording scope(f.graph);
    f.results = {{"R", body(f.graph.input("a"), f.graph.input("b"), f.graph.input("d")).node()}};
    const std::string text = emit::print(emit::find_language(language), f);
    const std::size_t begin = text.find("return ") + 7;
    return text.substr(begin, text.find(';', begin) - begin);
}

// By hand:
//   schlick           1 - c, three multiplications of pow5, 1 - f0, *, +
//   air_conductor     k2 1; R_s 2 (+, square, + k2) and a division 4; n c, c c and k2 (c c) 3, R_p 2 (+, square, +) and
//                     a division 4; R_s + R_p and its half 2
//   schlick_internal  f0 7: eta - 1, eta + 1, a division, a square; g2 3, the two sums being those of f0;
//                     comparison, root 4, division 4, min and selection 11; schlick 7
TEST(operations, are_counted_once_each_as_by_hand) {
    EXPECT_EQ(count_operations("schlick").cost(), 7);
    EXPECT_EQ(count_operations("air_conductor").cost(), 1 + (6 + 4) + 3 + (6 + 4) + 2);
    EXPECT_EQ(count_operations("schlick_internal").cost(), 7 + 3 + 11 + 7);
    EXPECT_EQ(count_operations("schlick", 3).cost(), 4 + 3 * 3) << "(1 - c)^5 serves all channels";
    EXPECT_EQ(count_operations("schlick_internal").division, 2);
    EXPECT_EQ(count_operations("schlick_internal").root, 1);
}

// Without n_i conductor_fast has no n_i cos_i, n_i sin2 and n_i n_i, and its c2 is cos2.
TEST(operations, in_vacuum_have_no_index_outside) {
    EXPECT_EQ(count_operations_in_vacuum("conductor_fast").cheap,
              count_operations("conductor_fast").cheap - 4);
    EXPECT_EQ(count_operations_in_vacuum("conductor_fast").division, 2);
    EXPECT_EQ(count_operations_in_vacuum("schlick").cost(), count_operations("schlick").cost());
}

TEST(operations, are_those_of_the_text) {
    for (const model_row<double>& row : model_table<double>())
        for (const int width : {1, 3}) {
            const function f = emit::record(row.name, {.width = width, .boundary = false, .fixed = {}});
            const int cost = count_operations(row.name, width).cost();
            EXPECT_EQ(count_operations(f).cost(), cost) << row.name;
            const std::string line = "cost    " + std::to_string(cost) + " operations";
            EXPECT_EQ(std::count(f.comment.begin(), f.comment.end(), line), 1) << row.name << ": " << line;
        }
}

TEST(printer, writes_the_parentheses_that_keep_the_order_and_no_others) {
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return a + b + c; }), "a + b + d");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return a + (b + c); }), "a + (b + d)");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return a - (b - c); }), "a - (b - d)");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return a * (b * c); }), "a * (b * d)");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return a / (b * c); }), "a / (b * d)");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return a / b * c; }), "a / b * d");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return (a + b) * c; }), "(a + b) * d");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return a + b * c; }), "a + b * d");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return a - -(b * c); }), "a - (-(b * d))");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return -a * b + c; }), "-a * b + d");
    EXPECT_EQ(returned([](sym a, sym b, sym) { return a + ratio<sym, -1, 2>() * b; }), "a + (-0.5 * b)");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return select(a < 0, b, c) + 1; }),
              "(a < 0.0 ? b : d) + 1.0");
    EXPECT_EQ(returned([](sym a, sym b, sym c) { return select(a > b, b, c); }, "wgsl"),
              "select(d, b, b < a)");
}

TEST(printer, writes_a_call_once_and_its_pair_where_it_is_used) {
    function f;
    f.name = "f", f.arguments = {{"a", 1, ""}, {"b", 1, ""}};
    const recording scope(f.graph);
    const sym a = f.graph.input("a"), b = f.graph.input("b");
    const twofold<sym> p = let("p", two_product(a, b));
    const twofold<sym> s = let("s", p - twofold<sym>{sym(1), sym(0)}, "a b - 1");
    f.results = {{"R", (s.hi + s.lo * p.hi).node()}};
    simplify(f);
    const auto body = [&](std::string_view language) {
        const std::string text = emit::print(emit::find_language(language), f);
        return text.substr(text.find("{\n") + 2);
    };
    EXPECT_EQ(body("glsl"), "    vec2 p = two_product(a, b);\n"
                            "    vec2 s = twofold_difference(p, vec2(1.0, 0.0)); // a b - 1\n"
                            "    return s.x + s.y * p.x;\n}\n");
    EXPECT_EQ(
        body("c"),
        "    const fresnel_float2 p = two_product(a, b);\n"
        "    const fresnel_float2 s = twofold_difference(p, fresnel_make_float2(1.0f, 0.0f)); // a b - 1\n"
        "    return s.x + s.y * p.x;\n}\n");
    EXPECT_TRUE(emit::calls_twofold(f));
}

TEST(printer, writes_the_title_of_a_step_above_it) {
    function f;
    f.name = "f", f.arguments = {{"a", 1, ""}};
    const recording scope(f.graph);
    const sym a = f.graph.input("a");
    const sym b = let("b", a + 2, "first\nabove 2");
    f.results = {{"R", (let("c", b * a, "second\n") - b).node()}};
    EXPECT_EQ(emit::print(emit::find_language("glsl"), f), "float f(float a) {\n"
                                                           "    // first\n"
                                                           "    float b = a + 2.0; // above 2\n"
                                                           "\n"
                                                           "    // second\n"
                                                           "    float c = b * a;\n"
                                                           "    return c - b;\n"
                                                           "}\n");
}

TEST(printer, writes_the_shortest_literal_that_reads_back_and_never_an_integer) {
    const emit::language& glsl = emit::find_language("glsl");
    const emit::language& c = emit::find_language("c");
    EXPECT_EQ(emit::literal(glsl, 1), "1.0");
    EXPECT_EQ(emit::literal(glsl, 0.04f), "0.04");
    EXPECT_EQ(emit::literal(c, 0.1f), "0.1f");
    EXPECT_EQ(emit::literal(glsl, 1e-20f), "1e-20");
    EXPECT_EQ(emit::literal(glsl, -16777216), "-16777216.0");
    EXPECT_THROW(emit::literal(glsl, INFINITY), failure);
    std::mt19937 random(3);
    for (int i = 0; i < 100000; ++i) {
        const float value = std::bit_cast<float>(static_cast<std::uint32_t>(random()));
        if (!std::isnormal(value)) continue;
        ASSERT_EQ(std::strtof(emit::literal(glsl, value).c_str(), nullptr), value);
        ASSERT_EQ(static_cast<float>(std::strtod(emit::literal(glsl, value).c_str(), nullptr)), value);
    }
}

TEST(printer, makes_every_name_one_that_the_language_accepts) {
    const auto legal = [](std::string_view language, std::string_view name) {
        return emit::legal_name(emit::find_language(language), name);
    };
    EXPECT_EQ(legal("glsl", "mix"), "mix_");
    EXPECT_EQ(legal("glsl", "sample"), "sample_");
    EXPECT_EQ(legal("hlsl", "sample"), "sample_");
    EXPECT_EQ(legal("wgsl", "new"), "new_");
    EXPECT_EQ(legal("c", "new"), "new_") << "a header that C++ includes too";
    EXPECT_EQ(legal("glsl", "__x"), "x");
    EXPECT_EQ(legal("glsl", "a__b"), "a_b");
    EXPECT_EQ(legal("glsl", "gl_Position"), "f_gl_Position");
    EXPECT_EQ(legal("osl", "normal"), "normal_");
    EXPECT_EQ(legal("glsl", "normal"), "normal");
    EXPECT_EQ(legal("c", "2fast"), "f_2fast");
    EXPECT_EQ(legal("c", "a-b c"), "a_b_c");
}

} // namespace
} // namespace fresnel::test
