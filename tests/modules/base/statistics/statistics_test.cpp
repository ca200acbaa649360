// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/statistics.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

GroupSums singles(const std::vector<double>& values) {
  ScenarioGroups groups;
  for (const double value : values) groups.push_back({value});
  return sums_of(groups);
}

TEST(Statistics, MeanDeviationAndMedianOfKnownNumbers) {
  // 2 4 4 4 5 5 7 9: sum 40, squares about 5: 9+1+1+1+0+0+4+16 = 32, over n - 1 = 7.
  const std::vector<double> values = {9, 2, 4, 5, 4, 7, 4, 5};
  EXPECT_DOUBLE_EQ(mean(values), 5);
  EXPECT_DOUBLE_EQ(*standard_deviation(values), std::sqrt(32.0 / 7));
  EXPECT_DOUBLE_EQ(median(values), 4.5);
  EXPECT_DOUBLE_EQ(median({3, 1, 2}), 2);
  EXPECT_FALSE(standard_deviation({1.0}).has_value());
}

TEST(Statistics, InterquartileMeanAgreesWithWorkedExamples) {
  // "Interquartile mean", Wikipedia: of 12 values the middle 6; of 9 the 4.5 in the middle.
  EXPECT_DOUBLE_EQ(interquartile_mean({5, 8, 4, 38, 8, 6, 9, 7, 7, 3, 1, 6}), 6.5);
  EXPECT_DOUBLE_EQ(interquartile_mean({1, 3, 5, 7, 9, 11, 13, 15, 17}), 9);
  EXPECT_DOUBLE_EQ(interquartile_mean({3}), 3);
}

TEST(Statistics, WilsonIntervalAgreesWithNewcombe1998) {
  // Newcombe, "Two-sided confidence intervals for the single proportion", 1998, table I, method 3.
  const struct {
    double successes, n, low, high;
  } published[] = {{81, 263, 0.2553, 0.3662},
                   {15, 148, 0.0624, 0.1605},
                   {0, 20, 0.0000, 0.1611},
                   {1, 29, 0.0061, 0.1718}};
  for (const auto& row : published) {
    const Interval interval = wilson_interval(row.successes / row.n, row.n, 0.95);
    EXPECT_NEAR(interval.low, row.low, 5e-5);
    EXPECT_NEAR(interval.high, row.high, 5e-5);
  }
}

TEST(Statistics, WilsonIntervalSolvesItsScoreEquation) {
  // Its ends are the rates p with |rate - p| = z sqrt(p (1 - p) / n); z of 90 % is 1.6448536.
  const Interval interval = wilson_interval(0.3, 50, 0.90);
  for (const double p : {interval.low, interval.high}) {
    EXPECT_NEAR(std::abs(0.3 - p), 1.6448536269514722 * std::sqrt(p * (1 - p) / 50), 1e-12);
  }
}

TEST(Statistics, EveryRunCountsIfEachScenarioHasOneRun) {
  EXPECT_DOUBLE_EQ(effective_sample_size(singles({1, 0, 1, 1})), 4);
}

TEST(Statistics, IdenticalRepetitionsAddNoSampleSize) {
  EXPECT_DOUBLE_EQ(effective_sample_size(sums_of({{1, 1, 1}, {1, 1, 1}})), 2);
  ScenarioGroups repeated;
  for (int i = 0; i < 30; ++i) repeated.push_back(std::vector<double>(5, i % 3 == 0 ? 0 : 1));
  EXPECT_NEAR(effective_sample_size(sums_of(repeated)), 30,
              1.01);  // k / (k - 1) of the variance's estimate
}

TEST(Statistics, RepetitionsThatVaryLikeIndependentRunsCountFully) {
  RandomEngine engine(5);
  ScenarioGroups groups;
  for (int i = 0; i < 400; ++i) {
    std::vector<double> group;
    for (int j = 0; j < 5; ++j) group.push_back(uniform_real(engine, 0, 1) < 0.6 ? 1 : 0);
    groups.push_back(group);
  }
  EXPECT_GT(effective_sample_size(sums_of(groups)), 0.8 * 2000);
}

TEST(Statistics, TheIntervalOfARateIsWilsonsIfEachScenarioHasOneRun) {
  const GroupMoments groups = moments_of(singles({1, 0, 1, 1, 0, 1}));
  const Interval interval = rate_interval(groups, 0.9), wilson = wilson_interval(4.0 / 6, 6, 0.9);
  EXPECT_DOUBLE_EQ(interval.low, wilson.low);
  EXPECT_DOUBLE_EQ(interval.high, wilson.high);
}

TEST(Statistics, TheIntervalOfARateCountsThatFewScenariosShowTheirVariationBadly) {
  const GroupSums groups = sums_of({{1, 1}, {1, 0}, {0, 0}});
  // Variance between scenarios: 3 / 2 * (1 + 0 + 1) / 36 = 1 / 12; 0.25 / (1 / 12) = 3 runs = k.
  EXPECT_DOUBLE_EQ(effective_sample_size(groups), 3);
  // Runs that vary as independent ones count as 8 of 8; R: (qt(0.975, 7) / qt(0.975, 3))^2 =
  // 0.5520825, so as 4.416660, but not as fewer than the 4 scenarios.
  const GroupSums even = sums_of({{1, 0}, {1, 0}, {1, 0}, {1, 0}});
  const Interval interval = rate_interval(moments_of(even), 0.95),
                 wilson = wilson_interval(0.5, 8 * 0.5520825, 0.95);
  EXPECT_NEAR(interval.low, wilson.low, 1e-6);
  EXPECT_NEAR(interval.high, wilson.high, 1e-6);
}

TEST(Statistics, TheIntervalOfARateCoversItWithRepetitions) {
  // Rates of scenarios from Beta(1, (1 - rate) / rate): by inversion, 1 - (1 - u)^(1 / b).
  constexpr int kSamples = 2000, kRepetitions = 10;
  for (const double rate : {0.1, 0.5, 0.9})
    for (const int scenarios : {12, 30}) {
      RandomEngine engine(static_cast<unsigned>(scenarios));
      int covered = 0;
      for (int sample = 0; sample < kSamples; ++sample) {
        ScenarioGroups groups;
        for (int i = 0; i < scenarios; ++i) {
          const double p = 1 - std::pow(1 - uniform_real(engine, 0, 1), rate / (1 - rate));
          std::vector<double> group;
          for (int j = 0; j < kRepetitions; ++j)
            group.push_back(uniform_real(engine, 0, 1) < p ? 1 : 0);
          groups.push_back(group);
        }
        const Interval interval = rate_interval(moments_of(sums_of(groups)), 0.95);
        covered += interval.low <= rate && rate <= interval.high ? 1 : 0;
      }
      EXPECT_GT(covered, 0.91 * kSamples) << rate << " " << scenarios;
      EXPECT_LT(covered, 0.985 * kSamples) << rate << " " << scenarios;
    }
}

TEST(Statistics, StudentIntervalAgreesWithTheSleepData) {
  // Student 1908, drug 1: R's t.test(extra) gives -0.5297804 to 2.0297804.
  const auto interval =
      t_interval(singles({0.7, -1.6, -0.2, -1.2, -0.1, 3.4, 3.7, 0.8, 0.0, 2.0}), 0.95);
  EXPECT_NEAR(interval->low, -0.5297804, 1e-7);
  EXPECT_NEAR(interval->high, 2.0297804, 1e-7);
}

TEST(Statistics, IdenticalRepetitionsDoNotNarrowAnInterval) {
  const std::vector<double> values = {1, 4, 2, 8, 5, 7};
  const GroupSums once = singles(values);
  ScenarioGroups groups;
  for (const double value : values) groups.push_back(std::vector<double>(3, value));
  const GroupSums thrice = sums_of(groups);
  EXPECT_NEAR(t_interval(once, 0.95)->low, t_interval(thrice, 0.95)->low, 1e-12);
}

TEST(Statistics, MiddleValuesAgreeWithSorting) {
  RandomEngine engine(13);
  for (int n = 1; n < 60; ++n) {
    std::vector<double> values;
    for (int i = 0; i < n; ++i) values.push_back(uniform_int(engine, -4, 9));
    const MiddleValues found = middle_values(values);
    std::sort(values.begin(), values.end());
    double total = 0;  // each value four times, so that quarters are integers
    for (int i = n; i < 3 * n; ++i) total += values[static_cast<std::size_t>(i / 4)];
    EXPECT_NEAR(found.interquartile_mean, total / (2 * n), 1e-12) << n;
    const auto upper = static_cast<std::size_t>(n / 2),
               lower = static_cast<std::size_t>((n - 1) / 2);
    EXPECT_DOUBLE_EQ(found.median, (values[lower] + values[upper]) / 2) << n;
  }
}

TEST(Statistics, IntervalsStayWithinTheRangeOfTheirQuantity) {
  const Interval clipped = clip_to_range(Range::between(0, 1), 0.4, {-0.3, 1.2});
  EXPECT_EQ(clipped.low, 0);
  EXPECT_EQ(clipped.high, 1);
  EXPECT_EQ(clip_to_range({}, 0.4, {-0.3, 1.2}).low, -0.3);
  const Interval foreign = clip_to_range(Range::between(0, 1), 1.1, {0.9, 1.3});
  EXPECT_EQ(foreign.low, 0.9);
  EXPECT_EQ(foreign.high, 1.3);
}

TEST(Statistics, StudentsIntervalNeedsGroupsThatDiffer) {
  EXPECT_FALSE(t_interval(sums_of({{1, 2, 3}}), 0.95).has_value());
  EXPECT_FALSE(t_interval(singles({0.5, 0.5, 0.5}), 0.95).has_value());
}

}  // namespace
}  // namespace slalom
