#pragma once

#include <string>

namespace fresnel::cli {

/// Evaluates a model on every row of a CSV file.
///
/// model    registry name
/// input    path, or "-" for standard input; its header names the model's parameters and cos_i, in any order.
///          Parameters whose default changes nothing (n_i = 1, k_t = 0, f90 = 1 ...) may be absent
/// output   path, or "" or "-" for standard output; a symbolic link is followed, a pipe or device written into
/// type     "float", "double" or "50"
///
/// Writes the input columns as given, then Rs,Rp,R,Ts,Tp,T (exact models) or R. A file is written beside and
/// renamed when complete; standard output receives only complete rows. Throws bad_input naming line and
/// column.
void evaluate_csv(const std::string& model, const std::string& input, const std::string& output,
                  const std::string& type);

} // namespace fresnel::cli
