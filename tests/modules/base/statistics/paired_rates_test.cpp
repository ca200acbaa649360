// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/paired_rates.h>

#include <gtest/gtest.h>

#include <tuple>

namespace slalom {
namespace {

TEST(RateTests, McNemarAgreesWithFagerlandLydersenAndLaake2013) {
  // "The McNemar test for binary matched-pairs data", tables 1 and 2 and the exact conditional
  // tests of them: discordant pairs 1 and 7, P = 0.0703; 6 and 16, P = 0.0525.
  EXPECT_NEAR(mcnemar_exact(1, 7), 0.0703, 5e-5);
  EXPECT_NEAR(mcnemar_exact(16, 6), 0.0525, 5e-5);
}

TEST(RateTests, McNemarIsTheBinomialTailProbability) {
  for (unsigned b = 0; b <= 6; ++b) {
    for (unsigned c = 0; b + c <= 10; ++c) {
      const unsigned n = b + c;
      int below = 0, above = 0;
      for (unsigned tosses = 0; tosses < 1U << n; ++tosses) {
        const auto heads = static_cast<unsigned>(__builtin_popcount(tosses));
        below += heads <= b ? 1 : 0;
        above += heads >= b ? 1 : 0;
      }
      const double p = std::min(1.0, 2.0 * std::min(below, above) / (1U << n));
      EXPECT_NEAR(mcnemar_exact(b, c), p, 1e-12) << b << " " << c;
    }
  }
}

TEST(RateTests, RateDifferenceAgreesWithNewcombe1998) {
  // "Interval estimation for the difference between independent proportions", table II, method 10.
  const struct {
    double a, m, b, n, low, high;
  } published[] = {{56, 70, 48, 80, 0.0524, 0.3339},
                   {9, 10, 3, 10, 0.1705, 0.8090},
                   {10, 10, 0, 10, 0.6075, 1.0000}};
  for (const auto& row : published) {
    const Interval interval =
        rate_difference_interval(row.a / row.m, row.m, row.b / row.n, row.n, 0, 0.95);
    EXPECT_NEAR(interval.low, row.low, 5e-5);
    EXPECT_NEAR(interval.high, row.high, 5e-5);
  }
}

/// Rates of 0 and 1: `both` pairs in which both sides succeeded, and so on.
Interval paired_interval(int both, int only_a, int only_b, int none) {
  std::vector<double> a, b;
  for (const auto& [n, value_a, value_b] :
       {std::tuple(both, 1, 1), {only_a, 1, 0}, {only_b, 0, 1}, {none, 0, 0}}) {
    a.insert(a.end(), n, value_a);
    b.insert(b.end(), n, value_b);
  }
  return paired_rate_interval(a, b, 0.95);
}

TEST(RateTests, PairedRateDifferenceIsNewcombesMethod8) {
  // Wilson's limits of 45/50 and 30/50 by hand: [0.7864, 0.9565], [0.4618, 0.7239]; of the pairs
  // 28, 17, 2, 3: phi = (28 3 - 17 2) / sqrt(45 5 30 20) = 50 / 367.4 = 0.1361 as it is. Method 10
  // would take (50 - 25) / 367.4 = 0.0680 and be wider: [0.1377, 0.4457].
  const Interval interval = paired_interval(28, 17, 2, 3);
  EXPECT_NEAR(interval.low, 0.1437, 5e-5);
  EXPECT_NEAR(interval.high, 0.4420, 5e-5);
}

TEST(RateTests, PairedIntervalHasNonzeroWidthAndStaysInItsRange) {
  const std::vector<double> ones(5, 1.0), zeros(5, 0.0);
  const Interval same = paired_rate_interval(ones, ones, 0.95);
  EXPECT_LT(same.low, -0.1);
  EXPECT_GT(same.high, 0.1);
  EXPECT_EQ(paired_rate_interval(ones, zeros, 0.95).high, 1);
}

TEST(RateTests, PairedIntervalHasNominalCoverage) {
  RandomEngine engine(3);
  int covered = 0;
  const int trials = 600;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> a, b;
    for (int i = 0; i < 60; ++i) {
      // Rates 0.8 and 0.7, equal in three of four scenarios: the difference is 0.1.
      const double hardness = uniform_real(engine, 0, 1);
      const double other =
          uniform_real(engine, 0, 1) < 0.75 ? hardness : uniform_real(engine, 0, 1);
      a.push_back(hardness < 0.8 ? 1 : 0);
      b.push_back(other < 0.7 ? 1 : 0);
    }
    const Interval interval = paired_rate_interval(a, b, 0.95);
    covered += interval.low <= 0.1 && 0.1 <= interval.high ? 1 : 0;
  }
  EXPECT_GT(covered, 0.92 * trials);
  EXPECT_LT(covered, 0.99 * trials);
}

TEST(RateTests, PairedIntervalsOfFewMeansContainTheDifference) {
  // Two methods with the same success in each scenario, which differs from scenario to scenario.
  RandomEngine engine(5);
  for (const int scenarios : {2, 3, 4, 5, 6, 10}) {
    int covered = 0;
    const int trials = 500, runs = 3;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> a, b;
      for (int i = 0; i < scenarios; ++i) {
        const double success = uniform_real(engine, 0, 1);
        for (std::vector<double>* side : {&a, &b}) {
          int reached = 0;
          for (int run = 0; run < runs; ++run) reached += uniform_real(engine, 0, 1) < success;
          side->push_back(static_cast<double>(reached) / runs);
        }
      }
      const Interval interval = paired_rate_interval(a, b, 0.95);
      covered += interval.low <= 0 && 0 <= interval.high;
    }
    EXPECT_GT(covered, 0.92 * trials) << scenarios;
  }
}

TEST(RateTests, HolmAgreesWithAWorkedExample) {
  // P values 0.01, 0.04, 0.03, 0.005 at 0.05: the first and the last are rejected ("Holm-Bonferroni
  // method", Wikipedia). 4 x 0.005, 3 x 0.01, 2 x 0.03, and 0.04 no less than that.
  const std::vector<double> adjusted = holm_adjusted({0.01, 0.04, 0.03, 0.005});
  const std::vector<double> expected = {0.03, 0.06, 0.06, 0.02};
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_NEAR(adjusted[i], expected[i], 1e-12);
  EXPECT_EQ(holm_adjusted({0.9, 0.8})[1], 1);
  EXPECT_TRUE(holm_adjusted({}).empty());
}

TEST(RateTests, HolmControlsTheFamilywiseErrorRate) {
  // Eight true null hypotheses: a rejection in at most 5 % of families.
  RandomEngine engine(5);
  int wrong = 0;
  for (int family = 0; family < 4000; ++family) {
    std::vector<double> p;
    for (int i = 0; i < 8; ++i) p.push_back(uniform_real(engine, 0, 1));
    for (const double adjusted : holm_adjusted(p))
      if (adjusted <= 0.05) {
        ++wrong;
        break;
      }
  }
  EXPECT_NEAR(wrong / 4000.0, 0.05, 0.012);  // 0.049 is exact, 3 standard deviations 0.010
}

}  // namespace
}  // namespace slalom
