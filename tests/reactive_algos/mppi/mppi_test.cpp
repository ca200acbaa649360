// SPDX-License-Identifier: BSD-3-Clause
#include "mppi/mppi.h"
#include "observations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

namespace mppi {
namespace {

using namespace reactive;

/// The command after some cycles with the same observation.
Twist decide(const std::vector<Wall>& walls, const Point& goal, const Twist& now = {},
             std::uint64_t seed = 1, int cycles = 5) {
  Mppi method({}, {});
  method.reset({goal, 0.2, 0.1, seed});
  Twist twist;
  for (int i = 0; i < cycles; ++i) twist = method.step(observe(walls, goal, now));
  return twist;
}

TEST(ImportanceWeights, AreSoftMinima) {
  // exp(0), exp(-1), exp(-2) over their sum.
  const auto weights = importance_weights({3, 4, 5}, 1);
  const double sum = 1 + std::exp(-1.0) + std::exp(-2.0);
  EXPECT_NEAR(weights[0], 1 / sum, 1e-12);
  EXPECT_NEAR(weights[2], std::exp(-2.0) / sum, 1e-12);
  EXPECT_NEAR(std::accumulate(weights.begin(), weights.end(), 0.0), 1, 1e-12);
}

TEST(ImportanceWeights, DoNotOverflowAndDoNotDependOnAConstant) {
  const auto weights = importance_weights({1e6, 1e6 + 1, 3e6}, 0.5);
  EXPECT_NEAR(weights[0], 1 / (1 + std::exp(-2.0)), 1e-12);
  EXPECT_EQ(weights[2], 0);
}

TEST(Noise, IsNormalAndFollowsItsSeed) {
  constexpr std::size_t kRollouts = 2000 + kFixedRollouts, kSteps = 10;
  Noise noise, again, other;
  noise.seed(5);
  again.seed(5);
  other.seed(6);
  for (Noise* each : {&noise, &again, &other}) each->draw(kRollouts, kSteps, 1, 0.2, 0.6);
  double mean = 0, square_v = 0, square_w = 0;
  for (std::size_t t = 0; t < kSteps; ++t)
    for (std::size_t k = kFixedRollouts; k < kRollouts; ++k) {
      const double v = noise.v(t)[k], w = noise.w(t)[k];
      ASSERT_EQ(v, again.v(t)[k]);
      mean += v / 20000;
      square_v += v * v / 20000;
      square_w += w * w / 20000;
    }
  EXPECT_NE(noise.v(0)[kFixedRollouts], other.v(0)[kFixedRollouts]);
  // Four standard errors: 4 * 0.2 / sqrt(20000); variances 4 * sqrt(2 / 20000) of themselves.
  EXPECT_NEAR(mean, 0, 0.0057);
  EXPECT_NEAR(square_v, 0.04, 0.04 * 0.04);
  EXPECT_NEAR(square_w, 0.36, 0.04 * 0.36);
}

TEST(Noise, IsHeldForTheGivenSteps) {
  Noise noise;
  noise.seed(5);
  noise.draw(kFixedRollouts + 1, 6, 4, 0.2, 0.6);
  EXPECT_EQ(noise.w(0)[kFixedRollouts], noise.w(3)[kFixedRollouts]);
  EXPECT_NE(noise.w(3)[kFixedRollouts], noise.w(4)[kFixedRollouts]);
  EXPECT_EQ(noise.w(4)[kFixedRollouts], noise.w(5)[kFixedRollouts]);
}

TEST(Noise, IsZeroInTheFixedRollouts) {
  Noise noise;
  noise.seed(5);
  noise.draw(4, 3, 1, 0.2, 0.6);
  for (std::size_t t = 0; t < 3; ++t)
    for (const FixedRollout k : {Unchanged, Braking}) {
      EXPECT_EQ(noise.v(t)[k], 0);
      EXPECT_EQ(noise.w(t)[k], 0);
    }
}

/// Algorithm 2 for one rollout, step by step.
double cost_of(std::size_t k, const CostRule& rule, const Observation& start,
               const std::vector<Twist>& plan, const Noise& noise, const ClearanceMap& map,
               const Waypoint& target, CostToGo& cost_to_go) {
  const Robot robot;
  Pose pose = start.pose;
  Twist now = start.measured;
  double cost = 0, nearest = 100, sum = 0;
  for (std::size_t t = 0; t < plan.size(); ++t) {
    const Twist change = {k == Braking ? -plan[t].v : noise.v(t)[k], noise.w(t)[k]};
    Twist desired = clamp_to_limits({plan[t].v + change.v, plan[t].w + change.w}, robot);
    desired.v = std::min(desired.v, rule.top_speed);
    const Twist next = apply_acceleration_limits(now, desired, robot, rule.period);
    pose = integrate(pose, {0.5 * (now.v + next.v), 0.5 * (now.w + next.w)}, rule.period);
    now = next;
    nearest = std::min(nearest, distance({pose.x, pose.y}, target.position));
    sum += nearest;
    const double gap = map.at({pose.x, pose.y}) - rule.radius;
    if (gap < 0)
      return cost + 100 * (2 - static_cast<double>(t) / static_cast<double>(plan.size()));
    const double deficit = std::max(0.0, 1 - gap / rule.span);
    cost += rule.obstacle_weight * rule.period * deficit * deficit +
            rule.control_v * plan[t].v * change.v + rule.control_w * plan[t].w * change.w;
  }
  if (target.is_goal) return cost + rule.goal_weight * 2 * sum / static_cast<double>(plan.size());
  const double ahead = cost_to_go.at(to_world(pose, {rule.look_ahead, 0}));
  const double end = cost_to_go.at({pose.x, pose.y}) + rule.look_ahead;
  return cost + rule.goal_weight * (ahead < CostToGo::kUnreached ? ahead : std::min(100.0, end));
}

TEST(RolloutCosts, AreThoseOfEachRolloutAlone) {
  const LocalMap map = map_of({{1.4, -4, 1.4, 0.1}});
  CostToGo cost_to_go;
  cost_to_go.compute(map.clearance(), {4, 0}, {0, 0}, {0.3, 0.55, 2}, 100);
  Observation start;
  start.measured = {0.5, 0.2};
  std::vector<Twist> plan;
  for (int t = 0; t < 20; ++t) plan.push_back({0.6 + 0.02 * t, 0.6 - 0.05 * t});
  Noise noise;
  noise.seed(3);
  noise.draw(101, plan.size(), 4, 0.3, 0.8);
  CostRule rule;
  rule.top_speed = 0.9;
  rule.control_v = 0.15;
  rule.control_w = 0.02;
  for (const bool is_goal : {false, true}) {
    const Waypoint target = {{1.2, 0.8}, is_goal, true};
    const std::vector<double> costs =
        rollout_costs(rule, {}, start, plan, noise, map.clearance(), target, cost_to_go);
    ASSERT_EQ(costs.size(), 101U);
    for (std::size_t k = 0; k < costs.size(); ++k)
      EXPECT_NEAR(costs[k],
                  cost_of(k, rule, start, plan, noise, map.clearance(), target, cost_to_go), 1e-9)
          << k;
    EXPECT_GT(*std::max_element(costs.begin(), costs.end()), 100);  // some collide, some do not
    EXPECT_LT(*std::min_element(costs.begin(), costs.end()), 100);
  }
}

TEST(RolloutCosts, AreLessForWhoReachesAVisibleGoalEarlier) {
  const LocalMap map = map_of({});
  CostToGo cost_to_go;
  const auto cost = [&](double v) {
    const std::vector<Twist> plan(20, {v, 0});
    Noise none;
    none.draw(1, plan.size(), 1, 0, 0);
    CostRule rule;
    rule.top_speed = 1;
    return rollout_costs(rule, {}, observe({}, {0.2, 0}), plan, none, map.clearance(),
                         {{0.2, 0}, true, true}, cost_to_go)
        .front();
  };
  // All but the last come within a centimeter of the goal in the time.
  EXPECT_LT(cost(0.4), cost(0.2));
  EXPECT_LT(cost(0.2), cost(0.11));
  EXPECT_LT(cost(0.11), cost(0));
}

TEST(Mppi, MovesToAGoalInFreeSpace) {
  const Twist twist = decide({}, {5, 0}, {0.5, 0}, 1, 20);
  EXPECT_GT(twist.v, 0.5);
  EXPECT_LT(std::abs(twist.w), 0.3);
}

TEST(Mppi, TurnsTowardsTheOpenEndOfAWall) {
  EXPECT_GT(decide({{1.2, -4, 1.2, 0.3}}, {5, 0}, {0.3, 0}).w, 0.1);
  EXPECT_LT(decide({{1.2, -0.3, 1.2, 4}}, {5, 0}, {0.3, 0}).w, -0.1);
}

TEST(Mppi, SlowsDownBeforeAWallThatItCannotPass) {
  EXPECT_LT(decide({{0.8, -7, 0.8, 7}}, {5, 0}, {0.5, 0}, 1, 10).v, 0.3);
}

TEST(Mppi, LeavesAUShapedObstacle) {
  const Twist twist = decide({{1, -1, 1, 1}, {-1, 1, 1, 1}, {-1, -1, 1, -1}}, {4, 0.2});
  EXPECT_EQ(twist.v, 0);
  EXPECT_GT(std::abs(twist.w), 1);
}

TEST(Mppi, GivesTheSameCommandForTheSameSeed) {
  const std::vector<Wall> walls = {{1.2, -4, 1.2, 0.3}};
  const Twist once = decide(walls, {5, 0}, {0.3, 0}, 7), again = decide(walls, {5, 0}, {0.3, 0}, 7);
  EXPECT_EQ(once.v, again.v);
  EXPECT_EQ(once.w, again.w);
  EXPECT_NE(once.w, decide(walls, {5, 0}, {0.3, 0}, 8).w);
}

TEST(Mppi, StopsBeforeItTurnsTowardsAGoalBehind) {
  const std::vector<Wall> beside = {{-1, 0.4, 3, 0.4}};
  const Twist moving = decide(beside, {-3, 0.5}, {0.8, 0});
  EXPECT_EQ(moving.v, 0);
  EXPECT_LE(moving.w, 0) << "not towards the wall, where the goal is";
  EXPECT_GT(decide(beside, {-3, 0.5}, {0.05, 0}).w, 1);
}

TEST(Mppi, AvoidsObstaclesWhileItBrakesBeforeARotationInPlace) {
  const Twist to_the_left{0.9, 0.9};
  const Twist twist = decide({{-1, 0.5, 3, 0.5}}, {-3, 0.5}, to_the_left);
  EXPECT_EQ(twist.v, 0);
  EXPECT_LT(twist.w, 0.6) << "as far as it can slow its rotation down within a period";
}

}  // namespace
}  // namespace mppi
