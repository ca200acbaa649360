// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/trend.h>
#include <slalom/core/random.h>

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

/// Mean and variance of `statistic` over all distinct arrangements of `labels`.
template <typename Statistic>
std::pair<double, double> over_permutations(std::vector<std::size_t> labels, Statistic statistic) {
  std::sort(labels.begin(), labels.end());
  double n = 0, sum = 0, squares = 0;
  do {
    const double value = statistic(labels);
    ++n;
    sum += value;
    squares += value * value;
  } while (std::next_permutation(labels.begin(), labels.end()));
  return {sum / n, squares / n - sum / n * (sum / n)};
}

TEST(CochranArmitage, FindsTheTrendThatOuterIntervalsMiss) {
  // 86 of 100; T = 23 + 2 * 19 + 3 * 19 - 0.86 * 150 = -11, variance 0.86 * 0.14 * 125 = 15.05.
  const TrendTest test = cochran_armitage({25, 23, 19, 19}, {25, 25, 25, 25});
  EXPECT_NEAR(test.z, -11 / std::sqrt(15.05), 1e-12);
  EXPECT_NEAR(test.p, 0.0046, 0.0001);
}

TEST(CochranArmitage, HasThePermutationVarianceWithoutItsFiniteCorrection) {
  // Four successes among groups of 3, 4 and 2: the permutations' variance has n - 1 for n.
  const std::vector<std::size_t> labels = {0, 0, 0, 1, 1, 1, 1, 2, 2};
  const auto sum_of_scores = [](const std::vector<std::size_t>& order) {
    return static_cast<double>(order[0] + order[1] + order[2] + order[3]);
  };
  const auto [mean, variance] = over_permutations(labels, sum_of_scores);
  const TrendTest test = cochran_armitage({0, 2, 2}, {3, 4, 2});  // a sum of scores of 6
  EXPECT_NEAR(test.z, (6 - mean) / std::sqrt(variance * 8 / 9), 1e-12);
}

TEST(JonckheereTerpstra, HasTheMeanAndTheVarianceOfAllPermutations) {
  const std::vector<double> values = {1, 2, 2, 3, 4, 4, 4, 5};
  const auto pairs_in_order = [&values](const std::vector<std::size_t>& labels) {
    double count = 0;
    for (std::size_t i = 0; i < values.size(); ++i)
      for (std::size_t j = 0; j < values.size(); ++j)
        if (labels[i] < labels[j])
          count += values[i] < values[j] ? 1 : values[i] == values[j] ? 0.5 : 0;
    return count;
  };
  const std::vector<std::size_t> labels = {0, 1, 0, 2, 1, 1, 2, 2};
  const auto [mean, variance] = over_permutations(labels, pairs_in_order);
  const TrendTest test = jonckheere_terpstra({{1, 2}, {2, 4, 4}, {3, 4, 5}});
  EXPECT_NEAR(test.z, (pairs_in_order(labels) - mean) / std::sqrt(variance), 1e-12);
  EXPECT_EQ(test.p, std::erfc(std::abs(test.z) / std::sqrt(2)));
}

RC_GTEST_PROP(JonckheereTerpstra, DependsOnRanksAndChangesSignWithTheOrder, ()) {
  std::vector<std::vector<double>> groups;
  for (std::size_t i = 0; i < 3; ++i) {
    groups.emplace_back();
    for (const int value : *rc::gen::container<std::vector<int>>(8, rc::gen::inRange(0, 6)))
      groups.back().push_back(value);
  }
  const TrendTest test = jonckheere_terpstra(groups);
  auto reversed = groups, cubes = groups;
  std::reverse(reversed.begin(), reversed.end());
  for (auto& group : cubes)
    for (double& value : group) value = value * value * value;
  RC_ASSERT(std::abs(jonckheere_terpstra(reversed).z + test.z) < 1e-9);
  RC_ASSERT(jonckheere_terpstra(cubes).z == test.z);
}

TEST(LinearContrast, DividesTheContrastOfMeansByItsStandardError) {
  // Means 1, 2 and 4, each over 4 runs of different scenarios, with sums of squares 12, 12 and 3:
  // variances of the means 4 / 3 * 12 / 16 = 1, 1 and 0.25.
  const std::vector<GroupMoments> groups = {{4, 4, 1, 12}, {4, 4, 2, 12}, {4, 4, 4, 3}};
  EXPECT_NEAR(linear_contrast(groups).z, 3 / std::sqrt(1.25), 1e-12);
  // A group of one scenario has no standard error, and keeps its score.
  const std::vector<GroupMoments> gap = {{4, 4, 1, 12}, {1, 1, 9, 0}, {4, 4, 4, 3}};
  EXPECT_NEAR(linear_contrast(gap).z, 3 / std::sqrt(1.25), 1e-12);
}

TEST(Trends, WithoutVariationAreNone) {
  EXPECT_EQ(cochran_armitage({9, 9}, {9, 9}).kind, TrendTest::Kind::NoVariation);
  EXPECT_EQ(jonckheere_terpstra({{2, 2}, {2, 2}}).p, 1);
  EXPECT_EQ(linear_contrast({}).p, 1);
}

/// The sums of a bin in which each value of a scenario is repeated.
CellSums bin_of(const std::vector<double>& values, std::uint32_t first, int repetitions = 1) {
  RowSums sums(1);
  std::vector<double> padded(RowSums::padded(1));
  for (std::size_t i = 0; i < values.size(); ++i)
    for (int repetition = 0; repetition < repetitions; ++repetition) {
      padded[0] = values[i];
      sums.add(padded.data(), first + static_cast<std::uint32_t>(i));
    }
  sums.end_part([](std::uint32_t scenario) { return scenario; });
  return sums.cell(0);
}

TEST(Trends, AreNotStrengthenedByRepetitionsWithTheSameOutcome) {
  const std::vector<double> easy = {1, 1, 1, 1, 1, 1, 1, 1, 0, 1},
                            hard = {0, 1, 0, 0, 1, 0, 0, 1, 0, 0};
  for (const bool rate : {true, false}) {
    const auto once = find_trend({bin_of(easy, 0), bin_of(hard, 10)}, rate);
    const auto thrice = find_trend({bin_of(easy, 0, 3), bin_of(hard, 10, 3)}, rate);
    EXPECT_EQ(once->scenarios, 20u);
    // The variance between scenarios has k - 1 for k: the effective number is below that of
    // scenarios, by no more than one per bin.
    EXPECT_NEAR(thrice->test.z, once->test.z, rate ? 0.2 : 1e-12);
    EXPECT_LE(std::abs(thrice->test.z), std::abs(once->test.z) + 1e-12);
  }
}

TEST(Trends, NeedTwentyScenariosInTwoBinsOfFive) {
  const auto bin = [](std::size_t size, std::uint32_t first) {
    std::vector<double> values(size);
    std::iota(values.begin(), values.end(), 0.0);
    return bin_of(values, first);
  };
  EXPECT_TRUE(find_trend({bin(15, 0), bin(5, 15)}, false));
  EXPECT_FALSE(find_trend({bin(14, 0), bin(5, 14)}, false));
  EXPECT_FALSE(find_trend({bin(40, 0), bin(4, 40)}, false));
}

TEST(Trends, OfLargeBinsUseTheContrastOfMeans) {
  RandomEngine engine(3);
  std::vector<double> low, high;
  for (int i = 0; i < 501; ++i) {
    low.push_back(uniform_real(engine, 0, 1));
    high.push_back(uniform_real(engine, 0.2, 1.2));
  }
  const auto trend = find_trend({bin_of(low, 0), bin_of(high, 501)}, false);
  EXPECT_EQ(trend->test.kind, TrendTest::Kind::LinearContrast);
  const double shift = mean(high) - mean(low), a = *standard_deviation(low),
               b = *standard_deviation(high);
  EXPECT_NEAR(trend->test.z, shift / std::sqrt((a * a + b * b) / 501), 1e-9);
}

}  // namespace
}  // namespace slalom
