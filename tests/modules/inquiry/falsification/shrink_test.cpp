// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "planted_methods.h"

#include <slalom/core/wall_clock.h>
#include <slalom/falsification/shrink.h>
#include <slalom/generation/scene.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <set>
#include <unistd.h>
#include <utility>

namespace slalom {
namespace {

/// The outcome of a run in this process, without the code that is tested.
Outcome outcome_in(const Scenario& scenario, const FalsificationSetup& setup,
                   const NamedMethod& method) {
  const auto made = method.make(setup.run.robot, setup.run.sensor);
  return run_trial(World(scenario, setup.run.simulation.resolution), setup, *made).outcome;
}

/// Removes each obstacle of a continuous scenario alone.
void expect_minimal(const Scenario& scenario, const FalsificationSetup& setup, Outcome outcome) {
  const std::size_t count = Scene(scenario).obstacles.size();
  for (std::size_t i = 0; i < count; ++i) {
    Scene scene(scenario);
    scene.obstacles.erase(scene.obstacles.begin() + static_cast<std::ptrdiff_t>(i));
    const Scenario without = scene.scenario("without");
    EXPECT_FALSE(outcome_in(without, setup, setup.method) == outcome &&
                 outcome_in(without, setup, setup.witnesses[0]) == Outcome::Success)
        << "obstacle " << i << " is not needed";
  }
}

TEST(Shrink, KeepsOnlyTheObstaclesThatTheFailureNeeds) {
  const FalsificationSetup setup = planted_setup("squeeze");
  ASSERT_EQ(outcome_in(passage(), setup, setup.method), Outcome::Collision);
  const auto small = shrink(setup, passage());
  ASSERT_TRUE(small);
  EXPECT_EQ(small->parts_before, 13U);
  EXPECT_LE(small->parts_after, 3U);
  EXPECT_EQ(small->trial.outcome, Outcome::Collision);
  EXPECT_EQ(outcome_in(small->scenario, setup, setup.method), Outcome::Collision);
  EXPECT_EQ(outcome_in(small->scenario, setup, setup.witnesses[0]), Outcome::Success);
  EXPECT_TRUE(small->minimal);
  EXPECT_EQ(small->removals.size(), small->parts_after);
  expect_minimal(small->scenario, setup, Outcome::Collision);
  EXPECT_LE(small->runs, 500U);
  RecordProperty("runs", static_cast<int>(small->runs));
}

TEST(Shrink, RemovesMoversThatTheFailureDoesNotNeed) {
  const FalsificationSetup setup = planted_setup("squeeze");
  // One that comes when the run is long over, one that stands in a corner.
  const Movers movers{{"late", 0.3, {{1e5, {5, 5}}}, MoverEnd::Stop},
                      {"aside", 0.1, {{0, {0.2, 9.8}}}, MoverEnd::Stop}};
  for (const Scenario& scenario : {passage(), convert(passage(), Representation::Grid, 0.05)}) {
    const auto small = shrink(setup, scenario.with_movers(movers));
    ASSERT_TRUE(small);
    EXPECT_EQ(small->parts_before, 15U);
    EXPECT_TRUE(small->scenario.movers().empty());
    EXPECT_TRUE(small->minimal);
    EXPECT_EQ(outcome_in(small->scenario, setup, setup.method), Outcome::Collision);
  }
}

TEST(Shrink, RemovesPeopleThatTheFailureDoesNotNeed) {
  FalsificationSetup setup = planted_setup("squeeze");
  // One who comes when the run is long over, one who stands in a corner.
  const People people{{"late", 0.3, 1, {5, 5}, {{8, 5}}, 1e5},
                      {"aside", 0.1, 1, {0.2, 9.8}, {{0.2, 9.8}}}};
  for (const Scenario& scenario : {passage(), convert(passage(), Representation::Grid, 0.05)}) {
    const auto small = shrink(setup, scenario.with_people(people));
    ASSERT_TRUE(small);
    EXPECT_EQ(small->parts_before, 15U);
    EXPECT_TRUE(small->scenario.people().empty());
    EXPECT_TRUE(small->minimal);
    EXPECT_EQ(outcome_in(small->scenario, setup, setup.method), Outcome::Collision);
  }
}

/// A fast person who does not notice the robot comes from behind, by way of its path; two others
/// walk far from it.
TEST(Shrink, ShortensAndRoundsTheRoutesOfPeople) {
  FalsificationSetup setup = planted_setup("none");
  setup.run.people.notices = 0;
  const Scenario scenario =
      Scenario::continuous("path", {0, 0, 12, 10}, {}, {2.53, 5, 0}, {10.97, 5})
          .with_people({{"anna", 0.31, 2.87, {0.73, 5.01}, {{3.13, 5}, {6.17, 5.03}, {11.31, 5}}},
                        {"bert", 0.25, 1.3, {1.1, 9.1}, {{8.9, 9.1}}},
                        {"carl", 0.25, 1.3, {8.9, 1.1}, {{5.3, 1.3}, {1.1, 1.1}}}});
  ASSERT_EQ(outcome_in(scenario, setup, setup.method), Outcome::Collision);
  const auto small = shrink(setup, scenario);
  ASSERT_TRUE(small);
  EXPECT_EQ(small->trial.outcome, Outcome::Collision);
  EXPECT_NE(small->trial.detail.find("contact with person 'anna'"), std::string::npos);
  EXPECT_EQ(small->parts_before, 3U);
  EXPECT_EQ(small->parts_after, 1U);
  ASSERT_EQ(small->scenario.people().size(), 1U);
  const Person& anna = small->scenario.people()[0];
  EXPECT_EQ(anna.route.size(), 1U);
  EXPECT_LT(anna.route.back().x, 10);
  EXPECT_NEAR(anna.radius, 0.31, 0.025);
  EXPECT_NEAR(anna.speed, 2.87, 0.025);
  const auto is_round = [](double x) { return std::abs(x * 20 - std::round(x * 20)) < 1e-9; };
  for (const double number :
       {anna.start.x, anna.start.y, anna.route[0].x, anna.route[0].y, anna.radius, anna.speed})
    EXPECT_TRUE(is_round(number)) << number;
  ASSERT_EQ(small->removals.size(), 1U);
  EXPECT_EQ(small->removals[0].part.find("person 'anna' of radius "), 0U);
  EXPECT_EQ(small->removals[0].verdict, "base: success");
  EXPECT_TRUE(small->minimal);
  RecordProperty("runs", static_cast<int>(small->runs));
}

TEST(Shrink, TheResultIsFair) {
  const auto small = shrink(planted_setup("squeeze"), passage());
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
  const auto small = shrink(planted_setup("squeeze"), passage());
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
  const FalsificationSetup setup = planted_setup("squeeze");
  const auto first = shrink(setup, passage()), second = shrink(setup, passage());
  ASSERT_TRUE(first && second);
  EXPECT_EQ(first->scenario.hash(), second->scenario.hash());
  EXPECT_TRUE(is_same_run(first->trial, second->trial));
  EXPECT_EQ(first->runs, second->runs);
}

TEST(Shrink, ACrashOfTheMethodIsAFailureLikeAnyOther) {
  const auto small = shrink(planted_setup("crash"), passage());
  ASSERT_TRUE(small);
  EXPECT_EQ(small->trial.outcome, Outcome::MethodCrash);
  EXPECT_LE(small->parts_after, 3U);
  EXPECT_TRUE(small->minimal);
  EXPECT_TRUE(small->fairness.fair());
}

TEST(Shrink, AMapIsShrunkByGroupsOfCells) {
  const FalsificationSetup setup = planted_setup("squeeze");
  const Scenario map = convert(passage(), Representation::Grid, 0.05);
  ASSERT_EQ(outcome_in(map, setup, setup.method), Outcome::Collision);
  const auto small = shrink(setup, map);
  ASSERT_TRUE(small);
  EXPECT_EQ(small->parts_before, 13U);
  EXPECT_LE(small->parts_after, 3U);
  EXPECT_EQ(outcome_in(small->scenario, setup, setup.method), Outcome::Collision);
  EXPECT_TRUE(small->minimal);
  EXPECT_TRUE(small->fairness.fair());
}

/// The obstacles of passage() inside a wall that connects them all, as cells of 5 cm.
Scenario connected_map() {
  Primitives obstacles = passage().primitives();
  for (Disc& disc : obstacles.discs) disc.center.y = 9.75;
  for (Polygon& polygon : obstacles.polygons)
    for (auto& vertex : polygon.vertices) {
      if (vertex.y == 0.5 || vertex.y == 1.23) vertex.y = 0;
      if (vertex.y == 9.5) vertex.y = 10;
    }
  for (const Bounds& wall : {Bounds{0, 0, 10, 0.1}, Bounds{0, 9.9, 10, 10}, Bounds{0, 0, 0.1, 10},
                             Bounds{9.9, 0, 10, 10}})
    obstacles.polygons.push_back({{{wall.x_min, wall.y_min},
                                   {wall.x_max, wall.y_min},
                                   {wall.x_max, wall.y_max},
                                   {wall.x_min, wall.y_max}}});
  const Scenario drawn = Scenario::continuous("map", passage().bounds(), obstacles,
                                              passage().start(), passage().goal());
  return convert(drawn, Representation::Grid, 0.05);
}

TEST(Shrink, OfAMapWithConnectedWallsNoGroupAndNoBlockCanBeRemoved) {
  const FalsificationSetup setup = planted_setup("squeeze");
  const Scenario map = connected_map();
  ASSERT_EQ(outcome_in(map, setup, setup.method), Outcome::Collision);
  const auto small = shrink(setup, map);
  ASSERT_TRUE(small);
  EXPECT_EQ(small->parts_before, 1U);
  EXPECT_TRUE(small->minimal);
  const auto& cells = *small->scenario.grid_map();
  constexpr int kBlock = 4;  // cells, of the finest division
  const int size_x = static_cast<int>(cells.getSizeX()),
            size_y = static_cast<int>(cells.getSizeY());
  std::size_t blocks = 0, occupied = 0;
  for (int by = 0; by < size_y; by += kBlock)
    for (int bx = 0; bx < size_x; bx += kBlock) {
      auto without = cells;
      std::size_t removed = 0;
      for (int y = by; y < std::min(by + kBlock, size_y); ++y)
        for (int x = bx; x < std::min(bx + kBlock, size_x); ++x) {
          removed += cells.getCell(x, y) < 0.5F ? 1 : 0;
          without.setCell(x, y, 1.0F);
        }
      if (removed == 0) continue;
      ++blocks;
      occupied += removed;
      const Scenario rest =
          Scenario::grid("without", without, small->scenario.start(), small->scenario.goal());
      EXPECT_FALSE(outcome_in(rest, setup, setup.method) == Outcome::Collision &&
                   outcome_in(rest, setup, setup.witnesses[0]) == Outcome::Success)
          << "the block at " << bx << ", " << by << " is not needed";
    }
  EXPECT_GE(blocks, 1U);
  EXPECT_LE(occupied, 200U) << "of about 6,000";
  // The proof: each group, and each block that is not a group.
  EXPECT_GE(small->removals.size(), std::max(blocks, small->parts_after));
  EXPECT_LE(small->removals.size(), blocks + small->parts_after);
}

TEST(Shrink, APointMapIsShrunkBySquaresOfPoints) {
  const FalsificationSetup setup = planted_setup("squeeze");
  const Scenario points =
      convert(convert(passage(), Representation::Grid, 0.05), Representation::Points, 0.05);
  ASSERT_EQ(outcome_in(points, setup, setup.method), Outcome::Collision);
  const auto small = shrink(setup, points);
  ASSERT_TRUE(small);
  EXPECT_TRUE(small->minimal);
  EXPECT_TRUE(small->fairness.fair());
  EXPECT_EQ(outcome_in(small->scenario, setup, setup.method), Outcome::Collision);
  const auto& map = *small->scenario.point_map();
  EXPECT_LE(map.size(), points.point_map()->size() / 10);
  constexpr double kSquare = 0.2;  // m, four times the resolution
  const auto square_of = [&](std::size_t i) {
    float x = 0, y = 0;
    map.getPoint(i, x, y);
    return std::make_pair(std::floor(static_cast<double>(x) / kSquare),
                          std::floor(static_cast<double>(y) / kSquare));
  };
  std::set<std::pair<double, double>> squares;
  for (std::size_t i = 0; i < map.size(); ++i) squares.insert(square_of(i));
  for (const auto& square : squares) {
    mrpt::maps::CSimplePointsMap rest;
    for (std::size_t i = 0; i < map.size(); ++i) {
      float x = 0, y = 0;
      map.getPoint(i, x, y);
      if (square_of(i) != square) rest.insertPoint(x, y);
    }
    const Scenario without = Scenario::points("without", small->scenario.bounds(), rest,
                                              small->scenario.start(), small->scenario.goal());
    EXPECT_FALSE(outcome_in(without, setup, setup.method) == Outcome::Collision &&
                 outcome_in(without, setup, setup.witnesses[0]) == Outcome::Success)
        << "the square at " << square.first << ", " << square.second << " is not needed";
  }
}

TEST(Shrink, AnUnfairFailureStaysAsFairAsItIs) {
  FalsificationSetup setup = planted_setup("squeeze");
  ShrinkOptions options;
  options.fairness.min_bottleneck = 3;  // robot widths; the passage has less
  const auto small = shrink(setup, passage(), options);
  ASSERT_TRUE(small);
  EXPECT_LE(small->parts_after, 3U);
  EXPECT_FALSE(small->fairness.fair());
  const World original(passage(), 0.05);
  EXPECT_GE(small->fairness.geometry.bottleneck,
            judge_geometry(original, setup.run.robot, {}).bottleneck - 1e-9);
}

TEST(Shrink, RefusesARunThatReachesTheGoal) {
  const FalsificationSetup setup = planted_setup("none");
  EXPECT_TRUE(throws_error(ErrorKind::Job, "scenario passage", {"base", "reaches the goal"},
                           [&] { shrink(setup, passage()); }));
}

TEST(Shrink, EndsAtTheLimitOfRunsWithoutAProof) {
  ShrinkOptions options;
  options.max_runs = 10;
  const auto small = shrink(planted_setup("squeeze"), passage(), options);
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
  FalsificationSetup setup = planted_setup("squeeze");
  // Read twice in each control cycle: runs last longer than it takes to see them, on any machine.
  setup.run.clock = [] {
    usleep(50);
    return steady_seconds();
  };
  EXPECT_FALSE(shrink(setup, passage(), options));
  ASSERT_FALSE(reported.empty());
  EXPECT_GE(reported.back(), 20U);
  EXPECT_TRUE(std::adjacent_find(reported.begin(), reported.end(), std::greater_equal<>()) ==
              reported.end());
}

TEST(Shrink, ResultsAreReadAsTheyWereWritten) {
  const auto small = shrink(planted_setup("squeeze"), passage());
  ASSERT_TRUE(small);
  const std::string bytes = to_bytes(*small);
  const ShrinkResult read = shrink_result_from_bytes(bytes, "shrunk");
  EXPECT_EQ(to_bytes(read), bytes);
  EXPECT_EQ(read.scenario.hash(), small->scenario.hash());
  EXPECT_TRUE(is_same_run(read.trial, small->trial));
  EXPECT_EQ(read.parts_before, small->parts_before);
  EXPECT_EQ(read.parts_after, small->parts_after);
  EXPECT_EQ(read.runs, small->runs);
  EXPECT_EQ(read.unfair, small->unfair);
  EXPECT_EQ(read.moved, small->moved);
  EXPECT_EQ(read.minimal, small->minimal);
  ASSERT_EQ(read.removals.size(), small->removals.size());
  EXPECT_EQ(read.removals[0].part, small->removals[0].part);
  EXPECT_EQ(read.removals[0].verdict, small->removals[0].verdict);
  EXPECT_EQ(read.fairness.geometry.bottleneck, small->fairness.geometry.bottleneck);
  EXPECT_EQ(read.fairness.witness, "base");
  EXPECT_TRUE(is_same_run(read.fairness.witness_run, small->fairness.witness_run));
  EXPECT_TRUE(read.fairness.repeatable);
  for (std::size_t size = 0; size < bytes.size(); size += 1 + bytes.size() / 100)
    EXPECT_THROW(shrink_result_from_bytes(bytes.substr(0, size), "shrunk"), Error);
  EXPECT_THROW(shrink_result_from_bytes(bytes + "x", "shrunk"), Error);
}

TEST(Shrink, IsInterrupted) {
  ShrinkOptions options;
  options.interrupted = [] { return true; };
  EXPECT_FALSE(shrink(planted_setup("squeeze"), passage(), options));
}

TEST(Shrink, TheSimplerOneHasFewerObstaclesThenAWiderBottleneckThenAShorterWay) {
  const Scenario empty = Scenario::continuous("empty", {0, 0, 4, 4}, {}, {1, 2, 0}, {3, 2});
  const auto shrunk = [&](std::size_t obstacles, double bottleneck, double distance) {
    ShrinkResult small{empty, {}};
    small.parts_after = obstacles;
    small.fairness.geometry.bottleneck = bottleneck;
    small.fairness.geometry.distance = distance;
    return small;
  };
  EXPECT_TRUE(is_simpler(shrunk(1, 1.5, 3), shrunk(2, 4, 2)));
  EXPECT_TRUE(is_simpler(shrunk(2, 3, 3), shrunk(2, 2, 2)));
  EXPECT_TRUE(is_simpler(shrunk(2, 2, 2), shrunk(2, 2, 3)));
  EXPECT_FALSE(is_simpler(shrunk(2, 2, 2), shrunk(2, 2, 2)));
}

}  // namespace
}  // namespace slalom
