// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/statistics/statistics.h>

#include <array>
#include <cstddef>
#include <vector>

namespace slalom {

/// A test of the mean of bounded values that is valid however often one looks. A bettor bets
/// against the hypothesis "the mean of the next value, whatever came before, is at most `null`" and
/// never stakes more than there is. Under the hypothesis the wealth, 1 at first, is a nonnegative
/// supermartingale: it ever reaches 1 / level with a probability of at most `level` (Ville 1939).
///
/// A value x multiplies the wealth by 1 + stake (x - null) (Waudby-Smith and Ramdas 2024, J. R.
/// Stat. Soc. B 86:1-27, section 4). Half of the wealth is bet with effect / (mean square of x -
/// null so far), which lets it grow fastest when the mean is null + effect (Kelly 1956), at most
/// what keeps half of it; the mean square begins as that of kPriorValues values of half the bound.
/// The other half is divided among kStakes constant stakes, between 0 and what could lose all,
/// evenly in their arc sines, and never stalls when the effect is another one (Cover 1991,
/// Mathematical Finance 1:1-29; Orabona and Jun 2024, IEEE Trans. Inf. Theory 70:436-455).
///
/// With a `population` the hypothesis is about the mean of that many values, which are drawn
/// without replacement: the mean of those that are left follows from it and from the values so far
/// (Waudby-Smith and Ramdas 2020, NeurIPS 33), until they could not have it and `p` is 0.
class BettingTest {
 public:
  /// Values are in [-bound, bound]. effect < 0 tests "the mean is at least `null`"; population = 0:
  /// values are independent of each other. Requires bound > 0, effect != 0, at most `population`
  /// values.
  BettingTest(double null, double effect, double bound, std::size_t population = 0);

  void add(double value);

  double log_wealth() const { return log_wealth_; }      ///< an e-value
  double log_evidence() const { return log_evidence_; }  ///< the largest wealth so far
  double p() const;                                      ///< valid at any time: 1 / evidence

  static constexpr double kPriorValues = 10;
  static constexpr std::size_t kStakes = 20;

 private:
  /// Whether some values of those that are left give the hypothesis.
  bool is_possible() const;

  double null_, effect_, bound_, population_;
  double values_ = 0, sum_ = 0, squares_;
  double log_wealth_ = 0, log_evidence_ = 0;
  double of_effect_ = 0.5;              ///< part of the wealth that the effect has earned
  std::array<double, kStakes> shares_;  ///< parts of the constant stakes; 1 with `of_effect_`
};

/// Bounds of the mean of values in [low, high] that are valid however often one looks: the means
/// that a BettingTest with this effect, at (1 - confidence) / 2, does not show to be exceeded, or
/// not to be reached. Both bounds hold with a probability of at least `confidence`. Outward by at
/// most 1e-4 of high - low.
Interval betting_interval(const std::vector<double>& values, double low, double high, double effect,
                          double confidence);

}  // namespace slalom
