#include "observations.h"
#include "trajectory_rollout/trajectory_rollout.h"

#include <gtest/gtest.h>

namespace trajectory_rollout {
namespace {

using namespace reactive;

Twist decide(const std::vector<Wall>& walls, const Point& goal, const Twist& now = {}) {
  TrajectoryRollout method({}, {});
  method.reset({goal, 0.2, 0.1, 1});
  return method.step(observe(walls, goal, now));
}

Rollout run_rollout(const std::vector<Wall>& walls, const Twist& now, const Twist& desired) {
  return roll_out(map_of(walls).clearance(), {}, now, desired, {}, 0.29, 1.5);
}

TEST(RollOut, ObeysTheRobotsAccelerations) {
  // From rest towards 1 m/s at 1 m/s^2: 0.5 m in the first second, then 0.5 m in half a second.
  EXPECT_NEAR(run_rollout({}, {0, 0}, {1, 0}).end.x, 1.0, 1e-9);
  // From 1 m/s to a stop: 0.5 m.
  EXPECT_NEAR(run_rollout({}, {1, 0}, {0, 0}).end.x, 0.5, 1e-9);
}

TEST(RollOut, EndsAtContactAndReportsItsTime) {
  // 0.5 m/s towards a wall 0.79 m ahead: contact after 0.5 m, 1 s.
  const Rollout rollout = run_rollout({{0.79, -3, 0.79, 3}}, {0.5, 0}, {0.5, 0});
  EXPECT_TRUE(rollout.collides);
  EXPECT_NEAR(rollout.until_contact, 1.0, 0.1);
  EXPECT_FALSE(run_rollout({{0.79, -3, 0.79, 3}}, {0.5, 0}, {0, 0}).collides);
}

TEST(RollOut, ReportsTheSmallestClearance) {
  EXPECT_NEAR(run_rollout({{-3, 0.6, 3, 0.6}}, {0.5, 0}, {0.5, 0}).clearance, 0.6, 0.01);
}

TEST(TrajectoryRollout, MovesStraightToAGoalInFreeSpace) {
  const Twist twist = decide({}, {5, 0}, {1, 0});
  EXPECT_DOUBLE_EQ(twist.v, 1);
  EXPECT_NEAR(twist.w, 0, 0.13);
}

TEST(TrajectoryRollout, TurnsTowardsTheOpenEndOfAWall) {
  EXPECT_GT(decide({{1.2, -4, 1.2, 0.3}}, {5, 0}, {0.3, 0}).w, 0);
  EXPECT_LT(decide({{1.2, -0.3, 1.2, 4}}, {5, 0}, {0.3, 0}).w, 0);
}

TEST(TrajectoryRollout, LeavesAUShapedObstacle) {
  const Twist twist = decide({{1, -1, 1, 1}, {-1, 1, 1, 1}, {-1, -1, 1, -1}}, {4, 0.2});
  EXPECT_EQ(twist.v, 0);
  EXPECT_GT(std::abs(twist.w), 1);
}

TEST(TrajectoryRollout, BrakesWhenEveryTrajectoryCollides) {
  EXPECT_EQ(decide({{0.5, -3, 0.5, 3}}, {5, 0}, {1, 0}).v, 0);
}

TEST(TrajectoryRollout, SlowsDownBeforeTheGoal) {
  EXPECT_LE(decide({}, {0.1, 0}, {0.5, 0}).v, std::sqrt(1.4 * 0.2) + 1e-9);
}

}  // namespace
}  // namespace trajectory_rollout
