// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/statistics.h>

#include <optional>
#include <vector>

namespace slalom {

/// Values that differ by no more than this fraction of the largest one at hand are equal: decimal
/// values are rounded when they are stored as doubles and once more by sums, so that 0.1 + 0.2 -
/// 0.3 is 6e-17.
constexpr double kTieTolerance = 1e-12;

/// kTieTolerance times the largest magnitude of `values`.
double tie_tolerance(const std::vector<double>& values);

/// Ranks from 1, in the order of `values`; equal values share the mean of their ranks. Equal to the
/// least of a group are those that exceed it by no more than `tolerance`.
std::vector<double> midranks(const std::vector<double>& values, double tolerance = 0);

/// Sum of t^3 - t over all groups of t equal ranks, for corrections of tests for ties.
double sum_of_tie_terms(const std::vector<double>& ranks);

/// Wilcoxon's signed-rank test of paired differences (Wilcoxon 1945), two-sided.
struct SignedRankTest {
  std::size_t n = 0;      ///< nonzero differences; zeros are dropped, as by Wilcoxon
  std::size_t zeros = 0;  ///< dropped
  double statistic = 0;   ///< sum of the midranks of positive differences
  double p = 1;           ///< 1 if n is 0
  bool exact = true;      ///< the permutation distribution, else the normal approximation
};

/// Exact (ties included: the distribution over all signs of the given midranks) up to 100 nonzero
/// differences; beyond, the normal approximation with corrections for continuity and ties.
/// Differences are zero or tied within a tolerance: by default that of the differences; that of the
/// values which were subtracted is the right one where they are at hand.
SignedRankTest signed_rank_test(const std::vector<double>& differences, double tolerance);
SignedRankTest signed_rank_test(const std::vector<double>& differences);

/// The corresponding estimate of location: the Hodges-Lehmann median of all pairwise means
/// (including each difference with itself, zeros kept), with Tukey's interval (Hollander and Wolfe
/// 1999, 3.3).
struct Shift {
  double estimate = 0;
  std::optional<Interval> interval;  ///< none if n is too small for the confidence
};

/// Requires at least one difference.
Shift hodges_lehmann(const std::vector<double>& differences, double confidence);

/// Probability that a value of `a` exceeds one of `b`, ties counting half: A12 of Vargha and
/// Delaney (2000). 0.5: no tendency. Requires nonempty samples.
double probability_of_superiority(const std::vector<double>& a, const std::vector<double>& b);

/// Kendall's tau-b (Kendall 1945): pairs in the same order less those in the opposite one, over the
/// geometric mean of the numbers of pairs that are not tied on either side; values within the tie
/// tolerance are tied. None if all are tied on a side. Requires equal sizes.
std::optional<double> kendall_tau(const std::vector<double>& x, const std::vector<double>& y);

/// Indices of `values` from the least to the largest one; equal ones keep their order.
std::vector<std::size_t> ascending_order(const std::vector<double>& values);

/// A correlation of two orders that would be found, by noise alone, if both were truly the same: a
/// correlation within the interval does not show that the orders differ. One below it is a hint
/// only, since measured values are spread more than true ones: of four equal methods in 50
/// scenarios one in eight is.
struct NoiseCeiling {
  double mean = 0;
  Interval interval;  ///< percentiles
};

/// The ceiling by resampled correlations of measurements with the same true order; none without
/// any.
std::optional<NoiseCeiling> noise_ceiling(std::vector<double> correlations, double confidence);

/// Pearson's correlation; none if a side is constant. Requires equal sizes of at least one.
std::optional<double> pearson(const std::vector<double>& x, const std::vector<double>& y);

/// A rank correlation.
struct RankCorrelation {
  std::size_t n = 0;
  std::optional<double> rho;         ///< none if n < 3 or one side is constant
  std::optional<Interval> interval;  ///< none if n < 4
};

/// Spearman's rho: Pearson's correlation of the midranks. Interval: Fisher's z with the variance
/// (1 + rho^2 / 2) / (n - 3) of Bonett and Wright (2000). Requires equal sizes.
RankCorrelation spearman(const std::vector<double>& x, const std::vector<double>& y,
                         double confidence);

}  // namespace slalom
