#pragma once

#include "emit/function.hpp"
#include "emit/language.hpp"
#include "emit/printer.hpp"

#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// That printed text is the model, shown by running both: every function of the library on the same inputs, in C++ and
// wherever its text can be compiled, bit against bit.
//
// What runs the text (a graphics device, a browser, a C compiler) is not known here. It gets a case's text, the
// expression that calls it and the inputs, and hands back the values. A case's inputs are `columns` floats for each
// evaluation, the arguments in order, three for an RGB value or a direction; its values are `results` floats for each.

namespace fresnel::emit {

/// Which of a model's printed functions is meant.
enum class overload {
    scalar,
    rgb,            ///< three channels that share the angle
    directions,     ///< two directions in place of cos_i
    rgb_directions, ///< both
    boundary,       ///< R_s, R_p, T_s and T_p of an exact model
    fixed,          ///< every parameter a constant
    geometry        ///< no model: directions, angles and indices
};

std::string_view to_string(overload kind);

/// One printed function and how it is called.
struct verify_case {
    std::string id;   ///< unlike every other; fit for a file's name: "conductor", "conductor_rgb"
    std::string name; ///< of the model, or of the function that is none
    overload kind = overload::scalar;
    std::vector<argument> arguments; ///< as the function takes them
    fixed_values fixed = {};
    int results = 1; ///< 1, 3 of an RGB value or a direction, 4 of a boundary
    bool transcendental =
        false; ///< whether it calls exp2, log2, log or pow, which no device rounds correctly

    int columns() const;
};

/// Every overload of those models, of all models if none is named; then, in that case, the geometry. Throws bad_input
/// for an unknown model.
std::vector<verify_case> verify_cases(std::span<const std::string> models = {});

/// Inputs, and the values of the float instantiation of the model.
struct verify_data {
    std::size_t rows = 0;
    std::vector<float> inputs;   ///< rows times columns
    std::vector<float> expected; ///< rows times results
    std::vector<std::uint8_t>
        open; ///< a row whose value languages leave open: something is NaN on the way, or pow is
              ///< outside its domain
};

/// Deterministic inputs: every combination of edges as far as there is room (cos_i 0 and 1, the ends of a parameter's
/// range, the neighbours of 1, infinity, NaN), critical and Brewster angles and their neighbours, and random values of
/// every magnitude. A row in whose evaluation a number is subnormal is left out, since devices may take those for 0.
verify_data make_data(const verify_case& c, std::size_t rows);

/// The rows to try where nothing else is asked for: scalar functions, and the others.
inline constexpr std::size_t scalar_rows = (1 << 18) + (1 << 13), other_rows = 1 << 16;
std::size_t default_rows(const verify_case& c);

/// The values to expect of inputs.
verify_data assess(const verify_case& c, std::vector<float> inputs);

/// Text in that language which defines the functions of cases and all they need, without a shader around it.
std::string verify_text(const language& l, std::span<const verify_case> cases, const style& how = {});

/// The expression that calls it, `column(k)` standing for column k of the inputs: "schlick(x[0], x[1])".
std::string verify_call(const language& l, const verify_case& c, std::string (*column)(int k));

/// What of its values differs.
struct difference {
    std::size_t rows = 0, differing = 0;           ///< differing: some bit does, any NaN being like any other
    std::size_t open_rows = 0, open_differing = 0; ///< rows whose value languages leave open, counted apart
    double max_difference = 0; ///< of a differing row; infinite where one side alone is NaN or infinite
    std::uint32_t max_ulp = 0; ///< steps between the floats of a differing row
    std::vector<float> inputs, expected, got; ///< of the row of max_difference, where there is one
};

/// Throws failure where `values` has another size than expected.
difference compare_bits(const verify_case& c, const verify_data& data, std::span<const float> values);

/// The largest difference there may be: 0, bit by bit, for what is made of + - * / sqrt alone. `rearranged`: the compiler
/// may move constant factors and re-associate, for want of a qualifier that forbids it; then 1e-6 for functions whose
/// parameters are constants and for two models with factors of their own in a row (gulbrandsen, f82_tint), and infinity,
/// no claim, for conductor_precise, whose compensated sums mean nothing there. Of what calls exp2 or pow the bound is
/// that of the devices' functions, over powers up to 1000; 1e-6 for the constants of `fixed`. A dot product may be summed
/// in any order: 5e-7 for the functions that are little else.
double allowed_difference(const verify_case& c, bool rearranged);

/// One line of the table that `fresnel shader --verify` prints.
struct verify_result {
    verify_case what;
    std::string receiver;
    difference found;
    double allowed = 0;

    bool passed() const;
};

/// Writes cases.json and for each case ID.in.f32 and ID.expected.f32 (little-endian, row after row), and its text in
/// each language, ID.EXTENSION; no language named is every language. cases.json: array of {id, name, kind, arguments:
/// [{name, width}], columns, results, rows, transcendental, inputs, expected, text: {LANG: FILE}, call: {LANG:
/// EXPRESSION of x[k]}}. `rows` as in default_rows if 0.
void dump_cases(const std::filesystem::path& folder, std::span<const verify_case> cases,
                std::span<const std::string> wanted = {}, std::size_t rows = 0);

/// Compares what a runner wrote into that folder: for each case ID.RECEIVER.out.f32, whatever RECEIVER is. Throws
/// bad_input where there is none.
std::vector<verify_result> check_dump(const std::filesystem::path& folder, std::span<const verify_case> cases,
                                      bool rearranged = true);

} // namespace fresnel::emit
