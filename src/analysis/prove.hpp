#pragma once

#include <fresnel/material.hpp>

#include <fresnel/material.hpp>

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace fresnel {

/// Two numbers between which the maximum certainly lies.
struct certified {
    double lo, hi;
};

/// A material at one wavelength: what is certain of a fitted model's error, and where it is largest, with the parameters.
struct certified_material {
    std::string name;
    double wavelength_nm;
    certified absolute;
    std::vector<std::pair<std::string, double>> at;
};

/// What is certain of a model's error over its stated domain.
struct certificate {
    std::string model, domain;
    certified absolute;                ///< largest |model - exact|
    std::optional<certified> relative; ///< largest |model - exact| / exact
    bool unbounded_near_match = false; ///< whether that exceeds every bound as eta goes to 1; proved
    std::vector<std::pair<std::string, double>> at; ///< where the largest |model - exact| is
    std::string material;                           ///< of fitted models: which material, at which wavelength
    std::vector<certified_material> materials;      ///< of fitted models: each by itself
    double rounding_found; ///< largest |float32 model - real model| that a search found
    std::vector<std::pair<std::string, double>> rounding_at; ///< where
    std::optional<double> rounding_bound; ///< what that certainly never exceeds, where proved
    bool proved;                          ///< whether `absolute` is proved, else measured
};

/// Whether `prove` certifies errors taken over that domain of the registry, or repeats the measured one.
bool can_prove(std::string_view over);

/// Certifies a model by branch and bound over intervals: models of one f0 over the index, Schlick's from inside by
/// reciprocity, those of n and k over a box of both, fitted models over every built-in metal, the angle always from 0 to
/// 90 degrees. The enclosure of the absolute error is at most 5e-6 wide, of fitted models 5e-5. Exact models, which have
/// no error but rounding, keep the one that the registry's test measures.
///
/// Rounding is of parameters up to 10, of exact models for n_t / n_i in [0.1, 10] as far from a critical angle and an
/// index match as `domain` says, of `schlick_internal` inside gems, of `gulbrandsen` for r in [0.02, 0.99]. It is
/// bounded by a running error analysis (types/rounding.hpp), but for models that compare: there float and real may take
/// two ways.
///
/// throws bad_input for an unknown model
certificate prove(std::string_view model);

/// Whether a model approximates what is seen from outside, and so can be fitted to a material.
bool can_fit(std::string_view model);

/// The same over other materials, at 450, 550 and 650 nm in air, for any approximation of what is seen from outside, with
/// the parameters that `fit` gives it: those of f0 alone too.
///
/// throws bad_input for an unknown model, for exact ones and `schlick_internal`, and for a material that has no index there,
/// has a critical angle (n <= 1 and k < 0.001) or reflects less than 1e-4 at normal incidence
certificate prove(std::string_view model, const std::vector<material>& materials);

/// All models, on as many threads as there are cores, in the order of the registry.
std::vector<certificate> prove_all();

} // namespace fresnel
