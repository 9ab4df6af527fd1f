#pragma once

#include <functional>

namespace fresnel {

/// Where f is least on [lo, hi]: the best of a uniform scan, refined by golden section between its neighbours.
/// The scan guards against the second minimum that a clamped model may have.
double minimize(double lo, double hi, const std::function<double(double)>& f);

} // namespace fresnel
