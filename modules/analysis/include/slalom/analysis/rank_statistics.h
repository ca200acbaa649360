#pragma once

#include <slalom/analysis/statistics.h>

#include <optional>
#include <vector>

namespace slalom {

/// Ranks from 1, in the order of `values`; equal values share the mean of their ranks.
std::vector<double> midranks(const std::vector<double>& values);

/// Wilcoxon's signed-rank test of paired differences (Wilcoxon 1945), two-sided.
struct SignedRankTest {
  std::size_t n = 0;      ///< differences that are not zero; zeros are dropped, as Wilcoxon did
  std::size_t zeros = 0;  ///< dropped
  double statistic = 0;   ///< sum of the midranks of positive differences
  double p = 1;           ///< 1 where n is 0
  bool exact = true;      ///< the permutation distribution, else the normal approximation
};

/// Exact (ties included: the distribution over all signs of the given midranks) up to 100 nonzero
/// differences; beyond, the normal approximation with corrections for continuity and ties.
SignedRankTest signed_rank_test(const std::vector<double>& differences);

/// The shift that belongs to it: Hodges and Lehmann's median of all pairwise means (each difference
/// with itself too, zeros kept), with the interval of Tukey (Hollander and Wolfe 1999, 3.3).
struct Shift {
  double estimate = 0;
  std::optional<Interval> interval;  ///< none where n is too small for the confidence
};

/// Requires at least one difference.
Shift hodges_lehmann(const std::vector<double>& differences, double confidence);

/// Probability that a value of `a` exceeds one of `b`, ties counting half: Vargha and Delaney's
/// (2000) A12. 0.5: no tendency. Requires a value in each.
double probability_of_superiority(const std::vector<double>& a, const std::vector<double>& b);

/// A rank correlation.
struct RankCorrelation {
  std::size_t n = 0;
  std::optional<double> rho;         ///< none where n < 3 or one side is constant
  std::optional<Interval> interval;  ///< none where n < 4
};

/// Spearman's rho: Pearson's correlation of the midranks. Interval: Fisher's z with the variance
/// (1 + rho^2 / 2) / (n - 3) of Bonett and Wright (2000). Requires equal sizes.
RankCorrelation spearman(const std::vector<double>& x, const std::vector<double>& y,
                         double confidence);

}  // namespace slalom
