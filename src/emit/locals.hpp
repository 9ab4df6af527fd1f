#pragma once

#include "emit/function.hpp"
#include "emit/language.hpp"

#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

namespace fresnel::emit {

/// What the text of a function keeps in variables, in which order, and under which names. Variables are the nodes that
/// `let` named, those that are used more than once, and the results of calls, in the order of the model. The rest is
/// written where it is used.
class locals {
public:
    locals(const language& l, const function& f);

    /// The nodes that a declaration is written for; of a call the result that is needed first.
    const std::vector<std::uint32_t>& order() const { return order_; }
    /// Of an input, a variable or a component of one; empty for what is written where it is used.
    const std::string& name(std::uint32_t node) const { return names_[node]; }
    /// The variable that holds the result of the call that a node is of.
    const std::string& pair_name(std::uint32_t node) const { return pair_names_[f_.graph[node].call - 1]; }
    bool is_local(std::uint32_t node) const;
    bool is_mask(std::uint32_t node) const;
    /// Whether the text reads an argument.
    bool reads(std::string_view argument) const;
    /// The call whose pair is what the function returns, if it is no variable.
    const function_call* returned_call() const;
    /// A name for one more variable.
    std::string unique(const std::string& name);

private:
    const expression& at(std::uint32_t node) const { return f_.graph[node]; }
    bool is_transparent(std::uint32_t node) const;
    bool is_only_result(std::uint32_t node) const;
    std::vector<std::uint32_t> behind(std::uint32_t node) const;
    std::uint32_t named(std::uint32_t node) const;
    void count_uses();
    void place(std::uint32_t root);
    void place_all();
    void name_all();
    std::string input_name(std::string_view name) const;
    std::optional<std::pair<std::uint32_t, int>> power_of(std::uint32_t node) const;
    std::string beside_one(std::uint32_t node, operation op) const;
    std::string constant_name(std::uint32_t node) const;
    std::string found_name(std::uint32_t node) const;
    static std::string found_name(const function_call& call);

    const language& l_;
    const function& f_;
    std::vector<int> uses_;
    std::vector<bool> placed_, placed_calls_;
    std::vector<std::uint32_t> order_;
    std::vector<std::string> names_, pair_names_;
    std::set<std::string> taken_;
    std::map<std::string, int> last_number_; ///< given to a name that was taken
};

} // namespace fresnel::emit
