// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace slalom {

/// Magnitudes of the discrete Fourier transform of a real signal at the frequencies 0 .. size / 2.
/// The signal is zero-padded to `size`, a power of two not below its own size.
std::vector<double> magnitude_spectrum(const std::vector<double>& signal, std::size_t size);

}  // namespace slalom
