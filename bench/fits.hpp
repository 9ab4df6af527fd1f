#pragma once

#include <functional>

namespace fresnel::bench {

/// What fits every model that suits a built-in material to each of its three colours, as `compare` does, for every
/// material. The exact curves are made beforehand. Calling it gives the number of fits.
std::function<int()> all_fits();

} // namespace fresnel::bench
