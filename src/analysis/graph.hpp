#pragma once

#include "analysis/model_table.hpp"

#include <fresnel/types/sym.hpp>

#include <string>
#include <string_view>
#include <vector>

namespace fresnel {

/// A quantity that is wanted of a graph.
struct result {
    std::string name;
    std::uint32_t node;
};

/// A graph and what is wanted of it.
struct recorded {
    std::vector<result> results;
    expression_graph graph;
};

/// The same value with less to read and to compute:
///   m ? a : f(m ? b : c)       becomes m ? a : f(c)
///   x <= 0 ? 0 : sqrt(x)       becomes sqrt(max(x, 0))
///   f(m ? 1 : a, m ? 2 : b)    becomes m ? f(1, 2) : f(a, b) with f(1, 2) a constant, where that is cheaper
/// Every bit stays for finite x.
void simplify(recorded& f);

/// The nodes that the results need: needed[node].
std::vector<bool> needed_nodes(const recorded& f);

/// Whether the results need a node that is so.
template <class Predicate>
bool needs_any(const recorded& f, Predicate is_so) {
    const std::vector<bool> needed = needed_nodes(f);
    for (std::uint32_t i = 0; i < f.graph.size(); ++i)
        if (needed[i] && is_so(f.graph[i])) return true;
    return false;
}

/// The reflectance for unpolarised light.
sym reflectance(const model_row<sym>& row, const std::vector<sym>& parameters, sym cos_i);

/// Operations by kind: + - * comparisons and selections are 1, a division, square root, exp2 or log2 is 4 and a pow 9,
/// the rates of a graphics processor; a change of sign is free, and so is what is made of constants alone.
struct operation_count {
    int cheap, division, root, exponential, power;
    int cost() const { return cheap + 4 * (division + root + exponential) + 9 * power; }
};

/// Operations of one evaluation, each node once however often it is used; three channels count three times.
operation_count count_operations(const recorded& f);

/// Those behind a model's unpolarised reflectance, simplified as its shader text is. Width 3: of the RGB function.
operation_count count_operations(std::string_view model, int width = 1);

/// The same where the medium outside is vacuum, n_i = 1.
operation_count count_operations_in_vacuum(std::string_view model);

} // namespace fresnel
