#pragma once

// Least squares for curves of one to three parameters: Gauss and Newton's step, damped where it fails, inside a
// box. The derivatives come from running the residual on duals, so that a model is fitted by its own body.
//
// A problem is a callable: given the parameters as std::array<dual<double, N>, N> it returns another, which gives the
// residual of sample i as a dual. What depends on the parameters alone is thus computed once for all samples.

#include <fresnel/types/dual.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace fresnel {

/// The parameters of a fit.
template <std::size_t N>
using point = std::array<double, N>;

/// Where the parameters may lie.
template <std::size_t N>
struct bounds {
    point<N> lo, hi;

    point<N> nearest(point<N> x) const {
        for (std::size_t i = 0; i < N; ++i)
            x[i] = std::clamp(x[i], lo[i], hi[i]);
        return x;
    }
};

template <std::size_t N>
using square_matrix = std::array<point<N>, N>;

template <std::size_t N>
point<N> product(const square_matrix<N>& a, const point<N>& x) {
    point<N> y{};
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j)
            y[i] += a[i][j] * x[j];
    return y;
}

template <std::size_t N>
double dot(const point<N>& x, const point<N>& y) {
    double sum = 0;
    for (std::size_t i = 0; i < N; ++i)
        sum += x[i] * y[i];
    return sum;
}

/// The sum of squared residuals r at a point and, with J their derivatives, J^T r and J^T J.
template <std::size_t N>
struct normal_equations {
    double squares = 0;
    point<N> gradient{};
    square_matrix<N> matrix{};
};

/// Which samples count: each, or fewer the further they are from the last one (grazing incidence, where curves of
/// reflectance bend), each for those it stands for.
struct sampling {
    std::size_t samples;
    std::size_t density; ///< every (distance / density)-th; 0 for each

    std::size_t gap(std::size_t distance) const {
        return density == 0 ? 1 : std::max<std::size_t>(distance / density, 1);
    }
};

/// The normal equations at x. Flattened: with everything inlined the derivatives of constants fold away.
template <std::size_t N, class Problem>
[[gnu::flatten]] normal_equations<N> linearize(const Problem& problem, const point<N>& x,
                                               const sampling& which) {
    using number = dual<double, static_cast<int>(N)>;
    std::array<number, N> variables;
    for (std::size_t i = 0; i < N; ++i)
        variables[i] = number::variable(x[i], static_cast<int>(i));
    const auto residual = problem(variables);
    normal_equations<N> sum;
    double left = 0.5; // half the gap before a sample, and half that after it
    for (std::size_t d = 0, gap; d < which.samples; d += gap) {
        gap = which.gap(d);
        const bool last = d + gap >= which.samples;
        const double right =
            last ? static_cast<double>(which.samples - d) - 0.5 : static_cast<double>(gap) / 2;
        const double weight = left + right;
        left = right;
        const number r = residual(which.samples - 1 - d);
        sum.squares += weight * r.value * r.value;
        for (std::size_t i = 0; i < N; ++i) {
            const double weighted = weight * r.d[i];
            sum.gradient[i] += weighted * r.value;
            for (std::size_t j = 0; j <= i; ++j)
                sum.matrix[i][j] += weighted * r.d[j];
        }
    }
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < i; ++j)
            sum.matrix[j][i] = sum.matrix[i][j];
    return sum;
}

/// Solves a x = b, a symmetric, by elimination; an unknown whose pivot vanishes is 0. Nothing where a pivot is negative.
template <std::size_t N>
std::optional<point<N>> solve(square_matrix<N> a, point<N> b) {
    const square_matrix<N> whole = a;
    std::array<bool, N> free{};
    for (std::size_t p = 0; p < N; ++p) {
        const double least = 1e-12 * std::abs(whole[p][p]);
        if (a[p][p] < -least) return std::nullopt;
        free[p] = a[p][p] > least;
        for (std::size_t i = p + 1; free[p] && i < N; ++i) {
            const double factor = a[i][p] / a[p][p];
            for (std::size_t j = p; j < N; ++j)
                a[i][j] -= factor * a[p][j];
            b[i] -= factor * b[p];
        }
    }
    point<N> x{};
    for (std::size_t p = N; p-- > 0;) {
        double rest = b[p];
        for (std::size_t j = p + 1; j < N; ++j)
            rest -= a[p][j] * x[j];
        x[p] = free[p] ? rest / a[p][p] : 0;
    }
    return x;
}

/// A descent to a minimum of the sum of squares inside a box, from one density of samples to the next.
///
/// Half the second derivatives of the sum are J^T J + C with C the sum of r times its second derivatives, which Gauss
/// and Newton leave out. C is learnt from the change of the gradient over each step, so that the last steps are
/// Newton's also where the residuals are large; where J^T J + C has no minimum, J^T J stands alone.
///
/// source  Levenberg 1944; Marquardt 1963; Dennis, Gay and Welsch 1981, "An Adaptive Nonlinear Least-Squares
///         Algorithm"; the update of C by rank one as in Nocedal and Wright 2006, "Numerical Optimization", sec. 6.2
template <std::size_t N>
class descent {
public:
    descent(const point<N>& start, const bounds<N>& box) : x_(box.nearest(start)), box_(box) {}

    const point<N>& x() const { return x_; }
    double squares() const { return at_.squares; }
    double distance(const descent& other) const {
        double largest = 0;
        for (std::size_t i = 0; i < N; ++i)
            largest = std::max(largest, std::abs(x_[i] - other.x_[i]));
        return largest;
    }
    /// Goes on until the next step should lessen the sum by less than the tolerance, relative.
    template <class Problem>
    void run(const Problem& problem, const sampling& which, double tolerance) {
        at_ = linearize(problem, x_, which);
        double damping = 0;
        for (int i = 0; i < 60 && damping < 1e8; ++i) {
            const point<N> s = step(damping);
            const double expected = decrease(s) * (1 + damping);
            if (!(std::abs(expected) > tolerance * at_.squares + 1e-26)) break;
            const bool better = expected > 0 && accept(problem, which, s);
            if (!better && damping > 0) curvature_ = {};
            damping = !better ? std::max(10 * damping, 1e-2) : damping > 1e-3 ? damping / 10 : 0;
        }
    }

private:
    /// Takes a step if it lessens the sum; learns from it in any case.
    template <class Problem>
    bool accept(const Problem& problem, const sampling& which, const point<N>& s) {
        point<N> beyond = x_;
        for (std::size_t i = 0; i < N; ++i)
            beyond[i] += s[i];
        const normal_equations<N> next = linearize(problem, box_.nearest(beyond), which);
        const bool better = next.squares < at_.squares;
        learn(s, next, better ? next.matrix : at_.matrix);
        if (better) x_ = box_.nearest(beyond), at_ = next;
        return better;
    }

    point<N> step(double damping) const {
        square_matrix<N> gauss_newton = at_.matrix, newton = curvature_;
        for (std::size_t i = 0; i < N; ++i) {
            gauss_newton[i][i] *= 1 + damping;
            for (std::size_t j = 0; j < N; ++j)
                newton[i][j] += gauss_newton[i][j];
        }
        const std::optional<point<N>> s = step_inside(newton);
        return s ? *s : *step_inside(gauss_newton);
    }

    /// The step s inside the box that solves a s = -J^T r, where a parameter that would leave stays on its bound.
    /// Nothing where a is not positive.
    std::optional<point<N>> step_inside(square_matrix<N> a) const {
        point<N> b, s{};
        std::array<bool, N> held{};
        for (std::size_t i = 0; i < N; ++i)
            b[i] = -at_.gradient[i];
        for (bool again = true; again;) {
            const std::optional<point<N>> free = solve(a, b);
            if (!free) return std::nullopt;
            again = false;
            for (std::size_t i = 0; i < N; ++i) {
                if (held[i]) continue;
                s[i] = (*free)[i];
                const double wanted = x_[i] + s[i];
                if (wanted >= box_.lo[i] && wanted <= box_.hi[i]) continue;
                s[i] = (wanted < box_.lo[i] ? box_.lo[i] : box_.hi[i]) - x_[i];
                held[i] = again = true;
                for (std::size_t j = 0; j < N; ++j)
                    b[j] -= a[j][i] * s[i], a[i][j] = a[j][i] = 0;
                b[i] = 0;
            }
        }
        return s;
    }

    /// By how much the sum should lessen over a step.
    double decrease(const point<N>& s) const {
        return -2 * dot(at_.gradient, s) - dot(s, product(at_.matrix, s)) - dot(s, product(curvature_, s));
    }

    void learn(const point<N>& s, const normal_equations<N>& next, const square_matrix<N>& matrix) {
        const point<N> by_matrix = product(matrix, s), by_curvature = product(curvature_, s);
        point<N> miss;
        for (std::size_t i = 0; i < N; ++i)
            miss[i] = next.gradient[i] - at_.gradient[i] - by_matrix[i] - by_curvature[i];
        const double along = dot(miss, s);
        if (!(square(along) > 1e-4 * dot(miss, miss) * dot(s, s))) return;
        for (std::size_t i = 0; i < N; ++i)
            for (std::size_t j = 0; j < N; ++j)
                curvature_[i][j] += miss[i] * miss[j] / along;
    }

    point<N> x_;
    bounds<N> box_;
    normal_equations<N> at_{};
    square_matrix<N> curvature_{};
};

/// Which of the starts have the least sums, those first.
template <std::size_t N, class Problem>
std::vector<point<N>> lowest(std::size_t count, const Problem& problem, const sampling& which,
                             const bounds<N>& box, const std::vector<point<N>>& starts) {
    std::vector<std::pair<double, point<N>>> ranked;
    for (const point<N>& start : starts)
        ranked.emplace_back(linearize(problem, box.nearest(start), which).squares, start);
    std::ranges::sort(ranked);
    std::vector<point<N>> result;
    for (std::size_t i = 0; i < std::min(count, ranked.size()); ++i)
        result.push_back(ranked[i].second);
    return result;
}

/// Where the sum of squares is least: a few samples decide which two of the starts to follow, more which of these leads
/// lowest, and all finish it.
///
/// samples   how many residuals the problem has
/// starts    at least one; several where there may be several minima
template <std::size_t N, class Problem>
point<N> least_squares(const Problem& problem, std::size_t samples, const bounds<N>& box,
                       const std::vector<point<N>>& starts) {
    constexpr std::size_t few = 3, some = 8, each = 0;
    std::vector<descent<N>> found;
    for (const point<N>& start : lowest(2, problem, {samples, few}, box, starts))
        found.emplace_back(start, box).run(problem, {samples, few}, 1e-3);
    const auto lower = [](const descent<N>& a, const descent<N>& b) { return a.squares() < b.squares(); };
    std::ranges::sort(found, lower);
    descent<N>& best = found[0];
    if (found.size() > 1 && best.distance(found[1]) < 0.5) found.pop_back();
    for (descent<N>& one : found)
        one.run(problem, {samples, some}, 1e-5);
    if (found.size() > 1 && lower(found[1], best)) best = found[1];
    best.run(problem, {samples, each}, 1e-10);
    return best.x();
}

} // namespace fresnel
