#include "conform/conform.hpp"

#include "conform/binding.hpp"
#include "conform/message.hpp"
#include "conform/samples.hpp"
#include "error.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fresnel::conform {

namespace {

constexpr std::size_t shown_failures = 5, shown_jumps = 5;

/// Runs the function, and hands out what it gives for each sample.
class runs {
public:
    runs(const conform_request& wanted, const binding& bound)
        : wanted_(wanted), bound_(bound), program_(bound.runnable(wanted)),
          runner_(open_runner(wanted.language)) {}

    std::string device() const { return runner_->name(); }

    std::vector<float> operator()(const std::vector<sample>& samples) {
        std::vector<float> inputs;
        for (const sample& s : samples) {
            const std::vector<float> x = bound_.arguments(s);
            inputs.insert(inputs.end(), x.begin(), x.end());
        }
        try {
            return runner_->run(program_, inputs);
        } catch (const render::refused_shader& refused) {
            throw bad_input(compiler_message(wanted_.file, wanted_.text, refused.what()));
        }
    }

private:
    const conform_request& wanted_;
    const binding& bound_;
    program program_;
    std::unique_ptr<shader_runner> runner_;
};

std::vector<std::pair<std::string, double>> named(const binding& bound, const sample& s, double cos_i) {
    std::vector<std::pair<std::string, double>> all;
    const auto& parameters = bound.model().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i)
        for (std::size_t c = 0; c < (bound.per_channel(i) ? 3u : 1u); ++c)
            all.emplace_back(bound.per_channel(i) ? fmt::format("{}.{}", parameters[i].name, "rgb"[c])
                                                  : std::string(parameters[i].name),
                             static_cast<double>(s.parameters[c][i]));
    all.emplace_back("cos_i", cos_i);
    return all;
}

void raise(std::optional<double>& largest, double value) {
    largest = std::max(largest.value_or(value), value);
}

/// Looks at every value, in [0, 1] of cos_i.
class judge {
public:
    judge(const conform_request& wanted, const binding& bound, conformance& found)
        : wanted_(wanted), bound_(bound), found_(found), exact_(exact_model(wanted, bound)) {}

    void look(const sample& s, const float* got) {
        const auto width = static_cast<std::size_t>(bound_.chosen().width);
        const std::vector<double> expected = bound_.expected(s, bound_.angle(s));
        std::string why;
        for (std::size_t c = 0; c < width; ++c) {
            if (const std::string what = value(s, c, expected[c], got[c]); why.empty()) why = what;
            if (exact_) against_exact(s, c, got[c]);
        }
        ++found_.inputs;
        if (why.empty() || found_.first_failures.size() >= shown_failures) return;
        const auto inputs = named(bound_, s, s.cos_i);
        for (const failed_input& earlier : found_.first_failures)
            if (earlier.inputs == inputs) return;
        found_.first_failures.push_back({inputs, bound_.arguments(s), expected, {got, got + width}, why});
    }

    void finish() {
        const auto rms = [this](double sum) { return std::sqrt(sum / static_cast<double>(values_)); };
        if (values_ > 0) found_.rms_error = rms(squares_);
        if (values_ > 0 && exact_) found_.exact_rms_error = rms(exact_squares_);
        if (too_large_ > 0)
            found_.findings.push_back(fmt::format("{} values are off by more than {}, at most by {:.3g}",
                                                  too_large_, wanted_.tolerance, *found_.max_error));
        if (digits_ > 0)
            found_.findings.push_back(fmt::format("{} values lose their digits: relative error up to {:.3g}",
                                                  digits_, *found_.max_relative_error));
        if (found_.nan > 0) found_.findings.push_back(fmt::format("{} values are NaN", found_.nan));
        if (found_.lowest.value_or(0) < -1e-12)
            found_.findings.push_back(
                fmt::format("{} values are negative, down to {:.3g}", found_.negative, *found_.lowest));
        if (found_.highest.value_or(0) > 1 + 1e-6)
            found_.findings.push_back(
                fmt::format("{} values are above 1, up to {:.9g}", found_.above_one, *found_.highest));
    }

private:
    static const model_row<double>* exact_model(const conform_request& wanted, const binding& bound) {
        if (!wanted.exact) return nullptr;
        for (const char* name : {"n_t", "n", "f0"})
            for (const parameter& p : bound.model().parameters)
                if (p.name == name)
                    return &find_model<double>(p.name == "n_t" || p.name == "n" ? "conductor" : "dielectric");
        throw bad_input(fmt::format("--exact: {} has neither an index nor f0", bound.model().name));
    }

    // The exact reflectance of what that channel's parameters describe: n and k, or the dielectric of that f0.
    void against_exact(const sample& s, std::size_t c, float got) {
        std::array<double, 3> index{1, 1, 0};
        const std::size_t channel = bound_.channels() == 3 ? c : 0;
        for (std::size_t i = 0; i < bound_.model().parameters.size(); ++i) {
            const std::string_view name = bound_.model().parameters[i].name;
            const auto value = static_cast<double>(s.parameters[channel][i]);
            if (name == "n_i") index[0] = value;
            if (name == "n_t" || name == "n") index[1] = value;
            if (name == "k_t" || name == "k") index[2] = value;
            if (name == "f0") index[1] = eta_from_f0(std::min(value, 0.9999));
        }
        const double error = std::abs(static_cast<double>(got) -
                                      exact_->evaluate(index.data(), bound_.angle(s)).reflectance());
        if (std::isnan(error)) return;
        raise(found_.exact_max_error, error);
        exact_squares_ += error * error;
    }

    // What is wrong with a value; empty if nothing.
    std::string value(const sample& s, std::size_t c, double expected, float got) {
        if (std::isnan(got)) {
            ++found_.nan;
            return "NaN";
        }
        const auto x = static_cast<double>(got);
        found_.lowest = std::min(found_.lowest.value_or(x), x), raise(found_.highest, x);
        const double error = std::abs(x - expected);
        squares_ += error * error, ++values_;
        raise(found_.max_error, error);
        if (expected > 1e-13) raise(found_.max_relative_error, error / expected);
        found_.negative += x < 0 ? 1 : 0, found_.above_one += x > 1 ? 1 : 0;
        if (error > wanted_.tolerance && error > wanted_.tolerance + spread(s, c)) {
            ++too_large_;
            return fmt::format("off by {:.3g}", error);
        }
        const bool exact = bound_.model().kind == model_kind::exact && expected > 1e-13;
        if (exact && error > wanted_.relative * expected &&
            error > wanted_.relative * expected + spread(s, c)) {
            ++digits_;
            return fmt::format("off by {:.3g} of itself", error / expected);
        }
        if (x < -1e-12) return "negative";
        return x > 1 + 1e-6 ? "above 1" : "";
    }

    // How much the model moves with cos_i by four floats.
    double spread(const sample& s, std::size_t c) const {
        // a dot product has the rounding errors of its terms
        const double cos_i = bound_.angle(s);
        const double step = 4 * 0x1p-24 * (bound_.takes_directions() ? 2 : std::max(cos_i, 0x1p-24));
        const double here = bound_.expected(s, cos_i)[c];
        const double below = bound_.expected(s, std::max(cos_i - step, 0.0))[c];
        const double above = bound_.expected(s, std::min(cos_i + step, 1.0))[c];
        return std::max(std::abs(below - here), std::abs(above - here));
    }

    const conform_request& wanted_;
    const binding& bound_;
    conformance& found_;
    const model_row<double>* exact_;
    double squares_ = 0, exact_squares_ = 0;
    std::size_t values_ = 0, too_large_ = 0, digits_ = 0;
};

// ---- outside of [0, 1] ------------------------------------------------------------------------------------

void look_beyond(const binding& bound, const std::vector<sample>& samples, const std::vector<float>& got,
                 conformance& found) {
    const auto width = static_cast<std::size_t>(bound.chosen().width);
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const float* row = &got[i * width];
        std::string why; // of the first channel that fails
        for (std::size_t c = 0; c < width; ++c) {
            const bool nan = std::isnan(row[c]);
            // a function of directions is the one that has to limit their cosine
            const bool outside = bound.takes_directions() && (row[c] < 0 || row[c] > 1 + 1e-6f);
            found.beyond_nan += nan ? 1 : 0, found.beyond_range += outside ? 1 : 0;
            if (why.empty() && (nan || outside)) why = nan ? "NaN outside of [0, 1]" : "no reflectance";
        }
        if (why.empty() || found.first_failures.size() >= shown_failures) continue;
        const sample& s = samples[i];
        found.first_failures.push_back({named(bound, s, s.cos_i),
                                        bound.arguments(s),
                                        bound.expected(s, std::clamp(bound.angle(s), 0.0, 1.0)),
                                        {row, row + width},
                                        why});
    }
    if (found.beyond_nan > 0)
        found.findings.push_back(fmt::format("{} values are NaN for {}", found.beyond_nan,
                                             bound.takes_directions()
                                                 ? "directions behind the surface"
                                                 : "cosines a rounding error outside of [0, 1]"));
    if (found.beyond_range > 0)
        found.findings.push_back(fmt::format("{} values are no reflectance for directions behind the surface",
                                             found.beyond_range));
}

// ---- discontinuities --------------------------------------------------------------------------------------

/// A step of a sweep across which the function moves and the model does not.
struct step {
    sample low, high;
    float at_low, at_high;
};

double jump_of(const binding& bound, const step& x, std::size_t channel) {
    const double moved = bound.expected(x.high, bound.angle(x.high))[channel] -
                         bound.expected(x.low, bound.angle(x.low))[channel];
    return std::abs(static_cast<double>(x.at_high) - static_cast<double>(x.at_low) - moved);
}

// Narrows every step to its two neighbouring halves until it is a few floats wide.
void narrow(runs& run, const binding& bound, std::vector<step>& steps) {
    const auto width = static_cast<std::size_t>(bound.chosen().width);
    for (int round = 0; round < 16 && !steps.empty(); ++round) {
        std::vector<sample> middles;
        for (const step& x : steps)
            middles.push_back(turned(x.low, (x.low.cos_i + x.high.cos_i) / 2));
        const std::vector<float> got = run(middles);
        for (std::size_t i = 0; i < steps.size(); ++i) {
            step left = steps[i], right = steps[i];
            left.high = right.low = middles[i];
            left.at_high = right.at_low = got[i * width];
            steps[i] = jump_of(bound, left, 0) > jump_of(bound, right, 0) ? left : right;
        }
    }
}

void find_jumps(runs& run, const binding& bound, const std::vector<sample>& sweep,
                const std::vector<float>& got, double tolerance, conformance& found) {
    const auto width = static_cast<std::size_t>(bound.chosen().width);
    const double smallest = std::max(10 * tolerance, 1e-3);
    std::vector<step> steps;
    for (std::size_t i = 1; i < sweep.size() && steps.size() < 64; ++i) {
        if (sweep[i].cos_i <= sweep[i - 1].cos_i) continue; // the next sweep
        const step x{sweep[i - 1], sweep[i], got[(i - 1) * width], got[i * width]};
        if (std::isfinite(x.at_low) && std::isfinite(x.at_high) && jump_of(bound, x, 0) > smallest)
            steps.push_back(x);
    }
    narrow(run, bound, steps);
    std::size_t jumps = 0;
    for (const step& x : steps) {
        if (!(jump_of(bound, x, 0) > smallest)) continue;
        ++jumps;
        if (found.discontinuities.size() < shown_jumps)
            found.discontinuities.push_back({named(bound, x.high, x.high.cos_i), jump_of(bound, x, 0)});
    }
    if (jumps > 0)
        found.findings.push_back(
            fmt::format("it jumps by up to {:.3g} where the model does not, first at cos_i = {:.6g}",
                        found.discontinuities[0].jump, found.discontinuities[0].inputs.back().second));
}

conformance opened(const conform_request& wanted, const binding& bound, const runs& run) {
    conformance found;
    found.device = run.device();
    found.signature = bound.chosen().text(wanted.language, wanted.function);
    for (std::size_t i = 0; i < bound.expressions().size(); ++i)
        found.bound.emplace_back(bound.chosen().arguments[i].name, bound.expressions()[i].text());
    const auto& parameters = bound.model().parameters;
    for (std::size_t i = 0; i < parameters.size(); ++i) {
        if (bound.varies(i)) continue;
        const auto given = wanted.fixed.find(std::string(parameters[i].name));
        found.fixed.emplace_back(parameters[i].name,
                                 given == wanted.fixed.end() ? parameters[i].default_value : given->second);
    }
    return found;
}

} // namespace

conformance conform(const conform_request& wanted) {
    const binding bound(wanted);
    runs run(wanted, bound);
    conformance found = opened(wanted, bound, run);
    sampler source(wanted, bound);
    const auto width = static_cast<std::size_t>(bound.chosen().width);

    const std::vector<sample> inside = source.inside(wanted.rows);
    const std::vector<float> got = run(inside);
    judge looking(wanted, bound, found);
    for (std::size_t i = 0; i < inside.size(); ++i)
        looking.look(inside[i], &got[i * width]);
    looking.finish();

    const std::vector<sample> beyond = source.beyond(4096);
    look_beyond(bound, beyond, run(beyond), found);
    const std::vector<sample> sweep = source.sweeps(8, 4096);
    find_jumps(run, bound, sweep, run(sweep), wanted.tolerance, found);
    return found;
}

} // namespace fresnel::conform
