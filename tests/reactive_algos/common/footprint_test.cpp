// SPDX-License-Identifier: BSD-3-Clause
#include "common/footprint.h"
#include "common/motion.h"
#include "observations.h"

#include <gtest/gtest.h>

#include <algorithm>

namespace reactive {
namespace {

using Corners = std::vector<Point>;

Corners rectangle(double length, double width) {
  const double x = 0.5 * length, y = 0.5 * width;
  return {{-x, -y}, {x, -y}, {x, y}, {-x, y}};
}

const Corners kJackal = rectangle(0.42, 0.33);
const Corners kPolygons[] = {
    kJackal,
    rectangle(1, 0.1),
    rectangle(0.5, 0.5),
    {{-0.2, -0.2}, {0.3, 0}, {-0.2, 0.2}},
    {{-0.3, 0}, {0, -0.3}, {0.3, 0}, {0, 0.3}},
    {{-0.3, -0.2}, {0.1, -0.3}, {0.3, -0.1}, {0.3, 0.1}, {0.1, 0.3}, {-0.3, 0.2}}};

Robot robot_with(const Corners& corners) {
  Robot robot;
  robot.footprint = corners;
  return with_cover_discs(robot);
}

/// 0 inside.
double distance_to(const Corners& corners, const Point& p) {
  bool inside = true;
  double nearest = HUGE_VAL;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Point &a = corners[i], &b = corners[(i + 1) % corners.size()];
    const double dx = b.x - a.x, dy = b.y - a.y, px = p.x - a.x, py = p.y - a.y;
    inside = inside && dx * py - dy * px >= 0;
    const double t = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
    nearest = std::min(nearest, std::hypot(px - t * dx, py - t * dy));
  }
  return inside ? 0 : nearest;
}

/// The smallest distance from `p` to a disc, negative inside.
double distance_to_discs(const Robot& robot, const Point& p) {
  double nearest = HUGE_VAL;
  for (const FootprintDisc& disc : robot.discs)
    nearest = std::min(nearest, distance(p, disc.center) - (robot.radius - disc.inset));
  return nearest;
}

TEST(Cover, ContainsThePolygonAndExceedsItByLittle) {
  for (const Corners& corners : kPolygons) {
    const Robot robot = robot_with(corners);
    double excess = 0;
    for (double x = -1; x < 1; x += 0.004)
      for (double y = -1; y < 1; y += 0.004) {
        const double outside = distance_to(corners, {x, y});
        const bool covered = distance_to_discs(robot, {x, y}) <= 0;
        EXPECT_TRUE(covered || outside > 0) << x << ' ' << y;
        if (covered) excess = std::max(excess, outside);
      }
    // The triangle has corners of 44 and 68 degrees.
    EXPECT_LE(excess, corners.size() == 3 ? 0.09 : 0.17 * robot.radius);
  }
}

TEST(Cover, OfTheJackalIsMuchNarrowerThanItsEnclosingDisc) {
  // Half of its width is 0.165 m, half of its diagonal 0.267 m.
  EXPECT_LT(robot_with(kJackal).radius, 0.165 * 1.17);
  EXPECT_LT(robot_with(kJackal).discs.size(), 15U);
}

TEST(Cover, OfADiscIsTheDisc) {
  const Robot disc = with_cover_discs({});
  EXPECT_EQ(disc.radius, Robot().radius);
  ASSERT_TRUE(disc.is_disc());
  EXPECT_EQ(disc.discs.front().inset, 0);
  EXPECT_EQ(disc.reach(), 0);
}

TEST(FootprintClearance, IsTheDistanceToThePolygonLessItsExcess) {
  const std::vector<Point> points = {{0.6, 0.1}, {-0.2, 0.5}, {0.3, -0.4}};
  for (const Corners& corners : {kJackal, kPolygons[3], kPolygons[5]}) {
    const Robot robot = robot_with(corners);
    ClearanceMap map(2, 0.05, 1);
    map.build({}, points);
    PoseBatch poses;
    poses.assign(20, {});
    std::vector<double> clearances(padded(20));
    for (int i = 0; i < 20; ++i) {
      const auto k = static_cast<std::size_t>(i);
      const Pose pose = {0.02 * (i % 5), 0.01 * (i % 3), 0.3 * i};
      double expected = HUGE_VAL;
      for (const Point& p : points)
        expected = std::min(expected, distance_to(corners, to_robot(pose, p)));
      const double gap = footprint_clearance(map, pose, robot) - robot.radius;
      EXPECT_LE(gap, expected + 0.012) << i;
      EXPECT_GE(gap, expected - (corners.size() == 3 ? 0.09 : 0.06)) << i;
      poses.x[k] = pose.x;
      poses.y[k] = pose.y;
      poses.cosine[k] = std::cos(pose.phi);
      poses.sine[k] = std::sin(pose.phi);
      clearances[k] = gap + robot.radius;
    }
    std::vector<double> batch(padded(20));
    footprint_clearances(map, poses, 20, robot, batch.data());
    for (std::size_t k = 0; k < 20; ++k) EXPECT_NEAR(batch[k], clearances[k], 1e-6) << k;
  }
}

TEST(FreeRotation, EndsWhereACornerMeetsAWall) {
  const Robot robot = robot_with(kJackal);
  // The corner at atan2(0.165, 0.21) = 0.666 rad, 0.267 m from the center, reaches y = 0.23 m after
  // 0.373 rad. The discs reach 0.026 m farther.
  const LocalMap beside = map_of({{-0.5, 0.23, 2, 0.23}});
  const double left = free_rotation(beside.clearance(), {}, robot, robot.radius, 1, M_PI);
  EXPECT_LE(left, 0.373 + 0.02);
  EXPECT_GE(left, 0.1);
  // A wall that no corner reaches, and a disc.
  const LocalMap far = map_of({{-0.5, 0.35, 2, 0.35}});
  EXPECT_EQ(free_rotation(far.clearance(), {}, robot, robot.radius, 1, M_PI), M_PI);
  EXPECT_EQ(free_rotation(beside.clearance(), {}, {}, 0.25, 1, M_PI), M_PI);
}

TEST(FreeRotation, DoesNotLeadCloserToAnObstacleThatIsAlmostTouched) {
  // Turned by 0.3 rad beside the wall, a corner is 0.009 m from it, which its disc exceeds.
  const Robot robot = robot_with(kJackal);
  const LocalMap beside = map_of({{-0.5, 0.23, 2, 0.23}});
  const Pose pose = {0, 0, 0.3};
  EXPECT_LT(free_rotation(beside.clearance(), pose, robot, 0, 1, 1), 0.05);
  EXPECT_LT(free_rotation(beside.clearance(), pose, robot, 0, 1, 0.08), 0.05) << "in one step";
  EXPECT_EQ(free_rotation(beside.clearance(), pose, robot, 0, -1, 0.3), 0.3);
}

TEST(CanRotate, IsWithinTheFreeAngle) {
  const Robot robot = robot_with(kJackal);
  const LocalMap map = map_of({{-0.5, 0.23, 2, 0.23}});
  // 0.1 s of 1.5 rad/s and braking with 70 % of 3 rad/s^2: 0.15 + 0.54 rad.
  EXPECT_FALSE(can_rotate(map.clearance(), {}, robot, robot.radius, 1.5, 0.1));
  EXPECT_TRUE(can_rotate(map.clearance(), {}, robot, robot.radius, 0.2, 0.1));
}

TEST(FreeArcLengths, OfAFootprintLeadThroughAGapThatIsTooNarrowForItsEnclosingDisc) {
  // The disc of the rectangle is 0.534 m wide.
  const LocalMap map = map_of(wall_with_opening(1, -0.22, 0.22));
  const Robot robot = robot_with(kJackal);
  Robot disc;
  disc.radius = 0.267;
  const auto length = [&](const Robot& moved, double w) {
    return free_arc_lengths(map.clearance(), {}, {{0.5, w}}, moved, moved.radius, 3).front();
  };
  EXPECT_EQ(length(robot, 0), 3);
  EXPECT_LT(length(disc, 0), 1);
  // On an arc of radius 1 m the rectangle hits the wall.
  EXPECT_LT(length(robot, 0.5), 1);
}

TEST(RotateInPlace, DoesNotBeginWhereTheFootprintWouldTouchAnObstacle) {
  const Robot robot = robot_with(kJackal);
  RotateInPlace turn(1.2, 0.4);
  EXPECT_TRUE(turn.update(2, map_of({}).clearance(), {}, robot, 0.01));
  EXPECT_GT(turn.twist(2, {}, robot, 0.1).w, 0);
  // A corner hits the wall on the left; a disc does not.
  const LocalMap wall = map_of({{-0.5, 0.23, 2, 0.23}});
  EXPECT_FALSE(turn.update(2, wall.clearance(), {}, robot, 0.01));
  EXPECT_TRUE(turn.update(2, wall.clearance(), {}, {}, 0.01));
}

}  // namespace
}  // namespace reactive
