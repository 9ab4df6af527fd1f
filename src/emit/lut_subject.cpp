#include "analysis/curve.hpp"
#include "analysis/drawing.hpp"
#include "analysis/model_table.hpp"
#include "emit/lut.hpp"
#include "error.hpp"
#include "materials/observer.hpp"

#include <fresnel/geometry.hpp>

#include <fmt/format.h>

#include <charconv>
#include <cmath>

namespace fresnel::emit {

namespace {

using parameter_list = std::vector<double>;

std::optional<std::size_t> index_of(const model_row<double>& row, std::string_view name) {
    for (std::size_t i = 0; i < row.parameters.size(); ++i)
        if (row.parameters[i].name == name) return i;
    return std::nullopt;
}

double value_of(const model_row<double>& row, const parameter_list& values, std::string_view name,
                double otherwise) {
    const auto i = index_of(row, name);
    return i ? values[*i] : otherwise;
}

// ---- parameters ---------------------------------------------------------------------------------------------

bool is_coloured(const fixed_values& fixed) {
    for (const auto& [name, v] : fixed)
        if (v[0] != v[1] || v[1] != v[2]) return true;
    return false;
}

std::array<parameter_list, 3> channel_values(const model_row<double>& row, const fixed_values& fixed) {
    std::array<parameter_list, 3> all;
    for (std::size_t c = 0; c < 3; ++c)
        for (const parameter& p : row.parameters) {
            const auto found = fixed.find(std::string(p.name));
            all[c].push_back(found == fixed.end() ? p.default_value : found->second[c]);
        }
    return all;
}

// ---- the second axis ------------------------------------------------------------------------------------------

/// The parameter that the second axis sets, and how.
struct driven {
    std::size_t parameter;
    enum { itself, times_n_i, index_of_f0 } how;

    double value(double by, double n_i) const {
        if (how == itself) return by;
        return n_i * (how == times_n_i ? by : eta_from_f0(by));
    }
};

// "eta=1.1:2" as name and ends; without ends the usual range of the model.
lut_axis parse_axis(const model_row<double>& row, const std::string& by) {
    const std::size_t equals = std::min(by.find('='), by.size());
    lut_axis axis{by.substr(0, equals), 0, 1};
    if (axis.name != "eta" && axis.name != "f0")
        throw bad_input(fmt::format("--by '{}': must be eta or f0, with a range if wanted: eta=1.1:2", by));
    if (axis.name == "eta") axis.lo = 1.3, axis.hi = 2.5;
    if (axis.name == "f0" && row.kind == model_kind::exact) axis.lo = 0.02, axis.hi = 0.2;
    if (equals == by.size()) return axis;
    const std::size_t colon = by.find(':', equals);
    const auto number = [&](std::size_t from, std::size_t to) {
        double value = 0;
        const auto [end, error] = std::from_chars(by.data() + from, by.data() + to, value);
        if (error != std::errc{} || end != by.data() + to || !std::isfinite(value))
            throw bad_input(fmt::format("--by '{}': the range must be LO:HI, two numbers", by));
        return value;
    };
    axis.lo = number(equals + 1, std::min(colon, by.size()));
    axis.hi = number(std::min(colon, by.size() - 1) + 1, by.size());
    if (!(axis.lo < axis.hi)) throw bad_input(fmt::format("--by '{}': the range must rise", by));
    return axis;
}

driven driven_by(const model_row<double>& row, const lut_axis& axis) {
    if (const auto itself = index_of(row, axis.name)) return {*itself, driven::itself};
    if (const auto n_t = index_of(row, "n_t"))
        return {*n_t, axis.name == "eta" ? driven::times_n_i : driven::index_of_f0};
    const auto n = index_of(row, "n");
    if (axis.name == "eta" && n) return {*n, driven::itself};
    throw bad_input(fmt::format("--by {}: {} has no {}", axis.name, row.name, axis.name));
}

bool is_transparent(const model_row<double>& row, const parameter_list& values) {
    return (row.kind == model_kind::exact || index_of(row, "eta")) && value_of(row, values, "k_t", 0) == 0;
}

void check_axis(const model_row<double>& row, const std::array<parameter_list, 3>& values,
                const lut_axis& axis, const driven& by, const fixed_values& fixed) {
    const parameter& p = row.parameters[by.parameter];
    if (fixed.count(std::string(p.name)) != 0)
        throw bad_input(fmt::format("--fix {}: --by {} sets it", p.name, axis.name));
    if (axis.name == "f0" && value_of(row, values[0], "k_t", 0) != 0)
        throw bad_input("--by f0 with k_t: an absorbing medium is not known by its f0; use --by eta");
    if (by.how == driven::index_of_f0 && !(axis.lo > 0 && axis.hi < 1))
        throw bad_input(fmt::format("--by f0={}:{}: must lie inside (0, 1): at 0 the media are equal and "
                                    "reflectance jumps at cos_i = 0",
                                    axis.lo, axis.hi));
    if (axis.name == "eta" && is_transparent(row, values[0]) && !(axis.lo > 1))
        throw bad_input(fmt::format(
            "--by eta={}:{}: must lie above 1: below it is a critical angle that moves with eta, across the "
            "texels; look up the table of 1 / eta at the transmitted cosine instead, reflectance is the same",
            axis.lo, axis.hi));
    for (const parameter_list& channel : values)
        for (const double end : {axis.lo, axis.hi})
            check_range(p, by.value(end, value_of(row, channel, "n_i", 1)));
}

// ---- the critical angle ---------------------------------------------------------------------------------------

double critical_of(const model_row<double>& row, const parameter_list& values) {
    if (!is_transparent(row, values)) return 0;
    const double eta =
        value_of(row, values, "eta", value_of(row, values, "n_t", 1) / value_of(row, values, "n_i", 1));
    return critical_cosine(eta);
}

// One for all channels or wavelengths, or a refusal.
double shared_critical(const std::string& name, const std::vector<double>& all) {
    const auto [least, most] = std::minmax_element(all.begin(), all.end());
    if (*most - *least < 1e-9) return *most;
    throw bad_input(fmt::format("{}: its critical angle lies between {:.2f} and {:.2f} degrees, another for "
                                "every colour, and one map can begin at one only; bake dielectric with the "
                                "n_t of each channel",
                                name, degrees_of_cosine(*most), degrees_of_cosine(*least)));
}

// ---- captions -------------------------------------------------------------------------------------------------

std::string caption_of(const model_row<double>& row, const std::array<parameter_list, 3>& values,
                       std::optional<std::size_t> driven) {
    std::string text(row.name);
    for (std::size_t i = 0; i < row.parameters.size(); ++i) {
        if (i == driven) continue;
        const auto shown = [&](std::size_t c) { return static_cast<float>(values[c][i]); };
        const bool one = values[0][i] == values[1][i] && values[1][i] == values[2][i];
        text += fmt::format(", {} = {}", row.parameters[i].name,
                            one ? fmt::format("{}", shown(0))
                                : fmt::format("({}, {}, {})", shown(0), shown(1), shown(2)));
    }
    return text;
}

} // namespace

lut_subject model_subject(std::string_view model, const fixed_values& fixed, const std::string& by) {
    const model_row<double>& row = find_model<double>(model);
    check_fixed(row, fixed);
    const std::array<parameter_list, 3> values = channel_values(row, fixed);
    lut_subject subject{std::string(row.name), "", is_coloured(fixed) ? 3 : 1};
    std::optional<driven> moved;
    if (!by.empty()) {
        subject.by = parse_axis(row, by);
        moved = driven_by(row, *subject.by);
        check_axis(row, values, *subject.by, *moved, fixed);
    } else {
        std::vector<double> critical;
        for (const parameter_list& channel : values)
            critical.push_back(critical_of(row, channel));
        subject.critical = shared_critical(subject.name, critical);
    }
    subject.caption = caption_of(row, values, moved ? std::optional(moved->parameter) : std::nullopt);
    subject.reflectance = [&row, values, moved, channels = subject.channels](const std::vector<double>& cos_i,
                                                                             double at) {
        std::vector<rgb> all(cos_i.size());
        for (std::size_t c = 0; c < 3; ++c) {
            parameter_list own = values[c];
            if (moved) own[moved->parameter] = moved->value(at, value_of(row, own, "n_i", 1));
            for (std::size_t i = 0; i < cos_i.size(); ++i)
                all[i][c] =
                    c > 0 && channels == 1 ? all[i][0] : row.evaluate(own.data(), cos_i[i]).reflectance();
        }
        return all;
    };
    return subject;
}

lut_subject material_subject(const material& substance, color_space space, double ambient) {
    constexpr double transparent = 1e-3; // more absorption rounds the critical angle off
    std::vector<double> critical;
    for (const double nm : default_recipe(space).wavelength_nm) {
        const optical_index index = index_at(substance, nm);
        critical.push_back(index.k <= transparent ? critical_cosine(index.n / ambient) : 0);
    }
    lut_subject subject{substance.name,
                        fmt::format("{} in {}, ambient {}", substance.name, space_title(space), ambient), 3};
    subject.critical = shared_critical(substance.name, critical);
    subject.data = substance.citation;
    subject.reflectance = [substance, space, ambient](const std::vector<double>& cos_i, double) {
        return exact_colours(substance, space, ambient, cos_i);
    };
    return subject;
}

} // namespace fresnel::emit
