// SPDX-License-Identifier: BSD-3-Clause
#include "common/motion.h"
#include "observations.h"

#include <gtest/gtest.h>

namespace reactive {
namespace {

TEST(Wrapped, MapsAnglesToOneTurn) {
  EXPECT_NEAR(wrapped(3 * M_PI), M_PI, 1e-12);
  EXPECT_NEAR(wrapped(-M_PI), M_PI, 1e-12);
  EXPECT_NEAR(wrapped(-0.5), -0.5, 1e-12);
}

TEST(Integrate, FollowsACircle) {
  // Radius v / w = 2 m; a quarter of it takes (pi / 2) / 0.5 s.
  const Pose quarter = integrate({0, 0, 0}, {1, 0.5}, M_PI);
  EXPECT_NEAR(quarter.x, 2, 1e-9);
  EXPECT_NEAR(quarter.y, 2, 1e-9);
  EXPECT_NEAR(quarter.phi, M_PI / 2, 1e-9);
  EXPECT_NEAR(integrate({1, 2, M_PI / 2}, {1, 0}, 3).y, 5, 1e-9);
}

TEST(FreeArcLength, EndsAtContact) {
  const LocalMap map = map_of({{2, -4, 2, 4}});
  const std::vector<double> lengths =
      free_arc_lengths(map.clearance(), {}, {{0.5, 0}, {0.5, 0.5}, {0, 1}}, {}, 0.25, 5);
  // Straight ahead the disc of 0.25 m touches after 1.75 m.
  EXPECT_NEAR(lengths[0], 1.75, 0.03);
  // On a circle of radius 1 m to the left the center reaches only x = 1: 0.75 m remain.
  EXPECT_EQ(lengths[1], 5);
  EXPECT_EQ(lengths[2], 5);
}

TEST(FreeArcLength, OfManyArcsIsThatOfEachAlone) {
  const LocalMap map = map_of({{2, -4, 2, 0.3}, {1, 0.9, 1.5, 4}});
  const Pose pose = {0.1, -0.2, 0.4};
  std::vector<Twist> twists;
  for (int i = 0; i < 300; ++i) twists.push_back({0.1 * (i % 8), 0.02 * (i - 150)});
  const std::vector<double> lengths = free_arc_lengths(map.clearance(), pose, twists, {}, 0.25, 3);
  for (std::size_t i = 0; i < twists.size(); ++i) {
    // Steps of the clearance, at least of 0.02 m, until the disc touches.
    double length = 0;
    while (twists[i].v > 0 && length < 3) {
      const Pose at = integrate(pose, twists[i], length / twists[i].v);
      const double gap = map.clearance().at({at.x, at.y}) - 0.25;
      if (gap < 0) break;
      length += std::max(gap, 0.02);
    }
    const double expected = twists[i].v > 0 ? std::min(length, 3.0) : 3;
    EXPECT_NEAR(lengths[i], expected, 1e-9) << i;
  }
}

TEST(ClearanceRadius, IsReducedCloseToObstacles) {
  Robot robot;
  robot.radius = 0.25;
  EXPECT_NEAR(clearance_radius(map_of({}).clearance(), {}, robot, 0.1), 0.35, 1e-9);
  const LocalMap near = map_of({{0.3, -1, 0.3, 1}});
  EXPECT_NEAR(clearance_radius(near.clearance(), {}, robot, 0.1), 0.295, 0.01);
}

TEST(RotateInPlace, StartsAndEndsAtDifferentAngles) {
  RotateInPlace turn(1.2, 0.4);
  EXPECT_FALSE(turn.update(1.1));
  EXPECT_TRUE(turn.update(1.3));
  EXPECT_TRUE(turn.update(0.5));
  EXPECT_FALSE(turn.update(0.3));
}

TEST(RotateInPlace, KeepsItsSideWhenTheBearingPassesBehind) {
  RotateInPlace turn(1.2, 0.4);
  EXPECT_TRUE(turn.update(3.0));
  EXPECT_TRUE(turn.update(-3.0));
  EXPECT_GT(turn.twist(-3.0, {}, {}, 0.1).w, 0);
  // If the bearing is ahead on the other side, the side changes.
  EXPECT_TRUE(turn.update(-1.0));
  EXPECT_LT(turn.twist(-1.0, {}, {}, 0.1).w, 0);
}

TEST(RotateInPlace, BrakesOnItsArcUntilTheRobotCanStopInOnePeriod) {
  Robot robot;
  robot.max_accel_v = 1;
  RotateInPlace turn(1.2, 0.4);
  ASSERT_TRUE(turn.update(2.0));
  // After 0.1 s of braking with 1 m/s^2, 0.5 m/s are 0.4 m/s: the curvature 0.6 / 0.5 is kept with
  // w = 0.48.
  const Twist braking = turn.twist(2.0, {0.5, -0.6}, robot, 0.1);
  EXPECT_EQ(braking.v, 0);
  EXPECT_NEAR(braking.w, -0.48, 1e-12);
  for (const double slow : {0.0, 0.05, 0.0999})
    EXPECT_GT(turn.twist(2.0, {slow, 0}, robot, 0.1).w, 0);
}

TEST(StoppingAngularVelocity, AllowsStoppingWithinTheAngle) {
  const Robot robot;
  for (const double angle : {-2.0, -0.3, 0.05, 0.4, 3.0}) {
    const double w = stopping_angular_velocity(angle, robot);
    EXPECT_LE(w * w / (2 * robot.max_accel_w), std::abs(angle));
    EXPECT_GT(w * angle, 0);
    EXPECT_LE(std::abs(w), robot.max_w);
  }
}

TEST(InscribedRadius, IsTheDistanceToTheClosestEdge) {
  Robot robot;
  EXPECT_EQ(inscribed_radius(robot), 0.25) << "of a disc";
  robot.footprint = {{0.21, 0.165}, {-0.21, 0.165}, {-0.21, -0.165}, {0.21, -0.165}};
  robot.radius = std::hypot(0.21, 0.165);
  EXPECT_NEAR(inscribed_radius(robot), 0.165, 1e-12);
  const double x = 0.3, y = 0.4;  // the edge between (0.3, 0) and (0, 0.4): 0.3 * 0.4 / 0.5
  robot.footprint = {{x, 0}, {0, y}, {-1, 0}, {0, -1}};
  EXPECT_NEAR(inscribed_radius(robot), 0.24, 1e-12);
}

}  // namespace
}  // namespace reactive
