#pragma once

#include "emit/function.hpp"

#include <fresnel/color.hpp>
#include <fresnel/material.hpp>

#include <array>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

// Reflectance baked into a table that a linear filter reads: what Wloka's texture variant needs (2002, "Fresnel
// Reflection", figures 10 and 11), with its error. The texels stand at t = 0, 1 / (N - 1), ..., 1 of a map t(cos_i),
// so that cos_i = 0 and 1 fall on the centres of the first and the last.

namespace fresnel::emit {

/// How the cosine becomes the coordinate along a table.
struct lut_map {
    std::string_view name;
    std::string_view even_in;     ///< what the texels are even in, for readers
    float (*coordinate)(float c); ///< t, for c in [0, 1]
    double (*cosine)(double t);   ///< its inverse
    bool offered;                 ///< the others are measured only, to show why they are not
};

/// cos and sqrt-cos, which can be baked, then angle and sine, which lose.
std::span<const lut_map> lut_maps();

/// One of the maps that can be baked; throws bad_input naming them.
const lut_map& find_lut_map(std::string_view name);

/// What the table's numbers are stored in.
enum class texel_format { r8, r16, r16f, rgba32f, c };

std::string_view to_string(texel_format format);

/// throws bad_input naming the five
texel_format find_texel_format(std::string_view name);

/// The second axis of a table: the relative index, or the reflectance at normal incidence.
struct lut_axis {
    std::string name; ///< eta or f0
    double lo, hi;
};

/// What is baked: reflectance against cos_i, of one channel (repeated in three) or of three.
struct lut_subject {
    std::string name;    ///< of the model or the material
    std::string caption; ///< name, parameters, working space
    int channels;        ///< 1 or 3
    double critical = 0; ///< cosine of the critical angle, below which reflectance is 1; 0: there is none
    std::optional<lut_axis> by = {};
    std::string data = {}; ///< what the numbers of a material are from
    /// Exact values at those cosines, and at one place of the second axis.
    std::function<std::vector<rgb>(const std::vector<double>& cos_i, double by)> reflectance = {};
};

/// A model's parameters are those in `fixed`, one value or one for each channel, and the defaults of the registry.
/// `by` is "", "eta" or "f0", which the model has or, if exact, has through n_t; a range may follow: "eta=1.1:2".
///
/// throws bad_input for an unknown model or parameter, a value outside its range, a second axis that the model lacks,
///        one that passes a critical angle, which no row of texels can follow as it moves
lut_subject model_subject(std::string_view model, const fixed_values& fixed, const std::string& by = {});

/// The exact colours of a material.
///
/// throws bad_input where the critical angle depends on the wavelength
lut_subject material_subject(const material& substance, color_space space, double ambient);

/// The exact values of a subject on a dense set of cosines, for errors: even in angle, in cos_i and in sqrt(cos_i),
/// and more finely than any table of that many columns.
struct lut_reference {
    std::vector<float> cos_i;
    std::size_t angles; ///< so many at the front are even in angle, 0 to 90 degrees: for the root mean square
    std::vector<rgb> value;
};

lut_reference make_reference(const lut_subject& subject, std::size_t columns, double by = 0);

struct lut_error {
    double max = 0;   ///< largest |table - exact| of any channel
    double rms = 0;   ///< root mean square, even in angle
    double cos_i = 0; ///< where the largest is
    double by = 0;    ///< and where along the second axis
    double max_8_bit =
        0; ///< the largest where the filter's weights have 8 bits, as in most graphics processors
    double at_critical = 0; ///< next to the critical cosine, where the root magnifies the rounding of a float
};

struct lut {
    lut_subject subject;
    const lut_map* map;
    std::size_t columns, rows; ///< along cos_i, and along the second axis or 1
    texel_format format;
    double lo = 0, hi = 1;          ///< what the texels 0 and 1 of r8 and r16 stand for
    std::vector<float> texels = {}; ///< as the format holds them, rows of columns of channels
    lut_error error = {};

    std::size_t channels() const { return static_cast<std::size_t>(subject.channels); }
    /// Whether texels are not yet the values: value = lo + (hi - lo) texel.
    bool scaled() const { return lo != 0 || hi != 1; }
};

struct lut_request {
    std::optional<std::string_view> map; ///< none: the map with the smaller error
    std::size_t columns = 64, rows = 1;
    texel_format format = texel_format::r16f;
};

/// The limits of a table's size.
inline constexpr std::size_t least_texels = 2, most_columns = 4096, most_columns_2d = 256;

/// Bakes a table and measures it against the subject, as its sampler reads it.
///
/// throws bad_input for the map cos of a subject with a critical angle, for sizes outside the limits
lut bake(const lut_subject& subject, const lut_request& wanted);

/// The same where the reference is known, for tables of one row.
lut bake(const lut_subject& subject, const lut_request& wanted, const lut_reference& exact);

/// A table of any map, without its error.
lut unmeasured(const lut_subject& subject, const lut_map& map, const lut_request& wanted);

lut_error error_of(const lut& table, const lut_reference& exact);

/// The same of a table of any number of rows, with a reference made for it.
lut_error error_of(const lut& table);

enum class filter_weights { exact, eight_bits };

/// What the sampler returns, computed in float as the sampler does.
std::array<float, 3> sample(const lut& table, float cos_i, float by = 0,
                            filter_weights weights = filter_weights::exact);

} // namespace fresnel::emit
