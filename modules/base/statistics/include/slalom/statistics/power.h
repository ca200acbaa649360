// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>

namespace slalom {

/// Power of a two-sided one-sample t test at level `alpha` for `n` paired differences with standard
/// deviation `deviation` and true mean `relevant` (noncentral t). 0 for n < 2; requires
/// deviation > 0.
double paired_t_power(double n, double relevant, double deviation, double alpha);

/// The smallest number of paired differences with at least that power, from 2 to 10 million.
/// Requires relevant > 0, deviation > 0.
std::size_t required_pairs(double relevant, double deviation, double alpha, double power);

/// The smallest number of nonzero differences for which an exact signed-rank or McNemar test can
/// reach p <= `alpha`: n differences of equal sign have p = 2^(1 - n).
std::size_t min_pairs(double alpha);

}  // namespace slalom
