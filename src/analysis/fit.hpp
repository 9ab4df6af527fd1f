#pragma once

#include "analysis/curve.hpp"
#include "analysis/model_table.hpp"

#include <string>
#include <vector>

namespace fresnel {

/// One colour channel (or one wavelength) of an exact curve, to be approximated.
struct channel {
    std::vector<double> theta_deg, cos_i; ///< uniform in theta, from 0 to 90 degrees
    std::vector<double> R;                ///< exact reflectance at those angles
    double f0, f82;                       ///< exact reflectance at cos_i = 1 and 1/7
    double ambient;                       ///< index of the ambient medium
};

/// The tint of `f82_tint` for reflectances f0 and f82: f82 / schlick(f0, 1/7), above 1 where f82 is above Schlick's curve.
double tint_of_f82(double f0, double f82);

/// Channel i of a curve whose colours at cos_i = 1 and 1/7 are f0 and f82, as parts of `white`: models are made for
/// reflectances up to 1, and XYZ's white is not (1, 1, 1).
channel channel_of(const rgb_curve& exact, const rgb& f0, const rgb& f82, double ambient, std::size_t i,
                   const rgb& white = {1, 1, 1});

/// A single wavelength as a channel, in air: the exact reflectance of n and k every quarter of a degree.
channel channel_of(const optical_index& index);

/// What a surface is, as far as the choice of models goes.
enum class surface_class {
    metal,      ///< k matters
    dielectric, ///< k = 0 and denser than the ambient medium
    internal,   ///< k = 0 and thinner: there is a critical angle
    matched     ///< there is no boundary to see: only f0 is used
};

/// Parameters of a model for one channel, in the order of its registry row.
using parameters = std::vector<double>;

/// The models worth comparing on that class of surface, in the order of the registry.
std::vector<std::string_view> models_for(surface_class surface);

/// Gulbrandsen's (r, g), and the index (n, k) relative to the ambient medium they stand for.
struct edge_tint {
    double r, g, n, k;
};

/// The best parameters of a model for a channel, inside the ranges of the registry.
///
/// f0 and f82 are the exact values; what is left, the power of Schlick, Lazanyi's a and alpha, Gulbrandsen's g, f90,
/// bias and scale, is found by least squares over theta. n and k are those of Gulbrandsen's family through f0.
/// Throws bad_input for an unknown model.
parameters fit(std::string_view model, const channel& exact);

/// The same where `fit_gulbrandsen` of the channel is known already, which four models need.
parameters fit(std::string_view model, const channel& exact, const edge_tint& tint);

/// f0, exact, and the f82 of least squares over theta of `f82`, `powers_4_12` or `powers_2_8_16`: the curve no longer
/// passes through the exact f82, but is closer in the mean. Throws bad_input for another model.
parameters fit_f82(std::string_view model, const channel& exact);

/// The model with those parameters at the channel's angles.
std::vector<double> evaluate(std::string_view model, const parameters& values,
                             const std::vector<double>& cos_i);

/// Gulbrandsen's (r, g) of least squares.
edge_tint fit_gulbrandsen(const channel& exact);

/// Index of Gulbrandsen's parameters; r is limited as in the model.
edge_tint index_of(double r, double g);

/// Where Schlick's approximation misses a metal most, and the exponent that makes Lazanyi's term with a = 2 n
/// equal to the miss there.
struct metal_dip {
    double cos_i; ///< of the least exact - schlick_nk
    double error; ///< that difference, negative
    double alpha; ///< 2 n c (1 - c)^alpha = -error
};

/// Lagarde's way to Lazanyi's alpha: match the error at its minimum only. `fit("lazanyi", ...)` is the way of
/// least squares.
///
/// n, k    relative to the ambient medium; a metal's, k >= 1
/// source  Lagarde 2013, "Memo on Fresnel equations"
metal_dip find_metal_dip(double n, double k);

} // namespace fresnel
