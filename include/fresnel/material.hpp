#pragma once

// A material is its measured optical constants n(lambda) and k(lambda) with their source, or, where only a
// table of numbers is known, an index or an f0 with its range. Wavelengths are in nanometres throughout.

#include <fresnel/geometry.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

namespace fresnel {

/// A tabulated quantity, linear in wavelength between its points and constant beyond the first and the last.
///
/// wavelength_nm   strictly increasing, at least one   nm
/// value           one for each wavelength
struct samples {
    std::vector<double> wavelength_nm, value;

    bool operator==(const samples&) const = default;
};

/// A dispersion formula of refractiveindex.info, which gives n; constant beyond the ends of its range.
///
/// formula        1 Sellmeier, 2 Sellmeier with poles not squared, 3 polynomial, 4 RefractiveIndex.INFO,
///                5 Cauchy, 6 gases, 7 Herzberger, 8 retro, 9 exotic
/// coefficients   C1 first, for wavelengths in micrometres; missing trailing ones are 0
/// lo_nm, hi_nm   the range over which it was fitted   nm
struct dispersion {
    int formula;
    std::vector<double> coefficients;
    double lo_nm, hi_nm;

    bool operator==(const dispersion&) const = default;
};

using spectrum = std::variant<samples, dispersion>;

namespace dispersion_formula {

/// Coefficient C_i, i counted from 1 as in the formulas; 0 where the page lists fewer.
inline double term(std::span<const double> c, std::size_t i) { return i <= c.size() ? c[i - 1] : 0; }

/// The sum of c_j * shape(c_{j+1}) over the pairs j = first, first + 2, ...; a pair with c_j = 0 is skipped,
/// since its shape may be 0 / 0.
template <class Shape>
double pairs(std::span<const double> c, std::size_t first, Shape shape) {
    double sum = 0;
    for (std::size_t j = first; j <= c.size(); j += 2)
        if (term(c, j) != 0) sum += term(c, j) * shape(term(c, j + 1));
    return sum;
}

/// Formula 4's resonance C_j um^C_{j+1} / (um^2 - C_{j+2}^C_{j+3}); 0 where C_j is.
inline double resonance(std::span<const double> c, std::size_t j, double um) {
    if (term(c, j) == 0) return 0;
    return term(c, j) * std::pow(um, term(c, j + 1)) / (um * um - std::pow(term(c, j + 2), term(c, j + 3)));
}

/// n^2 of formula 8, (n^2 - 1) / (n^2 + 2) = C1 + C2 um^2 / (um^2 - C3) + C4 um^2.
inline double retro(std::span<const double> c, double um2) {
    const double ratio = term(c, 1) + term(c, 2) * um2 / (um2 - term(c, 3)) + term(c, 4) * um2;
    return (1 + 2 * ratio) / (1 - ratio);
}

/// n of formula 7, C1 + C2 L + C3 L^2 + C4 um^2 + C5 um^4 + C6 um^6 with L = 1 / (um^2 - 0.028).
inline double herzberger(std::span<const double> c, double um2) {
    const double l = 1 / (um2 - 0.028);
    return term(c, 1) + l * (term(c, 2) + l * term(c, 3)) +
           um2 * (term(c, 4) + um2 * (term(c, 5) + um2 * term(c, 6)));
}

/// n^2 of formula 9, C1 + C2 / (um^2 - C3) + C4 (um - C5) / ((um - C5)^2 + C6).
inline double exotic(std::span<const double> c, double um) {
    const double d = um - term(c, 5);
    const double resonant = term(c, 4) == 0 ? 0 : term(c, 4) * d / (d * d + term(c, 6));
    return term(c, 1) + term(c, 2) / (um * um - term(c, 3)) + resonant;
}

/// n at a wavelength in micrometres, which must be above 0. NaN at a pole and where n^2 < 0, for a formula
/// that is not 1 to 9, and never for another reason.
///
/// source  M. N. Polyanskiy, refractiveindex.info database, "Dispersion formulas"
inline double evaluate(int formula, std::span<const double> c, double um) {
    const double um2 = um * um;
    const auto power = [&](double exponent) { return std::pow(um, exponent); };
    const auto root = [](double n2) {
        return n2 >= 0 && std::isfinite(n2) ? std::sqrt(n2) : std::numeric_limits<double>::quiet_NaN();
    };
    switch (formula) {
    case 1:
        return root(1 + term(c, 1) + pairs(c, 2, [&](double b) { return um2 / (um2 - b * b); }));
    case 2:
        return root(1 + term(c, 1) + pairs(c, 2, [&](double b) { return um2 / (um2 - b); }));
    case 3:
        return root(term(c, 1) + pairs(c, 2, power));
    case 4:
        return root(term(c, 1) + resonance(c, 2, um) + resonance(c, 6, um) + pairs(c, 10, power));
    case 5:
        return term(c, 1) + pairs(c, 2, power);
    case 6:
        return 1 + term(c, 1) + pairs(c, 2, [&](double b) { return 1 / (b - 1 / um2); });
    case 7:
        return herzberger(c, um2);
    case 8:
        return root(retro(c, um2));
    case 9:
        return root(exotic(c, um));
    default:
        return std::numeric_limits<double>::quiet_NaN();
    }
}

} // namespace dispersion_formula

/// A tabulated quantity at a wavelength; NaN for an empty table.
inline double value_at(const samples& table, double wavelength_nm) {
    const std::vector<double>& at = table.wavelength_nm;
    if (at.empty()) return std::numeric_limits<double>::quiet_NaN();
    const auto above = std::upper_bound(at.begin(), at.end(), wavelength_nm);
    if (above == at.begin()) return table.value.front();
    if (above == at.end()) return table.value.back();
    const auto i = static_cast<std::size_t>(above - at.begin());
    return mix(table.value[i - 1], table.value[i], (wavelength_nm - at[i - 1]) / (at[i] - at[i - 1]));
}

/// A dispersion formula's n at a wavelength; NaN at a pole, that is where the formula gives n^2 < 0 or is
/// infinite (four pages of the database have one inside their declared range, none of the built-in ones).
inline double value_at(const dispersion& law, double wavelength_nm) {
    const double um = std::clamp(wavelength_nm, law.lo_nm, law.hi_nm) / 1000;
    const double n = dispersion_formula::evaluate(law.formula, law.coefficients, um);
    return std::isfinite(n) ? n : std::numeric_limits<double>::quiet_NaN();
}

/// A spectrum at a wavelength, constant beyond the ends of its range.
///
/// wavelength_nm   > 0   nm
/// returns         the quantity; NaN at a pole of a formula
inline double value_at(const spectrum& quantity, double wavelength_nm) {
    return std::visit([&](const auto& form) { return value_at(form, wavelength_nm); }, quantity);
}

/// What is known of a material: its spectra, its index, or its reflectance at normal incidence.
enum class material_kind { spectral, index, f0 };

/// A material with its provenance.
///
/// name, aliases   what an engineer would type; lower case
/// category        metal, semimetal, semiconductor or dielectric
/// page            refractiveindex.info file without .yml, "main/Cu/nk/Johnson"; empty for table rows
/// n, k            spectra; k is absent where the source gives none, which is not the same as 0
/// index, f0       lo and hi, equal for a single value; of the kinds so named, otherwise 0
/// range_nm        where both n and k (or n alone, where k is absent) are known; beyond it they are held
///                 constant. The visible range for table rows, which name no wavelength
/// quality         one sentence: measured or calculated, points in the visible, film or bulk, weak points
struct material {
    std::string name;
    std::vector<std::string> aliases;
    std::string category;
    material_kind kind = material_kind::spectral;
    std::string page;
    std::optional<spectrum> n, k;
    std::array<double, 2> index{}, f0{};
    std::array<double, 2> range_nm{};
    std::string citation, doi, licence, quality;
};

/// A complex index n + i k.
struct optical_index {
    double n, k;
};

/// The complex index of a material at a wavelength, relative to vacuum or air as its source gives it.
///
/// An absent k counts as 0 here, and so does the negative k that some pages have as noise; ask `what.k` where
/// the difference matters. An `index` material has the middle of its range, an `f0` material the index above 1 that gives
/// the middle of its f0 range, at every wavelength.
///
/// wavelength_nm   > 0   nm
/// returns         n, k >= 0; n is NaN at a pole of its formula and where the material has no n
inline optical_index index_at(const material& what, double wavelength_nm) {
    switch (what.kind) {
    case material_kind::index:
        return {std::midpoint(what.index[0], what.index[1]), 0};
    case material_kind::f0:
        return {eta_from_f0(std::midpoint(what.f0[0], what.f0[1])), 0};
    default:
        break;
    }
    const double n = what.n ? value_at(*what.n, wavelength_nm) : std::numeric_limits<double>::quiet_NaN();
    const double k = what.k ? value_at(*what.k, wavelength_nm) : 0;
    return {n, k < 0 ? 0 : k};
}

/// The material with an `index` or `f0` range replaced by its end 0 (lower) or 1 (upper); spectral ones have
/// no range and come back unchanged. The two ends draw a material as a band.
inline material end_of_range(material what, std::size_t end) {
    what.index.fill(what.index[end]);
    what.f0.fill(what.f0[end]);
    return what;
}

/// The lower end of a material's index or f0 range.
inline material low_end(const material& what) { return end_of_range(what, 0); }

/// The upper end of a material's index or f0 range.
inline material high_end(const material& what) { return end_of_range(what, 1); }

/// Whether a material is known only as a range, to be drawn as a band.
inline bool has_range(const material& what) {
    return what.index[0] != what.index[1] || what.f0[0] != what.f0[1];
}

} // namespace fresnel
