#pragma once

#include <cstddef>

namespace slalom {

/// Probability that a two-sided one-sample t test at level `alpha` of `n` paired differences with
/// standard deviation `deviation` shows a true mean difference of `relevant` (noncentral t). 0
/// below two differences; requires deviation > 0.
double paired_t_power(double n, double relevant, double deviation, double alpha);

/// The smallest number of paired differences with which that probability reaches `power`; at least
/// 2. Requires relevant > 0, deviation > 0; at most 10 million.
std::size_t pairs_needed(double relevant, double deviation, double alpha, double power);

/// The fewest nonzero differences with which an exact signed-rank or McNemar test can come to a p
/// value of at most `alpha`: all of one sign has 2^(1 - n).
std::size_t fewest_pairs(double alpha);

}  // namespace slalom
