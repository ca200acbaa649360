// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/statistics.h>

#include <cstddef>
#include <vector>

namespace slalom {

/// A test of the mean of bounded values that is valid however often one looks. A bettor bets
/// against the hypothesis "the mean of the next value, whatever came before, is at most `null`" and
/// never stakes more than there is. Under the hypothesis the wealth, 1 at first, is a nonnegative
/// supermartingale: it ever reaches 1 / level with a probability of at most `level` (Ville 1939).
///
/// A value x multiplies the wealth by 1 + stake (x - null) (Waudby-Smith and Ramdas 2024, J. R.
/// Stat. Soc. B 86:1-27, section 4). The stake is effect / (mean square of x - null so far), which
/// lets the wealth grow fastest when the mean is null + effect (Kelly 1956), at most what keeps
/// half of the wealth. The mean square begins as that of kPriorValues values of half the bound.
class BettingTest {
 public:
  /// Values are in [-bound, bound]. effect < 0 tests "the mean is at least `null`". Requires
  /// bound > 0, effect != 0.
  BettingTest(double null, double effect, double bound);

  void add(double value);

  double log_wealth() const { return log_wealth_; }      ///< an e-value
  double log_evidence() const { return log_evidence_; }  ///< the largest wealth so far
  double p() const;                                      ///< valid at any time: 1 / evidence

  static constexpr double kPriorValues = 10;

 private:
  double null_, effect_, bound_;  ///< the bound is that of value - null
  double values_ = kPriorValues, squares_;
  double log_wealth_ = 0, log_evidence_ = 0;
};

/// Bounds of the mean of values in [low, high] that are valid however often one looks: the means
/// that a BettingTest with this effect, at (1 - confidence) / 2, does not show to be exceeded, or
/// not to be reached. Both bounds hold with a probability of at least `confidence`. Outward by at
/// most 1e-4 of high - low.
Interval betting_interval(const std::vector<double>& values, double low, double high, double effect,
                          double confidence);

}  // namespace slalom
