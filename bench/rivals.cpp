#include "rivals.hpp"

#include <algorithm>
#include <cmath>
#include <complex>

namespace fresnel::bench {

namespace {

template <class T>
T textbook(std::complex<T> m, T cos_i) {
    const T sin2 = 1 - cos_i * cos_i;
    const std::complex<T> cos_t = std::sqrt(T(1) - sin2 / (m * m));
    const std::complex<T> r_s = (cos_i - m * cos_t) / (cos_i + m * cos_t);
    const std::complex<T> r_p = (m * cos_i - cos_t) / (m * cos_i + cos_t);
    return (std::norm(r_s) + std::norm(r_p)) / 2;
}

struct complex_pair {
    float re, im;
};

complex_pair operator+(complex_pair z, complex_pair w) { return {z.re + w.re, z.im + w.im}; }
complex_pair operator-(complex_pair z, complex_pair w) { return {z.re - w.re, z.im - w.im}; }
complex_pair operator*(complex_pair z, complex_pair w) {
    return {z.re * w.re - z.im * w.im, z.re * w.im + z.im * w.re};
}
complex_pair operator/(complex_pair z, complex_pair w) {
    const float scale = 1 / (w.re * w.re + w.im * w.im);
    return {scale * (z.re * w.re + z.im * w.im), scale * (z.im * w.re - z.re * w.im)};
}
float norm(complex_pair z) { return z.re * z.re + z.im * z.im; }

complex_pair root(complex_pair z) {
    const float length = std::sqrt(norm(z));
    const float larger = std::sqrt(0.5f * (length + std::abs(z.re)));
    if (length == 0) return {0, 0};
    const float smaller = 0.5f * std::abs(z.im) / larger;
    if (z.re >= 0) return {larger, std::copysign(smaller, z.im)};
    return {smaller, std::copysign(larger, z.im)};
}

float by_complex_class(float n, float k, float cos_i) {
    const float c = std::clamp(cos_i, 0.0f, 1.0f);
    const complex_pair m = {n, k}, ci = {c, 0};
    const complex_pair sin2_t = complex_pair{1 - c * c, 0} / (m * m);
    const complex_pair cos_t = root(complex_pair{1, 0} - sin2_t);
    const complex_pair r_p = (m * ci - cos_t) / (m * ci + cos_t);
    const complex_pair r_s = (ci - m * cos_t) / (ci + m * cos_t);
    return (norm(r_p) + norm(r_s)) / 2;
}

float by_memo(float n, float k, float c) {
    const float c2 = c * c, s2 = 1 - c2;
    const float t0 = n * n - k * k - s2;
    const float a2_b2 = std::sqrt(t0 * t0 + 4 * n * n * k * k);
    const float a = std::sqrt(std::max(0.5f * (a2_b2 + t0), 0.0f));
    const float t1 = a2_b2 + c2, t2 = 2 * a * c;
    const float R_s = (t1 - t2) / (t1 + t2);
    const float t3 = c2 * a2_b2 + s2 * s2, t4 = t2 * s2;
    return R_s * (1 + (t3 - t4) / (t3 + t4)) / 2;
}

} // namespace

void textbook_conductor(const index_arrays& in, float* R, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        R[i] = textbook<float>({in.n[i], in.k[i]}, in.cos_i[i]);
}

void textbook_dielectric(const index_arrays& in, float* R, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        R[i] = textbook<float>({in.n[i], 0}, in.cos_i[i]);
}

void complex_class_conductor(const index_arrays& in, float* R, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        R[i] = by_complex_class(in.n[i], in.k[i], in.cos_i[i]);
}

void memo_conductor(const index_arrays& in, float* R, std::size_t count) {
    for (std::size_t i = 0; i < count; ++i)
        R[i] = by_memo(in.n[i], in.k[i], in.cos_i[i]);
}

void textbook_spectral_table(const double* n, const double* k, const double* const* weights,
                             std::size_t wavelengths, const double* cos_i, std::size_t angles,
                             double* const* rgb) {
    for (std::size_t j = 0; j < angles; ++j) {
        double sum[3] = {};
        for (std::size_t i = 0; i < wavelengths; ++i) {
            const double R = textbook<double>({n[i], k[i]}, cos_i[j]);
            for (int channel = 0; channel < 3; ++channel)
                sum[channel] += weights[channel][i] * R;
        }
        for (int channel = 0; channel < 3; ++channel)
            rgb[channel][j] = sum[channel];
    }
}

} // namespace fresnel::bench
