#pragma once

#include "materials/catalog.hpp"

#include <fresnel/color.hpp>
#include <fresnel/exact.hpp>
#include <fresnel/material.hpp>

#include <string>
#include <vector>

namespace fresnel {

double radians(double degrees);
double degrees(double radians);

/// cos of an angle in degrees, exact at 0, 60 and 90.
double cosine_of_degrees(double theta_deg);
double degrees_of_cosine(double cos_i);

/// The index of a material at a wavelength that is used. Throws bad_input where it has none, at a pole of its formula.
optical_index used_index(const material& substance, double wavelength_nm);

/// Which reflectance: that of unpolarised light, (R_s + R_p) / 2, or one of the two.
enum class polarization { mean, s, p };

/// That reflectance of a boundary.
inline double reflectance_of(const boundary<double>& at, polarization which) {
    return which == polarization::s ? at.R_s : which == polarization::p ? at.R_p : at.reflectance();
}

/// Reflectance of a material over wavelength and angle.
struct spectral_surface {
    std::vector<double> wavelength_nm;
    std::vector<double> theta_deg, cos_i;
    std::vector<std::vector<double>> R; ///< R[angle][wavelength]
};

/// Exact reflectance at those wavelengths and angles; ambient is the index of the medium outside.
spectral_surface exact_surface(const material& substance, double ambient, std::vector<double> wavelength_nm,
                               std::vector<double> theta_deg, polarization which = polarization::mean);

/// Reflectance against the angle of incidence, as colours of one space.
struct rgb_curve {
    color_space space;
    std::vector<double> theta_deg, cos_i; ///< uniform in theta, 0 to 90 degrees
    std::vector<rgb> value;
};

/// The exact curve: integrated over the spectrum first and turned into RGB after.
rgb_curve exact_curve(const material& substance, color_space space, double ambient, double step_deg = 0.25,
                      polarization which = polarization::mean);

/// The colour of a material at one angle, unpolarised: integrated over the spectrum.
rgb colour_at(const material& substance, color_space space, double ambient, double cos_i);

/// Exact colours at those cosines.
std::vector<rgb> exact_colours(const material& substance, color_space space, double ambient,
                               const std::vector<double>& cos_i, polarization which = polarization::mean);

/// What an artist types in: the colours of a surface at normal incidence and at cos_i = 1/7.
struct normal_colour {
    std::string material, page;
    color_space space;
    double ambient;
    rgb f0, f82;
    rgb f82_tint;                     ///< f82 / schlick(f0, 1/7), both as parts of white
    rgb gulbrandsen_r, gulbrandsen_g; ///< r as a part of white
    rgb average;                      ///< hemispherical: the integral of R 2 c dc
    std::string recipe;
    bool in_gamut; ///< whether f0 needed no limit
};

/// policy   limits f0 and, alike, everything else: `divide` divides all by f0's one factor, and tint, r and g are those
///          of the limited curve
normal_colour colour_at_normal(const material& substance, color_space space, double ambient,
                               gamut policy = gamut::none);

} // namespace fresnel
