// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <vector>

namespace slalom {

/// A quantity of the samples of a run, and by how much its linear interpolation may differ.
struct Signal {
  std::vector<double> values;  ///< one per sample
  double tolerance = 0;        ///< in the unit of the values
};

/// Indexes of the samples to keep, in increasing order: the first, the last, `kept`, and those that
/// linear interpolation over the times needs to stay within the tolerances of all signals at all
/// samples. One pass; few more than the fewest possible. Samples whose values are not finite, or
/// not later than the one before, are kept.
std::vector<std::size_t> thin_samples(const std::vector<double>& times,
                                      const std::vector<Signal>& signals, std::size_t kept);

}  // namespace slalom
