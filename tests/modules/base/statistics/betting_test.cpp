// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/betting.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace slalom {
namespace {

/// Wealth of half in a bettor on `effect` and half in equal parts in 20 of constant stakes, each on
/// its own, of values in [-1, 1] against a mean of at most 0.
double wealth_of_separate_bettors(const std::vector<double>& values, double effect) {
  double of_effect = 1, squares = 10 * 0.25, n = 10;
  for (const double value : values) {
    of_effect *= 1 + std::min(effect * n / squares, 0.5) * value;
    squares += value * value;
    ++n;
  }
  double constant = 0;
  for (int i = 0; i < 20; ++i) {
    double wealth = 1;
    for (const double value : values) wealth *= 1 + std::sin(M_PI / 2 * (i + 0.5) / 20) * value;
    constant += wealth / 20;
  }
  return of_effect / 2 + constant / 2;
}

TEST(BettingTest, HasTheWealthOfABettorOnTheEffectAndOfTwentyConstantStakes) {
  RandomEngine engine(3);
  std::vector<double> values;
  BettingTest test(0, 0.1, 1);
  double most = 1;
  for (int i = 0; i < 300; ++i) {
    values.push_back(uniform_real(engine, -0.6, 1));
    test.add(values.back());
    const double wealth = wealth_of_separate_bettors(values, 0.1);
    most = std::max(most, wealth);
    ASSERT_NEAR(test.log_wealth(), std::log(wealth), 1e-11) << i;
    ASSERT_NEAR(test.p() * most, 1, 1e-11) << i;
  }
}

TEST(BettingTest, KeepsAQuarterOfTheWealthAtTheLargestLossWhateverTheEffect) {
  BettingTest test(0.5, 100, 1);  // gains are at least -1.5
  test.add(-1);
  EXPECT_GT(test.log_wealth(), std::log(0.25));
}

TEST(BettingTest, OfTheOppositeHypothesisIsItsMirrorImage) {
  BettingTest above(0.1, 0.2, 1), below(-0.1, -0.2, 1);
  for (const double value : {0.3, -0.8, 1.0, 0.0, 0.5}) {
    above.add(value);
    below.add(-value);
    EXPECT_EQ(above.log_wealth(), below.log_wealth());
  }
}

/// The mean of the wealth after `values` more values, over all sequences of 1 (with probability
/// `chance`) and -1.
double expected_wealth(BettingTest test, double chance, int values) {
  if (values == 0) return std::exp(test.log_wealth());
  BettingTest win = test, loss = test;
  win.add(1);
  loss.add(-1);
  return chance * expected_wealth(win, chance, values - 1) +
         (1 - chance) * expected_wealth(loss, chance, values - 1);
}

TEST(BettingTest, IsAFairGameAtTheBorderOfTheHypothesisAndALosingOneBelow) {
  for (const double null : {-0.4, 0.0, 0.2}) {
    const BettingTest test(null, 0.1, 1);
    EXPECT_NEAR(expected_wealth(test, (1 + null) / 2, 12), 1, 1e-12) << null;
    EXPECT_LT(expected_wealth(test, (1 + null) / 2 - 0.05, 12), 1) << null;
    EXPECT_GT(expected_wealth(test, (1 + null) / 2 + 0.05, 12), 1) << null;
  }
}

/// A scan of all means in steps finds the same bounds as the bisection, and nothing beyond them.
TEST(BettingInterval, HoldsTheMeansThatAreNotRejected) {
  std::vector<double> values;
  for (int i = 0; i < 200; ++i) values.push_back(i % 7 < 2 ? 1 : i % 10 == 9 ? -1 : 0);
  const Interval interval = betting_interval(values, -1, 1, 0.1, 0.95);
  for (int i = -1000; i <= 1000; ++i) {
    const double mean = i * 1e-3;
    BettingTest above(mean, 0.1, 1), below(mean, -0.1, 1);
    for (const double value : values) {
      above.add(value);
      below.add(value);
    }
    EXPECT_TRUE(above.p() <= 0.025 ? mean <= interval.low + 2e-4 : mean >= interval.low) << mean;
    EXPECT_TRUE(below.p() <= 0.025 ? mean >= interval.high - 2e-4 : mean <= interval.high) << mean;
  }
}

TEST(BettingInterval, OfRatesIsTheMirrorImageOfThatOfFailures) {
  std::vector<double> successes, failures;
  for (int i = 0; i < 300; ++i) {
    successes.push_back(i % 10 == 0 ? 0 : 1);
    failures.push_back(1 - successes.back());
  }
  const Interval success = betting_interval(successes, 0, 1, 0.1, 0.95);
  const Interval failure = betting_interval(failures, 0, 1, 0.1, 0.95);
  EXPECT_NEAR(success.low, 1 - failure.high, 1e-12);
  EXPECT_NEAR(success.high, 1 - failure.low, 1e-12);
  EXPECT_LT(success.low, 0.9);
  EXPECT_GT(success.high, 0.9);
  EXPECT_LT(success.high - success.low, 0.15);
}

}  // namespace
}  // namespace slalom
