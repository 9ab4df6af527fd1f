#pragma once

#include <boost/multiprecision/mpfr.hpp>

namespace fresnel {

/// The truth: 50 decimal digits, and ten more that absorb the rounding of a computation. Expression templates
/// are off, so that a model's locals are plain values.
using real50 = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<60>,
                                             boost::multiprecision::et_off>;

} // namespace fresnel
