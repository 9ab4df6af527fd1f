#pragma once

#include "analysis/curve.hpp"
#include "analysis/model_table.hpp"
#include "figure/figure.hpp"

#include <map>
#include <optional>
#include <string>
#include <vector>

namespace fresnel {

/// What the x axis counts: the angle of incidence in degrees, its cosine or its sine.
enum class abscissa { theta, cos_theta, sin_theta };

/// A model or a material to plot: one of the two is there.
struct plot_subject {
    std::string name;
    const model_row<double>* model = nullptr;
    std::optional<material> substance;
};

/// The model of that name, or else the material (built in, or a .yml or .csv file); throws bad_input with the nearest
/// name of both where there is neither.
plot_subject find_subject(const std::string& name);

/// One curve for every value of a parameter.
struct plot_family {
    std::string parameter; ///< registry name
    std::vector<double> values;
};

/// What to plot.
///
/// A parameter that is not in `given` is fitted, channel by channel, to `fitted_to`. Where that is absent, models
/// of which no parameter is given are fitted to the first that there is of: a reference, the first material, and, for
/// approximations, the first exact model. Otherwise it is the registry's default, and n_i the ambient index.
struct plot_request {
    std::string id = "plot", title; ///< an empty title is made from the names
    std::vector<plot_subject> subjects;
    std::map<std::string, double> given;   ///< parameters by registry name, for every model that takes them
    std::optional<plot_family> family;     ///< as one that is given, in turn
    std::optional<plot_subject> reference; ///< a material or exact model: plots are signed errors against it
    std::optional<material> fitted_to;
    std::vector<polarization> polarizations = {polarization::mean};
    abscissa against = abscissa::theta;
    std::optional<double> wavelength_nm; ///< one wavelength instead of the colour channels
    color_space space = color_space::srgb;
    double ambient = 1;
    bool strips = false;  ///< a strip of colours under the curves for each
    bool surface = false; ///< reflectance of one material over wavelength and angle instead
};

/// The figure. Its curves have a value every 0.25 degrees. A material known as a range is a band: its ends thin, its
/// middle as the others.
///
/// Curves whose channels differ by less than the width of a line are drawn as one, their luminance.
/// Throws bad_input naming the argument that does not go with the rest.
figure make_plot(const plot_request& asked);

} // namespace fresnel
