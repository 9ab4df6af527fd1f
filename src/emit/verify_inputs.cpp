#include "emit/verify_values.hpp"

#include "error.hpp"

#include <fresnel/geometry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <bit>
#include <cmath>
#include <random>

namespace fresnel::emit {

namespace {

// ---- what inputs are made of ------------------------------------------------------------------------------

constexpr float infinity = std::numeric_limits<float>::infinity();
constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

/// The range that values of one column are drawn from.
struct range {
    float min, max;
    std::vector<float> edges;
};

range range_of(const parameter& p) {
    range r{static_cast<float>(p.min), static_cast<float>(p.max), {}};
    const float usual = static_cast<float>(p.default_value);
    for (const float x :
         {r.min, r.max, usual, 0.0f, 0x1p-60f, 0x1p-24f, 1e-4f, 0.04f, 0.5f, 1 - 1e-4f, 1 - 0x1p-24f, 1.0f,
          1 + 0x1p-23f, 1 + 1e-4f, 1.5f, 2.0f, 3.0f, std::nextafter(r.max, 0.0f)})
        if (x >= r.min && x <= r.max && std::find(r.edges.begin(), r.edges.end(), x) == r.edges.end())
            r.edges.push_back(x);
    return r;
}

range range_of(const verify_case& c, std::string_view name) {
    if (name == cosine.name) return range_of(cosine);
    if (c.kind == overload::geometry) {
        if (name == "eta") return range_of({"eta", "1", 0.01, 100, 1.5});
        if (name == "f0") return range_of({"f0", "1", 0, 1, 0.04});
        throw failure(fmt::format("{}: no range is known of its argument {}", c.name, name));
    }
    for (const parameter& p : find_model<float>(c.name).parameters)
        if (p.name == name) return range_of(p);
    throw failure(fmt::format("{}: has no parameter {}", c.name, name));
}

bool is_direction(const verify_case& c, const argument& a) {
    if (a.width != 3) return false;
    return c.kind == overload::geometry || a.name == "normal" || a.name == "direction";
}

/// Random numbers that are the same on every machine: bits of the generator, no distribution of the library.
class source {
public:
    explicit source(std::string_view seed) {
        std::uint32_t hash = 2166136261u; // FNV-1a
        for (const char c : seed)
            hash = (hash ^ static_cast<unsigned char>(c)) * 16777619u;
        engine_.seed(hash);
    }
    std::uint32_t below(std::uint32_t n) { return static_cast<std::uint32_t>(engine_() % n); }
    float uniform(float lo, float hi) {
        return lo + (hi - lo) * (static_cast<float>(engine_() >> 8) * 0x1p-24f);
    }
    // Every power of two down to 2^-24 of the largest is as likely.
    float any_magnitude(float lo, float hi) {
        const int octave = static_cast<int>(below(25));
        const float x = std::ldexp(uniform(0.5f, 1.0f) * std::max(hi, -lo), -octave);
        return std::clamp(lo < 0 && below(2) == 0 ? -x : x, lo, hi);
    }
    float value(const range& r) {
        switch (below(8)) {
        case 0:
            return r.edges[below(static_cast<std::uint32_t>(r.edges.size()))];
        case 1:
            return std::clamp(1 + std::ldexp(uniform(-1, 1), -static_cast<int>(below(23))), r.min, r.max);
        case 2:
        case 3:
        case 4:
            return any_magnitude(r.min, r.max);
        default:
            return uniform(std::max(r.min, -4.0f), std::min(r.max, 4.0f));
        }
    }
    // Along an axis, either way.
    vector3<float> axis() {
        std::array<float, 3> v{};
        v[below(3)] = below(2) == 0 ? 1.0f : -1.0f;
        return {v[0], v[1], v[2]};
    }
    // A unit vector, one in eight along an axis.
    vector3<float> direction() {
        if (below(8) == 0) return axis();
        vector3<float> v{};
        float length2 = 0;
        do {
            v = {uniform(-1, 1), uniform(-1, 1), uniform(-1, 1)};
            length2 = dot(v, v);
        } while (length2 < 0.01f || length2 > 1);
        return 1 / std::sqrt(length2) * v;
    }

private:
    std::mt19937 engine_;
};

/// Rows of inputs of one case, one after another.
class generator {
public:
    generator(const verify_case& c, std::size_t rows) : case_(c), random_(c.id), edge_rows_(1) {
        for (const argument& a : c.arguments) {
            ranges_.push_back(is_direction(c, a) ? range{} : range_of(c, a.name));
            const std::size_t edges = std::max<std::size_t>(ranges_.back().edges.size(), 1);
            for (int i = 0; i < a.width && edge_rows_ <= rows; ++i)
                edge_rows_ *= edges;
        }
        every_edge_ = edge_rows_ <= rows / 2;
        edge_rows_ = std::min(edge_rows_, rows / 4);
    }

    // Row k: edges first, then whatever comes.
    std::vector<float> next() {
        const std::size_t k = row_++;
        std::vector<float> x;
        if (every_edge_ ? k < whole_edges() : k < edge_rows_)
            edges(k, x);
        else
            anything(x);
        return x;
    }

private:
    std::size_t whole_edges() const {
        std::size_t n = 1;
        for (std::size_t a = 0; a < ranges_.size(); ++a)
            for (int i = 0; i < case_.arguments[a].width; ++i)
                n *= std::max<std::size_t>(ranges_[a].edges.size(), 1);
        return n;
    }

    void push(std::vector<float>& x, const vector3<float>& v) { x.insert(x.end(), {v.x, v.y, v.z}); }

    // The normal of a model's overload lies along an axis: then a dot product is exact, in whatever order it is summed,
    // which languages leave open. incidence_cosine and reflected_direction are cases of their own, with any directions.
    vector3<float> direction(std::size_t argument) {
        const bool own = case_.kind == overload::geometry && case_.name != "refracted_direction";
        const bool exact = !own && case_.arguments[argument].name == "normal";
        return exact ? random_.axis() : random_.direction();
    }

    void edges(std::size_t k, std::vector<float>& x) {
        for (std::size_t a = 0; a < ranges_.size(); ++a) {
            if (ranges_[a].edges.empty()) {
                push(x, direction(a));
                continue;
            }
            for (int i = 0; i < case_.arguments[a].width; ++i) {
                const auto n = static_cast<std::uint32_t>(ranges_[a].edges.size());
                x.push_back(ranges_[a].edges[every_edge_ ? k % n : random_.below(n)]);
                k /= n;
            }
        }
    }

    void anything(std::vector<float>& x) {
        for (std::size_t a = 0; a < ranges_.size(); ++a) {
            if (ranges_[a].edges.empty()) {
                push(x, direction(a));
                continue;
            }
            for (int i = 0; i < case_.arguments[a].width; ++i)
                x.push_back(random_.value(ranges_[a]));
        }
        switch (random_.below(16)) {
        case 0:
            x[random_.below(static_cast<std::uint32_t>(x.size()))] =
                random_.below(2) == 0 ? infinity : not_a_number;
            break;
        case 1:
        case 2:
            turn_to(x, critical_cosine(eta_of(x)));
            break;
        case 3:
            turn_to(x, brewster_cosine(eta_of(x)));
            break;
        default:
            break;
        }
    }

    float argument_of(const std::vector<float>& x, std::string_view name, float otherwise) const {
        std::size_t column = 0;
        for (const argument& a : case_.arguments) {
            if (a.name == name) return x[column];
            column += static_cast<std::size_t>(a.width);
        }
        const auto found = case_.fixed.find(std::string(name));
        return found == case_.fixed.end() ? otherwise : static_cast<float>(found->second[0]);
    }

    float eta_of(const std::vector<float>& x) const {
        const float n = argument_of(x, "n_t", argument_of(x, "n", argument_of(x, "eta", 1.5f)));
        return n / argument_of(x, "n_i", 1.0f);
    }

    // That angle, or one up to eight floats away.
    void turn_to(std::vector<float>& x, float cosine_there) {
        if (case_.arguments.empty() || case_.arguments.back().name != cosine.name) return;
        if (!(cosine_there > 0 && cosine_there < 1)) return;
        const auto bits = std::bit_cast<std::uint32_t>(cosine_there) + random_.below(17);
        x.back() = std::min(std::bit_cast<float>(bits - 8), 1.0f);
    }

    const verify_case& case_;
    source random_;
    std::vector<range> ranges_; ///< of a direction without edges
    std::size_t edge_rows_;
    bool every_edge_ = false;
    std::size_t row_ = 0;
};

} // namespace

verify_data make_data(const verify_case& c, std::size_t rows) {
    verify_data data;
    data.rows = rows;
    generator inputs(c, rows);
    model_values model(c);
    std::vector<float> values(static_cast<std::size_t>(c.results));
    std::size_t tries = 0;
    while (data.open.size() < rows) {
        if (++tries > 8 * rows)
            throw failure(fmt::format("{}: nearly every input is subnormal on the way", c.id));
        const std::vector<float> x = inputs.next();
        const encounter met = model.evaluate(x.data(), values.data());
        if (met.subnormal) continue;
        data.inputs.insert(data.inputs.end(), x.begin(), x.end());
        data.expected.insert(data.expected.end(), values.begin(), values.end());
        data.open.push_back(met.open ? 1 : 0);
    }
    return data;
}

verify_data assess(const verify_case& c, std::vector<float> inputs) {
    const auto columns = static_cast<std::size_t>(c.columns()), results = static_cast<std::size_t>(c.results);
    if (inputs.empty() || inputs.size() % columns != 0)
        throw bad_input(fmt::format("{}: {} inputs; must be a multiple of {}", c.id, inputs.size(), columns));
    verify_data data;
    data.rows = inputs.size() / columns;
    data.expected.resize(data.rows * results);
    model_values model(c);
    for (std::size_t i = 0; i < data.rows; ++i)
        data.open.push_back(model.evaluate(&inputs[i * columns], &data.expected[i * results]).open ? 1 : 0);
    data.inputs = std::move(inputs);
    return data;
}

} // namespace fresnel::emit
