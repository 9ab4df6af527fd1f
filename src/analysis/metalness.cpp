#include "analysis/metalness.hpp"

#include "error.hpp"

#include <fresnel/shading.hpp>

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <string>
#include <vector>

namespace fresnel {

namespace {

constexpr std::array<metalness_law, 6> laws = {{
    {"disney", "Burley 2012, Physically-Based Shading at Disney", "specular", 1, 0.5, false},
    {"unreal", "Karis 2013, Real Shading in Unreal Engine 4", "specular", 1, 0.5, false},
    {"frostbite", "Lagarde and de Rousiers 2014, Moving Frostbite to Physically Based Rendering",
     "reflectance", 1, 0.5, false},
    {"unity", "Unity, built-in shader source", "", 0, 0, false},
    {"gltf", "Khronos, KHR_materials_specular", "specular", 1, 1, true},
    {"openpbr", "OpenPBR Surface 1.1", "specular_weight", 1, 1, true},
}};

surface_color<double> color_of(const metalness_law& law, double base, const metalness_values& v) {
    if (law.name == "unity") return unity_surface(base, v.metalness);
    if (law.name == "openpbr") return openpbr_surface(base, v.metalness, v.ior, v.specular);
    const double f0 = law.name == "frostbite" ? frostbite_f0(v.specular)
                      : law.name == "gltf"    ? gltf_f0(v.ior, 1.0, v.specular)
                                              : disney_f0(v.specular);
    return metalness_surface(base, v.metalness, f0);
}

// For given metalness and specular every law is linear in the base color, f0 = A base + B and rho = D base, so that
// the best base follows channel by channel, and two numbers remain to be searched.
void choose_base(const metalness_law& law, const surface_colors& wanted, metalness_values& v) {
    const surface_color<double> at_0 = color_of(law, 0, v), at_1 = color_of(law, 1, v);
    const double A = at_1.f0 - at_0.f0, B = at_0.f0, D = at_1.albedo;
    for (std::size_t i = 0; i < 3; ++i)
        v.base[i] = std::clamp(
            (A * (wanted.f0[i] - B) + D * wanted.albedo[i]) / std::max(A * A + D * D, 1e-300), 0.0, 1.0);
}

double squared_error(const surface_colors& a, const surface_colors& b) {
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i)
        sum += square(a.f0[i] - b.f0[i]) + square(a.albedo[i] - b.albedo[i]);
    return sum;
}

double largest_error(const surface_colors& a, const surface_colors& b) {
    double worst = 0;
    for (std::size_t i = 0; i < 3; ++i)
        worst = std::max({worst, std::abs(a.f0[i] - b.f0[i]), std::abs(a.albedo[i] - b.albedo[i])});
    return worst;
}

// The nearest values, over metalness and, where the law has one, the dielectric's number.
class search {
public:
    search(const metalness_law& law, const surface_colors& wanted, double ior)
        : law_(law), wanted_(wanted), ior_(ior) {}

    metalness_values best() const {
        // greys have many answers: the usual dielectric first
        candidate found = refined(nearest(64, law_.specular_default), false);
        if (found.error < 1e-24 || law_.specular_max == 0) return found.values;
        for (int i = 0; i < 5; ++i)
            for (int j = 0; j < 5; ++j) {
                const candidate other = refined(at(0.25 * i, law_.specular_max * 0.25 * j), true);
                if (other.error < found.error) found = other;
            }
        return found.values;
    }

private:
    struct candidate {
        metalness_values values;
        double error;
    };

    candidate at(double metalness, double specular) const {
        metalness_values v{
            {}, std::clamp(metalness, 0.0, 1.0), std::clamp(specular, 0.0, law_.specular_max), ior_};
        choose_base(law_, wanted_, v);
        return {v, squared_error(to_surface(law_, v), wanted_)};
    }

    candidate nearest(int steps, double specular) const {
        candidate best = at(0, specular);
        for (int i = 1; i <= steps; ++i)
            if (const candidate other = at(static_cast<double>(i) / steps, specular);
                other.error < best.error)
                best = other;
        return best;
    }

    std::array<double, 6> residuals(double metalness, double specular) const {
        const surface_colors c = to_surface(law_, at(metalness, specular).values);
        std::array<double, 6> r{};
        for (std::size_t i = 0; i < 3; ++i)
            r[i] = c.f0[i] - wanted_.f0[i], r[i + 3] = c.albedo[i] - wanted_.albedo[i];
        return r;
    }

    // Levenberg and Marquardt's steps, with differences for derivatives.
    candidate refined(candidate best, bool specular_too) const {
        double damping = 1e-3;
        for (int step = 0; step < 2000 && damping < 1e20; ++step) {
            const double m = best.values.metalness, s = best.values.specular, h = 1e-7;
            const double hm = m < 0.5 ? h : -h, hs = s < 0.5 ? h : -h;
            const auto r = residuals(m, s), rm = residuals(m + hm, s), rs = residuals(m, s + hs);
            double mm = 0, ms = 0, ss = 0, gm = 0, gs = 0;
            for (std::size_t i = 0; i < 6; ++i) {
                const double dm = (rm[i] - r[i]) / hm, ds = specular_too ? (rs[i] - r[i]) / hs : 0;
                mm += dm * dm, ms += dm * ds, ss += ds * ds, gm += dm * r[i], gs += ds * r[i];
            }
            // a number that is pushed against its bound stays there
            const bool hold_m = (m <= 0 && gm > 0) || (m >= 1 && gm < 0);
            const bool hold_s = !specular_too || (s <= 0 && gs > 0) || (s >= law_.specular_max && gs < 0);
            if (hold_m) mm = 1, ms = 0, gm = 0;
            if (hold_s) ss = 1, ms = 0, gs = 0;
            mm *= 1 + damping, ss *= 1 + damping;
            const double determinant = mm * ss - ms * ms;
            if (determinant == 0) break;
            const candidate next =
                at(m - (gm * ss - gs * ms) / determinant, s - (gs * mm - gm * ms) / determinant);
            const bool better = next.error < best.error;
            damping *= better ? 0.1 : 10;
            if (better) best = next;
        }
        return best;
    }

    const metalness_law& law_;
    const surface_colors& wanted_;
    double ior_;
};

} // namespace

std::span<const metalness_law> metalness_laws() { return laws; }

const metalness_law& find_metalness_law(std::string_view name) {
    std::vector<std::string> names;
    for (const metalness_law& law : laws) {
        if (law.name == name) return law;
        names.emplace_back(law.name);
    }
    throw bad_input(fmt::format("--law '{}': must be one of {}{}", name, fmt::join(names, ", "),
                                did_you_mean(name, names)));
}

surface_colors to_surface(const metalness_law& law, const metalness_values& values) {
    surface_colors result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const surface_color<double> c = color_of(law, values.base[i], values);
        result.f0[i] = c.f0, result.albedo[i] = c.albedo;
    }
    return result;
}

surface_colors metalness_border_error(const metalness_law& law, const rgb& dielectric_base,
                                      const rgb& metal_base, double t) {
    const auto mixed = [t](const rgb& a, const rgb& b) {
        return rgb{mix(a[0], b[0], t), mix(a[1], b[1], t), mix(a[2], b[2], t)};
    };
    const surface_colors below = to_surface(law, {dielectric_base, 0, law.specular_default}),
                         above = to_surface(law, {metal_base, 1, law.specular_default}),
                         blended =
                             to_surface(law, {mixed(dielectric_base, metal_base), t, law.specular_default});
    const rgb f0 = mixed(below.f0, above.f0), albedo = mixed(below.albedo, above.albedo);
    surface_colors error{};
    for (std::size_t i = 0; i < 3; ++i)
        error.f0[i] = blended.f0[i] - f0[i], error.albedo[i] = blended.albedo[i] - albedo[i];
    return error;
}

metalness_fit from_surface(const metalness_law& law, const surface_colors& wanted, double ior) {
    const metalness_values values = search(law, wanted, ior).best();
    const surface_colors reproduced = to_surface(law, values);
    return {values, reproduced, largest_error(reproduced, wanted)};
}

} // namespace fresnel
