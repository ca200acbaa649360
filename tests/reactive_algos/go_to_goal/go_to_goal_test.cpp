// SPDX-License-Identifier: BSD-3-Clause
#include "go_to_goal/go_to_goal.h"
#include "observations.h"

#include <gtest/gtest.h>

namespace go_to_goal {
namespace {

using namespace reactive;

Twist decide(const Point& goal, const std::vector<Wall>& walls = {}) {
  GoToGoal method({}, {});
  method.reset({});
  return method.step(observe(walls, goal));
}

TEST(GoToGoal, MovesStraightAhead) {
  EXPECT_DOUBLE_EQ(decide({5, 0}).v, 1);
  EXPECT_DOUBLE_EQ(decide({5, 0}).w, 0);
}

TEST(GoToGoal, SlowsDownBeforeTheGoal) {
  // Distance 0.2 m plus half of the tolerance of 0.2 m: v^2 = 2 * 0.7 * 1 * 0.3.
  EXPECT_NEAR(decide({0.2, 0}).v, std::sqrt(0.42), 1e-9);
}

TEST(GoToGoal, RotatesInPlaceTowardsAGoalBehind) {
  EXPECT_EQ(decide({-3, 1}).v, 0);
  EXPECT_GT(decide({-3, 1}).w, 1);
  EXPECT_LT(decide({-3, -1}).w, -1);
}

TEST(GoToGoal, StopsBeforeItTurnsTowardsAGoalBehind) {
  GoToGoal method({}, {});
  method.reset({});
  EXPECT_EQ(method.step(observe({}, {-3, 1}, {0.8, 0})).w, 0);
  EXPECT_GT(method.step(observe({}, {-3, 1}, {0.05, 0})).w, 1);
}

TEST(GoToGoal, IgnoresObstacles) {
  EXPECT_DOUBLE_EQ(decide({5, 0}, {{0.5, -1, 0.5, 1}}).v, 1);
}

}  // namespace
}  // namespace go_to_goal
