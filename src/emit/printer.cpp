#include "emit/printer.hpp"

#include "emit/locals.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <optional>

namespace fresnel::emit {

namespace {

/// A piece of text and how tightly its outermost operation binds.
struct fragment {
    std::string text;
    enum { choosing = 1, comparing, adding, multiplying, unary, primary } binds = primary;
};

std::string dotted(std::string_view name, int i) { return fmt::format("{}.{}", name, "xyz"[i]); }
std::string indexed(std::string_view name, int i) { return fmt::format("{}[{}]", name, i); }

/// Prints the body of one function.
class body_printer {
public:
    body_printer(const language& l, const function& f, const style& how)
        : l_(l), f_(f), how_(how), locals_(l, f) {}

    std::string lines() {
        if (l_.id == "c" || l_.id == "cuda")
            for (const argument& a : f_.arguments)
                if (!locals_.reads(a.name))
                    text_ += fmt::format("    (void){};\n", argument_name(l_, f_, a.name));
        for (const std::uint32_t node : locals_.order()) {
            const function_call* call = f_.graph.call_of(node);
            text_ += statement(declaration(node), call != nullptr ? call->remark : at(node).remark);
        }
        return text_ + returned();
    }

private:
    const expression& at(std::uint32_t node) const { return f_.graph[node]; }

    // Before a step of the model that has a title stands the title, behind a quantity what it is.
    std::string statement(const std::string& text, const std::string& remark) const {
        const std::size_t end = remark.find('\n');
        const std::string step = end == std::string::npos ? "" : remark.substr(0, end);
        const std::string what = end == std::string::npos ? remark : remark.substr(end + 1);
        return (step.empty() ? "" : fmt::format("{}    // {}\n", text_.empty() ? "" : "\n", step)) +
               fmt::format("    {};{}{}\n", text, what.empty() ? "" : " // ", what);
    }

    // ---- expressions --------------------------------------------------------------------------------------

    std::string bracketed(const fragment& x, int needed) const {
        return x.binds < needed ? fmt::format("({})", x.text) : x.text;
    }
    // An operand that is not the first one must not begin with a sign.
    std::string later(const fragment& x, int needed) const {
        return x.text.front() == '-' ? fmt::format("({})", x.text) : bracketed(x, needed);
    }

    fragment binary(const fragment& a, std::string_view sign, const fragment& b, int binds) const {
        return {fmt::format("{} {} {}", bracketed(a, binds), sign, later(b, binds + 1)),
                static_cast<decltype(fragment::binds)>(binds)};
    }

    // A node as an argument of a function whose result has that width.
    std::string splat(std::uint32_t node, int width) {
        const fragment x = use(node);
        if (width == 1 || at(node).width == 3 || locals_.is_mask(node)) return x.text;
        const std::string_view type = f_.directions ? l_.vector : l_.triple;
        // FXC's constructors take three numbers, its casts take one
        if (l_.id == "hlsl") return fmt::format("({}){}", type, bracketed(x, fragment::primary));
        return fmt::format("{}({})", type, x.text);
    }

    fragment built_in(std::uint32_t node) {
        const expression& x = at(node);
        std::vector<std::string> arguments;
        for (std::size_t k = 0; k < arity(x.op); ++k)
            arguments.push_back(splat(x.operands[k], x.op == operation::dot_product ? 1 : x.width));
        // FXC warns of a base that might be negative; ours are not, and abs costs nothing there
        if (x.op == operation::power && l_.id == "hlsl" && !f_.graph.is_constant(x.operands[0]))
            arguments[0] = call("abs", {arguments[0]});
        return {call(std::string(l_.name_of(x.op)), arguments)};
    }

    // max(x, 0) limited to 1 by min is what languages call saturate or clamp.
    std::optional<fragment> limited(std::uint32_t node) {
        const expression& x = at(node);
        if (x.op != operation::minimum || !f_.graph.is(x.operands[1], 1)) return std::nullopt;
        const expression& inner = at(x.operands[0]);
        if (locals_.is_local(x.operands[0]) || inner.op != operation::maximum ||
            !f_.graph.is(inner.operands[1], 0))
            return std::nullopt;
        const std::string value = use(inner.operands[0]).text;
        if (l_.has_saturate) return fragment{call("saturate", {value})};
        if (l_.id == "c" || l_.id == "cuda") return std::nullopt;
        if (l_.id == "osl" && x.width == 3)
            return fragment{call("clamp", {value, "color(0.0)", "color(1.0)"})};
        return fragment{call("clamp", {value, "0.0", "1.0"})};
    }

    fragment comparison(std::uint32_t node) {
        const expression& x = at(node);
        auto [a, b] = std::pair{x.operands[0], x.operands[1]};
        const bool strict = x.op == operation::less;
        const bool flip = f_.graph.is_constant(a) && !f_.graph.is_constant(b);
        if (flip) std::swap(a, b);
        if (x.width == 3 && l_.mask == "bvec3") {
            const std::string name =
                fmt::format("{}Than{}", flip ? "greater" : "less", strict ? "" : "Equal");
            return {call(name, {splat(a, 3), splat(b, 3)})};
        }
        if (x.width == 3)
            return binary({splat(a, 3)}, sign_of(flip, strict), {splat(b, 3)}, fragment::comparing);
        return binary(use(a), sign_of(flip, strict), use(b), fragment::comparing);
    }

    static std::string_view sign_of(bool flip, bool strict) {
        if (flip) return strict ? ">" : ">=";
        return strict ? "<" : "<=";
    }

    fragment choice(std::uint32_t node) {
        const expression& x = at(node);
        const std::string mask = use(x.operands[0]).text;
        const std::string yes = splat(x.operands[1], x.width), no = splat(x.operands[2], x.width);
        const bool three = at(x.operands[0]).width == 3;
        if (three && l_.mask == "bvec3") return {call("mix", {no, yes, mask})};
        if (l_.choice == choice_style::select && (three || l_.id == "wgsl"))
            return {call("select", {no, yes, mask})};
        const auto side = [&](std::uint32_t operand, const std::string& text) {
            return use(operand).binds <= fragment::comparing ? fmt::format("({})", text) : text;
        };
        return {fmt::format("{} ? {} : {}", mask, side(x.operands[1], yes), side(x.operands[2], no)),
                fragment::choosing};
    }

    fragment constant(const expression& x) const {
        if (x.width == 1) {
            const std::string text = literal(l_, x.value[0]);
            return {text, text.front() == '-' ? fragment::unary : fragment::primary};
        }
        return {triple_of(l_, {literal(l_, x.value[0]), literal(l_, x.value[1]), literal(l_, x.value[2])},
                          f_.directions)};
    }

    fragment written_out(std::uint32_t node) {
        const expression& x = at(node);
        switch (x.op) {
        case operation::constant:
            return constant(x);
        case operation::negate:
            return {"-" + later(use(x.operands[0]), fragment::unary), fragment::unary};
        case operation::add:
            return binary(use(x.operands[0]), "+", use(x.operands[1]), fragment::adding);
        case operation::subtract:
            return binary(use(x.operands[0]), "-", use(x.operands[1]), fragment::adding);
        case operation::multiply:
            return binary(use(x.operands[0]), "*", use(x.operands[1]), fragment::multiplying);
        case operation::divide:
            return binary(use(x.operands[0]), "/", use(x.operands[1]), fragment::multiplying);
        case operation::less:
        case operation::less_equal:
            return comparison(node);
        case operation::choose:
            return choice(node);
        default:
            if (const auto short_form = limited(node)) return *short_form;
            return built_in(node);
        }
    }

    // A node where it is used: its name, or what it is made of. What is written out is short, since whatever the model
    // names or uses twice has a name.
    fragment use(std::uint32_t node) {
        if (!locals_.name(node).empty()) return {locals_.name(node)};
        return written_out(node);
    }

    // ---- statements ---------------------------------------------------------------------------------------

    std::string type(std::uint32_t node) const { return std::string(l_.type(at(node).width, f_.directions)); }

    std::string declaration(std::uint32_t node) {
        const function_call* call = f_.graph.call_of(node);
        const std::string name = call != nullptr ? locals_.pair_name(node) : locals_.name(node);
        const std::string value = call != nullptr ? call_text(*call) : written_out(node).text;
        if (l_.typed_names) return fmt::format("let {} = {}", name, value);
        return fmt::format("{}{}{} {} = {}", how_.precise ? "precise " : "", l_.id == "c" ? "const " : "",
                           call != nullptr ? l_.pair : type(node), name, value);
    }

    // Two nodes as one argument: the variable or the argument that they are the components of, if there is one.
    std::string pair_text(std::uint32_t x, std::uint32_t y) {
        const std::string first = use(x).text, second = use(y).text;
        const std::string whole = first.substr(0, first.size() - 2);
        const std::size_t name = whole.front() == '-' && l_.pair_arithmetic() ? 1 : 0;
        const bool is_name =
            std::all_of(whole.begin() + static_cast<std::ptrdiff_t>(name), whole.end(),
                        [](char c) { return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_'; });
        if (is_name && first == whole + ".x" && second == whole + ".y") return whole;
        return pair_of(l_, first, second);
    }

    std::string call_text(const function_call& x) {
        std::vector<std::string> arguments;
        for (const std::vector<std::uint32_t>& argument : x.arguments)
            arguments.push_back(argument.size() == 1 ? use(argument[0]).text
                                                     : pair_text(argument[0], argument[1]));
        return call(legal_name(l_, x.function), arguments);
    }

    std::string returned_pair() {
        const function_call* call = locals_.returned_call();
        const std::string value =
            call != nullptr ? call_text(*call) : pair_text(f_.results[0].node, f_.results[1].node);
        if (!how_.precise) return fmt::format("    return {};\n", value);
        return fmt::format("    precise {0} {1} = {2};\n    return {1};\n", l_.pair, locals_.unique("result"),
                           value);
    }

    std::string by_members(std::string_view type, const std::string& name,
                           const std::vector<std::string>& values) const {
        std::string text = fmt::format("    {} {};\n", type, name);
        for (std::size_t i = 0; i < values.size(); ++i)
            text += fmt::format("    {}.{} = {};\n", name, f_.results[i].name, values[i]);
        return text + fmt::format("    return {};\n", name);
    }

    std::string returned() {
        if (f_.results.size() == 2) return returned_pair();
        std::vector<std::string> values;
        for (const result& r : f_.results)
            values.push_back(use(r.node).text);
        if (values.size() == 1) {
            const std::uint32_t node = f_.results.front().node;
            values[0] = splat(node, f_.width());
            if (!how_.precise || !locals_.name(node).empty())
                return fmt::format("    return {};\n", values[0]);
            return fmt::format("    precise {0} {1} = {2};\n    return {1};\n", type(node),
                               locals_.unique("result"), values[0]);
        }
        const std::string list = fmt::format("{}", fmt::join(values, ", "));
        if (f_.components && l_.id != "c")
            return fmt::format("    return {};\n", triple_of(l_, values, f_.directions));
        const std::string_view name = f_.components ? l_.triple : "fresnel_boundary";
        if (l_.structs == struct_style::constructor) return fmt::format("    return {}({});\n", name, list);
        const std::string b = locals_.unique("result");
        if (l_.structs == struct_style::members) return by_members(name, b, values);
        return fmt::format("    {0} {1} = {{{2}}};\n    return {1};\n", name, b, list);
    }

    const language& l_;
    const function& f_;
    const style& how_;
    locals locals_;
    std::string text_;
};

// Whether a choice or a comparison is made for three values at once.
bool has_triple_mask(const function& f) {
    return needs_any(f, [](const expression& x) {
        return x.width == 3 && (x.op == operation::less || x.op == operation::less_equal);
    });
}

// Whether a function of two numbers is called for three values at once.
bool calls_for_triples(const function& f) {
    return needs_any(f, [](const expression& x) { return x.width == 3 && x.call != 0; });
}

bool has_triple(const function& f) {
    return needs_any(f, [](const expression& x) { return x.width == 3; });
}

std::string declared(const language& l, const function& f, const argument& a) {
    const std::string own = argument_name(l, f, a.name);
    const std::string_view type = l.type(a.width, f.directions);
    return l.typed_names ? fmt::format("{}: {}", own, type) : fmt::format("{} {}", type, own);
}

} // namespace

std::string literal(const language& l, float value) {
    if (!std::isfinite(value))
        throw failure(fmt::format("a constant of the function is {}: not a number", value));
    std::array<char, 32> digits;
    const auto [end, error] = std::to_chars(digits.data(), digits.data() + digits.size(), value);
    std::string text(digits.data(), end);
    if (text.find_first_of(".e") == std::string::npos) text += ".0";
    return text + std::string(l.literal_suffix);
}

std::string component(const language& l, std::string_view name, int i) {
    return l.swizzle == "[]" ? indexed(name, i) : dotted(name, i);
}

std::string pair_of(const language& l, const std::string& x, const std::string& y) {
    if (l.id == "cuda") return call("make_float2", {x, y});
    return call(std::string(l.id == "c" || l.id == "osl" ? "fresnel_make_float2" : l.pair), {x, y});
}

std::string triple_of(const language& l, const std::vector<std::string>& three, bool direction) {
    if (l.id == "cuda") return call("make_float3", three);
    if (l.id == "c") return fmt::format("(fresnel_float3){{{}}}", fmt::join(three, ", "));
    return call(std::string(direction ? l.vector : l.triple), three);
}

std::string call(const std::string& name, const std::vector<std::string>& arguments) {
    return fmt::format("{}({})", name, fmt::join(arguments, ", "));
}

std::string printed_name(const language& l, const std::string& name, int width, bool directions) {
    std::string own = legal_name(l, name);
    if (l.overloads) return own;
    if (width == 3) own += "_rgb";
    if (directions) own += "_dir";
    return own;
}

std::string argument_name(const language& l, const function& f, std::string_view name) {
    const std::string own = legal_name(l, name);
    return own == legal_name(l, f.name) ? own + "_" : own;
}

std::string signature(const language& l, const function& f, const std::string& name) {
    std::vector<std::string> arguments;
    for (const argument& a : f.arguments)
        arguments.push_back(declared(l, f, a));
    const std::string_view type =
        f.results.size() == 4 ? "fresnel_boundary" : l.type(f.width(), f.directions);
    const std::string list = fmt::format("{}", fmt::join(arguments, ", "));
    if (l.typed_names) return fmt::format("fn {}({}) -> {}", name, list, type);
    return fmt::format("{}{}{} {}({})", l.qualifier, l.qualifier.empty() ? "" : " ", type, name, list);
}

std::string print(const language& l, const function& f, const style& how) {
    const bool split =
        has_triple(f) && (!l.arithmetic || calls_for_triples(f) || (has_triple_mask(f) && l.mask.empty()));
    if (split) return print(l, scalarized(f, l.swizzle == "[]" ? indexed : dotted), how);
    function renamed = f;
    renamed.name = legal_name(l, f.name);
    return (how.comment ? comment_block(f.comment) : "") + signature(l, f, renamed.name) + " {\n" +
           body_printer(l, renamed, how).lines() + "}\n";
}

} // namespace fresnel::emit
