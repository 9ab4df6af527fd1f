#include "analysis/pareto.hpp"

#include "analysis/cost_table.hpp"
#include "analysis/drawing.hpp"
#include "analysis/model_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace fresnel {

namespace {

constexpr const char* grey = "#808080";

struct point {
    std::string name;
    double instructions, error;
    bool on_frontier, named;
};

// An error below it is drawn here: nothing sees it.
constexpr double smallest_error = 1e-4;

double drawn_error(const model_fit& m) { return std::max(m.error.worst(), smallest_error); }

// What artists turn by hand is no answer to the question which model to use.
bool is_shown(const model_fit& m) {
    return find_cost(m.name) != nullptr && find_model<double>(m.name).kind != model_kind::artistic;
}

std::vector<point> points_of(const comparison& all) {
    std::vector<point> points;
    for (const model_fit& m : all.models) {
        if (!is_shown(m)) continue;
        const bool best = on_frontier(all, m);
        points.push_back({m.name, find_cost(m.name)->instructions, drawn_error(m), best,
                          best || m.name == "schlick" || &m == &all.best_choice()});
    }
    std::sort(points.begin(), points.end(), [](const point& a, const point& b) {
        return std::pair(a.instructions, a.error) < std::pair(b.instructions, b.error);
    });
    return points;
}

// ---- labels that do not cover each other ------------------------------------------------------------------

struct box {
    double left, right, bottom, top;
    bool covers(const box& b) const {
        return left < b.right && b.left < right && bottom < b.top && b.bottom < top;
    }
};

// In units of the panel: x and y from 0 to 1.
constexpr double letter_width = 0.0106, line_height = 0.052, gap = 0.008;

/// Puts a number beside each point of a panel, at its right, its left, or a line or more above or below, and what the
/// numbers mean into the corner at the top right, which points and steps leave free.
class labels {
public:
    explicit labels(const panel& p) : p_(p) {}

    void avoid_point(double x, double y) {
        const double u = across(x), v = up(y);
        taken_.push_back({u - gap, u + gap, v - 0.4 * line_height, v + 0.4 * line_height});
    }

    void avoid_steps(const series& s) {
        for (std::size_t i = 1; i < s.x.size(); ++i) {
            const auto [left, right] = std::minmax({across(s.x[i - 1]), across(s.x[i])});
            const auto [bottom, top] = std::minmax({up(s.y[i - 1]), up(s.y[i])});
            taken_.push_back({left - 0.002, right + 0.002, bottom - 0.004, top + 0.004});
        }
    }

    note beside(const point& at, const std::string& text, const std::string& color) {
        const double u = across(at.instructions), v = up(at.error);
        const double length = letter_width * static_cast<double>(text.size());
        for (const double lines : {0.0, 0.6, -0.6, 1.1, -1.1, 1.7, -1.7, 2.4, -2.4})
            for (const bool right : {true, false}) {
                const double begin = right ? u + 1.4 * gap : u - 1.4 * gap - length;
                const double middle = v + lines * line_height;
                const box b{begin, begin + length, middle - line_height / 2, middle + line_height / 2};
                const bool inside = b.left > 0 && b.right < 1 && b.bottom > 0 && b.top < 1.05;
                const auto covers = [&](const box& t) { return t.covers(b); };
                if (!inside || std::any_of(taken_.begin(), taken_.end(), covers)) continue;
                taken_.push_back(b);
                return {x_at(right ? b.left : b.right), y_at(middle), text,
                        right ? note::side::left : note::side::right, color};
            }
        return {at.instructions, at.error, text, note::side::left, color};
    }

    note in_corner(int line, const std::string& text, const std::string& color) const {
        return {x_at(0.6), y_at(0.97 - 1.15 * line_height * line), text, note::side::left, color};
    }

private:
    double across(double x) const { return (x - p_.x.lo) / (p_.x.hi - p_.x.lo); }
    double up(double y) const { return std::log(y / p_.y.lo) / std::log(p_.y.hi / p_.y.lo); }
    double x_at(double u) const { return p_.x.lo + u * (p_.x.hi - p_.x.lo); }
    double y_at(double v) const { return p_.y.lo * std::pow(p_.y.hi / p_.y.lo, v); }

    const panel& p_;
    std::vector<box> taken_;
};

// The frontier as steps: with so many instructions, an error not below this.
series frontier_steps(const std::vector<point>& points, double end) {
    series s{"", {}, {}, model_colors[0], stroke::solid, 1.4, "frontier"};
    for (const point& p : points) {
        if (!p.on_frontier) continue;
        if (!s.y.empty()) s.x.push_back(p.instructions), s.y.push_back(s.y.back());
        s.x.push_back(p.instructions), s.y.push_back(p.error);
    }
    if (!s.y.empty()) s.x.push_back(end), s.y.push_back(s.y.back());
    return s;
}

std::string legend_line(int number, const point& p) {
    return fmt::format("{}  {}: {}{:.2g} with {:.0f}", number, p.name, p.error > smallest_error ? "" : "≤ ",
                       p.error, p.instructions);
}

} // namespace

bool on_frontier(const comparison& all, const model_fit& model) {
    if (!is_shown(model)) return false;
    const double own = find_cost(model.name)->instructions;
    return std::none_of(all.models.begin(), all.models.end(), [&](const model_fit& other) {
        if (!is_shown(other)) return false;
        const double cost = find_cost(other.name)->instructions;
        if (cost > own || drawn_error(other) > drawn_error(model)) return false;
        return cost < own || drawn_error(other) < drawn_error(model);
    });
}

figure pareto_figure(const comparison& all, const std::string& id, const std::string& title) {
    const std::vector<point> points = points_of(all);
    panel p{{"instructions of one evaluation (AMD navi21, fragment stage)", -1, 10, 10},
            {"largest error of any channel", 1, 1.8, 0, true},
            {},
            {}};
    series others{"", {}, {}, grey, stroke::points, 4, "models"}, best = others;
    best.color = model_colors[0], best.name = "models on the frontier";
    for (const point& each : points) {
        p.x.hi = std::max(p.x.hi, 10 * std::ceil((each.instructions + 3) / 10));
        p.y.lo = std::min(p.y.lo, 0.6 * each.error);
        series& s = each.on_frontier ? best : others;
        s.x.push_back(each.instructions), s.y.push_back(each.error);
    }
    p.curves = {frontier_steps(points, p.x.hi), others, best};
    labels placed(p);
    placed.avoid_steps(p.curves.front());
    for (const point& each : points)
        placed.avoid_point(each.instructions, each.error);
    int line = 0;
    for (const point& each : points) {
        if (!each.named) continue;
        const char* color = each.on_frontier ? model_colors[0] : grey;
        p.notes.push_back(placed.in_corner(line, legend_line(line + 1, each), color));
        p.notes.push_back(placed.beside(each, fmt::format("{}", ++line), color));
    }
    return {id,
            title,
            "Models on the line are the best of their cost: nothing as cheap is as close. Grey dots are the "
            "others of "
            "the table. Instructions are of one channel, by AMD's compiler (`fresnel cost`); errors below "
            "0.0001 are "
            "drawn there.",
            {p},
            {},
            {}};
}

} // namespace fresnel
