// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/random.h>
#include <slalom/statistics/distributions.h>
#include <slalom/statistics/sequential_rate.h>

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <vector>

namespace slalom {
namespace {

/// The mixture as its definition says, for numbers of runs at which nothing overflows.
double mixture(double rate, int successes, int failures) {
  const double q = 1 - rate;
  double sum = 0;
  for (const auto& [weight, part] : {std::pair{0.5, 0.0}, {0.25, 0.2}, {0.25, 0.5}})
    sum += weight * std::pow((1 - part * q) / rate, successes) * std::pow(part, failures);
  return sum;
}

TEST(RateTest, HasTheWealthOfTheMixture) {
  for (const double rate : {0.5, 0.9, 0.95, 0.999}) {
    const RateTest test(rate, 0.95);
    for (const int successes : {0, 1, 50, 300})
      for (const int failures : {0, 1, 2, 20})
        EXPECT_NEAR(test.log_wealth(static_cast<std::size_t>(successes),
                                    static_cast<std::size_t>(failures)),
                    std::log(mixture(rate, successes, failures)), 1e-9);
  }
}

TEST(RateTest, NeedsSoManyRunsWithoutAFailure) {
  for (const double rate : {0.5, 0.8, 0.95, 0.99})
    for (const double confidence : {0.5, 0.9, 0.95, 0.999}) {
      int runs = 1;
      while (mixture(rate, runs, 0) < 1 / (1 - confidence)) ++runs;
      EXPECT_EQ(runs_without_failure(rate, confidence), static_cast<std::size_t>(runs));
      RateTest test(rate, confidence);
      while (!test.reached()) test.add(true);
      EXPECT_EQ(test.runs(), static_cast<std::size_t>(runs));
    }
  // Fixed in advance, 59 would do: 0.95^59 < 0.05.
  EXPECT_EQ(runs_without_failure(0.95, 0.95), 67U);
}

TEST(RateTest, DoesNotCountRunsAfterItsDecision) {
  RateTest reached(0.95, 0.95), futile(0.95, 0.95);
  for (int i = 0; i < 100; ++i) {
    reached.add(i < 67);
    futile.add(i >= 40);
  }
  EXPECT_TRUE(reached.reached());
  EXPECT_FALSE(reached.futile());
  EXPECT_EQ(reached.runs(), 67U);
  EXPECT_EQ(reached.failures(), 0U);
  EXPECT_TRUE(futile.futile());
  EXPECT_EQ(futile.runs(), 40U);  // kMinFutileRuns, although it was hopeless before
}

struct Exact {
  double reached = 0;  ///< probability
  double runs = 0;     ///< mean
};

/// Follows the probability of each number of failures among the tests that are undecided after each
/// run.
Exact decide_exactly(double rate, double true_rate, std::size_t max_runs) {
  const RateTest test(rate, 0.95);
  Exact result;
  std::vector<double> open = {1};
  for (std::size_t n = 1; n <= max_runs; ++n) {
    std::vector<double> next(open.size() + 1, 0);
    for (std::size_t k = 0; k < open.size(); ++k) {
      result.runs += open[k];
      next[k] += open[k] * true_rate;
      next[k + 1] += open[k] * (1 - true_rate);
    }
    for (std::size_t k = 0; k < next.size(); ++k) {
      if (next[k] == 0) continue;
      const double wealth = test.log_wealth(n - k, k);
      if (wealth >= test.log_target()) result.reached += next[k];
      const bool futile =
          n >= RateTest::kMinFutileRuns && wealth < std::log(RateTest::kFutileWealth);
      if (wealth >= test.log_target() || futile) next[k] = 0;
    }
    while (!next.empty() && next.back() == 0) next.pop_back();
    open = std::move(next);
  }
  return result;
}

TEST(RateTest, IsReachedWithoutReasonAsRarelyAsItsConfidenceSays) {
  for (const double rate : {0.8, 0.95}) {
    const Exact at = decide_exactly(rate, rate, 2000);
    EXPECT_LE(at.reached, 0.05) << rate;
    EXPECT_GT(at.reached, 0.03) << rate;  // not far below: runs would be wasted
    EXPECT_LT(decide_exactly(rate, rate - 0.01, 2000).reached, at.reached) << rate;
  }
}

/// Runs and chances of a simulation of the same test by an independent program in Python.
TEST(RateTest, TakesTheRunsThatAnotherProgramTakes) {
  const std::pair<double, double> kRuns[] = {{0.995, 96}, {0.99, 138}, {0.98, 287}, {0.97, 634}};
  for (const auto& [true_rate, runs] : kRuns)
    EXPECT_NEAR(decide_exactly(0.95, true_rate, 2000).runs, runs, 0.06 * runs) << true_rate;
}

/// The steps that are reached with these true rates.
std::size_t reached_steps(const std::vector<double>& rates, RandomEngine& engine) {
  FixedSequence::Options options;
  options.steps = rates.size();
  options.budget = 1'000'000;
  FixedSequence sequence(options);
  while (const auto step = sequence.current())
    for (int i = 0; i < 20; ++i) sequence.add(*step, uniform_real(engine, 0, 1) < rates[*step]);
  return sequence.reached();
}

/// Whether a probability of at most `p` may have given so many of n, at 97.5 % (Clopper-Pearson).
bool is_possible(int count, int n, double p) {
  return distributions::binomial_lower_bound(count, n, 0.025) <= p;
}

TEST(FixedSequence, ClaimsAStepBelowTheRateAsRarelyAsItsConfidenceSays) {
  constexpr int kRepeats = 1000;
  RandomEngine engine(1);
  int below = 0, trapped = 0;
  for (int i = 0; i < kRepeats; ++i) {
    below += reached_steps(std::vector<double>(35, 0.95 - 1e-4), engine) > 0 ? 1 : 0;
    std::vector<double> rates(35, 0.995);
    const auto trap = static_cast<std::size_t>(uniform_int(engine, 0, 19));
    rates[trap] = 0.9;
    trapped += reached_steps(rates, engine) > trap ? 1 : 0;
  }
  EXPECT_TRUE(is_possible(below, kRepeats, 0.05)) << below;
  EXPECT_TRUE(is_possible(trapped, kRepeats, 0.05)) << trapped;
}

TEST(FixedSequence, EndsAtTheFirstStepThatIsNotReached) {
  FixedSequence::Options options;
  options.steps = 3;
  FixedSequence sequence(options);
  for (int i = 0; i < 100; ++i) sequence.add(0, true);
  EXPECT_EQ(sequence.current(), 1U);
  sequence.add(2, true);  // is not its turn
  EXPECT_EQ(sequence.runs(), 67U);
  for (int i = 0; i < 100; ++i) sequence.add(1, false);
  EXPECT_EQ(sequence.current(), std::nullopt);
  EXPECT_EQ(sequence.reached(), 1U);
  ASSERT_EQ(sequence.tests().size(), 2U);
  EXPECT_TRUE(sequence.tests()[1].futile());
  EXPECT_EQ(sequence.runs(), 67U + RateTest::kMinFutileRuns);
}

TEST(FixedSequence, EndsAtTheLimitOfAStepAndAtTheBudget) {
  FixedSequence::Options options;
  options.steps = 2;
  options.max_per_step = 66;
  FixedSequence capped(options);
  for (int i = 0; i < 100; ++i) capped.add(0, true);
  EXPECT_EQ(capped.current(), std::nullopt);
  EXPECT_EQ(capped.tests()[0].runs(), 66U);
  options.max_per_step = 2000;
  options.budget = 70;
  FixedSequence poor(options);
  while (const auto step = poor.current()) poor.add(*step, true);
  EXPECT_EQ(poor.reached(), 1U);
  EXPECT_EQ(poor.runs(), 70U);
}

TEST(FailureBound, IsTheRateAtWhichTheTestIsReached) {
  for (const double rate : {0.8, 0.95, 0.999}) {
    const std::size_t runs = runs_without_failure(rate, 0.95, close_rates_mixture());
    EXPECT_LE(failure_bound(runs, 0, 0.95), 1 - rate);
    EXPECT_GT(failure_bound(runs - 1, 0, 0.95), 1 - rate);
  }
  EXPECT_EQ(failure_bound(0, 0, 0.95), 1);
  EXPECT_EQ(failure_bound(5, 5, 0.95), 1);
  for (std::size_t failures = 0; failures < 50; ++failures) {
    EXPECT_GT(failure_bound(100, failures, 0.95), static_cast<double>(failures) / 100);
    EXPECT_GT(failure_bound(100, failures + 1, 0.95), failure_bound(100, failures, 0.95));
    EXPECT_GT(failure_bound(100, failures, 0.99), failure_bound(100, failures, 0.95));
  }
}

TEST(FailureBound, IsWithinATenthOfTheRateWithManyRuns) {
  for (const double rate : {0.001, 0.1, 0.7}) {
    const double runs = 1e7;
    EXPECT_LE(
        failure_bound(static_cast<std::size_t>(runs), static_cast<std::size_t>(runs * rate), 0.95),
        1.1 * rate);
  }
}

TEST(RateMixtures, AreMixtures) {
  for (const RateMixture& mixture : {few_runs_mixture(), close_rates_mixture()}) {
    double sum = 0;
    for (const RateAlternative& alternative : mixture) sum += alternative.weight;
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(FailureBound, HoldsAlsoWhenTheRunsEndWhereItIsSmallest) {
  RandomEngine engine(8);
  for (const double rate : {0.02, 0.2}) {
    int wrong = 0;
    for (int repetition = 0; repetition < 1000; ++repetition) {
      std::size_t failures = 0;
      bool below = false;
      for (std::size_t runs = 1; runs <= 300 && !below; ++runs) {
        failures += uniform_real(engine, 0, 1) < rate ? 1 : 0;
        // The wealth at the true rate, which is what the bound is compared with.
        const RateTest test(1 - rate, 0.95, close_rates_mixture());
        below = test.log_wealth(runs - failures, failures) >= test.log_target();
        if (!below && runs % 50 != 0) continue;
        const double bound = failure_bound(runs, failures, 0.95);
        EXPECT_EQ(below, bound <= rate * (1 + 1e-9)) << bound;
      }
      wrong += below ? 1 : 0;
    }
    // At most 5 % of 1000, and 65 with the deviation of a sample.
    EXPECT_LE(wrong, 65) << rate;
  }
}

TEST(ShownConfidence, IsOneMinusTheProbabilityOfSoFewFailures) {
  // The steps of ASTM E2801 and F3244: 0 of 10, 1 of 20, 3 of 30 at a reliability of 0.8.
  EXPECT_NEAR(shown_confidence(10, 0, 0.8), 0.893, 5e-4);
  EXPECT_NEAR(shown_confidence(20, 1, 0.8), 0.931, 5e-4);
  EXPECT_NEAR(shown_confidence(30, 3, 0.8), 0.877, 5e-4);
  EXPECT_EQ(shown_confidence(7, 7, 0.8), 0);
  for (const double rate : {0.5, 0.9})
    for (std::size_t failures = 0; failures < 12; ++failures) {
      double probability = 0, choose = 1;
      for (std::size_t k = 0; k <= failures; ++k) {
        probability += choose * std::pow(1 - rate, static_cast<double>(k)) *
                       std::pow(rate, static_cast<double>(12 - k));
        choose = choose * static_cast<double>(12 - k) / static_cast<double>(k + 1);
      }
      EXPECT_NEAR(shown_confidence(12, failures, rate), 1 - probability, 1e-12);
    }
}

}  // namespace
}  // namespace slalom
