#include "emit/lut.hpp"

#include "analysis/curve.hpp"
#include "error.hpp"

#include <fmt/format.h>
#include <half.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace fresnel::emit {

namespace {

// Where cosines are closer to the critical one than this, the error is that of a float, not of the table.
constexpr double critical_neighbourhood = 0x1p-20;

// ---- maps and formats -------------------------------------------------------------------------------------

constexpr double right_angle = std::numbers::pi / 2;

constexpr std::array maps = {
    lut_map{"cos", "cos θ", [](float c) { return c; }, [](double t) { return t; }, true},
    lut_map{"sqrt-cos", "√cos θ", [](float c) { return std::sqrt(c); }, [](double t) { return t * t; }, true},
    lut_map{"angle", "θ", [](float c) { return static_cast<float>(1 - std::acos(double(c)) / right_angle); },
            [](double t) { return t == 0 ? 0.0 : std::cos((1 - t) * right_angle); }, false},
    lut_map{"sine", "sin θ",
            [](float c) { return static_cast<float>(1 - std::sqrt((1 - double(c)) * (1 + double(c)))); },
            [](double t) { return std::sqrt(t * (2 - t)); }, false},
};

constexpr std::array<std::string_view, 5> format_names = {"r8", "r16", "r16f", "rgba32f", "c"};

// The largest integer of a format that stores fractions of it; 0 for floats.
int steps_of(texel_format format) {
    return format == texel_format::r8 ? 255 : format == texel_format::r16 ? 65535 : 0;
}

// A value as the format gives it back.
float stored(double value, const lut& table) {
    if (table.format == texel_format::r16f) return Imath::half(static_cast<float>(value));
    const int steps = steps_of(table.format);
    if (steps == 0) return static_cast<float>(value);
    const double fraction = std::clamp((value - table.lo) / (table.hi - table.lo), 0.0, 1.0);
    return static_cast<float>(static_cast<double>(std::lround(fraction * steps)) / steps);
}

// Fractions stand for [0, 1], or for a little more where a colour leaves it.
void choose_range(lut& table, const std::vector<rgb>& values) {
    if (steps_of(table.format) == 0) return;
    double lo = 0, hi = 1;
    for (const rgb& v : values)
        for (std::size_t c = 0; c < table.channels(); ++c)
            lo = std::min(lo, v[c]), hi = std::max(hi, v[c]);
    if (lo < -1e-6) table.lo = std::floor(lo * 1000) / 1000;
    if (hi > 1 + 1e-6) table.hi = std::ceil(hi * 1000) / 1000;
}

// ---- positions --------------------------------------------------------------------------------------------

// A share of the way, 0 for the first of count and 1 for the last.
double place(std::size_t i, std::size_t count) {
    return count < 2 ? 0 : static_cast<double>(i) / static_cast<double>(count - 1);
}

std::vector<double> texel_cosines(const lut& table) {
    std::vector<double> cosines;
    const double from = table.subject.critical;
    for (std::size_t i = 0; i < table.columns; ++i)
        cosines.push_back(from + (1 - from) * table.map->cosine(place(i, table.columns)));
    cosines.back() = 1;
    if (from > 0) cosines.front() = from - 1e-12; // where rounding leaves nothing below 1
    return cosines;
}

double along(const std::optional<lut_axis>& by, double share) {
    return by ? by->lo + (by->hi - by->lo) * share : 0;
}

// ---- reading, as the sampler does ---------------------------------------------------------------------------

float limited(float x) { return std::min(std::max(x, 0.0f), 1.0f); }

/// A place between two texels of an axis.
struct between {
    std::size_t first, second;
    float weight; ///< of the second
};

// The filter of a texture at the coordinate (t (N - 1) + 0.5) / N.
between filtered(float t, std::size_t count, filter_weights weights) {
    const auto n = static_cast<float>(count);
    const float u = (t * (n - 1) + 0.5f) / n;
    float x = u * n - 0.5f;
    if (weights == filter_weights::eight_bits) x = std::round(x * 256) / 256;
    const float below = std::floor(x);
    const auto i = static_cast<std::ptrdiff_t>(below), last = static_cast<std::ptrdiff_t>(count) - 1;
    return {static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i, 0, last)),
            static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(i + 1, 0, last)), x - below};
}

// An array's, without the detour.
between indexed(float t, std::size_t count) {
    const float x = t * static_cast<float>(count - 1);
    const auto i = static_cast<std::size_t>(std::min(x, static_cast<float>(count - 2)));
    return {i, i + 1, x - static_cast<float>(i)};
}

float mixed(float a, float b, float weight) { return (1 - weight) * a + weight * b; }

// ---- errors -------------------------------------------------------------------------------------------------

double largest_difference(const std::array<float, 3>& read, const rgb& exact, std::size_t channels) {
    double most = 0;
    for (std::size_t c = 0; c < channels; ++c)
        most = std::max(most, std::abs(double(read[c]) - exact[c]));
    return most;
}

/// Errors of many places, gathered.
struct error_sum {
    lut_error error;
    double squares = 0;
    std::size_t count = 0;

    void add(const lut& table, const lut_reference& exact, float by) {
        for (std::size_t i = 0; i < exact.cos_i.size(); ++i) {
            const float c = exact.cos_i[i];
            const std::array<float, 3> read = sample(table, c, by);
            const double off = largest_difference(read, exact.value[i], table.channels());
            if (off > error.max) error.max = off, error.cos_i = double(c), error.by = double(by);
            const std::array<float, 3> coarse = sample(table, c, by, filter_weights::eight_bits);
            error.max_8_bit =
                std::max(error.max_8_bit, largest_difference(coarse, exact.value[i], table.channels()));
            if (i >= exact.angles) continue;
            for (std::size_t k = 0; k < table.channels(); ++k)
                squares += std::pow(double(read[k]) - exact.value[i][k], 2), ++count;
        }
    }
    lut_error result() const {
        lut_error all = error;
        all.rms = std::sqrt(squares / static_cast<double>(std::max<std::size_t>(count, 1)));
        return all;
    }
};

// The error at the floats on both sides of the critical cosine.
double critical_error(const lut& table) {
    const auto critical = static_cast<float>(table.subject.critical);
    if (critical == 0) return 0;
    std::vector<double> cosines;
    float below = critical, above = critical;
    for (int i = 0; i < 16; ++i) {
        cosines.insert(cosines.end(), {double(below), double(above)});
        below = std::nextafter(below, 0.0f), above = std::nextafter(above, 1.0f);
    }
    const std::vector<rgb> exact = table.subject.reflectance(cosines, 0);
    double most = 0;
    for (std::size_t i = 0; i < cosines.size(); ++i)
        most = std::max(most, largest_difference(sample(table, static_cast<float>(cosines[i])), exact[i],
                                                 table.channels()));
    return most;
}

lut_error error_over_rows(const lut& table) {
    constexpr std::size_t steps = 8; // of each row's distance to the next
    error_sum sum;
    const std::size_t count = steps * (table.rows - 1) + 1;
    for (std::size_t i = 0; i < count; ++i) {
        const auto by = static_cast<float>(along(table.subject.by, place(i, count)));
        sum.add(table, make_reference(table.subject, table.columns, double(by)), by);
    }
    return sum.result();
}

// ---- requests -----------------------------------------------------------------------------------------------

void check_size(const lut_subject& subject, const lut_request& wanted) {
    const std::size_t most = subject.by ? most_columns_2d : most_columns;
    const auto check = [&](std::size_t count, std::string_view what) {
        if (count < least_texels || count > most)
            throw bad_input(fmt::format("--size {}: {} must be in [{}, {}]{}", count, what, least_texels,
                                        most, subject.by ? " for a table with --by" : ""));
    };
    check(wanted.columns, "the number of texels");
    if (subject.by) check(wanted.rows, "the number of rows");
}

// Why a critical angle needs a map of its own, with the number that shows it.
void refuse_cosine(const lut_subject& subject, const lut_request& wanted) {
    lut_subject plain = subject;
    plain.critical = 0;
    const lut table = unmeasured(plain, find_lut_map("cos"), wanted);
    const double error = error_of(table).max;
    throw bad_input(fmt::format(
        "--map cos: {} has a critical angle at {:.2f} degrees, where reflectance ends like a square root: {} "
        "texels even in cos_i err by {:.2g}, and four times as many halve that; sqrt-cos counts from there",
        subject.name, degrees_of_cosine(subject.critical), wanted.columns, error));
}

std::vector<const lut_map*> candidates(const lut_subject& subject, const lut_request& wanted) {
    const lut_map& root = find_lut_map("sqrt-cos");
    if (wanted.map) {
        const lut_map& chosen = find_lut_map(*wanted.map);
        if (subject.critical > 0 && &chosen != &root) refuse_cosine(subject, wanted);
        return {&chosen};
    }
    if (subject.critical > 0) return {&root};
    return {&find_lut_map("cos"), &root};
}

template <class Measure>
lut best_of(const lut_subject& subject, const lut_request& wanted, const Measure& measure) {
    std::optional<lut> best;
    for (const lut_map* map : candidates(subject, wanted)) {
        lut table = unmeasured(subject, *map, wanted);
        table.error = measure(table);
        if (!best || table.error.max < best->error.max) best = std::move(table);
    }
    return *best;
}

} // namespace

std::span<const lut_map> lut_maps() { return maps; }

const lut_map& find_lut_map(std::string_view name) {
    for (const lut_map& map : maps)
        if (map.offered && map.name == name) return map;
    throw bad_input(fmt::format("--map '{}': must be cos, sqrt-cos or auto", name));
}

std::string_view to_string(texel_format format) { return format_names[static_cast<std::size_t>(format)]; }

texel_format find_texel_format(std::string_view name) {
    for (std::size_t i = 0; i < format_names.size(); ++i)
        if (format_names[i] == name) return static_cast<texel_format>(i);
    throw bad_input(fmt::format("--format '{}': must be r8, r16, r16f, rgba32f or c", name));
}

lut unmeasured(const lut_subject& subject, const lut_map& map, const lut_request& wanted) {
    lut table{subject, &map, wanted.columns, subject.by ? wanted.rows : 1, wanted.format};
    const std::vector<double> cosines = texel_cosines(table);
    std::vector<rgb> values;
    for (std::size_t row = 0; row < table.rows; ++row) {
        const double by = along(subject.by, place(row, table.rows));
        const std::vector<rgb> line = subject.reflectance(cosines, by);
        values.insert(values.end(), line.begin(), line.end());
    }
    choose_range(table, values);
    for (const rgb& v : values)
        for (std::size_t c = 0; c < table.channels(); ++c)
            table.texels.push_back(stored(v[c], table));
    return table;
}

std::array<float, 3> sample(const lut& table, float cos_i, float by, filter_weights weights) {
    const auto critical = static_cast<float>(table.subject.critical);
    const bool array = table.format == texel_format::c;
    const auto locate = [&](float t, std::size_t count) {
        return array ? indexed(t, count) : filtered(t, count, weights);
    };
    const float c = critical > 0 ? limited((cos_i - critical) / (1 - critical)) : limited(cos_i);
    const between x = locate(table.map->coordinate(c), table.columns);
    between y{0, 0, 0};
    if (table.subject.by) {
        const auto lo = static_cast<float>(table.subject.by->lo),
                   hi = static_cast<float>(table.subject.by->hi);
        y = locate(limited((by - lo) / (hi - lo)), table.rows);
    }
    std::array<float, 3> result{};
    const auto texel = [&](std::size_t column, std::size_t row, std::size_t channel) {
        return table.texels[(row * table.columns + column) * table.channels() + channel];
    };
    for (std::size_t k = 0; k < table.channels(); ++k) {
        float value = mixed(texel(x.first, y.first, k), texel(x.second, y.first, k), x.weight);
        if (table.rows > 1)
            value = mixed(value, mixed(texel(x.first, y.second, k), texel(x.second, y.second, k), x.weight),
                          y.weight);
        const auto lo = static_cast<float>(table.lo), span = static_cast<float>(table.hi - table.lo);
        result[k] = table.scaled() ? value * span + lo : value;
    }
    return result;
}

lut_reference make_reference(const lut_subject& subject, std::size_t columns, double by) {
    const std::size_t count =
        subject.by ? std::max<std::size_t>(256, 6 * columns) : std::max<std::size_t>(4096, 8 * columns);
    const double critical = subject.critical;
    lut_reference exact{};
    const auto add = [&](double c) {
        const auto nearest = static_cast<float>(c);
        if (critical > 0 && std::abs(double(nearest) - critical) < critical_neighbourhood) return;
        exact.cos_i.push_back(nearest);
    };
    for (std::size_t i = 0; i <= count; ++i)
        add(cosine_of_degrees(90 * place(i, count + 1)));
    exact.angles = exact.cos_i.size();
    for (std::size_t i = 0; i <= count; ++i) {
        const double t = place(i, count + 1);
        add(t), add(critical + (1 - critical) * t * t);
    }
    exact.value = subject.reflectance({exact.cos_i.begin(), exact.cos_i.end()}, by);
    return exact;
}

lut_error error_of(const lut& table, const lut_reference& exact) {
    error_sum sum;
    sum.add(table, exact, 0);
    lut_error error = sum.result();
    error.at_critical = critical_error(table);
    return error;
}

lut_error error_of(const lut& table) {
    if (table.subject.by) return error_over_rows(table);
    return error_of(table, make_reference(table.subject, table.columns));
}

lut bake(const lut_subject& subject, const lut_request& wanted, const lut_reference& exact) {
    check_size(subject, wanted);
    return best_of(subject, wanted, [&](const lut& table) { return error_of(table, exact); });
}

lut bake(const lut_subject& subject, const lut_request& wanted) {
    check_size(subject, wanted);
    if (!subject.by) return bake(subject, wanted, make_reference(subject, wanted.columns));
    return best_of(subject, wanted, [](const lut& table) { return error_of(table); });
}

} // namespace fresnel::emit
