#include "conform/expression.hpp"

#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

namespace fresnel::conform {

/// A number, a variable, or an operation of up to two others.
struct expression_text::node {
    char op = '0'; ///< '0' a number, 'x' a variable, 'n' change of sign, 's' square root, + - * /
    double value = 0;
    std::string name = {};
    std::shared_ptr<const node> a = {}, b = {};
};

namespace {

using node = expression_text::node;
using pointer = std::shared_ptr<const node>;

class parser {
public:
    parser(std::string_view what, std::string_view text, std::vector<std::string>& variables, bool& splat)
        : what_(what), all_(text), rest_(text), variables_(variables), splat_(splat) {}

    pointer whole() {
        const pointer root = sum();
        if (peek() != 0) fail();
        return root;
    }

private:
    char peek() {
        while (!rest_.empty() && rest_.front() == ' ')
            rest_.remove_prefix(1);
        return rest_.empty() ? '\0' : rest_.front();
    }
    bool take(char c) {
        if (peek() != c) return false;
        rest_.remove_prefix(1);
        return true;
    }
    [[noreturn]] void fail() {
        throw bad_input(
            fmt::format("{} '{}': cannot be read at '{}'; must be a number or parameters with + - * / "
                        "( ) sqrt() vec3()",
                        what_, all_, rest_));
    }
    static pointer made(char op, pointer a, pointer b = {}) {
        return std::make_shared<node>(node{op, 0, {}, std::move(a), std::move(b)});
    }

    pointer sum() {
        pointer x = product();
        for (char c = peek(); c == '+' || c == '-'; c = peek())
            take(c), x = made(c, x, product());
        return x;
    }
    pointer product() {
        pointer x = factor();
        for (char c = peek(); c == '*' || c == '/'; c = peek())
            take(c), x = made(c, x, factor());
        return x;
    }
    pointer factor() {
        if (take('-')) return made('n', factor());
        if (take('(')) return closed(sum());
        const char c = peek();
        if (std::isdigit(static_cast<unsigned char>(c)) != 0 || c == '.') return number();
        if (std::isalpha(static_cast<unsigned char>(c)) != 0) return named();
        fail();
    }
    pointer closed(pointer x) {
        if (!take(')')) fail();
        return x;
    }
    pointer number() {
        node x;
        const auto [end, error] = std::from_chars(rest_.data(), rest_.data() + rest_.size(), x.value);
        if (error != std::errc{}) fail();
        rest_.remove_prefix(static_cast<std::size_t>(end - rest_.data()));
        if (!rest_.empty() && (rest_.front() == 'f' || rest_.front() == 'F')) rest_.remove_prefix(1);
        return std::make_shared<node>(x);
    }
    pointer named() {
        std::size_t n = 0;
        while (n < rest_.size() &&
               (std::isalnum(static_cast<unsigned char>(rest_[n])) != 0 || rest_[n] == '_'))
            ++n;
        const std::string name(rest_.substr(0, n));
        const bool outermost = n < rest_.size() && rest_.data() == all_.data();
        rest_.remove_prefix(n);
        if (name == "sqrt" && take('(')) return made('s', closed(sum()));
        const bool triple = name == "vec3" || name == "float3" || name == "vec3f";
        if (triple && outermost && take('(')) {
            splat_ = true;
            return closed(sum());
        }
        if (std::find(variables_.begin(), variables_.end(), name) == variables_.end())
            variables_.push_back(name);
        node x{'x'};
        x.name = name;
        return std::make_shared<node>(x);
    }

    std::string_view what_, all_, rest_;
    std::vector<std::string>& variables_;
    bool& splat_;
};

double value_of(const node& x, const std::function<double(const std::string&)>& variable) {
    if (x.op == '0') return x.value;
    if (x.op == 'x') return variable(x.name);
    const double a = value_of(*x.a, variable);
    if (x.op == 'n') return -a;
    if (x.op == 's') return std::sqrt(a);
    const double b = value_of(*x.b, variable);
    return x.op == '+' ? a + b : x.op == '-' ? a - b : x.op == '*' ? a * b : a / b;
}

} // namespace

expression_text::expression_text(std::string_view what, std::string_view text) : text_(text) {
    root_ = parser(what, text_, variables_, splat_).whole();
}

double expression_text::evaluate(const std::function<double(const std::string&)>& variable) const {
    return value_of(*root_, variable);
}

std::vector<std::string> split_list(std::string_view list) {
    std::vector<std::string> parts(1);
    int depth = 0;
    for (const char c : list) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (c == ',' && depth == 0)
            parts.emplace_back();
        else if (c != ' ' || !parts.back().empty())
            parts.back() += c;
    }
    return parts;
}

} // namespace fresnel::conform
