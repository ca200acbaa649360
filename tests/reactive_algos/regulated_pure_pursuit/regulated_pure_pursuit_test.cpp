// SPDX-License-Identifier: BSD-3-Clause
#include "observations.h"
#include "regulated_pure_pursuit/regulated_pure_pursuit.h"

#include <gtest/gtest.h>

namespace regulated_pure_pursuit {
namespace {

using namespace reactive;

Twist decide(const std::vector<Wall>& walls, const Point& goal, const Twist& now = {},
             const Parameters& parameters = {}) {
  RegulatedPurePursuit method(parameters, {});
  method.reset({goal, 0.2, 0.1, 1});
  return method.step(observe(walls, goal, now));
}

TEST(Carrot, IsWhereThePathLeavesTheCircle) {
  // From (0.6, 0) up: at a distance of 1 the height is 0.8.
  const Point p = carrot_of({{0.3, 0}, {0.6, 0}, {0.6, 2}}, 1);
  EXPECT_NEAR(p.x, 0.6, 1e-12);
  EXPECT_NEAR(p.y, 0.8, 1e-12);
  const Point first = carrot_of({{3, 4}}, 1);
  EXPECT_NEAR(first.x, 0.6, 1e-12);
  EXPECT_NEAR(first.y, 0.8, 1e-12);
}

TEST(Carrot, IsTheEndOfAShorterPath) {
  const Point p = carrot_of({{0.2, 0}, {0.4, 0.1}}, 1);
  EXPECT_EQ(p.x, 0.4);
  EXPECT_EQ(p.y, 0.1);
}

TEST(Curvature, IsThatOfTheArcThroughTheCarrot) {
  // A quarter of a circle of radius 2 to the left ends at (2, 2); the other one at (2, -2).
  EXPECT_NEAR(curvature_to({2, 2}), 0.5, 1e-12);
  EXPECT_NEAR(curvature_to({2, -2}), -0.5, 1e-12);
  EXPECT_EQ(curvature_to({2, 0}), 0);
  EXPECT_EQ(curvature_to({0, 0}), 0);
  // Any point of a circle through the origin that is tangent to the x axis there.
  for (double angle = 0.1; angle < 3; angle += 0.1)
    EXPECT_NEAR(curvature_to({2 * std::sin(angle), 2 * (1 - std::cos(angle))}), 0.5, 1e-9);
}

constexpr double kInscribed = 0.2;  // m

TEST(RegulatedSpeed, FallsWithTheRadiusOfTheTurn) {
  const Parameters p;
  EXPECT_EQ(regulated_speed(p, kInscribed, 0, 5, 5), 1);
  EXPECT_EQ(regulated_speed(p, kInscribed, 1 / 0.9, 5, 5), 1);
  EXPECT_NEAR(regulated_speed(p, kInscribed, -1 / 0.45, 5, 5), 0.5, 1e-12);
  EXPECT_EQ(regulated_speed(p, kInscribed, 100, 5, 5), 0.25) << "not below the minimum";
}

TEST(RegulatedSpeed, FallsWithTheClearance) {
  const Parameters p;
  EXPECT_EQ(regulated_speed(p, kInscribed, 0, 0.6, 5), 1);
  // The center has 0.2 m more: 0.5 of 0.8 m.
  EXPECT_NEAR(regulated_speed(p, kInscribed, 0, 0.3, 5), 0.5 / 0.8, 1e-12);
  EXPECT_NEAR(regulated_speed(p, kInscribed, 0, 0, 5), 0.2 / 0.8, 1e-12);
  EXPECT_EQ(regulated_speed(p, 0.01, 0, 0.01, 5), 0.25) << "not below the minimum";
  // The slower one of both heuristics counts: 0.5 of the radius, 3/4 of the distance.
  EXPECT_NEAR(regulated_speed(p, kInscribed, 1 / 0.45, 0.4, 5), 0.5, 1e-12);
}

/// costConstraint() of nav2's regulation_functions.hpp: gain * distance of the center /
/// cost_scaling_dist, here 0.6 m with an inscribed radius of 0.22 m.
TEST(RegulatedSpeed, IsThatOfNav2AtTheSameDistanceOfTheCenter) {
  Parameters p;
  p.cost_scaling_dist = 0.6 - 0.22;
  EXPECT_NEAR(regulated_speed(p, 0.22, 0, 0.14, 5), 0.36 / 0.6, 1e-12);
  EXPECT_NEAR(regulated_speed(p, 0.22, 0, 0, 5), 0.22 / 0.6, 1e-12);
  EXPECT_EQ(regulated_speed(p, 0.22, 0, 0.38, 5), 1);
}

TEST(RegulatedSpeed, FallsNearTheGoal) {
  const Parameters p;
  EXPECT_EQ(regulated_speed(p, kInscribed, 0, 5, 0.6), 1);
  EXPECT_NEAR(regulated_speed(p, kInscribed, 0, 5, 0.3), 0.5, 1e-12);
  EXPECT_NEAR(regulated_speed(p, kInscribed, 0, 5, 0.01), 0.05, 1e-12);
  Parameters slow;
  slow.desired_linear_vel = 0.1;
  EXPECT_NEAR(regulated_speed(slow, kInscribed, 100, 0, 5), 0.1, 1e-12)
      << "the minimum does not raise it";
}

TEST(RegulatedPurePursuit, MovesStraightToAGoalInFreeSpace) {
  const Twist twist = decide({}, {5, 0}, {1, 0});
  EXPECT_DOUBLE_EQ(twist.v, 1);
  EXPECT_NEAR(twist.w, 0, 0.05);
}

TEST(RegulatedPurePursuit, PursuesTheCarrotAtTheLookAheadDistance) {
  // At rest the carrot is 0.3 m ahead in the direction of the goal: curvature 2 sin(angle) / 0.3.
  const double angle = 0.5;
  const Twist twist = decide({}, {5 * std::cos(angle), 5 * std::sin(angle)});
  EXPECT_NEAR(twist.w / twist.v, 2 * std::sin(angle) / 0.3, 0.1);
  // At 0.4 m/s it is 0.6 m ahead.
  const Twist faster = decide({}, {5 * std::cos(angle), 5 * std::sin(angle)}, {0.4, 0});
  EXPECT_NEAR(faster.w / faster.v, 2 * std::sin(angle) / 0.6, 0.1);
}

TEST(RegulatedPurePursuit, RotatesInPlaceToAGoalBehind) {
  const Twist twist = decide({}, {-3, 0.5});
  EXPECT_EQ(twist.v, 0);
  EXPECT_GT(twist.w, 1);
}

TEST(RegulatedPurePursuit, RotatesToTheOtherSideAsSoonAsTheGoalIsThere) {
  RegulatedPurePursuit method({}, {});
  method.reset({{0, 3}, 0.2, 0.1, 1});
  EXPECT_GT(method.step(observe({}, {0, 3})).w, 0);
  EXPECT_LT(method.step(observe({}, {1, -1})).w, 0) << "from the left to 45 degrees on the right";
}

TEST(RegulatedPurePursuit, TurnsTowardsTheOpenEndOfAWall) {
  EXPECT_GT(decide({{1.2, -4, 1.2, 0.3}}, {5, 0}, {0.3, 0}).w, 0);
  EXPECT_LT(decide({{1.2, -0.3, 1.2, 4}}, {5, 0}, {0.3, 0}).w, 0);
}

TEST(RegulatedPurePursuit, StopsBeforeACollision) {
  // A wall 0.7 m ahead of the center of a robot of 0.25 m radius, with the goal right before it.
  const std::vector<Wall> wall = {{0.7, -3, 0.7, 3}};
  EXPECT_EQ(decide(wall, {0.6, 0}, {1, 0}).v, 0);
  Parameters brave;
  brave.max_allowed_time_to_collision_up_to_carrot = 0.1;
  EXPECT_GT(decide(wall, {0.6, 0}, {1, 0}, brave).v, 0);
}

TEST(RegulatedPurePursuit, IsSlowerBetweenWallsAndInTurns) {
  const std::vector<Wall> corridor = {{-6, 0.55, 8, 0.55}, {-6, -0.55, 8, -0.55}};
  // 0.3 m from both walls, with a radius of 0.25 m.
  EXPECT_NEAR(decide(corridor, {5, 0}, {1, 0}).v, (0.3 + 0.25) / (0.6 + 0.25), 0.05);
  const double angle = 0.7;
  EXPECT_LT(decide({}, {5 * std::cos(angle), 5 * std::sin(angle)}, {0.4, 0}).v, 0.6);
}

}  // namespace
}  // namespace regulated_pure_pursuit
