#include "analysis/compare.hpp"

#include "analysis/cost_table.hpp"
#include "analysis/graph.hpp"
#include "analysis/pareto.hpp"

#include "materials/observer.hpp"

#include <fresnel/geometry.hpp>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <tuple>

namespace fresnel {

namespace {

// The integral of f 2 c dc over [0, 1] from samples against theta: trapezoids in c^2.
double cosine_integral(const std::vector<double>& cos_i, const std::vector<double>& f) {
    double sum = 0;
    for (std::size_t i = 1; i < f.size(); ++i)
        sum += (f[i] + f[i - 1]) / 2 * (square(cos_i[i - 1]) - square(cos_i[i]));
    return sum;
}

// Raises the maxima to those over one more curve.
void raise_maxima(curve_error& error, const std::vector<rgb>& model, const rgb_curve& exact) {
    for (std::size_t a = 0; a < model.size(); ++a) {
        for (std::size_t i = 0; i < 3; ++i) {
            const double difference = std::abs(model[a][i] - exact.value[a][i]);
            if (difference > error.max[i]) error.max[i] = difference, error.max_theta[i] = exact.theta_deg[a];
        }
        const double difference = delta_e_2000(exact.value[a], model[a], exact.space);
        if (difference > error.delta_e_max)
            error.delta_e_max = difference, error.delta_e_theta = exact.theta_deg[a];
    }
}

} // namespace

curve_error error_of(const std::vector<rgb>& model, const rgb_curve& exact) {
    curve_error error{};
    for (std::size_t i = 0; i < 3; ++i) {
        std::vector<double> difference;
        double squares = 0;
        for (std::size_t a = 0; a < model.size(); ++a) {
            difference.push_back(std::abs(model[a][i] - exact.value[a][i]));
            squares += square(difference.back());
        }
        error.rms[i] = std::sqrt(squares / static_cast<double>(model.size()));
        error.cosine[i] = cosine_integral(exact.cos_i, difference);
    }
    raise_maxima(error, model, exact);
    return error;
}

curve_error schlick_error(const material& substance, color_space space) {
    const rgb_curve exact = exact_curve(substance, space, 1);
    const rgb &f0 = exact.value.front(), white = white_of(space);
    std::vector<rgb> model(exact.cos_i.size());
    for (std::size_t a = 0; a < model.size(); ++a)
        for (std::size_t i = 0; i < 3; ++i)
            model[a][i] = white[i] * schlick(f0[i] / white[i], exact.cos_i[a]);
    return error_of(model, exact);
}

namespace {

surface_class classify(const material& substance, double ambient) {
    double lowest = 1e9, highest = 0, k = 0;
    for (int nm = 400; nm <= 700; nm += 10) {
        const optical_index index = index_at(substance, nm);
        lowest = std::min(lowest, index.n), highest = std::max(highest, index.n), k = std::max(k, index.k);
    }
    if (k > 0.1) return surface_class::metal;
    if (highest == ambient && lowest == ambient) return surface_class::matched;
    return (lowest + highest) / 2 < ambient ? surface_class::internal : surface_class::dielectric;
}

double rms(const std::vector<double>& a, const std::vector<double>& b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += square(a[i] - b[i]);
    return std::sqrt(sum / static_cast<double>(a.size()));
}

fitted_f82 fit_f82_of(std::string_view name, const std::array<channel, 3>& channels) {
    fitted_f82 result{};
    for (std::size_t i = 0; i < 3; ++i) {
        const parameters found = fit_f82(name, channels[i]);
        result.f82[i] = found[1];
        result.rms[i] = rms(evaluate(name, found, channels[i].cos_i), channels[i].R);
    }
    return result;
}

// The exact curve around the critical angles of the spectrum, between which it rises to 1: finer than elsewhere, for there
// a model is furthest off between two quarters of a degree. Empty where there are none.
rgb_curve near_critical_angles(const material& substance, color_space space, double ambient) {
    double lowest = ambient, highest = 0;
    for (int nm = 400; nm <= 700; nm += 5) {
        const double n = index_at(substance, nm).n;
        lowest = std::min(lowest, n), highest = std::max(highest, std::min(n, ambient));
    }
    rgb_curve fine{space, {}, {}, {}};
    if (lowest == ambient) return fine;
    const double margin = 0.5, from = degrees_of_cosine(critical_cosine(lowest / ambient)) - margin,
                 to = std::min(degrees_of_cosine(critical_cosine(highest / ambient)) + margin, 90.0),
                 step = std::max(0.0025, (to - from) / 4000);
    for (double theta = std::max(from, 0.0); theta <= to; theta += step)
        fine.theta_deg.push_back(theta), fine.cos_i.push_back(cosine_of_degrees(theta));
    fine.value = exact_colours(substance, space, ambient, fine.cos_i);
    return fine;
}

std::vector<rgb> colours_of(const model_fit& m, const rgb_curve& at) {
    std::vector<rgb> colours(at.cos_i.size());
    const rgb white = white_of(at.space);
    for (std::size_t i = 0; i < 3; ++i) {
        const std::vector<double> R = evaluate(m.name, m.values[i], at.cos_i);
        for (std::size_t a = 0; a < R.size(); ++a)
            colours[a][i] = white[i] * R[a];
    }
    return colours;
}

model_fit fit_model(std::string_view name, const std::array<channel, 3>& channels,
                    const std::array<edge_tint, 3>& tints, const rgb_curve& exact, const rgb_curve& fine) {
    model_fit result{std::string(name), {}, {}, {}, {}, 0, 0};
    for (std::size_t i = 0; i < 3; ++i)
        result.values[i] = fit(name, channels[i], tints[i]);
    result.curve = colours_of(result, exact);
    result.error = error_of(result.curve, exact);
    raise_maxima(result.error, colours_of(result, fine), fine);
    if (name == "f82" || name == "powers_4_12" || name == "powers_2_8_16")
        result.least_squares = fit_f82_of(name, channels);
    result.cost = count_operations(name, 3).cost();
    return result;
}

void rank(std::vector<model_fit>& models) {
    const auto key = [](const model_fit& m) {
        return std::tuple(m.error.worst(), m.cost, std::string_view(m.name));
    };
    std::sort(models.begin(), models.end(),
              [&](const model_fit& a, const model_fit& b) { return key(a) < key(b); });
    for (std::size_t i = 0; i < models.size(); ++i)
        models[i].rank = static_cast<int>(i) + 1;
}

std::size_t recommend(const std::vector<model_fit>& models) {
    const auto physical = [](const model_fit& m) {
        return find_model<double>(m.name).kind != model_kind::artistic;
    };
    for (const double limit : {invisible, slight}) {
        std::size_t best = models.size();
        for (std::size_t i = 0; i < models.size(); ++i)
            if (physical(models[i]) && models[i].error.delta_e_max <= limit &&
                (best == models.size() || models[i].cost < models[best].cost))
                best = i;
        if (best < models.size()) return best;
    }
    const auto less = [](const model_fit& a, const model_fit& b) {
        return a.error.delta_e_max < b.error.delta_e_max;
    };
    return static_cast<std::size_t>(std::min_element(models.begin(), models.end(), less) - models.begin());
}

std::string_view channel_name(color_space space, std::size_t i) {
    constexpr std::array<std::string_view, 3> colours = {"red", "green", "blue"}, xyz = {"X", "Y", "Z"};
    return space == color_space::xyz ? xyz[i] : colours[i];
}

std::string loss(const model_fit& m, color_space space) {
    const std::size_t i = m.error.worst_channel();
    if (m.error.max[i] < 5e-4) return "exact to three decimals";
    return fmt::format("off by at most {:.3f}, in {} at {:.0f}°, ΔE {:.1f}", m.error.max[i],
                       channel_name(space, i), m.error.max_theta[i], m.error.delta_e_max);
}

} // namespace

std::size_t curve_error::worst_channel() const {
    return static_cast<std::size_t>(std::max_element(max.begin(), max.end()) - max.begin());
}

const model_fit* comparison::find(std::string_view model) const {
    for (const model_fit& m : models)
        if (m.name == model) return &m;
    return nullptr;
}

comparison compare(const material& substance, color_space space, double ambient) {
    comparison result{colour_at_normal(substance, space, ambient),
                      exact_curve(substance, space, ambient),
                      classify(substance, ambient),
                      {},
                      0};
    std::array<channel, 3> channels;
    std::array<edge_tint, 3> tints{};
    for (std::size_t i = 0; i < 3; ++i) {
        channels[i] =
            channel_of(result.exact, result.colour.f0, result.colour.f82, ambient, i, white_of(space));
        tints[i] = fit_gulbrandsen(channels[i]);
    }
    const rgb_curve fine = result.surface == surface_class::internal
                               ? near_critical_angles(substance, space, ambient)
                               : rgb_curve{space, {}, {}, {}};
    for (const std::string_view name : models_for(result.surface))
        result.models.push_back(fit_model(name, channels, tints, result.exact, fine));
    rank(result.models);
    result.recommended = recommend(result.models);
    return result;
}

std::string verdict(const comparison& result) {
    const model_fit& best = result.best_choice();
    const color_space space = result.colour.space;
    const double seen = best.error.delta_e_max;
    std::string text = fmt::format("Use {}: it is {}, which is {}", best.name, loss(best, space),
                                   seen <= invisible ? "not seen"
                                   : seen <= slight  ? "barely seen"
                                                     : "seen");
    const model_fit* schlick = result.find("schlick");
    if (schlick != nullptr && schlick != &best)
        text += fmt::format("; Schlick's would be {}", loss(*schlick, space));
    text += ".";
    if (space != color_space::xyz && !in_gamut(result.colour.f0))
        text +=
            fmt::format(" Its F0 lies outside {}, which no model in [0, 1] can follow: compare in acescg.",
                        to_string(space));
    return text;
}

namespace {

nlohmann::json cost_json(const comparison& all, const model_fit& m) {
    const cost_row* cost = find_cost(m.name);
    if (cost == nullptr) return {};
    return {{"gpu", cost->gpu},
            {"stage", cost->stage},
            {"instructions", cost->instructions},
            {"latency", cost->latency},
            {"inverse_throughput", cost->inverse_throughput},
            {"registers", cost->registers},
            {"on_frontier", on_frontier(all, m)}};
}

} // namespace

nlohmann::json to_json(const comparison& result) {
    nlohmann::json models = nlohmann::json::array();
    for (const model_fit& m : result.models) {
        nlohmann::json values = nlohmann::json::object();
        const auto wanted = find_model<double>(m.name).parameters;
        for (std::size_t p = 0; p < wanted.size(); ++p)
            values[std::string(wanted[p].name)] = {m.values[0][p], m.values[1][p], m.values[2][p]};
        nlohmann::json one = {{"name", m.name},
                              {"rank", m.rank},
                              {"parameters", values},
                              {"max_error", m.error.max},
                              {"max_error_theta", m.error.max_theta},
                              {"rms_error", m.error.rms},
                              {"cosine_error", m.error.cosine},
                              {"delta_e_max", m.error.delta_e_max},
                              {"delta_e_theta", m.error.delta_e_theta},
                              {"operations", m.cost},
                              {"cost", cost_json(result, m)}};
        if (m.least_squares)
            one["least_squares"] = {{"f82", m.least_squares->f82}, {"rms_error", m.least_squares->rms}};
        models.push_back(std::move(one));
    }
    const normal_colour& colour = result.colour;
    return {{"name", colour.material},
            {"page", colour.page.empty() ? nlohmann::json() : nlohmann::json(colour.page)},
            {"space", to_string(colour.space)},
            {"ambient", colour.ambient},
            {"recipe", colour.recipe},
            {"f0", colour.f0},
            {"f82", colour.f82},
            {"recommended", result.best_choice().name},
            {"verdict", verdict(result)},
            {"models", models}};
}

} // namespace fresnel
