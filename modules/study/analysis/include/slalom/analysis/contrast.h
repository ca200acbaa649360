// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/value.h>
#include <slalom/statistics/rank_statistics.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// A quantity in a group and in a reference group, matched: pair i is group[i] with reference[i].
struct MatchedValues {
  QuantityInfo quantity;
  std::vector<double> group, reference;
};

/// How a quantity differs between the two groups.
struct Contrast {
  QuantityInfo quantity;
  std::size_t pairs = 0, higher = 0, lower = 0;  ///< pairs by the sign of group - reference
  Interval group, reference;                     ///< lower to upper quartile (linear, type 7)
  Shift difference;                              ///< Hodges-Lehmann, of group - reference
  double p = 1;                                  ///< Wilcoxon's signed-rank test
  double adjusted_p = 1;                         ///< by Holm, over the contrasts of the same call
  /// The adjusted test rejects at the level of the confidence, and the interval of the difference
  /// excludes 0.
  bool holds = false;
};

/// The contrasts of all quantities with at least one pair, as one family: those that hold first, by
/// adjusted p, then in the order given. Requires groups of equal size.
std::vector<Contrast> contrast_matched(const std::vector<MatchedValues>& values, double confidence);

/// The number of pairs below which no contrast of a family of so many can hold: the signed-rank
/// test of n pairs has p >= 2^(1 - n).
std::size_t min_pairs_to_hold(std::size_t family, double confidence);

/// "14 of 15 have a higher Density than their REFERENCE: 0.12 to 0.2, REFERENCE 0.02 to 0.05
/// (quartiles); difference 0.11 [0.09, 0.13], p 0.004", numbers to three significant digits.
std::string contrast_sentence(const Contrast& contrast, const std::string& reference);

}  // namespace slalom
