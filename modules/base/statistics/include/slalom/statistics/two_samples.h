// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/rank_statistics.h>
#include <slalom/statistics/statistics.h>

#include <cstddef>
#include <optional>
#include <vector>

namespace slalom {

/// Two-sided p value of Fisher's exact test (1935) of two independent rates: the probability,
/// given the margins, of all tables that are at most as probable as this one, with R's tolerance
/// of 1e-7 for equal ones.
double fisher_exact(std::size_t successes_a, std::size_t n_a, std::size_t successes_b,
                    std::size_t n_b);

/// The test of Mann and Whitney (1947), also known as Wilcoxon's rank-sum test, two-sided.
struct RankSumTest {
  double statistic = 0;  ///< U: pairs in which a exceeds b, ties counting half
  double p = 1;
  bool exact = true;  ///< the permutation distribution, else the normal approximation
};

/// Exact (ties included: the distribution over all divisions of the given midranks) up to 100
/// values together; beyond, the normal approximation with corrections for continuity and ties.
/// Requires a value on each side.
RankSumTest rank_sum_test(const std::vector<double>& a, const std::vector<double>& b);

/// The corresponding estimate: the Hodges-Lehmann median of all differences of a value of `a` and
/// one of `b`, with Moses' interval by the normal approximation of the number of pairs (Hollander
/// and Wolfe 1999, 4.3). Requires nonempty samples.
Shift rank_sum_shift(const std::vector<double>& a, const std::vector<double>& b, double confidence);

/// Welch's (1947) interval of mean(a) - mean(b) of independent samples with different variances.
/// None for fewer than two values on a side, and if both are constant.
std::optional<Interval> welch_interval(const std::vector<double>& a, const std::vector<double>& b,
                                       double confidence);

/// The smallest size of two equal samples for which both tests can reach p <= `alpha`: the most
/// unequal ones have p = 2 / (2n over n).
std::size_t min_per_sample(double alpha);

}  // namespace slalom
