#pragma once

// The exact equations as they are commonly written, one value at a time, over arrays of n, k (relative to the ambient
// medium) and cos_i. Written for this comparison from the equations.

#include <cstddef>

namespace fresnel::bench {

struct index_arrays {
    const float *n, *k, *cos_i;
};

/// std::complex<float>, the form of textbooks: Snell's law for a complex index, then both amplitudes.
void textbook_conductor(const index_arrays& in, float* R, std::size_t count);
/// The same for k = 0, the transmitted cosine complex beyond the critical angle.
void textbook_dielectric(const index_arrays& in, float* R, std::size_t count);
/// A complex number class of two floats with a square root of its own, as renderers carry it.
void complex_class_conductor(const index_arrays& in, float* R, std::size_t count);
/// Two real roots and two divisions (Lagarde 2013, Memo on Fresnel equations).
void memo_conductor(const index_arrays& in, float* R, std::size_t count);

/// Reflectance of every wavelength and angle by std::complex<double>, weighted into three channels: the table that
/// spectral_table (batch.hpp) makes. weights: three arrays; rgb: three arrays of `angles` values.
void textbook_spectral_table(const double* n, const double* k, const double* const* weights,
                             std::size_t wavelengths, const double* cos_i, std::size_t angles,
                             double* const* rgb);

} // namespace fresnel::bench
