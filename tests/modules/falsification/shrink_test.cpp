#include "error_text.h"
#include "planted_methods.h"

#include <slalom/falsification/shrink.h>
#include <slalom/generation/scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>

namespace slalom {
namespace {

/// The outcome of a run in this process, without the code that is tested.
Outcome outcome_in(const Scenario& scenario, const TestBench& bench, const NamedMethod& method) {
  const auto made = method.make(bench.setup.robot, bench.setup.sensor);
  return run_trial(World(scenario, bench.setup.simulation.resolution), bench, *made).outcome;
}

/// Removes each obstacle of a continuous scenario alone.
void expect_minimal(const Scenario& scenario, const TestBench& bench, Outcome outcome) {
  const std::size_t count = Scene(scenario).obstacles.size();
  for (std::size_t i = 0; i < count; ++i) {
    Scene scene(scenario);
    scene.obstacles.erase(scene.obstacles.begin() + static_cast<std::ptrdiff_t>(i));
    const Scenario without = scene.scenario("without");
    EXPECT_FALSE(outcome_in(without, bench, bench.method) == outcome &&
                 outcome_in(without, bench, bench.witnesses[0]) == Outcome::Success)
        << "obstacle " << i << " is not needed";
  }
}

TEST(Shrink, KeepsOnlyTheObstaclesThatTheFailureNeeds) {
  const TestBench bench = planted_bench("squeeze");
  ASSERT_EQ(outcome_in(passage(), bench, bench.method), Outcome::Collision);
  const auto small = shrink(bench, passage());
  ASSERT_TRUE(small);
  EXPECT_EQ(small->parts_before, 13U);
  EXPECT_LE(small->parts_after, 3U);
  EXPECT_EQ(small->trial.outcome, Outcome::Collision);
  EXPECT_EQ(outcome_in(small->scenario, bench, bench.method), Outcome::Collision);
  EXPECT_EQ(outcome_in(small->scenario, bench, bench.witnesses[0]), Outcome::Success);
  EXPECT_TRUE(small->minimal);
  EXPECT_EQ(small->removals.size(), small->parts_after);
  expect_minimal(small->scenario, bench, Outcome::Collision);
  EXPECT_LE(small->runs, 500U);
  RecordProperty("runs", static_cast<int>(small->runs));
}

TEST(Shrink, TheResultIsFair) {
  const auto small = shrink(planted_bench("squeeze"), passage());
  ASSERT_TRUE(small);
  EXPECT_TRUE(small->fairness.fair());
  EXPECT_GE(small->fairness.geometry.bottleneck, 1.5);
  EXPECT_GE(small->fairness.geometry.start_clearance, 0.1 - 1e-9);
  EXPECT_EQ(small->fairness.witness, "base");
  EXPECT_TRUE(small->fairness.repeatable);
  const Bounds& bounds = small->scenario.bounds();
  EXPECT_GE(bounds.x_min, 0);
  EXPECT_GE(bounds.y_min, 0);
  EXPECT_LE(bounds.x_max, 10);
  EXPECT_LE(bounds.y_max, 10);
  EXPECT_LT(bounds.area(), 100);
}

TEST(Shrink, NumbersAreMultiplesOfFiveCentimeters) {
  const auto small = shrink(planted_bench("squeeze"), passage());
  ASSERT_TRUE(small);
  const auto is_round = [](double x) { return std::abs(x * 20 - std::round(x * 20)) < 1e-9; };
  for (const Disc& disc : small->scenario.primitives().discs) {
    EXPECT_TRUE(is_round(disc.center.x) && is_round(disc.center.y) && is_round(disc.radius));
    EXPECT_GE(disc.radius, 0.05);
  }
  for (const Polygon& polygon : small->scenario.primitives().polygons)
    for (const auto& vertex : polygon.vertices)
      EXPECT_TRUE(is_round(vertex.x) && is_round(vertex.y)) << vertex;
  EXPECT_TRUE(is_round(small->scenario.goal().x) && is_round(small->scenario.goal().y));
  EXPECT_EQ(small->scenario.start().phi, 0);
}

TEST(Shrink, GivesTheSameScenarioAgain) {
  const TestBench bench = planted_bench("squeeze");
  const auto first = shrink(bench, passage()), second = shrink(bench, passage());
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->scenario.hash(), second->scenario.hash());
  EXPECT_TRUE(is_same_run(first->trial, second->trial));
  EXPECT_EQ(first->runs, second->runs);
}

TEST(Shrink, ACrashOfTheMethodIsAFailureLikeAnyOther) {
  const auto small = shrink(planted_bench("crash"), passage());
  ASSERT_TRUE(small);
  EXPECT_EQ(small->trial.outcome, Outcome::MethodCrash);
  EXPECT_LE(small->parts_after, 3U);
  EXPECT_TRUE(small->minimal);
  EXPECT_TRUE(small->fairness.fair());
}

TEST(Shrink, AMapIsShrunkByGroupsOfCells) {
  const TestBench bench = planted_bench("squeeze");
  const Scenario map = convert(passage(), Representation::Grid, 0.05);
  ASSERT_EQ(outcome_in(map, bench, bench.method), Outcome::Collision);
  const auto small = shrink(bench, map);
  ASSERT_TRUE(small);
  EXPECT_EQ(small->parts_before, 13U);
  EXPECT_LE(small->parts_after, 3U);
  EXPECT_EQ(outcome_in(small->scenario, bench, bench.method), Outcome::Collision);
  EXPECT_TRUE(small->minimal);
  EXPECT_TRUE(small->fairness.fair());
}

TEST(Shrink, AnUnfairFailureStaysAsFairAsItIs) {
  TestBench bench = planted_bench("squeeze");
  ShrinkOptions options;
  options.fairness.min_bottleneck = 3;  // robot widths; the passage has less
  const auto small = shrink(bench, passage(), options);
  ASSERT_TRUE(small);
  EXPECT_LE(small->parts_after, 3U);
  EXPECT_FALSE(small->fairness.fair());
  const World original(passage(), 0.05);
  EXPECT_GE(small->fairness.geometry.bottleneck,
            judge_geometry(original, bench.setup.robot, {}).bottleneck - 1e-9);
}

TEST(Shrink, RefusesARunThatReachesTheGoal) {
  const TestBench bench = planted_bench("none");
  EXPECT_TRUE(throws_error(ErrorKind::Job, "scenario passage", {"base", "reaches the goal"},
                           [&] { shrink(bench, passage()); }));
}

TEST(Shrink, EndsAtTheLimitOfRunsWithoutAProof) {
  ShrinkOptions options;
  options.max_runs = 10;
  const auto small = shrink(planted_bench("squeeze"), passage(), options);
  ASSERT_TRUE(small);
  EXPECT_LE(small->runs, 11U);
  EXPECT_FALSE(small->minimal);
}

TEST(Shrink, ReportsTheNumberOfRunsWhileItWorks) {
  std::vector<std::size_t> reported;
  ShrinkOptions options;
  options.on_runs = [&](std::size_t runs) { reported.push_back(runs); };
  // Ends after 20 runs, however many of them were seen one by one.
  options.interrupted = [&] { return !reported.empty() && reported.back() >= 20; };
  EXPECT_FALSE(shrink(planted_bench("squeeze"), passage(), options));
  ASSERT_FALSE(reported.empty());
  EXPECT_GE(reported.back(), 20U);
  EXPECT_TRUE(std::adjacent_find(reported.begin(), reported.end(), std::greater_equal<>()) ==
              reported.end());
}

TEST(Shrink, IsInterrupted) {
  ShrinkOptions options;
  options.interrupted = [] { return true; };
  EXPECT_FALSE(shrink(planted_bench("squeeze"), passage(), options));
}

}  // namespace
}  // namespace slalom
