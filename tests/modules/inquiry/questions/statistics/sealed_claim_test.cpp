// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/core/random.h>
#include <slalom/inquiry/sealed_claim.h>
#include <slalom/statistics/distributions.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace slalom {
namespace {

/// Rates of outcomes of pairs.
struct PairRates {
  double both = 0, only_tuned = 0, only_reference = 0;
};

void run_pairs(SealedClaim& claim, const PairRates& rates, RandomEngine& engine) {
  while (claim.next() > 0) {
    const double x = uniform_real(engine, 0, 1);
    const bool only_tuned = x < rates.only_tuned;
    const bool only_reference = !only_tuned && x < rates.only_tuned + rates.only_reference;
    const bool both =
        !only_tuned && !only_reference && x < rates.only_tuned + rates.only_reference + rates.both;
    claim.add(both || only_tuned, both || only_reference);
  }
}

bool covers(const RateEstimate& estimate, double truth) {
  return estimate.interval.low <= truth && truth <= estimate.interval.high;
}

TEST(SealedClaim, StopsAtTheFirstLookAfterTheMinimum) {
  // Pairs of 0, 0 do not change the wealth; 60 successes of the tuned one alone are evident. The
  // look is at 200, the next ones would be at 220 and 240.
  SealedClaim claim;
  std::size_t batches = 0;
  while (const std::size_t next = claim.next()) {
    EXPECT_EQ(next, 20U);
    ++batches;
    for (std::size_t i = 0; i < next; ++i) claim.add(batches <= 3, false);
    EXPECT_EQ(claim.verdict() == TuneVerdict::Better, batches == 10);
  }
  EXPECT_EQ(claim.scenarios(), 200U);
  EXPECT_DOUBLE_EQ(claim.difference().value, 60 / 200.0);
  claim.add(false, true);
  EXPECT_EQ(claim.scenarios(), 200U);
  EXPECT_EQ(claim.verdict(), TuneVerdict::Better);
}

TEST(SealedClaim, EndsAtTheLargestNumberAndCanBeExtended) {
  SealedOptions options;
  options.max_scenarios = 410;
  SealedClaim claim(options);
  for (int i = 0; i < 400; ++i) claim.add(i % 2 == 0, i % 2 == 1);
  EXPECT_EQ(claim.next(), 10U);
  for (int i = 0; i < 10; ++i) claim.add(true, true);
  EXPECT_EQ(claim.next(), 0U);
  EXPECT_EQ(claim.verdict(), TuneVerdict::NotShown);
  claim.extend(1000);
  EXPECT_EQ(claim.next(), 10U);  // looks stay at multiples of 20
  while (claim.next() > 0) claim.add(true, false);
  EXPECT_EQ(claim.verdict(), TuneVerdict::Better);
  EXPECT_LT(claim.scenarios(), 600U);
}

TEST(SealedClaim, TheIntervalOfTheDifferenceAgreesWithTheVerdict) {
  RandomEngine engine(1);
  int better = 0;
  for (int i = 0; i < 200; ++i) {
    SealedClaim claim;
    run_pairs(claim, {0.6, 0.12, 0.06}, engine);
    const bool is_better = claim.verdict() == TuneVerdict::Better;
    EXPECT_EQ(claim.difference().interval.low >= 0, is_better);
    better += is_better ? 1 : 0;
  }
  EXPECT_GT(better, 20);
  EXPECT_LT(better, 180);
}

/// Smallest probability that a rate may have that was observed as `count` of `n` (97.5 %).
double at_least(int count, int n) {
  return distributions::binomial_lower_bound(count, n, 0.025);
}

TEST(SealedClaim, IsRarelyBetterWithoutADifference) {
  RandomEngine engine(1);
  const int repeats = 1000;
  int wrong = 0;
  for (int i = 0; i < repeats; ++i) {
    SealedOptions options;
    options.max_scenarios = 1000;
    SealedClaim claim(options);
    run_pairs(claim, {0.6, 0.125, 0.125}, engine);
    wrong += claim.verdict() == TuneVerdict::Better ? 1 : 0;
  }
  EXPECT_LE(at_least(wrong, repeats), 0.025) << wrong;
}

/// Each end of the intervals at the end of a test that mostly stops early.
TEST(SealedClaim, IntervalsCoverWhereItStops) {
  RandomEngine engine(1);
  const int repeats = 500;
  int low = 0, high = 0, tuned_low = 0, tuned_high = 0, optimism = 0;
  double bias = 0;
  for (int i = 0; i < repeats; ++i) {
    SealedClaim claim;
    run_pairs(claim, {0.6, 0.175, 0.075}, engine);
    low += claim.difference().interval.low > 0.1 ? 1 : 0;
    high += claim.difference().interval.high < 0.1 ? 1 : 0;
    tuned_low += claim.tuned().interval.low > 0.775 ? 1 : 0;
    tuned_high += claim.tuned().interval.high < 0.775 ? 1 : 0;
    bias += (claim.difference().value - 0.1) / repeats;
    TuneCounts finals;
    finals.runs = 200;
    for (int j = 0; j < 200; ++j) finals.successes += uniform_real(engine, 0, 1) < 0.775 ? 1 : 0;
    optimism += covers(claim.optimism(finals), 0) ? 0 : 1;
  }
  for (const int wrong : {low, high, tuned_low, tuned_high})
    EXPECT_LE(at_least(wrong, repeats), 0.025) << wrong;
  EXPECT_LE(at_least(optimism, repeats), 0.05) << optimism;
  EXPECT_NEAR(bias, 0, 0.01);
}

TEST(SealedClaim, OptimismIsTheFinalsMinusTheSealedScenarios) {
  SealedClaim claim;
  for (int i = 0; i < 400; ++i) claim.add(i % 4 != 0, i % 4 != 0);
  TuneCounts finals;
  finals.runs = 200;
  finals.successes = 160;
  const RateEstimate optimism = claim.optimism(finals);
  EXPECT_NEAR(optimism.value, 0.05, 1e-12);
  // Wilson's intervals with z = 1.959964: of 160 of 200 [0.739202, 0.849595], of 300 of 400
  // [0.705317, 0.789986]; 0.05 - hypot(0.060798, 0.039986), 0.05 + hypot(0.049595, 0.044683).
  EXPECT_NEAR(optimism.interval.low, -0.022769, 1e-4);
  EXPECT_NEAR(optimism.interval.high, 0.116755, 1e-4);
}

/// All of the claim of a tuned configuration: search, finals, sealed scenarios.
TEST(SealedClaim, ATunedConfigurationIsRarelyBetterWhereNoneIs) {
  SpaceParameter a, b;
  a.name = "a";
  b.name = "b";
  const ParameterSpace space({a, b});
  RandomEngine engine(1);
  const auto outcome = [&engine](double difficulty) {
    TuneOutcome run;
    run.success = uniform_real(engine, 0, 1) >= difficulty;
    return run;
  };
  const int repeats = 500;
  int better = 0, keeps_default = 0;
  for (int i = 0; i < repeats; ++i) {
    // Scenarios are easy or hard, alike for all configurations.
    const RunConfiguration run_null = [&](const TuneRequest& request) {
      std::vector<TuneOutcome> outcomes;
      for (std::size_t j = request.first; j < request.first + request.count; ++j)
        outcomes.push_back(outcome(j % 3 == 0 ? 0.7 : 0.1));
      return outcomes;
    };
    TuneOptions options;
    options.seed = static_cast<std::uint64_t>(i);
    const TuneResult result = tune_search(space, options, run_null);
    keeps_default += result.keeps_default() ? 1 : 0;
    if (result.keeps_default()) continue;
    SealedClaim claim;
    for (std::size_t j = 0; claim.next() > 0; ++j) {
      const double difficulty = j % 3 == 0 ? 0.7 : 0.1;
      claim.add(outcome(difficulty).success, outcome(difficulty).success);
    }
    better += claim.verdict() == TuneVerdict::Better ? 1 : 0;
  }
  // The largest rate that may give so many, at 95 %.
  EXPECT_LE(distributions::binomial_upper_bound(better, repeats, 0.05), 0.065) << better;
  // One of about six finalists: a search alone replaces the default by noise.
  EXPECT_LT(keeps_default, repeats / 2);
}

TEST(SealedClaim, RefusesInvalidOptions) {
  const auto error_of = [](const SealedOptions& options) -> std::string {
    try {
      const SealedClaim claim(options);
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  SealedOptions options;
  options.max_scenarios = 1001;
  EXPECT_EQ(error_of(options), "SealedClaim.max_scenarios: 1001; expected 1 to 1000");
  options = {};
  options.effect = 0;
  EXPECT_EQ(error_of(options), "SealedClaim.effect: 0; expected in (0, 1]");
  options = {};
  options.confidence = 1;
  EXPECT_EQ(error_of(options), "SealedClaim.confidence: 1; expected in (0, 1)");
  options = {};
  options.batch = 0;
  EXPECT_EQ(error_of(options), "SealedClaim.batch: 0; expected at least 1");
  SealedClaim claim;
  EXPECT_THROW(claim.extend(1001), Error);
}

}  // namespace
}  // namespace slalom
