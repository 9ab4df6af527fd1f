#include "materials/observer.hpp"

#include "error.hpp"
#include "materials/embedded.hpp"

#include <charconv>
#include <system_error>

namespace fresnel {

namespace {

using row = std::vector<double>;

// "360,0.1,0.2" as numbers. Stops at whatever is not one: a damaged table must not become a wrong colour.
row read_row(std::string_view line, std::string_view path) {
    row numbers;
    const char *at = line.data(), *const end = at + line.size();
    while (true) {
        const auto [after, error] = std::from_chars(at, end, numbers.emplace_back());
        if (error != std::errc{} || (after != end && *after != ',' && *after != '\r'))
            throw failure("data/" + std::string(path) + ": '" + std::string(line) +
                          "' is not a row of numbers");
        if (after == end || *after == '\r') return numbers;
        at = after + 1;
    }
}

// The rows of an embedded table, which begin with a digit; comments and the header do not.
std::vector<row> read_rows(std::string_view path, std::size_t columns) {
    std::vector<row> rows;
    std::string_view text = embedded_data(path);
    while (!text.empty()) {
        const std::size_t end = std::min(text.find('\n'), text.size());
        const std::string_view line = text.substr(0, end);
        text.remove_prefix(std::min(end + 1, text.size()));
        if (line.empty() || line.front() < '0' || line.front() > '9') continue;
        if (rows.emplace_back(read_row(line, path)).size() != columns)
            throw failure("data/" + std::string(path) + ": '" + std::string(line) + "' must have " +
                          std::to_string(columns) + " columns");
    }
    if (rows.empty()) throw failure("data/" + std::string(path) + ": not built in, or empty");
    return rows;
}

// The illuminant's power at a wavelength between two of its samples, or at one.
double power_at(const std::vector<row>& rows, double nm, std::string_view path) {
    const auto above =
        std::lower_bound(rows.begin(), rows.end(), nm, [](const row& r, double x) { return r[0] < x; });
    if (above == rows.end() || (above == rows.begin() && nm < above->at(0)))
        throw failure("data/" + std::string(path) + ": does not reach " + std::to_string(nm) + " nm");
    if (above == rows.begin()) return above->at(1);
    const row &hi = *above, &lo = *(above - 1);
    return lo[1] + (hi[1] - lo[1]) * (nm - lo[0]) / (hi[0] - lo[0]);
}

observer read_observer(const std::vector<row>& bars, std::string_view illuminant) {
    observer eye;
    const std::vector<row> power = read_rows(illuminant, 2);
    for (const row& r : bars) {
        eye.wavelength_nm.push_back(r[0]);
        eye.bars.push_back({r[1], r[2], r[3]});
        eye.power.push_back(power_at(power, r[0], illuminant));
    }
    return eye;
}

constexpr std::array<std::string_view, 5> titles = {"linear sRGB", "linear Display P3", "linear Rec.2020",
                                                    "linear ACEScg", "XYZ with Y = 1 for white"};

std::array<recipe, 5> make_recipes() {
    const std::vector<row> bars = read_rows("cie/cie1931_2deg_1nm.csv", 4);
    const observer by_d65 = read_observer(bars, "cie/d65.csv");
    const observer by_d60 = read_observer(bars, "cie/aces_d60.csv");
    const auto make = [&](color_space space) {
        const bool aces = space == color_space::acescg;
        return make_recipe(space, aces ? by_d60 : by_d65, aces ? std::optional(aces_white) : std::nullopt,
                           std::string("CIE 1931 2°, 360–830 nm at 1 nm, ") +
                               (aces ? "ACES white (D60), Bradford to AP1, " : "D65 without adaptation, ") +
                               std::string(titles[static_cast<std::size_t>(space)]));
    };
    return {make(color_space::srgb), make(color_space::p3), make(color_space::rec2020),
            make(color_space::acescg), make(color_space::xyz)};
}

} // namespace

const recipe& default_recipe(color_space space) {
    static const std::array<recipe, 5> recipes = make_recipes();
    return recipes[static_cast<std::size_t>(space)];
}

rgb white_of(color_space space) {
    return space == color_space::xyz ? default_recipe(space).white : rgb{1, 1, 1};
}

std::string recipe_text(color_space space, gamut policy) {
    return default_recipe(space).text + ", gamut " + std::string(to_string(policy));
}

double delta_e_2000(const rgb& p, const rgb& q, color_space space) {
    const recipe& how = default_recipe(space);
    return delta_e_2000(to_lab(how.to_xyz * p, how.white), to_lab(how.to_xyz * q, how.white));
}

rgb to_srgb(const rgb& color, color_space space) {
    return space == color_space::srgb
               ? color
               : convert(color, default_recipe(space), default_recipe(color_space::srgb));
}

rgb from_srgb(const rgb& linear, color_space space) {
    return space == color_space::srgb
               ? linear
               : convert(linear, default_recipe(color_space::srgb), default_recipe(space));
}

screen_color to_screen(const rgb& color, color_space space) { return to_screen(to_srgb(color, space)); }

} // namespace fresnel
