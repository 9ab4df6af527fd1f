#include "analysis/graph.hpp"

#include <cmath>
#include <optional>

namespace fresnel {

namespace {

// The nodes behind one node, itself included.
std::vector<bool> reach(const expression_graph& graph, std::initializer_list<std::uint32_t> roots) {
    std::vector<bool> reached(graph.size());
    std::uint32_t last = 0;
    for (const std::uint32_t root : roots)
        reached[root] = true, last = std::max(last, root);
    for (std::uint32_t i = last + 1; i-- > 0;)
        if (reached[i])
            for (std::size_t k = 0; k < arity(graph[i].op); ++k)
                reached[graph[i].operands[k]] = true;
    return reached;
}

std::uint32_t rebuilt(expression_graph& graph, std::uint32_t node, const std::vector<std::uint32_t>& now) {
    const expression x = graph[node];
    std::array<std::uint32_t, 3> operands = x.operands;
    bool changed = false;
    for (std::size_t k = 0; k < arity(x.op); ++k) {
        operands[k] = now[x.operands[k]];
        changed = changed || operands[k] != x.operands[k];
    }
    if (!changed) return node;
    const std::uint32_t made = graph.make(x.op, operands);
    graph.pass_name(node, made);
    return made;
}

// `node`, given that the mask holds or does not.
std::uint32_t assume(expression_graph& graph, std::uint32_t node, std::uint32_t mask, bool holds) {
    const std::vector<bool> wanted = reach(graph, {node});
    std::vector<std::uint32_t> now(node + 1);
    for (std::uint32_t i = 0; i <= node; ++i) {
        now[i] = i;
        if (!wanted[i]) continue;
        const expression x = graph[i];
        if (x.op == operation::choose && x.operands[0] == mask) {
            now[i] = now[x.operands[holds ? 1 : 2]];
            graph.pass_name(i, now[i]);
        } else {
            now[i] = rebuilt(graph, i, now);
        }
    }
    return now[node];
}

// m ? a : f(m ? b : c) becomes m ? a : f(c).
std::uint32_t without_repetition(expression_graph& graph, std::uint32_t node) {
    const expression x = graph[node];
    if (x.op != operation::choose) return node;
    const std::uint32_t yes = assume(graph, x.operands[1], x.operands[0], true);
    const std::uint32_t no = assume(graph, x.operands[2], x.operands[0], false);
    return graph.make(operation::choose, {x.operands[0], yes, no});
}

// x <= 0 ? 0 : sqrt(x) becomes sqrt(max(x, 0)).
std::uint32_t without_guard(expression_graph& graph, std::uint32_t node) {
    const expression x = graph[node];
    if (x.op != operation::choose) return node;
    const expression mask = graph[x.operands[0]], root = graph[x.operands[2]];
    const bool guards = mask.op == operation::less_equal && graph.is(mask.operands[1], 0) &&
                        graph.is(x.operands[1], 0) && root.op == operation::square_root &&
                        root.operands[0] == mask.operands[0];
    if (!guards) return node;
    const std::uint32_t positive = graph.make(operation::maximum, mask.operands);
    return graph.make(operation::square_root, {positive, 0, 0});
}

// The mask of a choice between a constant and something else, if every operand of the node is such a choice of the same
// mask and the same side, or a constant.
std::optional<std::uint32_t> common_mask(const expression_graph& graph, const expression& x,
                                         std::size_t side) {
    std::optional<std::uint32_t> mask;
    for (std::size_t k = 0; k < arity(x.op); ++k) {
        const expression& operand = graph[x.operands[k]];
        if (operand.op == operation::constant) continue;
        if (operand.op != operation::choose || !graph.is_constant(operand.operands[side]))
            return std::nullopt;
        if (mask && *mask != operand.operands[0]) return std::nullopt;
        mask = operand.operands[0];
    }
    return mask;
}

// f(m ? 1 : a, m ? 2 : b) becomes m ? f(1, 2) : f(a, b), in which f(1, 2) is a constant.
std::uint32_t with_choice_outside(expression_graph& graph, std::uint32_t node) {
    const expression x = graph[node];
    if (x.op == operation::choose || x.op == operation::dot_product) return node;
    for (const std::size_t side : {1u, 2u})
        if (const auto mask = common_mask(graph, x, side)) {
            std::array<std::uint32_t, 3> chosen = {*mask, 0, 0};
            for (const std::size_t branch : {1u, 2u}) {
                std::array<std::uint32_t, 3> operands = x.operands;
                for (std::size_t k = 0; k < arity(x.op); ++k)
                    if (const expression operand = graph[operands[k]]; operand.op == operation::choose) {
                        operands[k] = operand.operands[branch];
                        if (graph[operand.operands[branch]].named == 0)
                            graph.pass_name(x.operands[k], operands[k]);
                    }
                chosen[branch] = graph.make(x.op, operands);
            }
            return graph.make(operation::choose, chosen);
        }
    return node;
}

// Every node that the results need, operands first, made anew by `rule` of the node with its new operands.
template <class Rule>
void rewrite(recorded& f, Rule&& rule) {
    expression_graph& graph = f.graph;
    const std::size_t size = graph.size();
    const std::vector<bool> wanted = needed_nodes(f);
    std::vector<std::uint32_t> now(size);
    for (std::uint32_t i = 0; i < size; ++i) {
        now[i] = i;
        if (!wanted[i]) continue;
        now[i] = rule(graph, rebuilt(graph, i, now));
        graph.pass_name(i, now[i]);
    }
    for (result& r : f.results)
        r.node = now[r.node];
}

} // namespace

void simplify(recorded& f) {
    rewrite(f, without_repetition);
    recorded outside = f;
    rewrite(outside, with_choice_outside);
    rewrite(outside, without_repetition);
    if (count_operations(outside).cost() < count_operations(f).cost()) f = std::move(outside);
    rewrite(f, without_guard);
}

std::vector<bool> needed_nodes(const recorded& f) {
    std::vector<bool> needed(f.graph.size());
    for (const result& r : f.results)
        needed[r.node] = true;
    for (std::size_t i = f.graph.size(); i-- > 0;)
        if (needed[i])
            for (std::size_t k = 0; k < arity(f.graph[static_cast<std::uint32_t>(i)].op); ++k)
                needed[f.graph[static_cast<std::uint32_t>(i)].operands[k]] = true;
    return needed;
}

operation_count count_operations(const recorded& f) {
    const std::vector<bool> needed = needed_nodes(f);
    operation_count count{};
    for (std::uint32_t i = 0; i < f.graph.size(); ++i) {
        const expression& x = f.graph[i];
        if (!needed[i]) continue;
        switch (x.op) {
        case operation::input:
        case operation::constant:
        case operation::negate:
        case operation::absolute:
            break;
        case operation::divide: {
            // by a power of two it is a multiplication
            int exponent = 0;
            const expression& by = f.graph[x.operands[1]];
            const bool exact = by.op == operation::constant && std::frexp(by.value[0], &exponent) == 0.5f;
            (exact ? count.cheap : count.division) += x.width;
            break;
        }
        case operation::square_root:
            count.root += x.width;
            break;
        case operation::exponential2:
        case operation::logarithm2:
        case operation::logarithm:
            count.exponential += x.width;
            break;
        case operation::power:
            count.power += x.width;
            break;
        case operation::dot_product:
            count.cheap += 5;
            break;
        default:
            count.cheap += x.width;
        }
    }
    return count;
}

sym reflectance(const model_row<sym>& row, const std::vector<sym>& parameters, sym cos_i) {
    const boundary<sym> b = row.evaluate(parameters.data(), cos_i);
    return row.polarised() ? reflectance(b) : b.R_s;
}

namespace {

operation_count count_operations_of(std::string_view model, int width, bool vacuum) {
    const model_row<sym>& row = find_model<sym>(model);
    recorded f;
    const recording scope(f.graph);
    std::vector<sym> parameters;
    for (const parameter& p : row.parameters)
        parameters.push_back(vacuum && is_ambient(p) ? sym(1)
                                                     : f.graph.input(p.name, is_ambient(p) ? 1 : width));
    f.results = {{"R", reflectance(row, parameters, f.graph.input(cosine.name)).node()}};
    simplify(f);
    return count_operations(f);
}

} // namespace

operation_count count_operations(std::string_view model, int width) {
    return count_operations_of(model, width, false);
}

operation_count count_operations_in_vacuum(std::string_view model) {
    return count_operations_of(model, 1, true);
}

} // namespace fresnel
