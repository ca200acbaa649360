// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/core/distance.h>
#include <slalom/robot/robot_model.h>
#include <slalom/scenario/geometry.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The first time at which a disc with the motion of the mover is within `lane` of the axis y, by
/// bisection: it approaches the axis all the time.
double time_in_lane(const Mover& mover, double y, double lane) {
  double before = 0, after = mover.waypoints.back().t;
  while (after - before > 1e-10) {
    const double t = (before + after) / 2;
    const bool is_in = std::abs(mover.position(t).y - y) - mover.radius <= lane;
    (is_in ? after : before) = t;
  }
  return after;
}

/// The time at which it begins to walk.
double begin_of(const Mover& mover) {
  return mover.waypoints[1].position == mover.waypoints[0].position ? mover.waypoints[1].t : 0;
}

double end_of_wall(const Scenario& scenario) {
  double end = 0;
  for (const TPoint2D& corner : scenario.primitives().polygons.at(0).vertices)
    end = std::max(end, corner.x);
  return end;
}

TEST(SuddenObstacle, TheMoverReachesTheLaneWhenTheRobotIsAsFarAwayAsTheOptionsSay) {
  const double robot_speed = 0.8, lane = 0.35;
  const auto generator = family("sudden_obstacle",
                                "robot_speed = 0.8\nlane = 0.35\nmin_radius = 0.25\n"
                                "max_radius = 0.3\nmin_speed = 0.6\nmax_speed = 1.2\n"
                                "min_appearance = 1\nmax_appearance = 1.5\n"
                                "min_start_distance = 4.5\nmax_start_distance = 6\n"
                                "min_angle_deg = 5\nmax_angle_deg = 10\n");
  RandomEngine engine(4);
  int left = 0, turned_left = 0;
  for (int i = 0; i < 200; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const auto& start = scenario.start();
    ASSERT_EQ(scenario.movers().size(), 1U);
    const Mover& mover = scenario.movers()[0];
    EXPECT_EQ(mover.after, MoverEnd::Stop);
    expect_within(mover.radius, 0.25, 0.3);
    const TPoint2D place = mover.waypoints.back().position;
    EXPECT_EQ(place.y, start.y);
    EXPECT_EQ(scenario.goal().y, start.y);
    EXPECT_NEAR(scenario.goal().x - place.x, 2.5, kRoundingError);
    expect_within(place.x - start.x, 4.5, 6);
    const double driven = robot_speed * time_in_lane(mover, start.y, lane);
    expect_within(place.x - start.x - driven, 1, 1.5);
    const TPoint2D velocity = mover.velocity(begin_of(mover));
    expect_within(std::hypot(velocity.x, velocity.y), 0.6, 1.2);
    expect_angle_within(start.phi, 5, 10);
    left += mover.position(0).y > start.y ? 1 : 0;
    turned_left += start.phi > 0 ? 1 : 0;
  }
  // Both sides alike: 200 throws of a coin are within 60 and 140 but once in 10^8.
  EXPECT_NEAR(left, 100, 40);
  EXPECT_NEAR(turned_left, 100, 40);
}

TEST(SuddenObstacle, TheWallHidesTheMoverUntilItWalks) {
  const auto generator = family("sudden_obstacle");
  RandomEngine engine(5);
  for (int i = 0; i < 100; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Mover& mover = scenario.movers().at(0);
    const TPoint2D place = mover.waypoints.back().position;
    const double begin = begin_of(mover);
    EXPECT_EQ(mover.position(begin), mover.position(0));
    const double end = end_of_wall(scenario);
    // From each point of the path up to the wall's end, no ray reaches the disc before the wall.
    for (double x = scenario.start().x; x <= end; x += 0.05)
      for (double a = 0; a < 2 * M_PI; a += M_PI / 18) {
        const TPoint2D eye(x, place.y);
        const TPoint2D seen = mover.position(0) + TPoint2D(std::cos(a), std::sin(a)) * mover.radius;
        const double range = distance_between(eye, seen);
        EXPECT_LT(cast_ray(scenario.primitives(), scenario.bounds(), eye,
                           std::atan2(seen.y - eye.y, seen.x - eye.x), range),
                  range - 0.1);
      }
    // The robot is not past the wall's end when the mover reaches the lane: 0.4 m + 0.05 m < 0.8 m.
    EXPECT_LT(place.x - 0.8, end);
  }
}

TEST(SuddenObstacle, TheMoverKeepsOffTheWallAndLeavesRoomOnTheOtherSide) {
  const auto generator = family("sudden_obstacle");
  RandomEngine engine(6);
  for (int i = 0; i < 100; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Bounds& b = scenario.bounds();
    const Mover& mover = scenario.movers().at(0);
    const Polygon& wall = scenario.primitives().polygons.at(0);
    for (double t = 0; t < mover.waypoints.back().t + 1; t += 0.02) {
      const TPoint2D at = mover.position(t);
      EXPECT_GE(distance(at, wall), mover.radius + 0.05 - kRoundingError);
      EXPECT_GE(std::min({at.x - b.x_min, at.y - b.y_min, b.y_max - at.y}), mover.radius);
    }
    // Three eighths of 8 m less the radius.
    const TPoint2D place = mover.waypoints.back().position;
    const bool is_above = mover.position(0).y > place.y;
    EXPECT_GE(is_above ? place.y - b.y_min : b.y_max - place.y, 3);
    EXPECT_GE(distance({scenario.start().x, scenario.start().y}, wall), 0.6 - kRoundingError);
    EXPECT_GE(distance_between(scenario.goal(), place), mover.radius + 0.6);
  }
}

TEST(SuddenObstacle, TheSpeedOfTheRobotIsThatOfTheDefaultRobot) {
  OptionFunction compare([](const Option& option) {
    if (option.key != "robot_speed") return;
    const double* value = option.get_if<double>();
    ASSERT_NE(value, nullptr);
    EXPECT_EQ(*value, RobotModel().max_v);
  });
  visit_generator_options("sudden_obstacle", compare);
}

TEST(SuddenObstacle, EveryDrawOfTheDefaultsIsSolvable) {
  expect_solvable("sudden_obstacle", 1);
}

TEST(SuddenObstacle, OptionsWithoutARangeGiveDistinctScenarios) {
  expect_distinct("sudden_obstacle",
                  "min_radius = 0.3\nmax_radius = 0.3\nmin_speed = 1\n"
                  "max_speed = 1\nmin_appearance = 1\nmax_appearance = 1\n"
                  "min_start_distance = 5\nmax_start_distance = 5\n");
}

TEST(SuddenObstacle, RejectsInvalidOptions) {
  expect_refusals(
      "sudden_obstacle",
      {{"min_radius = 0.5\n", "max_radius: is less than min_radius"},
       {"min_speed = 2\n", "max_speed: is less than min_speed"},
       {"min_appearance = 3\n", "max_appearance: is less than min_appearance"},
       {"min_angle_deg = 10\n", "max_angle_deg: is less than min_angle_deg"},
       {"min_start_distance = 4\n", "min_start_distance: leaves the moving obstacle no time"},
       {"robot_speed = 1.5\n", "min_start_distance: leaves the moving obstacle no time"},
       {"wall_distance = 2.5\n", "wall_distance: leaves no room for the moving obstacle"},
       {"lane = 0.7\n", "lane: contains the wall"},
       {"clear_radius = 0.7\n", "clear_radius: reaches the wall"},
       {"goal_distance = 0.9\n", "goal_distance: places the goal within clear_radius"},
       {"max_radius = 2\nheight = 20\n", "max_radius: leaves no room for the moving obstacle"},
       {"max_start_distance = 9\n", "max_start_distance: start and goal do not fit"},
       {"min_distance = 11\n", "min_distance: start and goal cannot be min_distance apart"}});
}

}  // namespace
}  // namespace slalom
