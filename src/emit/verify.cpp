#include "emit/verify.hpp"

#include "emit/library.hpp"
#include "error.hpp"
#include "figure/figure.hpp"
#include "files.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>
#include <set>

namespace fresnel::emit {

namespace {

static_assert(std::endian::native == std::endian::little, "the dump is little-endian, as this machine is");

// ---- cases ------------------------------------------------------------------------------------------------

bool calls_transcendental(const function& f) {
    return needs_any(f, [](const expression& x) {
        return x.op == operation::exponential2 || x.op == operation::logarithm2 ||
               x.op == operation::logarithm || x.op == operation::power;
    });
}

// A value for a parameter that shows: no default that the graph folds away, but for the ambient.
float constant_for(const parameter& p) {
    if (p.name == "k_t" || p.name == "k") return 3.0f;
    if (p.name == "a") return 0.5f;
    if (p.name == "bias") return 0.1f;
    if (p.name == "scale" || p.name == "f90") return 0.9f;
    if (p.name == "tint") return 0.7f;
    return static_cast<float>(p.default_value);
}

std::vector<argument> with_directions(std::vector<argument> arguments) {
    arguments.pop_back(); // cos_i
    arguments.push_back({"normal", 3, "unit"});
    arguments.push_back({"direction", 3, "unit"});
    return arguments;
}

void add_model(std::string_view model, std::vector<verify_case>& cases) {
    const model_row<float>& row = find_model<float>(model);
    const std::string name(model);
    const function scalar = record(model);
    const bool hard = calls_transcendental(scalar);
    cases.push_back({name, name, overload::scalar, scalar.arguments, {}, 1, hard});
    const auto directed = with_directions(scalar.arguments);
    cases.push_back({name + "_directions", name, overload::directions, directed, {}, 1, hard});
    if (row.kind == model_kind::exact)
        cases.push_back({name + "_boundary", name, overload::boundary, scalar.arguments, {}, 4, hard});
    if (row.parameters.empty()) return;

    const function rgb = record(model, {3, false, {}});
    cases.push_back({name + "_rgb", name, overload::rgb, rgb.arguments, {}, 3, hard});
    const auto rgb_directed = with_directions(rgb.arguments);
    cases.push_back({name + "_rgb_directions", name, overload::rgb_directions, rgb_directed, {}, 3, hard});
    request all_fixed;
    for (const parameter& p : row.parameters) {
        const auto x = static_cast<double>(constant_for(p));
        all_fixed.fixed[std::string(p.name)] = {x, x, x};
    }
    const function fixed = record(model, all_fixed);
    cases.push_back({name + "_fixed", name, overload::fixed, fixed.arguments, all_fixed.fixed, 1,
                     calls_transcendental(fixed)});
}

} // namespace

std::string_view to_string(overload kind) {
    switch (kind) {
    case overload::scalar:
        return "scalar";
    case overload::rgb:
        return "rgb";
    case overload::directions:
        return "directions";
    case overload::rgb_directions:
        return "rgb_directions";
    case overload::boundary:
        return "boundary";
    case overload::fixed:
        return "fixed";
    default:
        return "geometry";
    }
}

int verify_case::columns() const {
    int sum = 0;
    for (const argument& a : arguments)
        sum += a.width;
    return sum;
}

std::vector<verify_case> verify_cases(std::span<const std::string> models) {
    std::vector<verify_case> cases;
    for (const std::string& model : models)
        add_model(model, cases);
    if (!models.empty()) return cases;
    for (const model_row<float>& row : model_table<float>())
        add_model(row.name, cases);
    for (const function& f : record_geometry())
        cases.push_back(
            {f.name, f.name, overload::geometry, f.arguments, {}, f.width(), calls_transcendental(f)});
    return cases;
}

std::size_t default_rows(const verify_case& c) {
    return c.kind == overload::scalar ? scalar_rows : other_rows;
}

// ---- text -------------------------------------------------------------------------------------------------

std::string verify_text(const language& l, std::span<const verify_case> cases, const style& how) {
    std::vector<model_request> models;
    for (const verify_case& c : cases)
        if (c.kind != overload::geometry) models.push_back({c.name, c.fixed});
    std::string text = preamble(l, "fresnel shader --verify", models, how);
    std::set<std::string> printed = {"incidence_cosine"}; // which the preamble has
    for (const verify_case& c : cases) {
        const std::string own = c.kind == overload::fixed ? c.id : c.name;
        if (!printed.insert(own).second) continue;
        if (c.kind != overload::geometry) {
            text += "\n" + model_text(l, {c.name, c.fixed, own}, how);
            continue;
        }
        for (const function& f : record_geometry())
            if (f.name == c.name) text += "\n" + print(l, f, how);
    }
    return text;
}

std::string verify_call(const language& l, const verify_case& c, std::string (*column)(int k)) {
    std::vector<std::string> arguments;
    int k = 0;
    for (const argument& a : c.arguments) {
        const bool direction = c.kind == overload::geometry || a.name == "normal" || a.name == "direction";
        arguments.push_back(
            a.width == 1 ? column(k) : triple_of(l, {column(k), column(k + 1), column(k + 2)}, direction));
        k += a.width;
    }
    const bool directions = c.kind == overload::directions || c.kind == overload::rgb_directions;
    const bool own_name = c.kind == overload::boundary || c.kind == overload::fixed;
    std::string name = own_name ? legal_name(l, c.id)
                       : c.kind == overload::geometry
                           ? legal_name(l, c.name)
                           : printed_name(l, c.name, c.results == 3 ? 3 : 1, directions);
    return call(name, arguments);
}

// ---- comparison -------------------------------------------------------------------------------------------

namespace {

// Floats in the order of their values as integers in the same order.
std::int64_t place_of(float x) {
    const auto bits = std::bit_cast<std::int32_t>(x);
    return bits < 0 ? -static_cast<std::int64_t>(bits & 0x7fffffff) : bits;
}

struct distance {
    double value;
    std::uint32_t ulp;
};

distance between(float a, float b) {
    if (std::isnan(a) != std::isnan(b)) return {std::numeric_limits<double>::infinity(), 0xffffffff};
    if (std::isnan(a)) return {0, 0};
    const std::int64_t steps = std::abs(place_of(a) - place_of(b));
    const double value = a == b ? 0 : std::abs(static_cast<double>(a) - static_cast<double>(b));
    return {value, static_cast<std::uint32_t>(std::min<std::int64_t>(steps, 0xffffffff))};
}

bool same_bits(float a, float b) {
    return (std::isnan(a) && std::isnan(b)) ||
           std::bit_cast<std::uint32_t>(a) == std::bit_cast<std::uint32_t>(b);
}

std::vector<float> row_of(std::span<const float> all, std::size_t row, std::size_t width) {
    const auto part = all.subspan(row * width, width);
    return {part.begin(), part.end()};
}

} // namespace

difference compare_bits(const verify_case& c, const verify_data& data, std::span<const float> values) {
    if (values.size() != data.expected.size())
        throw failure(
            fmt::format("{}: gave {} values; must be {}", c.id, values.size(), data.expected.size()));
    difference found;
    const auto results = static_cast<std::size_t>(c.results);
    for (std::size_t row = 0; row < data.rows; ++row) {
        bool same = true;
        distance worst{0, 0};
        for (std::size_t i = row * results; i < (row + 1) * results; ++i) {
            if (same_bits(data.expected[i], values[i])) continue;
            same = false;
            const distance d = between(data.expected[i], values[i]);
            worst = {std::max(worst.value, d.value), std::max(worst.ulp, d.ulp)};
        }
        const bool open = data.open[row] != 0;
        ++(open ? found.open_rows : found.rows);
        if (same) continue;
        ++(open ? found.open_differing : found.differing);
        if (open) continue;
        found.max_ulp = std::max(found.max_ulp, worst.ulp);
        if (found.differing > 1 && worst.value <= found.max_difference) continue;
        found.max_difference = worst.value;
        found.inputs = row_of(data.inputs, row, static_cast<std::size_t>(c.columns()));
        found.expected = row_of(data.expected, row, results);
        found.got = row_of(values, row, results);
    }
    return found;
}

double allowed_difference(const verify_case& c, bool rearranged) {
    if (c.name == "conductor_precise" && rearranged) return std::numeric_limits<double>::infinity();
    if (c.name == "incidence_cosine" || c.name == "reflected_direction") return 5e-7;
    const bool factors = c.kind == overload::fixed || c.name == "gulbrandsen" || c.name == "f82_tint";
    if (!c.transcendental) return rearranged && factors ? 1e-6 : 0.0;
    if (c.kind == overload::fixed || c.name == "spherical_gaussian") return 1e-6;
    // pow(x, y) is off by about 2e-7 y, a factor beside it as much more
    if (c.name == "schlick_power" || c.name == "hoffman") return 2e-4;
    if (c.name == "lazanyi") return 2e-4;
    return 1e-3;
}

bool verify_result::passed() const {
    return found.rows > 0 && (allowed == 0 ? found.differing == 0 : found.max_difference <= allowed);
}

// ---- dump -------------------------------------------------------------------------------------------------

namespace {

std::string bytes_of(std::span<const float> values) {
    std::string bytes(values.size_bytes(), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    return bytes;
}

std::vector<float> read_floats(const std::filesystem::path& path) {
    const auto bytes = file_content(path);
    if (!bytes) throw bad_input(fmt::format("{}: cannot be read", path.string()));
    std::vector<float> values(bytes->size() / sizeof(float));
    std::memcpy(values.data(), bytes->data(), values.size() * sizeof(float));
    return values;
}

std::string indexed_x(int k) { return fmt::format("x[{}]", k); }

nlohmann::json described(const verify_case& c, std::size_t rows) {
    nlohmann::json arguments = nlohmann::json::array();
    for (const argument& a : c.arguments)
        arguments.push_back({{"name", a.name}, {"width", a.width}});
    return {{"id", c.id},
            {"name", c.name},
            {"kind", to_string(c.kind)},
            {"arguments", arguments},
            {"columns", c.columns()},
            {"results", c.results},
            {"rows", rows},
            {"transcendental", c.transcendental},
            {"inputs", c.id + ".in.f32"},
            {"expected", c.id + ".expected.f32"}};
}

} // namespace

void dump_cases(const std::filesystem::path& folder, std::span<const verify_case> cases,
                std::span<const std::string> wanted, std::size_t rows) {
    std::filesystem::create_directories(folder);
    std::vector<std::string> chosen(wanted.begin(), wanted.end());
    if (chosen.empty())
        for (const language& l : languages())
            chosen.emplace_back(l.id);
    nlohmann::json all = nlohmann::json::array();
    for (const verify_case& c : cases) {
        const verify_data data = make_data(c, rows == 0 ? default_rows(c) : rows);
        nlohmann::json one = described(c, data.rows);
        write_file((folder / (c.id + ".in.f32")).string(), bytes_of(data.inputs));
        write_file((folder / (c.id + ".expected.f32")).string(), bytes_of(data.expected));
        for (const std::string& id : chosen) {
            const language& l = find_language(id);
            const std::string file = fmt::format("{}.{}", c.id, l.extension);
            write_file((folder / file).string(), verify_text(l, {&c, 1}));
            one["text"][id] = file;
            one["call"][id] = verify_call(l, c, indexed_x);
        }
        all.push_back(one);
    }
    write_file((folder / "cases.json").string(), all.dump(1) + "\n");
}

std::vector<verify_result> check_dump(const std::filesystem::path& folder, std::span<const verify_case> cases,
                                      bool rearranged) {
    std::vector<std::filesystem::path> files;
    if (is_folder(folder))
        for (const auto& entry : std::filesystem::directory_iterator(folder))
            if (entry.path().string().ends_with(".out.f32")) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    std::vector<verify_result> all;
    for (const verify_case& c : cases)
        for (const auto& file : files) {
            const std::string name = file.filename().string(); // ID.RECEIVER.out.f32
            if (!name.starts_with(c.id + ".") || name.size() <= c.id.size() + 9) continue;
            const std::string receiver = name.substr(c.id.size() + 1, name.size() - c.id.size() - 9);
            const verify_data data = assess(c, read_floats(folder / (c.id + ".in.f32")));
            all.push_back(
                {c, receiver, compare_bits(c, data, read_floats(file)), allowed_difference(c, rearranged)});
        }
    if (all.empty())
        throw bad_input(fmt::format("--compare {}: holds no ID.RECEIVER.out.f32 of a case", folder.string()));
    return all;
}

} // namespace fresnel::emit
