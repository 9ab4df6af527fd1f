#include "emit/locals.hpp"

#include "emit/printer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>

namespace fresnel::emit {

locals::locals(const language& l, const function& f) : l_(l), f_(f) {
    count_uses();
    place_all();
    name_all();
}

// ---- which nodes ------------------------------------------------------------------------------------------

bool locals::is_mask(std::uint32_t node) const {
    return at(node).op == operation::less || at(node).op == operation::less_equal;
}

// Written out wherever it is used, never a variable of its own.
bool locals::is_transparent(std::uint32_t node) const {
    return at(node).call == 0 && (is_mask(node) || at(node).op == operation::negate);
}

bool locals::reads(std::string_view argument) const {
    for (std::uint32_t i = 0; i < f_.graph.size(); ++i) {
        const expression& x = at(i);
        if (uses_[i] > 0 && x.op == operation::input &&
            x.name.substr(0, x.name.find_first_of(".[")) == argument)
            return true;
    }
    return false;
}

// What a node is written with: the arguments of its call, or its operands.
std::vector<std::uint32_t> locals::behind(std::uint32_t node) const {
    std::vector<std::uint32_t> nodes;
    if (const function_call* call = f_.graph.call_of(node))
        for (const auto& argument : call->arguments)
            nodes.insert(nodes.end(), argument.begin(), argument.end());
    else
        nodes.assign(at(node).operands.begin(), at(node).operands.begin() + arity(at(node).op));
    return nodes;
}

// The arguments of a call are used once, however many of its results are.
void locals::count_uses() {
    uses_.assign(f_.graph.size(), 0);
    std::vector<bool> counted(f_.graph.calls().size());
    for (const result& r : f_.results)
        ++uses_[r.node];
    for (auto node = static_cast<std::uint32_t>(f_.graph.size()); node-- > 0;) {
        if (uses_[node] == 0) continue;
        const std::uint32_t call = at(node).call;
        if (call != 0 && counted[call - 1]) continue;
        if (call != 0) counted[call - 1] = true;
        for (const std::uint32_t operand : behind(node))
            uses_[operand] += is_transparent(node) ? uses_[node] : 1;
    }
}

bool locals::is_only_result(std::uint32_t node) const {
    return f_.results.size() == 1 && f_.results.front().node == node && uses_[node] == 1;
}

const function_call* locals::returned_call() const {
    if (f_.results.size() != 2) return nullptr;
    const std::uint32_t x = f_.results[0].node, y = f_.results[1].node;
    const bool alone = at(x).call == at(y).call && uses_[x] == 1 && uses_[y] == 1;
    return alone ? f_.graph.call_of(x) : nullptr;
}

bool locals::is_local(std::uint32_t node) const {
    const expression& x = at(node);
    if (uses_[node] == 0 || x.op == operation::input) return false;
    if (x.call != 0) return f_.graph.call_of(node) != returned_call();
    if (x.op == operation::constant) return x.width == 3;
    if (is_transparent(node) || is_only_result(node)) return false;
    return x.named != 0 || uses_[node] > 1;
}

// The place of a node among the names that `let` gave; 0 is none.
std::uint32_t locals::named(std::uint32_t node) const {
    const function_call* call = f_.graph.call_of(node);
    return call != nullptr ? call->named : at(node).named;
}

// ---- in which order ---------------------------------------------------------------------------------------

// The locals behind a node that have no place yet, operands first.
void locals::place(std::uint32_t root) {
    struct visit {
        std::uint32_t node;
        std::vector<std::uint32_t> behind;
        std::size_t next = 0;
    };
    std::vector<visit> open;
    open.push_back({root, behind(root)});
    while (!open.empty()) {
        visit& now = open.back();
        if (now.next < now.behind.size() && !placed_[now.node]) {
            const std::uint32_t operand = now.behind[now.next++];
            open.push_back({operand, behind(operand)});
            continue;
        }
        const std::uint32_t done = now.node;
        open.pop_back();
        if (placed_[done]) continue;
        placed_[done] = true;
        if (!is_local(done)) continue;
        const std::uint32_t call = at(done).call;
        if (call != 0 && placed_calls_[call - 1]) continue;
        if (call != 0) placed_calls_[call - 1] = true;
        order_.push_back(done);
    }
}

void locals::place_all() {
    placed_.assign(f_.graph.size(), false);
    placed_calls_.assign(f_.graph.calls().size(), false);
    std::vector<std::uint32_t> first;
    for (std::uint32_t i = 0; i < f_.graph.size(); ++i)
        if (is_local(i) && named(i) != 0) first.push_back(i);
    std::sort(first.begin(), first.end(),
              [&](auto a, auto b) { return std::pair(named(a), a) < std::pair(named(b), b); });
    for (const std::uint32_t node : first)
        place(node);
    for (const result& r : f_.results)
        place(r.node);
}

// ---- under which names ------------------------------------------------------------------------------------

void locals::name_all() {
    names_.assign(f_.graph.size(), {});
    pair_names_.assign(f_.graph.calls().size(), {});
    for (std::uint32_t i = 0; i < f_.graph.size(); ++i)
        if (at(i).op == operation::input) {
            names_[i] = input_name(at(i).name);
            taken_.insert(names_[i].substr(0, names_[i].find_first_of(".[")));
        }
    for (const function_call& call : f_.graph.calls()) // a variable would hide the function
        taken_.insert(legal_name(l_, call.function));
    for (const bool given : {true, false})
        for (const std::uint32_t node : order_) {
            if ((named(node) != 0) != given) continue;
            if (const function_call* call = f_.graph.call_of(node)) {
                const std::string name = unique(legal_name(l_, given ? call->name : found_name(*call)));
                pair_names_[at(node).call - 1] = name;
                for (const std::size_t i : {0u, 1u})
                    if (f_.graph.call_of(call->results[i]) == call)
                        names_[call->results[i]] = fmt::format("{}.{}", name, "xy"[i]);
            } else {
                names_[node] = unique(given ? legal_name(l_, at(node).name) : found_name(node));
            }
        }
}

// An argument, or a component of one.
std::string locals::input_name(std::string_view name) const {
    const std::size_t end = std::min(name.find_first_of(".["), name.size());
    return argument_name(l_, f_, name.substr(0, end)) + std::string(name.substr(end));
}

std::string locals::unique(const std::string& name) {
    std::string tried = name;
    for (int& i = last_number_[name]; !taken_.insert(tried).second;)
        tried = fmt::format("{}_{}", name, (i = std::max(i, 1) + 1));
    return tried;
}

// Base and exponent of a product of one quantity with itself.
std::optional<std::pair<std::uint32_t, int>> locals::power_of(std::uint32_t node) const {
    const expression& x = at(node);
    if (x.op == operation::multiply && x.call == 0) {
        const auto a = power_of(x.operands[0]), b = power_of(x.operands[1]);
        if (a && b && a->first == b->first) return std::pair{a->first, a->second + b->second};
    }
    if (x.op == operation::input || named(node) != 0) return std::pair{node, 1};
    return std::nullopt;
}

// The quantity that an operation with 1 is of, if it is that and has a name.
std::string locals::beside_one(std::uint32_t node, operation op) const {
    const expression& x = at(node);
    if (x.op != op) return {};
    const bool first = f_.graph.is(x.operands[0], 1), second = f_.graph.is(x.operands[1], 1);
    const std::string& other = first ? names_[x.operands[1]] : second ? names_[x.operands[0]] : names_[node];
    if (other.empty() || other.find_first_of(".[") != std::string::npos) return {};
    if (op == operation::add) return other + "_plus_1";
    return first ? "one_minus_" + other : other + "_minus_1";
}

// A constant that is 1 - f0 or the like of a constant with a name, which folding has hidden; otherwise folded, a word
// that no equation uses.
std::string locals::constant_name(std::uint32_t node) const {
    for (const std::uint32_t other : order_) {
        if (named(other) == 0 || at(other).op != operation::constant) continue;
        const auto is = [&](operation op, bool one_first) {
            for (std::size_t c = 0; c < 3; ++c) {
                const float x = at(other).value[c];
                if (at(node).value[c] != (one_first ? fold(op, 1, x) : fold(op, x, 1))) return false;
            }
            return true;
        };
        if (is(operation::subtract, true)) return "one_minus_" + names_[other];
        if (is(operation::subtract, false)) return names_[other] + "_minus_1";
        if (is(operation::add, false)) return names_[other] + "_plus_1";
    }
    return "folded";
}

// What a product of one quantity with itself is called, m2 or m5, and a sum with 1; otherwise t.
std::string locals::found_name(std::uint32_t node) const {
    if (at(node).op == operation::constant) return constant_name(node);
    for (const operation op : {operation::add, operation::subtract})
        if (const std::string name = beside_one(node, op); !name.empty()) return name;
    const auto power = power_of(node);
    if (!power || power->second < 2) return "t";
    std::string base = names_[power->first].substr(0, names_[power->first].find_first_of(".["));
    if (base == "cos_i") base = "cos";
    if (std::isdigit(static_cast<unsigned char>(base.back())) != 0) base += "_";
    return legal_name(l_, fmt::format("{}{}", base, power->second));
}

// What a call is called that has no name: twofold_sum and two_sum give a sum.
std::string locals::found_name(const function_call& call) {
    return call.function.substr(call.function.rfind('_') + 1);
}

} // namespace fresnel::emit
