// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/core/error.h>
#include <slalom/inquiry/tune_search.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>
#include <set>
#include <string>
#include <tuple>
#include <utility>
#include <vector>

namespace slalom {
namespace {

SpaceParameter unit_parameter(const std::string& name, double default_value) {
  SpaceParameter parameter;
  parameter.name = name;
  parameter.default_value = default_value;
  return parameter;
}

/// Four parameters in [0, 1]; `c` and `d` have no effect.
ParameterSpace four_parameters() {
  return ParameterSpace({unit_parameter("a", 0.2), unit_parameter("b", 0.8),
                         unit_parameter("c", 0.5), unit_parameter("d", 0.5)});
}

/// A number in [0, 1) that depends on nothing else: the difficulty or the noise of a scenario.
double random_number(std::uint64_t seed, TunePhase phase, std::size_t scenario,
                     std::size_t configuration) {
  const std::uint64_t stream = derive_seed(seed, to_string(phase), scenario);
  return static_cast<double>(derive_seed(stream, "run", configuration) >> 11) * 0x1p-53;
}

using Rate = std::function<double(const Configuration&)>;

/// Runs that succeed with the rate of their configuration.
RunConfiguration runs_with(const Rate& rate, std::uint64_t seed) {
  return [rate, seed](const TuneRequest& request) {
    std::vector<TuneOutcome> outcomes(request.count);
    for (std::size_t i = 0; i < request.count; ++i)
      outcomes[i].success = random_number(seed, request.phase, request.first + i, request.index) <
                            rate(request.configuration);
    return outcomes;
  };
}

/// The logistic of a quadratic with its maximum, 0.88, at a = 0.7 and b = 0.3; 0.27 by default.
double planted(const Configuration& x) {
  const double distance = (x[0] - 0.7) * (x[0] - 0.7) + (x[1] - 0.3) * (x[1] - 0.3);
  return 1 / (1 + std::exp(-(2 - 6 * distance)));
}

double constant(const Configuration&) {
  return 0.6;
}

TuneOptions options_with(std::size_t budget, std::uint64_t seed) {
  TuneOptions options;
  options.budget = budget;
  options.seed = seed;
  return options;
}

TEST(TuneSearch, FindsAPlantedOptimum) {
  int found = 0;
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    const TuneResult result =
        tune_search(four_parameters(), options_with(3000, seed), runs_with(planted, seed));
    const Configuration& winner = result.candidates[result.winner].configuration;
    found += planted(winner) >= planted({0.7, 0.3}) - 0.05 ? 1 : 0;
  }
  EXPECT_GE(found, 9);
}

TEST(TuneSearch, KeepsTheBudgetAndRunsEachOnce) {
  for (const std::size_t budget : {300, 500, 999, 1000, 1400, 3000, 20000}) {
    std::set<std::tuple<TunePhase, Configuration, std::size_t>> runs;
    std::size_t last = 0;
    const RunConfiguration run = runs_with(planted, budget);
    const RunConfiguration counting = [&](const TuneRequest& request) {
      for (std::size_t i = request.first; i < request.first + request.count; ++i)
        EXPECT_TRUE(runs.emplace(request.phase, request.configuration, i).second);
      EXPECT_LE(request.first + request.count,
                request.phase == TunePhase::Development ? 240U : 300U);
      last = std::max(last, request.index);
      return run(request);
    };
    const TuneResult result = tune_search(four_parameters(), options_with(budget, 1), counting);
    EXPECT_TRUE(result.complete);
    EXPECT_LE(runs.size(), budget);
    EXPECT_EQ(result.runs(TunePhase::Development) + result.runs(TunePhase::Finals), runs.size());
    EXPECT_LE(result.runs(TunePhase::Development), budget * 3 / 5);
    EXPECT_EQ(last + 1, result.candidates.size());
    ASSERT_EQ(result.elites.size(), 3U);
    // The finals use what is left, but at most 300 scenarios.
    const std::size_t left = budget - result.runs(TunePhase::Development);
    for (const std::size_t index : result.finalists)
      EXPECT_EQ(result.candidates[index].finals.size(),
                std::min<std::size_t>(300, left / result.finalists.size()));
    EXPECT_TRUE(budget < 1000 || result.candidates[0].finals.size() >= 100) << budget;
    EXPECT_EQ(std::count(result.finalists.begin(), result.finalists.end(), 0U), 1);
    EXPECT_EQ(result.candidates[0].configuration, four_parameters().defaults());
  }
}

TEST(TuneSearch, TheDefaultIsAlwaysAFinalist) {
  // The default always fails: it is no elite, but a finalist.
  const auto rate = [](const Configuration& x) { return x[0] == 0.2 ? 0.0 : 0.9; };
  const TuneResult result =
      tune_search(four_parameters(), options_with(1000, 1), runs_with(rate, 1));
  EXPECT_EQ(std::count(result.elites[2].begin(), result.elites[2].end(), 0U), 0);
  EXPECT_EQ(result.finalists.size(), 6U);
  EXPECT_EQ(result.finalists.back(), 0U);
  EXPECT_FALSE(result.keeps_default());
}

TEST(TuneSearch, KeepsTheDefaultIfNothingIsBetter) {
  const auto rate = [](const Configuration& x) { return x[0] == 0.2 ? 1.0 : 0.5; };
  const TuneResult result =
      tune_search(four_parameters(), options_with(1000, 1), runs_with(rate, 1));
  EXPECT_TRUE(result.keeps_default());
  EXPECT_EQ(result.finalists[0], 0U);
}

TEST(TuneSearch, HalvesOnTheSameScenarios) {
  std::map<std::size_t, std::size_t> counts;  // configurations of the first iteration by their runs
  std::map<std::size_t, std::size_t> runs;    // by configuration
  const RunConfiguration run = runs_with(planted, 1);
  bool first_iteration = true;
  tune_search(four_parameters(), options_with(3000, 1), [&](const TuneRequest& request) {
    if (request.phase == TunePhase::Finals) return run(request);
    EXPECT_EQ(request.first, runs[request.index]);
    first_iteration = first_iteration && request.index <= 32;
    runs[request.index] += request.count;
    if (first_iteration) {
      if (request.first > 0) --counts[request.first];
      ++counts[runs[request.index]];
    }
    return run(request);
  });
  // The first iteration has 600 runs, and 600 / (2.3 * 8) = 32 new configurations besides the
  // default. 33, 17 and 9 of them in 8, 16 and 32 scenarios are 33 * 8 + 17 * 8 + 9 * 16 = 544
  // runs; 5 of them in 64 would make it 704.
  EXPECT_EQ(counts, (std::map<std::size_t, std::size_t>{{8, 16}, {16, 8}, {32, 9}}));
}

TEST(TuneSearch, IsTheSameTwiceAndOtherWithAnotherSeed) {
  const auto configurations = [](std::uint64_t seed) {
    const TuneResult result =
        tune_search(four_parameters(), options_with(1000, seed), runs_with(planted, 1));
    std::vector<Configuration> all;
    for (const TuneCandidate& candidate : result.candidates) all.push_back(candidate.configuration);
    all.push_back(all[result.winner]);
    return all;
  };
  EXPECT_EQ(configurations(1), configurations(1));
  EXPECT_NE(configurations(1), configurations(2));
}

TEST(TuneSearch, OnlyTheFinalsDecide) {
  // Configurations with a > 0.5 are perfect in the search and fail in two of three finals.
  const RunConfiguration run = [](const TuneRequest& request) {
    std::vector<TuneOutcome> outcomes(request.count);
    for (std::size_t i = 0; i < request.count; ++i) {
      const bool third = (request.first + i) % 3 == 0;
      const bool finals = request.phase == TunePhase::Finals;
      outcomes[i].success = request.configuration[0] > 0.5 ? !finals || third : !third;
    }
    return outcomes;
  };
  const TuneResult result = tune_search(four_parameters(), options_with(1000, 1), run);
  for (const std::size_t index : result.elites[2])
    EXPECT_GT(result.candidates[index].configuration[0], 0.5);
  EXPECT_TRUE(result.keeps_default());
  EXPECT_EQ(counts_of(result.candidates[result.elites[2][0]].development).rate(), 1);
}

TEST(TuneSearch, MoreCollisionsThanTheDefaultDoNotWin) {
  // Configurations with a > 0.5 reach the goal in 19 of 20 scenarios and collide in the others;
  // the rest reach it in 14 of 20 without a collision.
  const RunConfiguration run = [](const TuneRequest& request) {
    std::vector<TuneOutcome> outcomes(request.count);
    for (std::size_t i = 0; i < request.count; ++i) {
      const std::size_t part = (request.first + i) % 20;
      const bool fast = request.configuration[0] > 0.5;
      outcomes[i].success = part < (fast ? 19 : 14);
      outcomes[i].collision = fast && !outcomes[i].success;
    }
    return outcomes;
  };
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const TuneResult result = tune_search(four_parameters(), options_with(1000, seed), run);
    EXPECT_TRUE(result.keeps_default());
    const auto fast = [&](std::size_t index) {
      return result.candidates[index].configuration[0] > 0.5;
    };
    EXPECT_TRUE(std::any_of(result.finalists.begin(), result.finalists.end(), fast));
    EXPECT_TRUE(std::is_partitioned(result.finalists.begin(), result.finalists.end(),
                                    [&](std::size_t index) { return !fast(index); }));
  }
}

TEST(TuneSearch, ACollisionCostsThreeFailures) {
  // Costs in 8 scenarios: 3 with one collision and 7 successes, 2 with two failures.
  const RunConfiguration run = [](const TuneRequest& request) {
    std::vector<TuneOutcome> outcomes(request.count);
    for (std::size_t i = 0; i < request.count; ++i) {
      const std::size_t part = (request.first + i) % 8;
      const bool collides = request.configuration[0] > 0.5;
      outcomes[i].success = part < (collides ? 7 : 6);
      outcomes[i].collision = collides && part == 7;
    }
    return outcomes;
  };
  const auto colliding = [&](double cost) {
    TuneOptions options = options_with(3000, 1);
    options.collision_cost = cost;
    const TuneResult result = tune_search(four_parameters(), options, run);
    return std::count_if(result.elites[2].begin(), result.elites[2].end(), [&](std::size_t index) {
      return result.candidates[index].configuration[0] > 0.5;
    });
  };
  EXPECT_EQ(colliding(3), 0);
  EXPECT_EQ(colliding(1), 5);
}

/// Outcomes that succeed with the same runs, and a secondary value that is least at a = 1.
RunConfiguration runs_with_time(const Rate& rate) {
  return [rate](const TuneRequest& request) {
    std::vector<TuneOutcome> outcomes = runs_with(rate, 1)(request);
    for (TuneOutcome& outcome : outcomes)
      if (outcome.success) outcome.secondary = 2 - request.configuration[0];
    return outcomes;
  };
}

TEST(TuneSearch, TheSecondaryValueDecidesAmongEquals) {
  const auto equal = [](const Configuration&) { return 1.0; };
  const TuneResult result =
      tune_search(four_parameters(), options_with(1000, 1), runs_with_time(equal));
  const auto a = [&](std::size_t index) { return result.candidates[index].configuration[0]; };
  for (const std::size_t index : result.finalists) EXPECT_LE(a(index), a(result.winner));
  EXPECT_GT(a(result.winner), 0.9);
}

TEST(TuneSearch, TheSecondaryValueDoesNotOutweighSuccess) {
  // 0.95 for a < 0.5, else 0.3, which is faster: McNemar's test shows it in 100 scenarios.
  const auto rate = [](const Configuration& x) { return x[0] < 0.5 ? 0.95 : 0.3; };
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    const TuneResult result =
        tune_search(four_parameters(), options_with(1000, seed), runs_with_time(rate));
    EXPECT_LT(result.candidates[result.winner].configuration[0], 0.5);
  }
}

TEST(TuneSearch, ComparesTheSecondaryValueInCommonScenarios) {
  // The default is faster in each scenario, but the others fail in some of the slow ones, so that
  // the mean of their own runs is less.
  const RunConfiguration run = [](const TuneRequest& request) {
    std::vector<TuneOutcome> outcomes(request.count);
    for (std::size_t i = 0; i < request.count; ++i) {
      const bool slow = (request.first + i) % 2 == 1;
      outcomes[i].success = !slow || request.index == 0 || (request.first + i) % 64 != 1;
      if (outcomes[i].success)
        outcomes[i].secondary = (slow ? 100 : 1) + (request.index == 0 ? 0 : 0.1);
    }
    return outcomes;
  };
  const TuneResult result = tune_search(four_parameters(), options_with(1000, 1), run);
  EXPECT_TRUE(result.keeps_default());
}

TEST(TuneSearch, TriesEachConfigurationOfASmallSpaceOnce) {
  SpaceParameter bins = unit_parameter("bins", 1), mode;
  bins.integer = true;
  mode.name = "mode";
  mode.choices = {"plain", "smooth", "fast"};
  SpaceParameter weight = unit_parameter("weight", 0);
  weight.integer = true;
  weight.condition = ParameterCondition{"mode", "smooth"};
  const auto rate = [](const Configuration& x) { return x == Configuration{0, 1, 1} ? 0.9 : 0.5; };
  const TuneResult result =
      tune_search(ParameterSpace({bins, mode, weight}), options_with(3000, 1), runs_with(rate, 1));
  EXPECT_EQ(result.candidates.size(), 8U);  // 2 x (1 + 2 + 1)
  EXPECT_EQ(result.candidates[result.winner].configuration, (Configuration{0, 1, 1}));
}

TEST(TuneSearch, EndsWhereItIsInterrupted) {
  for (const std::size_t calls : {0U, 5U, 40U}) {
    std::size_t made = 0;
    const RunConfiguration run = runs_with(constant, 1);
    const TuneResult result =
        tune_search(four_parameters(), options_with(1000, 1), [&](const TuneRequest& request) {
          std::vector<TuneOutcome> outcomes = run(request);
          if (made++ == calls) outcomes.pop_back();
          EXPECT_LE(made, calls + 1);
          return outcomes;
        });
    EXPECT_FALSE(result.complete);
    EXPECT_TRUE(result.keeps_default());
  }
}

TEST(TuneSearch, RefusesInvalidOptions) {
  const auto error_of = [](const TuneOptions& options) -> std::string {
    try {
      tune_search(four_parameters(), options, runs_with(constant, 1));
    } catch (const Error& error) {
      return error.what();
    }
    return "";
  };
  EXPECT_EQ(error_of(options_with(299, 1)), "tune_search.budget: 299; expected at least 300");
  TuneOptions options;
  options.development = 7;
  EXPECT_EQ(error_of(options), "tune_search.development: 7; expected at least 8");
  options = {};
  options.finals = 0;
  EXPECT_EQ(error_of(options), "tune_search.finals: 0; expected at least 1");
}

}  // namespace
}  // namespace slalom
