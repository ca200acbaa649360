#pragma once

#include <cstddef>
#include <vector>

namespace slalom {

/// Magnitudes of the discrete Fourier transform of a real signal, padded with zeros to `size`, a
/// power of two not below the signal's: of the frequencies 0 .. size / 2.
std::vector<double> magnitude_spectrum(const std::vector<double>& signal, std::size_t size);

}  // namespace slalom
