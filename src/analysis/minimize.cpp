#include "analysis/minimize.hpp"

#include <algorithm>
#include <cmath>

namespace fresnel {

double minimize(double lo, double hi, const std::function<double(double)>& f) {
    constexpr int scan = 32;
    const auto at = [&](int i) { return lo + (hi - lo) * i / scan; };
    int best = 0;
    double least = f(lo);
    for (int i = 1; i <= scan; ++i)
        if (const double value = f(at(i)); value < least) least = value, best = i;

    const double golden = (std::sqrt(5.0) - 1) / 2;
    double a = at(std::max(best - 1, 0)), b = at(std::min(best + 1, scan));
    double x = b - golden * (b - a), y = a + golden * (b - a);
    double fx = f(x), fy = f(y);
    while (b - a > 1e-9 * (hi - lo)) {
        if (fx < fy)
            b = y, y = x, fy = fx, x = b - golden * (b - a), fx = f(x);
        else
            a = x, x = y, fx = fy, y = a + golden * (b - a), fy = f(y);
    }
    const double inner = (a + b) / 2;
    return f(inner) < least ? inner : at(best);
}

} // namespace fresnel
