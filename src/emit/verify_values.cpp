#include "emit/verify_values.hpp"

#include "error.hpp"

#include <fresnel/geometry.hpp>

#include <fmt/format.h>

namespace fresnel::emit {

namespace {

bool in_domain_of_pow(float x, float y) {
    return std::isfinite(x) && std::isfinite(y) && (x > 0 || (x == 0 && y > 0));
}

/// A function's graph, evaluated node by node as C++ evaluates the model, to see what its results are made from. The
/// side of a choice that is not taken does not count.
class inspector {
public:
    explicit inspector(function f) : f_(std::move(f)), at_(f_.graph.size()) {
        const recording scope(f_.graph);
        for (const argument& a : f_.arguments)
            inputs_.push_back(f_.graph.input(a.name, a.width).node());
        const std::vector<bool> needed = needed_nodes(f_);
        for (std::uint32_t i = 0; i < f_.graph.size(); ++i)
            if (const operation op = f_.graph[i].op; needed[i] && op == operation::constant)
                step(i);
            else if (needed[i] && op != operation::input)
                steps_.push_back(i);
    }

    // x: the arguments in order.
    encounter inspect(const float* x) {
        for (std::size_t i = 0; i < inputs_.size(); ++i) {
            const int width = f_.arguments[i].width;
            state& node = at_[inputs_[i]] = {};
            for (std::size_t c = 0; c < 3; ++c)
                node.value[c] = width == 1 ? x[0] : x[c];
            for (int c = 0; c < width; ++c)
                node.met += *x++;
        }
        for (const std::uint32_t i : steps_)
            step(i);
        encounter all;
        for (const result& r : f_.results)
            all += at_[r.node].met;
        return all;
    }

private:
    struct state {
        std::array<float, 3> value{};
        encounter met;
    };

    void step(std::uint32_t node) {
        const expression& x = f_.graph[node];
        state& y = at_[node] = {};
        const bool choice = x.op == operation::choose;
        for (std::size_t k = 0; k < arity(x.op); ++k)
            if (!choice || k == 0) y.met += at_[x.operands[k]].met;
        for (std::size_t c = 0; c < (x.width == 3 ? 3u : 1u); ++c) {
            y.value[c] = value(x, c, y.met);
            y.met += y.value[c];
        }
        if (x.width == 1) y.value[1] = y.value[2] = y.value[0];
    }

    float value(const expression& x, std::size_t c, encounter& met) const {
        if (x.op == operation::constant) return x.value[c];
        const auto &a = at_[x.operands[0]].value, &b = at_[x.operands[1]].value;
        if (x.op == operation::choose) {
            const state& taken = at_[x.operands[a[c] != 0 ? 1 : 2]];
            met += taken.met;
            return taken.value[c];
        }
        if (x.op == operation::dot_product) {
            for (std::size_t i = 0; i < 3; ++i)
                met += a[i] * b[i];
            return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
        }
        if (x.op == operation::power && !in_domain_of_pow(a[c], b[c])) met.open = true;
        return fold(x.op, a[c], b[c]);
    }

    function f_;
    std::vector<std::uint32_t> inputs_, steps_; ///< nodes; constants are computed once
    std::vector<state> at_;
};

void geometry_values(std::string_view name, const float* x, float* y) {
    const auto vector = [](const float* v) { return vector3<float>{v[0], v[1], v[2]}; };
    const auto store = [y](vector3<float> v) { y[0] = v.x, y[1] = v.y, y[2] = v.z; };
    if (name == "incidence_cosine")
        y[0] = incidence_cosine(vector(x), vector(x + 3));
    else if (name == "reflected_direction")
        store(reflect(vector(x), vector(x + 3)));
    else if (name == "refracted_direction")
        store(refract(vector(x), vector(x + 3), x[6]));
    else if (name == "refracted_cosine")
        y[0] = refracted_cosine(x[0], x[1]);
    else if (name == "critical_cosine")
        y[0] = critical_cosine(x[0]);
    else if (name == "brewster_cosine")
        y[0] = brewster_cosine(x[0]);
    else if (name == "f0_from_eta")
        y[0] = f0_from_eta(x[0]);
    else if (name == "eta_from_f0")
        y[0] = eta_from_f0(x[0]);
    else
        throw failure(fmt::format("{}: there is nothing to compare it with", name));
}

const function& geometry_function(std::string_view name) {
    static const std::vector<function> all = record_geometry();
    for (const function& f : all)
        if (f.name == name) return f;
    throw failure(fmt::format("{}: is no function of ours", name));
}

} // namespace

class model_values::evaluator {
public:
    explicit evaluator(const verify_case& c) : case_(c), graph_(graph_of(c)) {
        if (c.kind != overload::geometry) row_ = &find_model<float>(c.name);
    }

    encounter evaluate(const float* x, float* y) {
        encounter met;
        if (row_ == nullptr) {
            geometry_values(case_.name, x, y);
            return graph_.inspect(x);
        }
        const float cos_i = angle(x, met);
        for (int channel = 0; channel < (case_.results == 3 ? 3 : 1); ++channel)
            one_channel(x, channel, cos_i, y, met);
        return met;
    }

private:
    static function graph_of(const verify_case& c) {
        if (c.kind == overload::geometry) return geometry_function(c.name);
        return record(c.name, {1, c.kind == overload::boundary, c.fixed});
    }

    float angle(const float* x, encounter& met) const {
        const float* end = x + case_.columns();
        if (case_.arguments.back().name == cosine.name) return end[-1];
        const vector3<float> normal{end[-6], end[-5], end[-4]}, direction{end[-3], end[-2], end[-1]};
        for (const float product : {normal.x * direction.x, normal.y * direction.y, normal.z * direction.z,
                                    normal.x * direction.x + normal.y * direction.y})
            met += product;
        const float cos_i = dot(normal, direction);
        met += cos_i;
        return incidence_cosine(normal, direction);
    }

    // Parameters of that channel: the arguments', in the order of the registry, or the fixed ones.
    void one_channel(const float* x, int channel, float cos_i, float* y, encounter& met) {
        all_.clear(), free_.clear();
        std::size_t next = 0;
        for (const parameter& p : row_->parameters) {
            const auto fixed = case_.fixed.find(std::string(p.name));
            if (fixed != case_.fixed.end()) {
                all_.push_back(static_cast<float>(fixed->second[static_cast<std::size_t>(channel)]));
                continue;
            }
            const int width = case_.arguments[next++].width;
            all_.push_back(width == 1 ? x[0] : x[channel]);
            free_.push_back(all_.back());
            x += width;
        }
        free_.push_back(cos_i);
        met += graph_.inspect(free_.data());
        const boundary<float> value = row_->evaluate(all_.data(), cos_i);
        if (case_.kind == overload::boundary)
            y[0] = value.R_s, y[1] = value.R_p, y[2] = value.T_s, y[3] = value.T_p;
        else
            y[channel] = value.reflectance();
    }

    const verify_case& case_;
    inspector graph_;
    const model_row<float>* row_ = nullptr;
    std::vector<float> all_, free_;
};

model_values::model_values(const verify_case& c) : own_(std::make_unique<evaluator>(c)) {}
model_values::~model_values() = default;
encounter model_values::evaluate(const float* x, float* y) { return own_->evaluate(x, y); }

} // namespace fresnel::emit
