#include "emit/printer.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <map>
#include <optional>
#include <set>

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
    body_printer(const language& l, const function& f, const style& how) : l_(l), f_(f), how_(how) {
        count_uses();
        name_locals();
    }

    std::string lines() {
        if (l_.id == "c" || l_.id == "cuda")
            for (const argument& a : f_.arguments)
                if (!reads(a.name)) text_ += fmt::format("    (void){};\n", argument_name(l_, f_, a.name));
        for (const std::uint32_t node : order_) {
            const std::string& remark = at(node).remark;
            text_ += fmt::format("    {};{}{}\n", declaration(node), remark.empty() ? "" : " // ", remark);
        }
        return text_ + returned();
    }

private:
    const expression& at(std::uint32_t node) const { return f_.graph[node]; }

    bool is_mask(std::uint32_t node) const {
        return at(node).op == operation::less || at(node).op == operation::less_equal;
    }
    // Written out wherever it is used, never a variable of its own.
    bool is_transparent(std::uint32_t node) const {
        return is_mask(node) || at(node).op == operation::negate;
    }

    bool reads(std::string_view argument) const {
        for (std::size_t i = 0; i < f_.graph.size(); ++i) {
            const expression& x = at(static_cast<std::uint32_t>(i));
            if (uses_[i] > 0 && x.op == operation::input &&
                x.name.substr(0, x.name.find_first_of(".[")) == argument)
                return true;
        }
        return false;
    }

    void count_uses() {
        uses_.assign(f_.graph.size(), 0);
        for (const result& r : f_.results)
            ++uses_[r.node];
        for (std::size_t i = f_.graph.size(); i-- > 0;) {
            const auto node = static_cast<std::uint32_t>(i);
            if (uses_[i] == 0) continue;
            const int times = is_transparent(node) ? uses_[i] : 1;
            for (std::size_t k = 0; k < arity(at(node).op); ++k)
                uses_[at(node).operands[k]] += times;
        }
    }

    bool is_only_result(std::uint32_t node) const {
        return f_.results.size() == 1 && f_.results.front().node == node && uses_[node] == 1;
    }

    bool is_local(std::uint32_t node) const {
        const expression& x = at(node);
        if (uses_[node] == 0 || x.op == operation::input) return false;
        if (x.op == operation::constant) return x.width == 3;
        if (is_transparent(node) || is_only_result(node)) return false;
        return x.named != 0 || uses_[node] > 1;
    }

    // The locals behind a node that have no place yet, operands first.
    void place(std::uint32_t root) {
        std::vector<std::pair<std::uint32_t, std::size_t>> open = {{root, 0}};
        while (!open.empty()) {
            auto& [node, next] = open.back();
            if (next < arity(at(node).op) && !placed_[node]) {
                open.emplace_back(at(node).operands[next++], 0);
                continue;
            }
            const std::uint32_t done = node;
            open.pop_back();
            if (placed_[done]) continue;
            placed_[done] = true;
            if (is_local(done)) order_.push_back(done);
        }
    }

    void name_locals() {
        placed_.assign(f_.graph.size(), false);
        std::vector<std::uint32_t> named;
        for (std::uint32_t i = 0; i < f_.graph.size(); ++i)
            if (at(i).named != 0 && is_local(i)) named.push_back(i);
        std::sort(named.begin(), named.end(), [&](auto a, auto b) { return at(a).named < at(b).named; });
        for (const std::uint32_t node : named)
            place(node);
        for (const result& r : f_.results)
            place(r.node);

        names_.assign(f_.graph.size(), {});
        for (std::uint32_t i = 0; i < f_.graph.size(); ++i)
            if (at(i).op == operation::input) {
                names_[i] = input_name(at(i).name);
                taken_.insert(names_[i].substr(0, names_[i].find_first_of(".[")));
            }
        for (const std::uint32_t node : order_)
            if (at(node).named != 0) names_[node] = unique(legal_name(l_, at(node).name));
        for (const std::uint32_t node : order_)
            if (at(node).named == 0) names_[node] = unique(found_name(node));
    }

    // An argument, or a component of one.
    std::string input_name(std::string_view name) const {
        const std::size_t end = std::min(name.find_first_of(".["), name.size());
        return argument_name(l_, f_, name.substr(0, end)) + std::string(name.substr(end));
    }

    std::string unique(const std::string& name) {
        std::string tried = name;
        for (int& i = last_number_[name]; !taken_.insert(tried).second;)
            tried = fmt::format("{}_{}", name, (i = std::max(i, 1) + 1));
        return tried;
    }

    // Base and exponent of a product of one quantity with itself.
    std::optional<std::pair<std::uint32_t, int>> power_of(std::uint32_t node) const {
        const expression& x = at(node);
        if (x.op == operation::multiply) {
            const auto a = power_of(x.operands[0]), b = power_of(x.operands[1]);
            if (a && b && a->first == b->first) return std::pair{a->first, a->second + b->second};
        }
        if (x.op == operation::input || x.named != 0) return std::pair{node, 1};
        return std::nullopt;
    }

    // The quantity that an operation with 1 is of, if it is that and has a name.
    std::string beside_one(std::uint32_t node, operation op) const {
        const expression& x = at(node);
        if (x.op != op) return {};
        const bool first = f_.graph.is(x.operands[0], 1), second = f_.graph.is(x.operands[1], 1);
        const std::string& other = first    ? names_[x.operands[1]]
                                   : second ? names_[x.operands[0]]
                                            : names_[node];
        if (other.empty() || other.find_first_of(".[") != std::string::npos) return {};
        if (op == operation::add) return other + "_plus_1";
        return first ? "one_minus_" + other : other + "_minus_1";
    }

    // What a product of one quantity with itself is called, m2 or m5, and a sum with 1; otherwise t.
    std::string found_name(std::uint32_t node) const {
        if (at(node).op == operation::constant) return "c";
        for (const operation op : {operation::add, operation::subtract})
            if (const std::string name = beside_one(node, op); !name.empty()) return name;
        const auto power = power_of(node);
        if (!power || power->second < 2) return "t";
        std::string base = names_[power->first].substr(0, names_[power->first].find_first_of(".["));
        if (base == "cos_i") base = "cos";
        if (std::isdigit(static_cast<unsigned char>(base.back())) != 0) base += "_";
        return legal_name(l_, fmt::format("{}{}", base, power->second));
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
        if (width == 1 || at(node).width == 3 || is_mask(node)) return x.text;
        const std::string_view type = f_.directions ? l_.vector : l_.triple;
        // FXC's constructors take three numbers, its casts take one
        if (l_.id == "hlsl") return fmt::format("({}){}", type, bracketed(x, fragment::primary));
        return fmt::format("{}({})", type, x.text);
    }

    fragment function_call(std::uint32_t node) {
        const expression& x = at(node);
        std::vector<std::string> arguments;
        for (std::size_t k = 0; k < arity(x.op); ++k)
            arguments.push_back(splat(x.operands[k], x.op == operation::dot_product ? 1 : x.width));
        // FXC warns of a base that might be negative; ours are not, and abs costs nothing there
        if (x.op == operation::power && l_.id == "hlsl") arguments[0] = call("abs", {arguments[0]});
        return {call(std::string(l_.name_of(x.op)), arguments)};
    }

    // max(x, 0) limited to 1 by min is what languages call saturate or clamp.
    std::optional<fragment> limited(std::uint32_t node) {
        const expression& x = at(node);
        if (x.op != operation::minimum || !f_.graph.is(x.operands[1], 1)) return std::nullopt;
        const expression& inner = at(x.operands[0]);
        if (is_local(x.operands[0]) || inner.op != operation::maximum || !f_.graph.is(inner.operands[1], 0))
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
            return function_call(node);
        }
    }

    // A node where it is used: its name, or what it is made of. What is written out is short, since whatever the model
    // names or uses twice has a name.
    fragment use(std::uint32_t node) {
        if (!names_[node].empty()) return {names_[node]};
        return written_out(node);
    }

    // ---- statements ---------------------------------------------------------------------------------------

    std::string type(std::uint32_t node) const {
        return std::string(at(node).width == 1 ? l_.scalar : f_.directions ? l_.vector : l_.triple);
    }

    std::string declaration(std::uint32_t node) {
        const std::string value = written_out(node).text;
        if (l_.typed_names) return fmt::format("let {} = {}", names_[node], value);
        return fmt::format("{}{}{} {} = {}", how_.precise ? "precise " : "", l_.id == "c" ? "const " : "",
                           type(node), names_[node], value);
    }

    std::string returned() {
        std::vector<std::string> values;
        for (const result& r : f_.results)
            values.push_back(use(r.node).text);
        if (values.size() == 1) {
            const std::uint32_t node = f_.results.front().node;
            values[0] = splat(node, f_.width());
            if (!how_.precise || !names_[node].empty()) return fmt::format("    return {};\n", values[0]);
            return fmt::format("    precise {0} {1} = {2};\n    return {1};\n", type(node), unique("result"),
                               values[0]);
        }
        const std::string list = fmt::format("{}", fmt::join(values, ", "));
        if (f_.components && l_.id != "c")
            return fmt::format("    return {};\n", triple_of(l_, values, f_.directions));
        const std::string_view name = f_.components ? l_.triple : "fresnel_boundary";
        if (l_.structs == struct_style::constructor) return fmt::format("    return {}({});\n", name, list);
        const std::string b = unique("result");
        return fmt::format("    {0} {1} = {{{2}}};\n    return {1};\n", name, b, list);
    }

    const language& l_;
    const function& f_;
    const style& how_;
    std::vector<int> uses_;
    std::vector<bool> placed_;
    std::vector<std::uint32_t> order_; ///< local variables
    std::vector<std::string> names_;   ///< of inputs and local variables, otherwise empty
    std::set<std::string> taken_;
    std::map<std::string, int> last_number_; ///< given to a name that was taken
    std::string text_;
};

// Whether a choice or a comparison is made for three values at once.
bool has_triple_mask(const function& f) {
    const std::vector<bool> needed = needed_nodes(f);
    for (std::uint32_t i = 0; i < f.graph.size(); ++i)
        if (needed[i] && f.graph[i].width == 3 &&
            (f.graph[i].op == operation::less || f.graph[i].op == operation::less_equal))
            return true;
    return false;
}

bool has_triple(const function& f) {
    const std::vector<bool> needed = needed_nodes(f);
    for (std::uint32_t i = 0; i < f.graph.size(); ++i)
        if (needed[i] && f.graph[i].width == 3) return true;
    return false;
}

// Where a line that is too long is broken: behind a comma or a sign, as few brackets deep as can be, as late as fits.
std::size_t line_break(std::string_view line, std::size_t from, std::size_t longest) {
    std::size_t best = std::string_view::npos;
    int depth = 0, best_depth = 0;
    for (std::size_t i = 0; i + 2 < std::min(line.size(), longest); ++i) {
        if (line[i] == '(' || line[i] == '{') ++depth;
        if (line[i] == ')' || line[i] == '}') --depth;
        if (i < from || line[i + 1] != ' ') continue;
        const bool sign =
            line[i - 1] == ' ' && std::string_view("+-?:=").find(line[i]) != std::string_view::npos;
        if (line[i] != ',' && !sign) continue;
        if (best == std::string_view::npos || depth <= best_depth) best = i + 2, best_depth = depth;
    }
    return best;
}

std::string wrapped(std::string line) {
    constexpr std::size_t longest = 110;
    const std::size_t indent = line.find_first_not_of(' ');
    std::string text;
    while (line.size() > longest) {
        const std::size_t at = line_break(line, indent + 24, longest);
        if (at == std::string::npos) break;
        text += line.substr(0, at - 1) + "\n";
        line = std::string(indent + 8, ' ') + line.substr(at);
    }
    return text + line;
}

std::string declared(const language& l, const function& f, const argument& a) {
    const std::string own = argument_name(l, f, a.name);
    const std::string_view type = a.width == 1 ? l.scalar : f.directions ? l.vector : l.triple;
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

std::string comment_block(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines)
        text += line.empty() ? "//\n" : fmt::format("// {}\n", line);
    return text;
}

std::string wrapped_lines(const std::string& text) {
    std::string result;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = std::min(text.find('\n', from), text.size());
        const std::string line = text.substr(from, end - from);
        const bool whole = line.starts_with("#") || line.find("//") != std::string::npos;
        result += (whole ? line : wrapped(line)) + "\n";
        from = end + 1;
    }
    return result;
}

std::string signature(const language& l, const function& f, const std::string& name) {
    std::vector<std::string> arguments;
    for (const argument& a : f.arguments)
        arguments.push_back(declared(l, f, a));
    const std::string_view type = f.results.size() == 4 ? "fresnel_boundary"
                                  : f.width() == 1      ? l.scalar
                                  : f.directions        ? l.vector
                                                        : l.triple;
    const std::string list = fmt::format("{}", fmt::join(arguments, ", "));
    if (l.typed_names) return fmt::format("fn {}({}) -> {}", name, list, type);
    return fmt::format("{}{}{} {}({})", l.qualifier, l.qualifier.empty() ? "" : " ", type, name, list);
}

std::string print(const language& l, const function& f, const style& how) {
    const bool split = has_triple(f) && (!l.arithmetic || (has_triple_mask(f) && l.mask.empty()));
    if (split) return print(l, scalarized(f, l.swizzle == "[]" ? indexed : dotted), how);
    function renamed = f;
    renamed.name = legal_name(l, f.name);
    return (how.comment ? comment_block(f.comment) : "") + signature(l, f, renamed.name) + " {\n" +
           body_printer(l, renamed, how).lines() + "}\n";
}

} // namespace fresnel::emit
