// SPDX-License-Identifier: BSD-3-Clause
#include "fourier.h"

#include <slalom/core/math.h>

#include <cmath>
#include <complex>
#include <map>
#include <utility>

namespace slalom {
namespace {

using Complex = std::complex<double>;

/// Bit-reversal permutation.
void reverse_bits(std::vector<Complex>& data) {
  for (std::size_t i = 1, j = 0; i < data.size(); ++i) {
    std::size_t bit = data.size() / 2;
    for (; (j & bit) != 0; bit /= 2) j ^= bit;
    j |= bit;
    if (i < j) std::swap(data[i], data[j]);
  }
}

/// The first half of the roots of unity, clockwise, kept for the next signal of this size.
const std::vector<Complex>& roots_of_unity(std::size_t size) {
  thread_local std::map<std::size_t, std::vector<Complex>> known;
  std::vector<Complex>& roots = known[size];
  for (std::size_t k = roots.size(); k < size / 2; ++k) {
    const double angle = -2 * M_PI * static_cast<double>(k) / static_cast<double>(size);
    roots.emplace_back(math::cos(angle), math::sin(angle));
  }
  return roots;
}

/// In-place radix-2 FFT (Cooley and Tukey); the size is a power of two.
void transform(std::vector<Complex>& data) {
  reverse_bits(data);
  const std::vector<Complex>& roots = roots_of_unity(data.size());
  for (std::size_t half = 1; half < data.size(); half *= 2) {
    const std::size_t step = roots.size() / half;
    for (std::size_t begin = 0; begin < data.size(); begin += 2 * half)
      for (std::size_t k = 0; k < half; ++k) {
        Complex& low = data[begin + k];
        Complex& high = data[begin + k + half];
        const Complex& root = roots[k * step];
        const Complex turned(high.real() * root.real() - high.imag() * root.imag(),
                             high.real() * root.imag() + high.imag() * root.real());
        high = low - turned;
        low += turned;
      }
  }
}

/// Not std::abs(), whose last bits depend on the C library's cabs().
double magnitude(const Complex& value) {
  return math::hypot(value.real(), value.imag());
}

}  // namespace

std::vector<double> magnitude_spectrum(const std::vector<double>& signal, std::size_t size) {
  std::vector<Complex> data(size);
  for (std::size_t i = 0; i < signal.size(); ++i) data[i] = signal[i];
  transform(data);
  std::vector<double> magnitudes(size / 2 + 1);
  for (std::size_t k = 0; k < magnitudes.size(); ++k) magnitudes[k] = magnitude(data[k % size]);
  return magnitudes;
}

}  // namespace slalom
