// SPDX-License-Identifier: BSD-3-Clause
#include "dwa/dwa.h"
#include "observations.h"

#include <gtest/gtest.h>

namespace dwa {
namespace {

using namespace reactive;

Twist decide(const std::vector<Wall>& walls, const Point& goal, const Twist& now = {},
             const Parameters& parameters = {}) {
  Dwa method(parameters, {});
  method.reset({goal, 0.2, 0.1, 1});
  return method.step(observe(walls, goal, now));
}

TEST(DynamicWindow, ContainsTheVelocitiesReachableWithinAPeriod) {
  // 1 m/s^2 and 3 rad/s^2 for 0.1 s.
  const Window window = dynamic_window({0.5, 0.2}, {}, 0.1);
  EXPECT_NEAR(window.low.v, 0.4, 1e-12);
  EXPECT_NEAR(window.high.v, 0.6, 1e-12);
  EXPECT_NEAR(window.low.w, -0.1, 1e-12);
  EXPECT_NEAR(window.high.w, 0.5, 1e-12);
}

TEST(DynamicWindow, StaysWithinTheRobotsLimits) {
  const Window window = dynamic_window({0, 1.4}, {}, 0.1);
  EXPECT_EQ(window.low.v, 0);
  EXPECT_EQ(window.high.w, Robot{}.max_w);
}

TEST(CanStop, ComparesTheBrakingDistanceWithTheFreeDistance) {
  // Eq. (14), with 0.7 of 1 m/s^2, after a period of 0.1 s: v = 1 needs 1 / 1.4 + 0.1 = 0.814 m.
  EXPECT_TRUE(can_stop({1, 0}, 0.82, {}, 0.1));
  EXPECT_FALSE(can_stop({1, 0}, 0.81, {}, 0.1));
  EXPECT_TRUE(can_stop({0, 1.5}, 2, {}, 0.1));
  EXPECT_TRUE(can_stop({0, 0}, 0, {}, 0.1));
}

TEST(HeadingTerm, IsMaximalWhenTheRobotWillFaceTheTarget) {
  EXPECT_NEAR(heading_term({}, {0.5, 0}, {5, 0}, {}, 0.1), 1, 1e-12);
  EXPECT_NEAR(heading_term({}, {0, 0}, {-5, 1e-9}, {}, 0.1), 0, 1e-6);
  // Rotating at 1 rad/s for 0.1 s and braking at 3 rad/s^2: 0.1 + 1 / 6 rad.
  const double bearing = 0.1 + 1.0 / 6;
  EXPECT_NEAR(heading_term({}, {0, 1}, {std::cos(bearing), std::sin(bearing)}, {}, 0.1), 1, 1e-12);
}

TEST(Dwa, AcceleratesTowardsAGoalAhead) {
  const Twist twist = decide({}, {5, 0}, {0.5, 0});
  EXPECT_NEAR(twist.v, 0.6, 1e-9);
  EXPECT_NEAR(twist.w, 0, 0.02);
}

TEST(Dwa, TurnsTowardsTheFreeSideOfAnObstacle) {
  EXPECT_GT(decide({{1.2, -2, 1.2, 0.3}}, {5, 0}, {0.4, 0}).w, 0);
  EXPECT_LT(decide({{1.2, -0.3, 1.2, 2}}, {5, 0}, {0.4, 0}).w, 0);
}

TEST(Dwa, AlwaysChoosesVelocitiesFromWhichItCanStop) {
  for (double distance = 0.35; distance < 3; distance += 0.15)
    for (const double v : {0.0, 0.3, 0.6}) {
      const double free_distance = distance - Robot{}.radius;
      if (v * v / 1.4 > free_distance - 0.16) continue;  // collision unavoidable
      const Twist twist = decide({{distance, -20, distance, 20}}, {10, 0}, {v, 0});
      EXPECT_LE(twist.v * twist.v / 2 + 0.1 * twist.v, free_distance + 0.01)
          << distance << ' ' << v;
    }
}

TEST(Dwa, RotatesInPlaceTowardsAGoalBehind) {
  const Twist twist = decide({}, {-3, 0.5});
  EXPECT_EQ(twist.v, 0);
  EXPECT_GT(twist.w, 1);
}

TEST(Dwa, StopsBeforeItTurnsTowardsAGoalBehind) {
  const std::vector<Wall> beside = {{-1, 0.4, 3, 0.4}};
  const Twist moving = decide(beside, {-3, 0.5}, {0.8, 0});
  EXPECT_EQ(moving.v, 0);
  EXPECT_EQ(moving.w, 0);
  EXPECT_GT(decide(beside, {-3, 0.5}, {0.05, 0}).w, 1);
}

TEST(Dwa, BrakesOnItsArcIfNoVelocityIsAdmissible) {
  const Twist twist = decide({{0.7, -3, 0.7, 3}}, {5, 0}, {0.9, -0.45});
  EXPECT_EQ(twist.v, 0);
  EXPECT_NEAR(twist.w, -0.4, 1e-12) << "of 0.8 m/s, to which it slows down, on the same arc";
}

TEST(Dwa, GivesTheSameCommandAfterAReset) {
  Dwa method({}, {});
  const auto first = observe({{1.2, -2, 1.2, 0.3}}, {5, 0}, {0.4, 0});
  method.reset({});
  const Twist once = method.step(first);
  method.step(observe({{0.8, -0.3, 0.8, 2}}, {5, 1}, {0.2, 0}));
  method.reset({});
  const Twist again = method.step(first);
  EXPECT_EQ(once.v, again.v);
  EXPECT_EQ(once.w, again.w);
}

TEST(Dwa, WithGuidanceLeavesAUShapedObstacle) {
  // A U-shaped obstacle: the exit is behind.
  const std::vector<Wall> trap = {{1, -1, 1, 1}, {-1, 1, 1, 1}, {-1, -1, 1, -1}};
  Parameters guided;
  guided.guidance = true;
  EXPECT_EQ(decide(trap, {4, 0.2}, {}, guided).v, 0);
  EXPECT_GT(std::abs(decide(trap, {4, 0.2}, {}, guided).w), 1);
  EXPECT_LT(std::abs(decide(trap, {4, 0.2}).w), 1);
}

}  // namespace
}  // namespace dwa
