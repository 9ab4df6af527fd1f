#pragma once

// A number that remembers how it was made: run on it, a model becomes the graph of its own expressions, which
// src/emit prints as shader text, counts and measures.
//
//     expression_graph graph;
//     const recording scope(graph);
//     const sym F = schlick(graph.input("f0", 3), graph.input("cos_i"));
//     graph[F.node()] is the sum f0 + (1 - f0) x^5, graph[graph[F.node()].operands[1]] the product, ...
//
// The graph is one flat array in which every node stands after its operands, so that a walk over it is a loop and
// never a recursion. A node is made once: the same operation on the same operands gives the same node, whose
// operands keep the order in which they were first written. Operations on constants alone are done at once, in
// float, one rounding each, as the float model does them; x + 0, x - 0, 1 x, x / 1, x^1 and -(-x) are x and 0 x is 0,
// which is so for every finite x but for the sign of a zero; a `select` between equal nodes, or by a comparison of
// constants, is the node it gives. Nothing else is rewritten and no sum or product is re-associated, so that the text made
// of a graph gives the bits of the float model.
//
// A node is one number, or three that are computed alike: an RGB value, or a vector where `dot` makes a number of
// two. An operation on one and three gives three.
//
// What `result_of` says is kept beside the nodes: the graph holds every operation, whoever counts or computes it sees
// no call, and whoever prints it may write a node as a result of the call instead of its operation.

#include <fresnel/number.hpp>
#include <fresnel/twofold.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

namespace fresnel {

/// How a node is made of its operands.
enum class operation : std::uint8_t {
    input,
    constant,
    negate,
    add,
    subtract,
    multiply,
    divide,
    square_root,
    absolute,
    minimum,
    maximum,
    exponential2,
    logarithm2,
    logarithm,
    power,
    dot_product,
    less,       ///< a < b, a mask
    less_equal, ///< a <= b, a mask
    choose      ///< the second operand where the first, a mask, holds; otherwise the third
};

/// A node of an expression graph.
struct expression {
    operation op = operation::constant;
    int width = 1;                           ///< 1, or 3 for an RGB value or a vector
    std::array<std::uint32_t, 3> operands{}; ///< indices of earlier nodes, `arity` of them
    std::array<float, 3> value{};            ///< of a constant: all equal for width 1
    std::string name{};                      ///< of an input, or what `let` called it; otherwise empty
    std::string remark{};                    ///< what `let` said of it
    std::uint32_t named = 0;                 ///< the how manieth name of its graph that is; 0 is none
    std::uint32_t call = 0; ///< the how manieth call of its graph it is a result of; 0 is none
};

/// A function that printed text calls: what it is given, and the two nodes that it makes.
struct function_call {
    std::string function;
    std::vector<std::vector<std::uint32_t>> arguments; ///< one node each, or the two of a twofold
    std::array<std::uint32_t, 2> results{};
    std::string name{}, remark{}; ///< of the pair, by `let`
    std::uint32_t named = 0;
};

/// The number of operands an operation takes.
constexpr std::size_t arity(operation op) {
    switch (op) {
    case operation::input:
    case operation::constant:
        return 0;
    case operation::negate:
    case operation::square_root:
    case operation::absolute:
    case operation::exponential2:
    case operation::logarithm2:
    case operation::logarithm:
        return 1;
    case operation::choose:
        return 3;
    default:
        return 2;
    }
}

class expression_graph;

/// A node of the graph that is being recorded, behind the vocabulary of number.hpp.
class sym {
public:
    sym(int integer);
    explicit sym(std::uint32_t node) : node_(node) {}
    template <class U>
    sym(U) = delete; // a double would be cut to an int; `constant` takes a float
    /// A measured value or a parameter that is fixed.
    static sym constant(float value);
    static sym constant(std::array<float, 3> values);
    std::uint32_t node() const { return node_; }

private:
    std::uint32_t node_;
};

/// The result of a comparison. It has no conversion to bool: a symbol has no truth yet.
class sym_mask {
public:
    explicit sym_mask(std::uint32_t node) : node_(node) {}
    std::uint32_t node() const { return node_; }

private:
    std::uint32_t node_;
};

/// What a constant operation gives, for one channel, as the float model computes it.
inline float fold(operation op, float a, float b) {
    switch (op) {
    case operation::negate:
        return -a;
    case operation::add:
        return a + b;
    case operation::subtract:
        return a - b;
    case operation::multiply:
        return a * b;
    case operation::divide:
        return a / b;
    case operation::square_root:
        return std::sqrt(a);
    case operation::absolute:
        return std::abs(a);
    case operation::minimum:
        return fresnel::min(a, b);
    case operation::maximum:
        return fresnel::max(a, b);
    case operation::exponential2:
        return std::exp2(a);
    case operation::logarithm2:
        return std::log2(a);
    case operation::logarithm:
        return std::log(a);
    case operation::power:
        return std::pow(a, b);
    case operation::less:
        return a < b ? 1.0f : 0.0f;
    default:
        return a <= b ? 1.0f : 0.0f;
    }
}

/// Nodes in the order they were made.
class expression_graph {
public:
    /// A variable of the expressions, one number or three. The same name gives the same node.
    sym input(std::string_view name, int width = 1) {
        for (std::uint32_t i = 0; i < nodes_.size(); ++i)
            if (nodes_[i].op == operation::input && nodes_[i].name == name) return sym(i);
        expression node{operation::input, width};
        node.name = name;
        nodes_.push_back(node);
        return sym(static_cast<std::uint32_t>(nodes_.size() - 1));
    }

    std::uint32_t constant(std::array<float, 3> value, int width) {
        expression node{operation::constant, width};
        node.value = value;
        return shared(node);
    }

    /// The node of an operation, a new one only where there is none; constants are folded.
    std::uint32_t make(operation op, std::array<std::uint32_t, 3> operands) {
        if (op == operation::choose) return choice(operands);
        const std::size_t n = arity(op);
        bool constant_operands = op != operation::dot_product;
        int width = 1;
        for (std::size_t i = 0; i < n; ++i) {
            constant_operands = constant_operands && is_constant(operands[i]);
            if (op != operation::dot_product) width = std::max(width, nodes_[operands[i]].width);
        }
        if (constant_operands) return folded(op, operands, width);
        if (n == 2) {
            const std::uint32_t kept = without_effect(op, operands[0], operands[1], width);
            if (kept != none) return kept;
        }
        if (op == operation::negate && nodes_[operands[0]].op == operation::negate)
            return nodes_[operands[0]].operands[0];
        return shared({op, width, operands});
    }

    /// Names a node that has no name yet. Inputs keep theirs; one number that is constant is written as such.
    void name(std::uint32_t node, std::string_view given, std::string_view remark = {}) {
        expression& x = nodes_[node];
        if (!can_be_named(x)) return;
        x.name = given;
        x.remark = remark;
        x.named = ++names_;
    }

    /// Gives the name of a node, and its place among the names, to the node that takes its place.
    void pass_name(std::uint32_t from, std::uint32_t to) {
        if (nodes_[from].named == 0 || !can_be_named(nodes_[to])) return;
        nodes_[to].name = nodes_[from].name;
        nodes_[to].remark = nodes_[from].remark;
        nodes_[to].named = nodes_[from].named;
    }

    /// Notes that two nodes are what a function makes of its arguments. Inputs, constants and what was there before an
    /// argument stay what they are; a later, outer call takes the place of an earlier one.
    void note(function_call call) {
        if (call.function == own_) return;
        std::uint32_t last = 0;
        for (const auto& argument : call.arguments)
            for (const std::uint32_t node : argument)
                last = std::max(last, node);
        for (const std::uint32_t node : call.results) {
            expression& x = nodes_[node];
            if (node <= last || x.op == operation::input || x.op == operation::constant) continue;
            x.call = static_cast<std::uint32_t>(calls_.size() + 1);
            x.name.clear(), x.remark.clear(), x.named = 0;
        }
        calls_.push_back(std::move(call));
    }

    /// The graph is the body of that function, which does not call itself.
    void set_own(std::string_view function) { own_ = function; }

    /// Names the pair that a node is one of; where no call made it, the node alone.
    void name_pair(std::uint32_t node, std::string_view given, std::string_view remark) {
        if (nodes_[node].call == 0) return name(node, given, remark);
        function_call& call = calls_[nodes_[node].call - 1];
        if (call.named != 0) return;
        call.name = given;
        call.remark = remark;
        call.named = ++names_;
    }

    /// The call that a node is a result of, if it is one.
    const function_call* call_of(std::uint32_t node) const {
        return nodes_[node].call == 0 ? nullptr : &calls_[nodes_[node].call - 1];
    }
    const std::vector<function_call>& calls() const { return calls_; }

    const expression& operator[](std::uint32_t node) const { return nodes_[node]; }
    std::size_t size() const { return nodes_.size(); }
    bool is_constant(std::uint32_t node) const { return nodes_[node].op == operation::constant; }
    /// Whether a node is that constant in every channel.
    bool is(std::uint32_t node, float value) const {
        const expression& x = nodes_[node];
        return is_constant(node) && x.value[0] == value && x.value[1] == value && x.value[2] == value;
    }

private:
    static constexpr std::uint32_t none = 0xffffffff;

    static bool can_be_named(const expression& x) {
        return x.op != operation::input && (x.op != operation::constant || x.width == 3) && x.name.empty() &&
               x.call == 0;
    }

    struct key_hash {
        std::size_t operator()(const std::array<std::uint32_t, 8>& key) const {
            std::size_t h = 0;
            for (const std::uint32_t word : key)
                h = (h ^ word) * 0x9e3779b97f4a7c15u, h ^= h >> 29;
            return h;
        }
    };

    // The two orders of a sum, a product or a dot product are one node.
    static std::array<std::uint32_t, 8> key(const expression& x) {
        std::array<std::uint32_t, 3> operands = x.operands;
        if ((x.op == operation::add || x.op == operation::multiply || x.op == operation::dot_product) &&
            operands[1] < operands[0])
            std::swap(operands[0], operands[1]);
        std::array<std::uint32_t, 3> bits;
        std::memcpy(bits.data(), x.value.data(), sizeof bits);
        return {static_cast<std::uint32_t>(x.op),
                static_cast<std::uint32_t>(x.width),
                operands[0],
                operands[1],
                operands[2],
                bits[0],
                bits[1],
                bits[2]};
    }

    std::uint32_t shared(const expression& x) {
        const auto [at, added] = index_.try_emplace(key(x), static_cast<std::uint32_t>(nodes_.size()));
        if (added) nodes_.push_back(x);
        return at->second;
    }

    std::uint32_t folded(operation op, std::array<std::uint32_t, 3> operands, int width) {
        std::array<float, 3> value;
        for (std::size_t i = 0; i < 3; ++i)
            value[i] =
                fold(op, nodes_[operands[0]].value[i], arity(op) > 1 ? nodes_[operands[1]].value[i] : 0.0f);
        return constant(value, width);
    }

    // The operand that an operation returns as it is, if it does and has the width of the result.
    std::uint32_t without_effect(operation op, std::uint32_t a, std::uint32_t b, int width) {
        std::uint32_t kept = none;
        if (op == operation::add) kept = is(a, 0) ? b : is(b, 0) ? a : none;
        if (op == operation::subtract && is(b, 0)) kept = a;
        if (op == operation::multiply) kept = is(a, 1) ? b : is(b, 1) ? a : none;
        if (op == operation::divide && is(b, 1)) kept = a;
        if (op == operation::power && is(b, 1)) kept = a;
        if (op == operation::multiply && (is(a, 0) || is(b, 0))) return constant({0, 0, 0}, width);
        return kept != none && nodes_[kept].width == width ? kept : none;
    }

    std::uint32_t choice(std::array<std::uint32_t, 3> operands) {
        const auto [mask, yes, no] = operands;
        const int width = std::max({nodes_[mask].width, nodes_[yes].width, nodes_[no].width});
        if (yes == no && nodes_[yes].width == width) return yes;
        if (is(mask, 1) && nodes_[yes].width == width) return yes;
        if (is(mask, 0) && nodes_[no].width == width) return no;
        return shared({operation::choose, width, operands});
    }

    std::vector<expression> nodes_;
    std::unordered_map<std::array<std::uint32_t, 8>, std::uint32_t, key_hash> index_;
    std::uint32_t names_ = 0;
    std::vector<function_call> calls_;
    std::string own_;
};

/// Makes a graph the one that this thread's symbols are recorded in, for the lifetime of this object.
class recording {
public:
    explicit recording(expression_graph& graph) : before_(current_) { current_ = &graph; }
    ~recording() { current_ = before_; }
    recording(const recording&) = delete;
    recording& operator=(const recording&) = delete;
    /// The graph being recorded; there must be one.
    static expression_graph& graph() { return *current_; }

private:
    static inline thread_local expression_graph* current_ = nullptr;
    expression_graph* before_;
};

inline sym sym::constant(float value) { return sym(recording::graph().constant({value, value, value}, 1)); }
inline sym sym::constant(std::array<float, 3> values) { return sym(recording::graph().constant(values, 3)); }
inline sym::sym(int integer) : sym(constant(static_cast<float>(integer))) {}

inline sym made(operation op, sym a) { return sym(recording::graph().make(op, {a.node(), 0, 0})); }
inline sym made(operation op, sym a, sym b) {
    return sym(recording::graph().make(op, {a.node(), b.node(), 0}));
}

inline sym operator-(sym a) { return made(operation::negate, a); }
inline sym operator+(sym a, sym b) { return made(operation::add, a, b); }
inline sym operator-(sym a, sym b) { return made(operation::subtract, a, b); }
inline sym operator*(sym a, sym b) { return made(operation::multiply, a, b); }
inline sym operator/(sym a, sym b) { return made(operation::divide, a, b); }
inline sym sqrt(sym a) { return made(operation::square_root, a); }
inline sym abs(sym a) { return made(operation::absolute, a); }
inline sym min(sym a, sym b) { return made(operation::minimum, a, b); }
inline sym max(sym a, sym b) { return made(operation::maximum, a, b); }
inline sym exp2(sym a) { return made(operation::exponential2, a); }
inline sym log2(sym a) { return made(operation::logarithm2, a); }
inline sym log(sym a) { return made(operation::logarithm, a); }
inline sym pow(sym a, sym b) { return made(operation::power, a, b); }
/// Of two vectors, one number.
inline sym dot(sym a, sym b) { return made(operation::dot_product, a, b); }

inline sym_mask operator<(sym a, sym b) { return sym_mask(made(operation::less, a, b).node()); }
inline sym_mask operator<=(sym a, sym b) { return sym_mask(made(operation::less_equal, a, b).node()); }
inline sym_mask operator>(sym a, sym b) { return b < a; }
inline sym_mask operator>=(sym a, sym b) { return b <= a; }

inline sym select(sym_mask m, sym yes, sym no) {
    return sym(recording::graph().make(operation::choose, {m.node(), yes.node(), no.node()}));
}

inline sym let(const char* name, sym x, const char* remark = "") {
    recording::graph().name(x.node(), name, remark);
    return x;
}

inline twofold<sym> let(const char* name, twofold<sym> x, const char* remark = "") {
    recording::graph().name_pair(x.hi.node(), name, remark);
    return x;
}

inline std::vector<std::uint32_t> nodes_of(sym x) { return {x.node()}; }
inline std::vector<std::uint32_t> nodes_of(twofold<sym> x) { return {x.hi.node(), x.lo.node()}; }

template <class... Arguments>
twofold<sym> result_of(const char* function, twofold<sym> value, const Arguments&... arguments) {
    recording::graph().note({function, {nodes_of(arguments)...}, {value.hi.node(), value.lo.node()}});
    return value;
}

} // namespace fresnel

/// The properties of the float that the text computes with.
template <>
struct std::numeric_limits<fresnel::sym> : std::numeric_limits<float> {};
