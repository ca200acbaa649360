// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"

#include <slalom/limit.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

NamedMethod towards_goal_method() {
  Methods methods;
  // Turns towards the goal, then moves forward.
  methods.add("mine", [](const Observation& seen) {
    const double bearing = std::atan2(seen.goal_in_robot.y, seen.goal_in_robot.x);
    return Command{std::abs(bearing) < 0.3 ? 1.0 : 0.0, std::max(-1.5, std::min(1.5, 2 * bearing))};
  });
  return methods.list().at(0);
}

/// A family without obstacles below 2, with so many above that the straight line is never free.
std::shared_ptr<const Generator> empty_below_two(double value) {
  RandomGeneratorOptions family;
  family.obstacles.min_obstacles = family.obstacles.max_obstacles = value < 2 ? 0 : 60;
  family.obstacles.size = {0.3, 0.4};
  return make_generator(family);
}

TEST(Limit, ClaimsTheBinsInWhichTheMethodSucceedsAndNoneBehindThem) {
  LimitOptions search;
  search.reliability = 0.8;
  search.blocks = 0;
  const LimitResult result = limit(towards_goal_method(), empty_below_two, {0, 1, 2, 3, 4}, search);
  ASSERT_TRUE(result.complete);
  EXPECT_EQ(result.claimed(), 2U);
  for (std::size_t step = 0; step < 2; ++step) {
    EXPECT_EQ(result.steps[step].bins.first, step);
    EXPECT_EQ(result.steps[step].runs, runs_without_failure(0.8, 0.95));
  }
  EXPECT_EQ(result.steps.back().bins.first, 2U);
}

TEST(Limit, IsTheSameForAnyNumberOfWorkers) {
  LimitOptions search;
  search.reliability = 0.5;
  Options options;
  const std::vector<double> edges = {1.4, 1, 0.6};
  const FamilyAt passage = [](double width) {
    PassageOptions family;
    family.min_width = family.max_width = width;
    return make_generator(family);
  };
  const LimitResult one = limit(towards_goal_method(), passage, edges, search, options);
  options.workers = 3;
  const LimitResult three = limit(towards_goal_method(), passage, edges, search, options);
  ASSERT_EQ(one.steps.size(), three.steps.size());
  for (std::size_t i = 0; i < one.steps.size(); ++i) {
    EXPECT_EQ(one.steps[i].runs, three.steps[i].runs);
    EXPECT_EQ(one.steps[i].failures, three.steps[i].failures);
  }
}

TEST(Limit, AValueForWhichNoScenarioIsSolvableIsAFailure) {
  LimitOptions search;
  search.reliability = 0.5;
  const FamilyAt closed = [](double) {
    PassageOptions family;
    family.min_width = family.max_width = 0.3;  // m, of a robot of 0.5 m
    return make_generator(family);
  };
  const LimitResult result = limit(towards_goal_method(), closed, {0, 1}, search);
  EXPECT_EQ(result.claimed(), 0U);
  EXPECT_EQ(result.curve.at(0).failures, result.curve.at(0).runs);
}

TEST(Limit, RefusesEdgesWithoutABin) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "limit", {"at least two"},
                           [] { limit(towards_goal_method(), empty_below_two, {1}); }));
}

}  // namespace
}  // namespace slalom
