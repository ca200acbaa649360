// SPDX-License-Identifier: BSD-3-Clause
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
  return roll_out(map_of(walls).clearance(), {}, now, {{desired.v}, {desired.w}}, {}, 0.29, 1.5)
      .front();
}

TEST(RollOut, OfAGridIsThatOfEachPair) {
  const LocalMap map = map_of({{1.2, -4, 1.2, 0.3}});
  const Twist now = {0.4, -0.3};
  const Robot robot;
  const VelocityGrid grid = {{0, 0.5, 1}, {-1.5, -0.2, 0, 0.7}};
  const auto rollouts = roll_out(map.clearance(), {0.1, 0.2, 0.3}, now, grid, robot, 0.29, 1.5);
  ASSERT_EQ(rollouts.size(), 12U);
  int collisions = 0;
  for (std::size_t i = 0; i < rollouts.size(); ++i) {
    const Twist desired = {grid.v[i / 4], grid.w[i % 4]};
    // 30 steps of 0.05 s, each with the mean of its first and last velocity.
    Pose pose = {0.1, 0.2, 0.3};
    Twist twist = now;
    bool collides = false;
    for (int step = 0; step < 30; ++step) {
      const Twist next = apply_acceleration_limits(twist, desired, robot, 0.05);
      pose = integrate(pose, {0.5 * (twist.v + next.v), 0.5 * (twist.w + next.w)}, 0.05);
      twist = next;
      collides = collides || map.clearance().at({pose.x, pose.y}) < 0.29;
    }
    EXPECT_EQ(rollouts[i].collides, collides) << i;
    EXPECT_EQ(rollouts[i].end.x, pose.x) << i;
    EXPECT_EQ(rollouts[i].end.y, pose.y) << i;
    EXPECT_EQ(rollouts[i].end.phi, pose.phi) << i;
    collisions += collides ? 1 : 0;
  }
  EXPECT_GT(collisions, 0);
  EXPECT_LT(collisions, 12);
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

TEST(TrajectoryRollout, BrakesOnItsArcWhenEveryTrajectoryCollides) {
  // Other arcs were found to end later, but at other speeds than those while it brakes.
  const Twist now{1, 0.4};
  const Twist twist = decide({{0.5, -3, 0.5, 3}}, {5, 0}, now);
  const Twist on_arc = brake_on_arc(now, Robot{}, NavigationTask{}.control_period).value();
  EXPECT_EQ(twist.v, on_arc.v);
  EXPECT_EQ(twist.w, on_arc.w);
}

TEST(TrajectoryRollout, SlowsDownBeforeTheGoal) {
  EXPECT_LE(decide({}, {0.1, 0}, {0.5, 0}).v, std::sqrt(1.4 * 0.2) + 1e-9);
}

TEST(TrajectoryRollout, StopsBeforeItTurnsTowardsAGoalBehind) {
  const std::vector<Wall> beside = {{-1, 0.4, 3, 0.4}};
  const Twist moving = decide(beside, {-3, 0.5}, {0.8, 0});
  EXPECT_EQ(moving.v, 0);
  EXPECT_EQ(moving.w, 0);
  EXPECT_GT(decide(beside, {-3, 0.5}, {0.05, 0}).w, 1);
}

/// A decision with these movers, seen in front of walls.
Twist decide_among(const std::vector<Track>& tracks, const Point& goal, const Twist& now,
                   const std::vector<Wall>& walls = {}, const Parameters& parameters = {}) {
  TrajectoryRollout method(parameters, {});
  method.reset({goal, 0.2, 0.1, 1});
  method.set_tracks(tracks);
  return method.step(observe(walls, goal, now));
}

TEST(RollOut, MeetsMoversWhereTheyWillBe) {
  const LocalMap map = map_of({});
  const auto rollout = [&](const Track& mover) {
    return roll_out(map.clearance(), {}, {0.5, 0}, {{0.5}, {0}}, {}, 0.3, 1.5, {mover}).front();
  };
  // Head-on: the gap of 2 - 0.3 - 0.3 m closes at 1.5 m/s, 0.93 s. It turns to 1.5 m at 0.5 s.
  const Rollout head_on = rollout({{2, 0}, {-1, 0}, 0.3});
  EXPECT_TRUE(head_on.collides);
  EXPECT_TRUE(head_on.meets_mover);
  EXPECT_NEAR(head_on.until_contact, 1.4 / 1.5, 0.06);
  // It crosses 0.5 m ahead and is gone: at time t it is 0.5 (1 - t) m ahead and 2 t - 0.5 m aside.
  const Rollout crossing = rollout({{0.7, -0.2}, {0, 2}, 0.1});
  EXPECT_FALSE(crossing.collides);
  EXPECT_LT(crossing.clearance, 0.7);
  EXPECT_FALSE(rollout({{2, 0}, {1, 0}, 0.3}).collides) << "it moves ahead faster";
}

TEST(TrajectoryRollout, LetsAMoverPassThatCrossesItsWay) {
  // From the right, 1 m/s: straight ahead at 1 m/s the robot would meet it 1.5 m ahead.
  const std::vector<Track> crossing = {{{1.5, -1.5}, {0, 1}, 0.3}};
  const Twist alone = decide_among({}, {5, 0}, {1, 0}),
              twist = decide_among(crossing, {5, 0}, {1, 0});
  EXPECT_EQ(alone.v, 1);
  EXPECT_TRUE(twist.v < 0.9 || std::abs(twist.w) > 0.3) << twist.v << " " << twist.w;
  const std::vector<Track> leaving = {{{1.5, 1.5}, {0, 1}, 0.3}};
  EXPECT_EQ(decide_among(leaving, {5, 0}, {1, 0}).v, 1);
}

TEST(TrajectoryRollout, EvadesAMoverInsteadOfStandingInItsWay) {
  // From the left at the standing robot, while the goal is behind it: alone it would turn in place.
  const std::vector<Track> approaching = {{{0, 1.6}, {0, -1}, 0.3}};
  EXPECT_EQ(decide_among({}, {-4, 0.2}, {}).v, 0);
  EXPECT_GT(decide_among(approaching, {-4, 0.2}, {}).v, 0);
}

TEST(TrajectoryRollout, KeepsTrackedMoversOutOfItsMap) {
  // A mover that closes the opening of a wall, and moves away: the way is free behind it.
  const std::vector<Wall> closed = {{1, -20, 1, -0.6}, {1, -0.6, 1, 0.6}, {1, 0.6, 1, 20}};
  const std::vector<Track> leaving = {{{1.5, 0}, {1.5, 0}, 0.6}};
  Parameters parameters;
  parameters.memory = 6;  // as far as the wall is seen: there is no way around it
  const Twist tracked = decide_among(leaving, {5, 0}, {0.5, 0}, closed, parameters);
  const Twist untracked = decide_among({}, {5, 0}, {0.5, 0}, closed, parameters);
  EXPECT_GT(tracked.v, 0.8);
  EXPECT_LT(untracked.v, 0.4);
}

}  // namespace
}  // namespace trajectory_rollout
