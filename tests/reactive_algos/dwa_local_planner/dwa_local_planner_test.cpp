// SPDX-License-Identifier: BSD-3-Clause
#include "common/motion.h"
#include "dwa_local_planner/dwa_local_planner.h"
#include "dwa_local_planner/jackal.h"
#include "observations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <set>
#include <vector>

namespace dwa_local_planner {
namespace {

using reactive::Costmap;
using reactive::KnownMap;
using reactive::Observation;
using reactive::observe;
using reactive::Point;
using reactive::Pose;
using reactive::Robot;
using reactive::Twist;
using reactive::Wall;

TEST(EvenlySpaced, IncludesBothEndsAndZero) {
  EXPECT_EQ(evenly_spaced(0, 1, 3), (std::vector<double>{0, 0.5, 1}));
  EXPECT_EQ(evenly_spaced(-1, 2, 2), (std::vector<double>{-1, 0, 2}));
  EXPECT_EQ(evenly_spaced(0.5, 0.5, 4), (std::vector<double>{0.5}));
}

TEST(VelocitySamples, AreReachableWithinAPeriodAndNotTooSlow) {
  Parameters parameters = limited_parameters();
  const auto samples = velocity_samples(parameters, {0.45, 0}, 0.1);
  std::set<double> v, w;
  for (const Twist& twist : samples) {
    v.insert(twist.v);
    w.insert(twist.w);
  }
  EXPECT_NEAR(*v.begin(), 0.35, 1e-12);
  EXPECT_NEAR(*v.rbegin(), 0.5, 1e-12) << "the limit";
  EXPECT_EQ(v.size(), 3u);
  EXPECT_NEAR(*w.begin(), -0.3, 1e-12);
  EXPECT_NEAR(*w.rbegin(), 0.3, 1e-12);
  EXPECT_EQ(w.size(), 21u) << "20, and 0";
  // At rest: 0.1 m/s, and rotations of 0.25 rad/s or more.
  parameters.min_vel_theta = 0.25;
  for (const Twist& twist : velocity_samples(parameters, {}, 0.1))
    EXPECT_TRUE(twist.v > 0.099 || std::abs(twist.w) > 0.249) << twist.v << ' ' << twist.w;
}

/// Along x for 2.45 m, at cell centers, where nothing is interpolated.
std::vector<Point> straight_path() {
  std::vector<Point> path;
  for (int i = 0; i < 50; ++i) path.push_back({0.025 + 0.05 * i, 0.025});
  return path;
}

TEST(TrajectoryScorer, SumsTheWeightedDistancesAtTheEndOfTheTrajectory) {
  // Straight on along the path of 2.45 m: 0.5 m/s for 1.7 s ends on it, and the point ahead is
  // 0.325 m closer to a goal 0.325 m further on. Distances are off by half a cell at most.
  TrajectoryScorer scorer(limited_parameters(), jackal());
  const Costmap map = costmap_of({});
  scorer.prepare(map, {0.025, 0.025, 0}, straight_path());
  const double to_goal = 2.45 - 0.5 * 1.7;
  EXPECT_NEAR(scorer.cost({0.5, 0}, HUGE_VAL), 20 * 2 * to_goal, 20 * 2 * 0.025);
  // Across the path for 0.85 m: a cell's diagonal counts as 1.4 cells.
  scorer.prepare(map, {0.025, 0.025, 0.5 * M_PI}, straight_path());
  const double across = 0.85, ahead = across + 0.325;
  const auto octile = [](double x, double y) { return std::max(x, y) + 0.4 * std::min(x, y); };
  EXPECT_NEAR(scorer.cost({0.5, 0}, HUGE_VAL),
              32 * (across + ahead) + 20 * (octile(2.45, across) + octile(2.775, ahead)),
              0.025 * 2 * (32 + 20));
  EXPECT_LT(scorer.cost({0.5, 0}, 50), 0) << "more than the limit";
}

TEST(TrajectoryScorer, RefusesTrajectoriesThatTouchAnObstacle) {
  const Parameters parameters = limited_parameters();
  TrajectoryScorer scorer(parameters, jackal());
  // At 0.5 m/s the footprint is 1.2 times as large, and its front reaches 0.85 + 1.2 * 0.22 m.
  for (const double x : {1.04, 1.23}) {
    const Costmap map = costmap_of({{x, 0}});
    scorer.prepare(map, {}, straight_path());
    EXPECT_EQ(scorer.cost({0.5, 0}, HUGE_VAL) < 0, x < 1.1) << x;
    EXPECT_GT(scorer.cost({0.2, 0}, HUGE_VAL), 0) << x;
  }
}

TEST(TrajectoryScorer, AddsTheHighestCostOfTheFootprint) {
  Parameters parameters = limited_parameters();
  TrajectoryScorer scorer(parameters, jackal());
  const Costmap map = costmap_of({{0.5, 0.37}});
  scorer.prepare(map, {}, straight_path());
  const double with = scorer.cost({0.2, 0}, HUGE_VAL);
  parameters.occdist_scale = 0;
  TrajectoryScorer without(parameters, jackal());
  without.prepare(map, {}, straight_path());
  const double added = with - without.cost({0.2, 0}, HUGE_VAL);
  // The outline at y = 0.175 is in the row of cells at 0.175, the obstacle in that at 0.375.
  EXPECT_NEAR(added, 0.01 * kInflation.cost(0.2), 1e-9);
}

/// One control cycle after another, with exact motion.
class Drive {
 public:
  Drive(const Parameters& parameters, const Robot& robot, const Point& goal,
        double goal_tolerance = 0.2)
      : method_(parameters, robot), goal_(goal) {
    method_.reset({goal, goal_tolerance, 0.1, 0});
  }

  Twist cycle(const std::vector<Wall>& walls) {
    Observation observation =
        observe(in_robot_frame(walls), reactive::to_robot(pose, goal_), twist);
    observation.pose = pose;
    twist = method_.step(observation);
    pose = reactive::integrate(pose, twist, 0.1);
    return twist;
  }

  DwaLocalPlanner& method() { return method_; }

  Pose pose;
  Twist twist;

 private:
  std::vector<Wall> in_robot_frame(const std::vector<Wall>& walls) const {
    std::vector<Wall> result;
    for (const Wall& wall : walls) {
      const Point a = reactive::to_robot(pose, {wall.x1, wall.y1});
      const Point b = reactive::to_robot(pose, {wall.x2, wall.y2});
      result.push_back({a.x, a.y, b.x, b.y});
    }
    return result;
  }

  DwaLocalPlanner method_;
  Point goal_;
};

TEST(DwaLocalPlanner, DrivesStraightToAVisibleGoalAndStops) {
  Drive drive({}, jackal(), {3, 0});
  for (int i = 0; i < 90; ++i) drive.cycle({});
  EXPECT_NEAR(drive.pose.x, 3, 0.12);
  EXPECT_NEAR(drive.pose.y, 0, 0.1);
  EXPECT_EQ(drive.twist.v, 0) << "within xy_goal_tolerance";
}

TEST(DwaLocalPlanner, StopsWithinTheToleranceOfTheTask) {
  for (const double tolerance : {0.05, 0.3}) {
    Drive drive({}, jackal(), {3, 0}, tolerance);
    for (int i = 0; i < 90; ++i) drive.cycle({});
    EXPECT_NEAR(drive.pose.x, 3, tolerance);
    EXPECT_EQ(drive.twist.v, 0);
  }
  Parameters parameters;
  parameters.xy_goal_tolerance = 0.1;
  EXPECT_NO_THROW(Drive(parameters, jackal(), {3, 0}, 0.1));
  EXPECT_THROW(Drive(parameters, jackal(), {3, 0}, 0.05), std::invalid_argument);
}

TEST(DwaLocalPlanner, WithoutATrajectoryThatIsFastEnoughIsRefused) {
  Robot slow = jackal();
  slow.max_v = 0.05;
  EXPECT_THROW(Drive({}, slow, {3, 0}), std::invalid_argument);
  Parameters parameters;
  parameters.min_vel_trans = 0.02;
  EXPECT_NO_THROW(Drive(parameters, slow, {3, 0}));
}

TEST(DwaLocalPlanner, TurnsInPlaceTowardsAPathBehindIt) {
  Drive drive({}, jackal(), {-3, 0.5});
  for (int i = 0; i < 200; ++i) drive.cycle({});
  EXPECT_NEAR(drive.pose.x, -3, 0.15);
}

TEST(DwaLocalPlanner, PassesADoorOnlyIfTheFootprintFits) {
  for (const double half_width : {0.4, 0.15}) {
    const std::vector<Wall> walls = follow_the_gap::wall_with_opening(2, -half_width, half_width);
    Drive drive({}, jackal(), {4, 0});
    for (int i = 0; i < 150; ++i) drive.cycle(walls);
    EXPECT_EQ(drive.pose.x > 3, half_width > 0.2) << drive.pose.x;
  }
}

TEST(DwaLocalPlanner, PlansAroundWhatItHasNotSeenWithAKnownMap) {
  // A wall at x = 3 from y = -3 to 6: beyond the obstacle range of 2.5 m.
  Parameters parameters;
  EXPECT_FALSE(DwaLocalPlanner(parameters, jackal()).uses_map());
  parameters.map = reactive::PathMap::Known;
  Drive known(parameters, jackal(), {6, 0}), sensed({}, jackal(), {6, 0});
  EXPECT_TRUE(known.method().uses_map());
  KnownMap map = {0.1, {-2, -8}, 100, 160, std::vector<std::uint8_t>(std::size_t{100} * 160)};
  for (std::size_t y = 50; y < 140; ++y) map.cells[y * 100 + 50] = 1;
  known.method().set_map(map);
  for (int i = 0; i < 15; ++i) {
    known.cycle({{3, -3, 3, 6}});
    sensed.cycle({{3, -3, 3, 6}});
  }
  EXPECT_NEAR(sensed.pose.phi, 0, 0.15);
  EXPECT_LT(known.pose.phi, -0.3) << "to the closer end";
}

TEST(DwaLocalPlanner, BeginsToRecoverAfterItsPatience) {
  Parameters parameters;
  parameters.min_vel_trans = jackal().max_v;  // no trajectory from standing is fast enough
  parameters.min_vel_theta = 10;
  Drive drive(parameters, jackal(), {3, 0});
  for (int i = 0; i < 20; ++i) EXPECT_EQ(drive.cycle({}).w, 0) << i;
  for (int i = 0; i < 4; ++i) drive.cycle({});
  EXPECT_GT(drive.twist.w, 0) << "the turn, after the costmap is cleared";
  parameters.recovery_behavior_enabled = false;
  Drive stays(parameters, jackal(), {3, 0});
  for (int i = 0; i < 100; ++i) stays.cycle({});
  EXPECT_EQ(stays.pose.phi, 0);
}

TEST(DwaLocalPlanner, HasNamedChoicesThatAreChecked) {
  Parameters parameters;
  reactive::set_parameter(parameters, "map", "known");
  EXPECT_EQ(parameters.map, reactive::PathMap::Known);
  reactive::set_parameter(parameters, "recovery_behavior_enabled", "false");
  EXPECT_FALSE(parameters.recovery_behavior_enabled);
  try {
    reactive::set_parameter(parameters, "map", "guessed");
    FAIL();
  } catch (const slalom::Error& e) {
    EXPECT_STREQ(e.what(), "map: 'guessed' is not valid; expected one of sensed, known");
  }
}

}  // namespace
}  // namespace dwa_local_planner
