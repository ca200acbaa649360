// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/rank_statistics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

/// Depression scores of nine patients before and after a tranquilizer: Hollander and Wolfe,
/// "Nonparametric Statistical Methods", table 3.1 (also in R's ?wilcox.test).
const std::vector<double> kBefore = {1.83, 0.50, 1.62, 2.48, 1.68, 1.88, 1.55, 3.06, 1.30};
const std::vector<double> kAfter = {0.878, 0.647, 0.598, 2.05, 1.06, 1.29, 1.06, 3.14, 1.29};

std::vector<double> differences(const std::vector<double>& a, const std::vector<double>& b) {
  std::vector<double> d;
  for (std::size_t i = 0; i < a.size(); ++i) d.push_back(a[i] - b[i]);
  return d;
}

/// Values with many ties and zeros.
std::vector<double> coarse_values(RandomEngine& engine, int n) {
  std::vector<double> values;
  for (int i = 0; i < n; ++i) values.push_back(uniform_int(engine, -3, 4));
  return values;
}

TEST(RankStatistics, TiesShareTheMeanOfTheirRanks) {
  EXPECT_EQ(midranks({5, 1, 5, 0}), (std::vector<double>{3.5, 2, 3.5, 1}));
  EXPECT_TRUE(midranks({}).empty());
}

TEST(RankStatistics, SignedRankTestAgreesWithHollanderAndWolfe) {
  // V = 40; one-sided P = .0195 there, so twice that: 10 / 2^9 on either side.
  const SignedRankTest test = signed_rank_test(differences(kBefore, kAfter));
  EXPECT_EQ(test.n, 9u);
  EXPECT_DOUBLE_EQ(test.statistic, 40);
  EXPECT_DOUBLE_EQ(test.p, 2 * 10 / 512.0);
  EXPECT_TRUE(test.exact);
}

TEST(RankStatistics, HodgesLehmannShiftAgreesWithHollanderAndWolfe) {
  // Estimate .46 and the interval [.010, .786] of their example 3.4, of confidence .961.
  const Shift shift = hodges_lehmann(differences(kBefore, kAfter), 0.95);
  EXPECT_NEAR(shift.estimate, 0.46, 1e-12);
  EXPECT_NEAR(shift.interval->low, 0.010, 1e-12);
  EXPECT_NEAR(shift.interval->high, 0.786, 1e-12);
}

TEST(RankStatistics, ExactSignedRankTestEnumeratesAllSigns) {
  RandomEngine engine(2);
  for (int round = 0; round < 40; ++round) {
    const std::vector<double> d = coarse_values(engine, uniform_int(engine, 1, 11));
    const SignedRankTest test = signed_rank_test(d);
    std::vector<double> sizes;
    for (const double x : d)
      if (x != 0) sizes.push_back(std::abs(x));
    const std::vector<double> ranks = midranks(sizes);
    int below = 0, above = 0;
    const unsigned signs_end = 1U << ranks.size();
    for (unsigned signs = 0; signs < signs_end; ++signs) {
      double sum = 0;
      for (std::size_t i = 0; i < ranks.size(); ++i) sum += (signs >> i) % 2 == 1 ? ranks[i] : 0;
      below += sum <= test.statistic ? 1 : 0;
      above += sum >= test.statistic ? 1 : 0;
    }
    EXPECT_NEAR(test.p, std::min(1.0, 2.0 * std::min(below, above) / signs_end), 1e-12);
    EXPECT_EQ(test.zeros + test.n, d.size());
  }
}

TEST(RankStatistics, SignedRankTestFindsTiesAndZerosOfDecimalValues) {
  // 0.1 + 0.2 is not 0.3 as a double, and 0.1 + 0.2 - 0.3 is not 0: what is meant is 0.3 against
  // -0.3, 0.1, 0.4, and no difference.
  const std::vector<double> d = {0.1 + 0.2, -0.3, 0.1, -0.4, 0.6, 0.1 + 0.2 - 0.3};
  const std::vector<double> meant = {3, -3, 1, -4, 6, 0};
  const SignedRankTest test = signed_rank_test(d), exact = signed_rank_test(meant);
  EXPECT_EQ(test.zeros, 1u);
  EXPECT_EQ(test.statistic, exact.statistic);  // 2.5 + 1 + 5
  EXPECT_EQ(test.statistic, 8.5);
  EXPECT_EQ(test.p, exact.p);
  // Differences that are small beside each other stay apart.
  EXPECT_EQ(signed_rank_test({1e-6, -2e-6, 1}).statistic, 4);
}

TEST(RankStatistics, NormalApproximationAgreesWithTheExactTest) {
  RandomEngine engine(4);
  std::vector<double> d;
  for (int i = 0; i < 100; ++i) d.push_back(normal(engine, 0.25, 1));
  const SignedRankTest exact = signed_rank_test(d);
  d.push_back(0.01);  // the lowest rank: the statistic hardly changes
  const SignedRankTest approximate = signed_rank_test(d);
  EXPECT_TRUE(exact.exact);
  EXPECT_FALSE(approximate.exact);
  EXPECT_NEAR(approximate.p, exact.p, 0.05 * exact.p + 1e-4);
}

TEST(RankStatistics, SignedRankTestOfNoDifferenceIsOne) {
  EXPECT_EQ(signed_rank_test({0, 0, 0}).p, 1);
  EXPECT_EQ(signed_rank_test({0, 0, 0}).n, 0u);
  EXPECT_EQ(signed_rank_test({}).p, 1);
}

TEST(RankStatistics, ShiftOfManyDifferencesEqualsThatOfAllPairs) {
  RandomEngine engine(6);
  std::vector<double> d;
  for (int i = 0; i < 2200; ++i) d.push_back(normal(engine, 1, 2));
  std::vector<double> means;
  for (std::size_t i = 0; i < d.size(); ++i)
    for (std::size_t j = i; j < d.size(); ++j) means.push_back((d[i] + d[j]) / 2);
  const auto middle = means.begin() + static_cast<std::ptrdiff_t>((means.size() - 1) / 2);
  std::nth_element(means.begin(), middle, means.end());
  EXPECT_NEAR(hodges_lehmann(d, 0.95).estimate, *middle, 1e-6);
}

TEST(RankStatistics, IntervalOfTheShiftHasNominalCoverage) {
  RandomEngine engine(8);
  for (const int n : {8, 30, 150}) {
    int covered = 0;
    const int trials = 400;
    for (int trial = 0; trial < trials; ++trial) {
      std::vector<double> d;
      for (int i = 0; i < n; ++i) d.push_back(normal(engine, 0.7, 1));
      const Interval interval = *hodges_lehmann(d, 0.95).interval;
      covered += interval.low <= 0.7 && 0.7 <= interval.high ? 1 : 0;
    }
    EXPECT_GT(covered, 0.92 * trials) << n;  // 0.95 less three standard deviations of 1.1 %
    EXPECT_LT(covered, 0.99 * trials) << n;
  }
}

TEST(RankStatistics, FiveDifferencesAreTooFewForAnInterval) {
  EXPECT_FALSE(hodges_lehmann({1, 2, 3, 4, 5}, 0.95).interval);  // 2 / 2^5 > 0.05
  EXPECT_TRUE(hodges_lehmann({1, 2, 3, 4, 5, 6}, 0.95).interval);
}

TEST(RankStatistics, SuperiorityAgreesWithHollanderAndWolfe) {
  // Permeability constants, their table 4.1: the Mann-Whitney statistic is 35 of 10 x 5 pairs.
  const std::vector<double> term = {0.80, 0.83, 1.89, 1.04, 1.45, 1.38, 1.91, 1.64, 0.73, 1.46};
  const std::vector<double> week = {1.15, 0.88, 0.90, 0.74, 1.21};
  EXPECT_DOUBLE_EQ(probability_of_superiority(term, week), 0.7);
}

TEST(RankStatistics, SuperiorityCountsPairs) {
  RandomEngine engine(10);
  for (int round = 0; round < 20; ++round) {
    const auto a = coarse_values(engine, uniform_int(engine, 1, 12));
    const auto b = coarse_values(engine, uniform_int(engine, 1, 12));
    double wins = 0;
    for (const double x : a)
      for (const double y : b) wins += x > y ? 1 : x == y ? 0.5 : 0;
    const double pairs = static_cast<double>(a.size() * b.size());
    EXPECT_NEAR(probability_of_superiority(a, b), wins / pairs, 1e-12);
  }
}

TEST(RankStatistics, SpearmanAgreesWithPublishedExamples) {
  // Intelligence and hours of television: -29 / 165 ("Spearman's rank correlation coefficient",
  // Wikipedia, 1 - 6 x 194 / (10 x 99)).
  const auto iq = spearman({106, 100, 86, 101, 99, 103, 97, 113, 112, 110},
                           {7, 27, 2, 50, 28, 29, 20, 12, 6, 17}, 0.95);
  EXPECT_NEAR(*iq.rho, -29.0 / 165, 1e-12);
  // Hunter L and panel scores of tuna, Hollander and Wolfe table 8.1 (R's ?cor.test): S = 48.
  const auto tuna = spearman({44.4, 45.9, 41.9, 53.3, 44.7, 44.1, 50.7, 45.2, 60.1},
                             {2.6, 3.1, 2.5, 5.0, 3.6, 4.0, 5.2, 2.8, 3.8}, 0.95);
  EXPECT_NEAR(*tuna.rho, 1 - 6.0 * 48 / (9 * 80), 1e-12);
  // tanh(atanh(0.6) +- 1.959964 sqrt((1 + 0.18) / 6)) = tanh(0.693147 +- 0.869183).
  EXPECT_NEAR(tuna.interval->low, std::tanh(0.693147 - 0.869183), 1e-5);
  EXPECT_NEAR(tuna.interval->high, std::tanh(0.693147 + 0.869183), 1e-5);
}

TEST(RankStatistics, KendallCountsPairsInTheSameOrder) {
  // Five of six pairs are in the same order.
  EXPECT_DOUBLE_EQ(*kendall_tau({1, 2, 3, 4}, {1, 2, 4, 3}), 4.0 / 6);
  EXPECT_DOUBLE_EQ(*kendall_tau({1, 2, 3}, {9, 8, 7}), -1);
  // Two of three pairs are in the same order, the third is tied in x: 2 / sqrt(2 * 3).
  EXPECT_DOUBLE_EQ(*kendall_tau({1, 1, 2}, {1, 2, 3}), 2 / std::sqrt(6.0));
  EXPECT_FALSE(kendall_tau({1, 1, 1}, {1, 2, 3}));
}

TEST(RankStatistics, SpearmanIsUndefinedForConstantsAndFewValues) {
  EXPECT_FALSE(spearman({1, 1, 1, 1}, {1, 2, 3, 4}, 0.95).rho);
  EXPECT_FALSE(spearman({1, 2}, {1, 2}, 0.95).rho);
  EXPECT_EQ(*spearman({1, 2, 3, 4}, {10, 20, 30, 40}, 0.95).rho, 1);
}

TEST(RankStatistics, SpearmanIntervalHasNominalCoverage) {
  // Bivariate normal values with correlation r have rho = 6 / pi asin(r / 2) (Pearson 1907).
  RandomEngine engine(12);
  const double r = 0.5, truth = 6 / M_PI * std::asin(r / 2);
  int covered = 0;
  const int trials = 600;
  for (int trial = 0; trial < trials; ++trial) {
    std::vector<double> x, y;
    for (int i = 0; i < 40; ++i) {
      x.push_back(normal(engine, 0, 1));
      y.push_back(r * x.back() + std::sqrt(1 - r * r) * normal(engine, 0, 1));
    }
    const Interval interval = *spearman(x, y, 0.95).interval;
    covered += interval.low <= truth && truth <= interval.high ? 1 : 0;
  }
  EXPECT_GT(covered, 0.92 * trials);
  EXPECT_LT(covered, 0.98 * trials);
}

}  // namespace
}  // namespace slalom
