#pragma once

#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::conform {

/// What a function is given for one of its arguments, in terms of a model's parameters: "f0", "1.5", "-cos_i", "1/eta",
/// "vec3(f0)", "sqrt(f0)", "normal", "-direction".
class expression_text {
public:
    struct node;

    /// Throws bad_input naming `what` and the place where the text goes wrong.
    expression_text(std::string_view what, std::string_view text);

    /// Its value, of each variable the value that `variable` gives.
    double evaluate(const std::function<double(const std::string&)>& variable) const;
    /// The variables in it, each once.
    const std::vector<std::string>& variables() const { return variables_; }
    /// Whether it is vec3(...): one number for three channels.
    bool splat() const { return splat_; }
    const std::string& text() const { return text_; }

private:
    std::string text_;
    std::shared_ptr<const node> root_;
    std::vector<std::string> variables_;
    bool splat_ = false;
};

/// Splits a list at the commas that stand in no brackets.
std::vector<std::string> split_list(std::string_view list);

} // namespace fresnel::conform
