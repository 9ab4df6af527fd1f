#include "emit/function.hpp"

#include "analysis/prove.hpp"
#include "error.hpp"

#include <fresnel/geometry.hpp>

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

// ---- recording --------------------------------------------------------------------------------------------

std::string meaning_of(const parameter& p) { return fmt::format("{}, [{}, {}]", p.meaning, p.min, p.max); }

sym symbol_of(function& f, const parameter& p, const request& wanted) {
    if (const auto found = wanted.fixed.find(std::string(p.name)); found != wanted.fixed.end()) {
        const auto& v = found->second;
        const std::array rgb{static_cast<float>(v[0]), static_cast<float>(v[1]), static_cast<float>(v[2])};
        if (rgb[0] == rgb[1] && rgb[1] == rgb[2]) return sym::constant(rgb[0]);
        const sym value = sym::constant(rgb);
        f.graph.name(value.node(), p.name);
        return value;
    }
    const int width = is_ambient(p) ? 1 : wanted.width;
    f.arguments.push_back({std::string(p.name), width, meaning_of(p)});
    return f.graph.input(p.name, width);
}

// An equation on lines of its own, broken after commas where it is long.
void add_equation(std::vector<std::string>& lines, std::string_view equation) {
    constexpr std::size_t longest = 96;
    std::string line = equation.find('=') < equation.find(',') ? "  " : "  F = ";
    while (!equation.empty()) {
        const std::size_t end = std::min(equation.find(", "), equation.size());
        const std::string_view part = equation.substr(0, std::min(end + 2, equation.size()));
        if (line.size() + part.size() > longest)
            lines.push_back(line.substr(0, line.size() - 1)), line = "  ";
        line += part;
        equation.remove_prefix(part.size());
    }
    lines.push_back(line);
}

// Whether the registry's error is taken over that value of a parameter.
bool is_covered(std::string_view over, std::string_view name, double x) {
    const auto within = [x](double lo, double hi) { return x >= lo && x <= hi; };
    if (over == row::gems) return name == "f90" ? x == 1 : within(f0_from_eta(1.3), f0_from_eta(2.5));
    if (over == row::inside_gems) return within(1 / 2.5, 1 / 1.3);
    if (over == row::box) return name == "n" ? within(0.1, 4) : within(1, 8);
    return false; // of a metal all parameters are fitted
}

std::string error_of(const model_row<double>& row, const fixed_values& fixed) {
    if (!row.error.in_float32.empty()) return fmt::format("rounding only, in float {}", row.error.in_float32);
    for (const auto& [name, values] : fixed)
        for (const double x : values)
            if (!is_covered(row.error.over, name, x)) return "not known for these constants";
    return fmt::format("at most {:.3g}, {} for {}", row.error.max,
                       can_prove(row.error.over) ? "certified" : "measured", row.error.over);
}

std::vector<std::string> comment_of(const model_row<double>& row, const function& f, const request& wanted) {
    std::vector<std::string> lines = {std::string(row.summary), ""};
    add_equation(lines, row.equation);
    lines.emplace_back();
    for (const argument& a : f.arguments)
        lines.push_back(fmt::format("{:<7} {}", a.name, a.meaning));
    lines.push_back(fmt::format("error   {}", error_of(row, wanted.fixed)));
    lines.push_back(fmt::format("cost    {} operations", count_operations(f).cost()));
    lines.push_back(fmt::format("source  {}", row.citation));
    return lines;
}

// Three of the three: a constant result still has the width that was asked for.
sym widened(sym x, int width) {
    return recording::graph()[x.node()].width == width ? x : x * sym::constant(std::array<float, 3>{1, 1, 1});
}

void record_row(const model_row<sym>& row, function& f, const request& wanted) {
    std::vector<sym> values;
    for (const parameter& p : row.parameters)
        values.push_back(symbol_of(f, p, wanted));
    f.arguments.push_back({"cos_i", 1, std::string(angle_meaning)});
    const sym cos_i = f.graph.input("cos_i");
    if (wanted.boundary && row.polarised()) {
        const boundary<sym> b = row.evaluate(values.data(), cos_i);
        f.results = {
            {"R_s", b.R_s.node()}, {"R_p", b.R_p.node()}, {"T_s", b.T_s.node()}, {"T_p", b.T_p.node()}};
        return;
    }
    bool rgb = wanted.width == 3 && row.name != "one_minus_cos";
    for (const auto& [name, fixed] : wanted.fixed)
        rgb = rgb || fixed[0] != fixed[1] || fixed[1] != fixed[2];
    const sym R = reflectance(row, values, cos_i);
    f.results = {{"R", rgb ? widened(R, 3).node() : R.node()}};
}

// A call of three at once, for channel c: `now` has the node of each channel that a node became.
void note_channel(const function& f, const function_call& call, const std::vector<bool>& needed,
                  const std::vector<std::array<std::uint32_t, 3>>& now, std::size_t c, function& split) {
    function_call one{call.function, call.arguments, {now[call.results[0]][c], now[call.results[1]][c]}};
    for (auto& argument : one.arguments)
        for (std::uint32_t& node : argument) {
            if (!needed[node]) return;
            node = now[node][c];
        }
    const std::uint32_t first = one.results[0];
    split.graph.note(std::move(one));
    if (call.named == 0) return;
    const std::string suffix = f.graph[call.results[0]].width == 3 ? std::string("_") + "rgb"[c] : "";
    split.graph.name_pair(first, call.name + suffix, call.remark);
}

} // namespace

void check_fixed(const model_row<double>& row, const fixed_values& fixed) {
    for (const auto& [name, values] : fixed) {
        const parameter* found = nullptr;
        std::vector<std::string> names;
        for (const parameter& p : row.parameters) {
            names.emplace_back(p.name);
            if (p.name == name) found = &p;
        }
        if (found == nullptr)
            throw bad_input(fmt::format(
                "parameter '{}' is none of {}{}: it takes {}", name, row.name, did_you_mean(name, names),
                names.empty() ? "no parameters" : fmt::format("{}", fmt::join(names, ", "))));
        for (const double value : values)
            check_range(*found, value);
    }
}

function scalarized(const function& f, std::string (*component)(std::string_view name, int i)) {
    function split;
    split.name = f.name, split.arguments = f.arguments, split.comment = f.comment;
    split.directions = f.directions, split.components = f.width() == 3;
    const recording scope(split.graph);
    const std::vector<bool> needed = needed_nodes(f);
    std::vector<std::array<std::uint32_t, 3>> now(f.graph.size());
    for (std::uint32_t i = 0; i < f.graph.size(); ++i) {
        if (!needed[i]) continue;
        const expression& x = f.graph[i];
        for (std::size_t c = 0; c < 3; ++c) {
            if (c > 0 && x.width == 1) {
                now[i][c] = now[i][0];
            } else if (x.op == operation::input) {
                const std::string name = x.width == 3 ? component(x.name, static_cast<int>(c)) : x.name;
                now[i][c] = split.graph.input(name).node();
            } else if (x.op == operation::constant) {
                now[i][c] = sym::constant(x.value[c]).node();
            } else if (x.op == operation::dot_product) {
                const auto &a = now[x.operands[0]], &b = now[x.operands[1]];
                now[i][c] = (sym(a[0]) * sym(b[0]) + sym(a[1]) * sym(b[1]) + sym(a[2]) * sym(b[2])).node();
            } else {
                std::array<std::uint32_t, 3> operands{};
                for (std::size_t k = 0; k < arity(x.op); ++k)
                    operands[k] = now[x.operands[k]][c];
                now[i][c] = split.graph.make(x.op, operands);
            }
            if (x.named != 0 && (c == 0 || x.width == 3))
                split.graph.name(now[i][c],
                                 x.width == 3 ? x.name + "_" + (f.directions ? "xyz" : "rgb")[c] : x.name);
        }
    }
    for (const function_call& call : f.graph.calls())
        for (std::size_t c = 0; c < 3; ++c)
            note_channel(f, call, needed, now, c, split);
    for (const result& r : f.results)
        for (std::size_t c = 0; c < (split.components ? 3u : 1u); ++c)
            split.results.push_back({r.name, now[r.node][c]});
    return split;
}

bool calls_twofold(const function& f) {
    return needs_any(f, [](const expression& x) { return x.call != 0; });
}

function record(std::string_view model, const request& wanted) {
    const model_row<double>& row = find_model<double>(model);
    check_fixed(row, wanted.fixed);
    function f;
    f.name = row.name;
    const recording scope(f.graph);
    record_row(find_model<sym>(model), f, wanted);
    simplify(f);
    f.comment = comment_of(row, f, wanted);
    return f;
}

} // namespace fresnel::emit
