// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/inquiry/tune_effects.h>

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace slalom {
namespace {

/// A number `a` in [0, 1], a `mode`, and a `weight` that only one mode uses.
ParameterSpace mixed_space() {
  SpaceParameter a, mode, weight;
  a.name = "a";
  mode.name = "mode";
  mode.choices = {"plain", "smooth"};
  weight.name = "weight";
  weight.high = 2;
  weight.integer = true;
  weight.condition = ParameterCondition{"mode", "smooth"};
  return ParameterSpace({a, mode, weight});
}

/// Success depends on `a` only: 0.2 + 0.6 a, which is 0.3, 0.5 and 0.7 in thirds.
TuneOutcome outcome_of(const Configuration& configuration, RandomEngine& engine) {
  TuneOutcome outcome;
  outcome.success = uniform_real(engine, 0, 1) < 0.2 + 0.6 * configuration[0];
  return outcome;
}

TuneResult search_with(std::uint64_t seed, std::size_t budget, bool with_later_runs = true) {
  TuneOptions options;
  options.seed = seed;
  options.budget = budget;
  RandomEngine engine(seed);
  return tune_search(mixed_space(), options, [&](const TuneRequest& request) {
    std::vector<TuneOutcome> outcomes;
    for (std::size_t i = 0; i < request.count; ++i)
      outcomes.push_back(outcome_of(request.configuration, engine));
    if (request.first > 0 && !with_later_runs) outcomes.clear();  // interrupted
    return outcomes;
  });
}

TEST(MainEffects, AreOfThirdsAndChoices) {
  const auto effects = main_effects(mixed_space(), search_with(1, 20000), 0.95);
  ASSERT_EQ(effects.size(), 3U);
  // 4000 / (2.3 * 8) = 217 Sobol points: 72 or 73 in each third, 108 or 109 with each mode.
  ASSERT_EQ(effects[0].levels.size(), 3U);
  const double rates[] = {0.3, 0.5, 0.7};
  for (std::size_t i = 0; i < 3; ++i) {
    const ParameterLevel& level = effects[0].levels[i];
    EXPECT_NEAR(static_cast<double>(level.configurations), 72.5, 3);
    EXPECT_NEAR(level.rate, rates[i], 0.08);  // 4 standard deviations of 580 runs
    EXPECT_LT(level.interval.low, level.rate);
    EXPECT_GT(level.interval.high, level.rate);
  }
  EXPECT_LT(effects[0].levels[0].interval.high, effects[0].levels[1].interval.low);
  ASSERT_EQ(effects[1].levels.size(), 2U);
  EXPECT_EQ(effects[1].levels[0].text, "plain");
  EXPECT_EQ(effects[1].levels[1].text, "smooth");
  EXPECT_TRUE(effects[1].levels[0].interval.overlaps(effects[1].levels[1].interval));
  // The weight counts only where it is used.
  ASSERT_EQ(effects[2].levels.size(), 3U);
  std::size_t configurations = 0;
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_EQ(effects[2].levels[i].text, std::to_string(i));
    configurations += effects[2].levels[i].configurations;
  }
  EXPECT_EQ(configurations, effects[1].levels[1].configurations);
}

/// Runs after the first ones of each configuration are of those that succeeded in these.
TEST(MainEffects, DoNotUseRunsOfTheBetterConfigurations) {
  const auto all = main_effects(mixed_space(), search_with(1, 3000), 0.95);
  const auto first = main_effects(mixed_space(), search_with(1, 3000, false), 0.95);
  ASSERT_EQ(all.size(), 3U);
  ASSERT_EQ(first.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < all[i].levels.size(); ++j)
      EXPECT_EQ(all[i].levels[j].rate, first[i].levels[j].rate);
}

TEST(MainEffects, HaveIntervalsThatCover) {
  // Wrong in at most 5 % of 900 intervals, and 3 standard deviations more.
  int wrong = 0;
  const double rates[] = {0.3, 0.5, 0.7};
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const auto effects = main_effects(mixed_space(), search_with(seed, 3000), 0.95);
    for (std::size_t i = 0; i < 3; ++i) {
      const Interval& interval = effects[0].levels[i].interval;
      wrong += rates[i] < interval.low || rates[i] > interval.high ? 1 : 0;
    }
  }
  EXPECT_LE(wrong, 900 * 0.0715) << wrong;
}

TEST(MainEffects, AreNoneWithoutRuns) {
  const TuneResult none =
      tune_search(mixed_space(), {}, [](const TuneRequest&) { return std::vector<TuneOutcome>(); });
  EXPECT_TRUE(main_effects(mixed_space(), none, 0.95).empty());
}

}  // namespace
}  // namespace slalom
