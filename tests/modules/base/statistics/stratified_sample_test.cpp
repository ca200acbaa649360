// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/stratified_sample.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

std::size_t sum_of(const Allocation& allocation) {
  return std::accumulate(allocation.begin(), allocation.end(), std::size_t{0});
}

/// Strata of these sizes.
Strata of_sizes(const std::vector<std::size_t>& sizes) {
  Strata strata;
  for (const std::size_t size : sizes) strata.emplace_back(size);
  return strata;
}

TEST(StratifiedSample, StrataAreBetweenQuantilesAndHoldEachScenarioOnce) {
  RandomEngine engine(1);
  std::vector<double> values;
  for (int i = 0; i < 103; ++i) values.push_back(uniform_real(engine, 0, 1));
  const Strata strata = make_strata(values, kStrata, engine);
  ASSERT_EQ(strata.size(), 8U);
  std::vector<std::size_t> all;
  double highest = 0;
  for (const auto& stratum : strata) {
    EXPECT_TRUE(stratum.size() == 12 || stratum.size() == 13) << stratum.size();  // 103 / 8
    all.insert(all.end(), stratum.begin(), stratum.end());
    double next = highest;
    for (const std::size_t index : stratum) {
      EXPECT_GE(values[index], highest);
      next = std::max(next, values[index]);
    }
    highest = next;
  }
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < 103; ++i) EXPECT_EQ(all[i], i);
}

TEST(StratifiedSample, DependsOnTheSeedOnlyAndDividesEqualValuesAtRandom) {
  const std::vector<double> equal(100, 1.0);
  RandomEngine a(1), b(1), c(2);
  const Strata strata = make_strata(equal, 4, a);
  EXPECT_EQ(strata, make_strata(equal, 4, b));
  EXPECT_NE(strata, make_strata(equal, 4, c));
  std::size_t below = 0;
  for (const std::size_t index : strata[0]) below += index < 25 ? 1 : 0;
  EXPECT_LT(below, 25U) << "not the first ones";
  EXPECT_EQ(make_strata({3, 1}, 8, a), (Strata{{1}, {0}}));
  EXPECT_TRUE(make_strata({}, 8, a).empty());
}

TEST(StratifiedSample, OrdersAStratumIndependentlyOfWhatIsEqualBeyondIt) {
  // The first stratum holds scenario 0 and one of three equal ones. Scenario 0 is its first one in
  // half of 1,000 draws, to 4 standard deviations of sqrt(1000 / 4) = 15.8.
  RandomEngine engine(1);
  int first = 0;
  for (int i = 0; i < 1000; ++i) first += make_strata({0, 1, 1, 1}, 2, engine)[0][0] == 0 ? 1 : 0;
  EXPECT_NEAR(first, 500, 4 * 15.8);
}

TEST(StratifiedSample, AllocatesInProportionToTheSizes) {
  EXPECT_EQ(proportional_allocation(of_sizes({100, 100, 200}), 40), (Allocation{10, 10, 20}));
  EXPECT_EQ(proportional_allocation(of_sizes({1, 1, 98}), 10), (Allocation{1, 1, 8}));
  EXPECT_EQ(proportional_allocation(of_sizes({2, 3}), 100), (Allocation{2, 3})) << "all there are";
  EXPECT_EQ(proportional_allocation(of_sizes({2, 3}), 1), (Allocation{1, 1})) << "one of each";
}

TEST(StratifiedSample, EstimatesTheRateOfAllScenarios) {
  // Strata of 30 and 10 with 3 of 6 and 4 of 4 successes: 0.75 x 0.5 + 0.25 x 1 = 0.625. Variances
  // of the cautious rates 4/8 and 5/6: 0.75^2 x 0.25 / 6 x 0.8 + 0.25^2 x (5/36) / 4 x 0.6.
  const StratifiedRate found = stratified_rate(of_sizes({30, 10}), {6, 4}, {3, 4}, 0.95);
  EXPECT_DOUBLE_EQ(found.rate, 0.625);
  const double variance = 0.5625 * 0.25 / 6 * 0.8 + 0.0625 * 5 / 36 / 4 * 0.6;
  EXPECT_NEAR(found.interval.high - found.rate, 1.959964 * std::sqrt(variance), 1e-6);
  // With a scenario that half of its repetitions solve: 0.75 x 2.5 / 6 + 0.25.
  EXPECT_DOUBLE_EQ(stratified_rate(of_sizes({30, 10}), {6, 4}, {2.5, 4}, 0.95).rate, 0.5625);
  const StratifiedRate all = stratified_rate(of_sizes({3, 1}), {3, 1}, {2, 1}, 0.95);
  EXPECT_DOUBLE_EQ(all.rate, 0.75);
  EXPECT_DOUBLE_EQ(all.interval.low, all.interval.high) << "nothing is left to estimate";
  EXPECT_EQ(stratified_rate(of_sizes({9}), {3}, {3}, 0.95).interval.high, 1);
}

/// 15 methods with abilities of -3 to 3 logit in 2,000 scenarios, whose difficulties have a
/// standard deviation of 3.
struct Population {
  RandomEngine engine{1};
  std::vector<double> predicted;          ///< of the difficulty, with R^2 = 0.77 as of descriptors
  std::vector<std::vector<bool>> solved;  ///< [method][scenario]

  Population() {
    std::vector<double> difficulty;
    for (int i = 0; i < 2000; ++i) {
      predicted.push_back(normal(engine, 0, 3 * std::sqrt(0.77)));
      difficulty.push_back(predicted.back() + normal(engine, 0, 3 * std::sqrt(0.23)));
    }
    for (int method = 0; method < 15; ++method) {
      solved.emplace_back();
      for (const double d : difficulty) {
        const double p = 1 / (1 + std::exp(d - 3.0 * (method - 7) / 7));
        solved.back().push_back(uniform_real(engine, 0, 1) < p);
      }
    }
  }

  /// The difficulty by the number of the other methods that fail.
  std::vector<double> calibrated_without(std::size_t left_out) const {
    std::vector<double> values(2000, 0.0);
    for (std::size_t method = 0; method < solved.size(); ++method)
      for (std::size_t i = 0; i < values.size(); ++i)
        values[i] += method != left_out && !solved[method][i] ? 1 : 0;
    return values;
  }
};

struct Performance {
  double error_ratio = 0;  ///< root mean square error, relative to that of a random sample
  double coverage = 0;
};

/// Estimates the rate of each method 200 times from 100 of the 2,000 scenarios, in proportion to
/// the strata. A coverage of 0.95 is measured to sqrt(0.95 x 0.05 / 3000) = 0.004, the ratio to 2
/// %.
template <typename ValuesFor>
Performance performance(Population& population, const ValuesFor& values_for) {
  double stratified_error = 0, random_error = 0, covered = 0;
  for (std::size_t method = 0; method < population.solved.size(); ++method) {
    const std::vector<bool>& solved = population.solved[method];
    const double rate = static_cast<double>(std::count(solved.begin(), solved.end(), true)) / 2000;
    const std::vector<double> values = values_for(method);
    const auto successes_of = [&solved](const Strata& strata, const Allocation& sampled) {
      std::vector<std::size_t> successes(strata.size(), 0);
      for (std::size_t i = 0; i < strata.size(); ++i)
        for (std::size_t k = 0; k < sampled[i]; ++k) successes[i] += solved[strata[i][k]] ? 1 : 0;
      return successes;
    };
    for (int repeat = 0; repeat < 200; ++repeat) {
      const Strata strata = make_strata(values, kStrata, population.engine);
      const Allocation sampled = proportional_allocation(strata, 100);
      EXPECT_EQ(sum_of(sampled), 100U);
      const std::vector<std::size_t> successes = successes_of(strata, sampled);
      const StratifiedRate found =
          stratified_rate(strata, sampled, {successes.begin(), successes.end()}, 0.95);
      stratified_error += (found.rate - rate) * (found.rate - rate);
      covered += found.interval.low <= rate && rate <= found.interval.high ? 1 : 0;
      const Strata one = make_strata(values, 1, population.engine);
      const double random = static_cast<double>(successes_of(one, {100})[0]) / 100;
      random_error += (random - rate) * (random - rate);
    }
  }
  return {std::sqrt(stratified_error / random_error), covered / 3000};
}

TEST(StratifiedSample, ByTheRunsOfOtherMethodsHasAtMostThreeQuartersOfTheErrorOfARandomOne) {
  Population population;
  const Performance found = performance(
      population, [&](std::size_t method) { return population.calibrated_without(method); });
  EXPECT_LE(found.error_ratio, 0.75);
  EXPECT_GE(found.coverage, 0.95);
}

TEST(StratifiedSample, ByAPredictionFromDescriptorsStillCoversTheRate) {
  Population population;
  const Performance found =
      performance(population, [&](std::size_t) { return population.predicted; });
  EXPECT_LE(found.error_ratio, 0.85);
  EXPECT_GE(found.coverage, 0.95);
}

}  // namespace
}  // namespace slalom
