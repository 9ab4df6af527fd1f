#pragma once

#include <fresnel/color.hpp>
#include <fresnel/material.hpp>

#include <functional>
#include <string>
#include <string_view>
#include <vector>

// What an approximation costs, as single numbers: each is measured here and nowhere else, for the figures, the
// tables, the ledger of claims and the commands.

namespace fresnel {

using curve_function = std::function<double(double cos_i)>;

/// Where a signed difference is largest in size over cos_i in [0, 1].
struct extremum {
    double cos_i, value;

    double theta_deg() const;
    double size() const;
};

/// The largest |difference| over all angles: a scan of 0.125 degrees, refined between its neighbours.
extremum largest(const curve_function& difference);

/// The root of a function that changes its sign once on [lo, hi], by bisection.
double root_of(double lo, double hi, const std::function<double(double)>& f);

/// Schlick minus exact, at a boundary of index eta seen from outside (eta > 1) or inside (eta < 1).
extremum schlick_error(double eta);

/// (Schlick - exact) / exact, eta > 1.
extremum schlick_relative_error(double eta);

/// `schlick_internal` minus exact, eta < 1.
extremum schlick_internal_error(double eta);

/// 1 - cos_i minus exact.
extremum one_minus_cos_error(double eta);

/// R_s - R: what a shader that ignores polarisation gets wrong for light polarised across the plane.
extremum polarisation_gap(double eta);

/// `air_conductor` minus exact.
extremum air_conductor_error(double n, double k);

/// `schlick_nk` minus exact, at a metal.
extremum schlick_nk_error(double n, double k);

/// `lazanyi` minus exact.
extremum lazanyi_error(double n, double k, double a, double alpha);

/// Linear interpolation in a table of `size` texels over cos_i, the end texels at 0 and 1, minus the function
/// itself. `bits` is the storage of a texel, 0 for exact.
extremum table_error(const curve_function& f, int size, int bits);

/// A value interpolated between two vertices of a regular polygon with so many sides minus the value at the
/// interpolated normal, the worst over all facets that face the viewer.
double vertex_interpolation_error(const curve_function& f, int sides);

/// How far R, G and B of a material lie apart at most, over all angles, in linear sRGB and air.
double channel_spread(const material& substance);

/// A material at one wavelength.
struct material_sample {
    std::string name;
    double wavelength_nm;
    optical_index index;
};

/// A material at 450, 550 and 650 nm. Throws bad_input where it has no index there.
std::vector<material_sample> samples_of(const material& m);

/// Whether it is one of the metals over which fitted models are judged: all whose n and k were measured but for caesium,
/// whose plasma edge lies in the visible, where nothing but the exact equations follows it.
bool is_sample_metal(const material& m);

/// Each built-in one at 450, 550 and 650 nm.
const std::vector<material_sample>& metal_samples();

} // namespace fresnel
