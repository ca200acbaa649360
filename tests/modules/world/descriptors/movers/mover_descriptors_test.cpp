// SPDX-License-Identifier: BSD-3-Clause
#include "../small_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

constexpr double kCell = 0.1;  ///< m

/// A room of 5 m x 5 m, whose lattice points are close to 0.5, 1.5, ... 4.5 m.
World room_with(const Movers& movers, const Primitives& obstacles = {}) {
  return {Scenario::continuous("room", {0, 0, 5, 5}, obstacles, {0.5, 2.5, 0}, {4.5, 2.5})
              .with_movers(movers),
          kCell};
}

double survivability(const Movers& movers, const Primitives& obstacles = {}) {
  const World world = room_with(movers, obstacles);
  return value_of("survivability", context_of(world));
}

/// Along the middle row at 1 m/s.
const Movers kInMiddleRow{{"a", 0.25, {{0, {0.5, 2.5}}, {4, {4.5, 2.5}}}, MoverEnd::Stop}};

/// When it touches a robot at x in that row, all of whose points are equally far from its path: at
/// a distance of 0.5 m.
double time_of_touch(double x) {
  const double beside = kLatticeShift * kCell;
  return std::max(0.0, x - 0.5 - std::sqrt(0.5 * 0.5 - beside * beside));
}

TEST(Survivability, IsTheMeanTimeUntilAMoverTouchesARobotThatStands) {
  // The points of the other four rows are 0.9 m away or more: never, which counts as 12 s.
  double row = 0;
  for (const double x : lattice_along(5, kCell)) row += time_of_touch(x) / 10;
  EXPECT_NEAR(survivability(kInMiddleRow), (row + 4 * 12) / 5, 1e-12);
}

TEST(Survivability, CountsOnlyMoversThatArePresent) {
  const std::vector<Waypoint> at_center = {{3, {2.5, 2.5}}, {5, {2.5, 2.5}}};
  EXPECT_NEAR(survivability({{"late", 0.2, at_center, MoverEnd::Vanish}}), (3 + 24 * 12) / 25.0,
              1e-12);
  const std::vector<Waypoint> too_late = {{12, {2.5, 2.5}}};
  EXPECT_EQ(survivability({{"later", 0.2, too_late, MoverEnd::Stop}}), 12);
}

TEST(Survivability, LeavesOutPointsWhereTheRobotDoesNotFit) {
  Primitives obstacles;
  obstacles.discs.push_back({{2.5, 2.5}, 0.3});
  double others = 0;  // of the row, without the four points in the disc
  for (const double x : lattice_along(5, kCell))
    if (std::abs(x - 2.5) > 0.5) others += 2 * time_of_touch(x);
  EXPECT_NEAR(survivability(kInMiddleRow, obstacles), (others + 80 * 12) / 96, 1e-12);
  obstacles.discs[0].radius = 4;
  const World full = room_with(kInMiddleRow, obstacles);
  EXPECT_EQ(descriptor("survivability").compute(context_of(full)).reason(),
            "the robot fits at no lattice point");
}

TEST(Survivability, EqualsTheTimesOfASampledMotion) {
  RandomEngine engine(7);
  constexpr double kStep = 1e-3, kHorizon = 12;
  for (int trial = 0; trial < 8; ++trial) {
    Movers movers;
    for (int i = 0; i < 3; ++i) {
      std::vector<Waypoint> waypoints;
      double t = uniform_real(engine, 0, 2);
      for (int k = 0; k < 4; ++k, t += uniform_real(engine, 0.5, 5))
        waypoints.push_back({t, {uniform_real(engine, 0, 5), uniform_real(engine, 0, 5)}});
      const MoverEnd after = i == 0 ? MoverEnd::Loop : i == 1 ? MoverEnd::Stop : MoverEnd::Vanish;
      if (after == MoverEnd::Loop) waypoints.back().position = waypoints.front().position;
      movers.push_back({std::to_string(i), uniform_real(engine, 0.1, 0.5), waypoints, after});
    }
    double sum = 0;
    for (const double y : lattice_along(5, kCell))
      for (const double x : lattice_along(5, kCell)) {
        double time = 0;
        const auto is_touched = [&](const Mover& mover) {
          const auto to = mover.position(time) - mrpt::math::TPoint2D(x, y);
          return mover.present(time) && std::hypot(to.x, to.y) < mover.radius + 0.25;
        };
        while (time < kHorizon && std::none_of(movers.begin(), movers.end(), is_touched))
          time += kStep;
        sum += std::min(time, kHorizon);
      }
    // A touch of less than a step may be missed: then it differs by at most 12 s at one point.
    EXPECT_NEAR(survivability(movers), sum / 100, 0.02) << trial;
  }
}

TEST(DynamicTraversability, IsTheMeanOverTheInstantsAtWhichMoversArePresent) {
  // At 0, 2, 4 and 6 s, four of seven instants, a disc covers all lattice points.
  const World covered =
      room_with({{"a", 10, {{0, {2.5, 2.5}}, {6, {2.5, 2.5}}}, MoverEnd::Vanish}});
  const double empty = value_of("traversability", context_of(covered));
  EXPECT_GT(empty, 1);
  EXPECT_NEAR(value_of("dynamic_traversability", context_of(covered)), 3 * empty / 7, 1e-12);
  const World later = room_with({{"a", 10, {{12.1, {2.5, 2.5}}}, MoverEnd::Stop}});
  EXPECT_NEAR(value_of("dynamic_traversability", context_of(later)), empty, 1e-12);
}

TEST(DynamicTraversability, RaysEndAtMovers) {
  // A disc of 0.6 m that stands in the middle. From a point at (x, y) relative to it, a ray to (c,
  // s) meets the wall at the nearer of two lines. It meets the disc before if it heads to it and
  // passes its center at less than the radius: half a chord before the point nearest to the center.
  constexpr double kRadius = 0.6;
  const World world = room_with({{"a", kRadius, {{0, {2.5, 2.5}}}, MoverEnd::Stop}});
  double sum = 0;
  for (const double at_x : lattice_along(5, kCell))
    for (const double at_y : lattice_along(5, kCell))
      for (int i = 0; i < 8; ++i) {
        const double x = at_x - 2.5, y = at_y - 2.5;
        const double c = std::cos(M_PI / 8 + i * M_PI / 4), s = std::sin(M_PI / 8 + i * M_PI / 4);
        const double wall = std::min((2.5 - std::copysign(1, c) * x) / std::abs(c),
                                     (2.5 - std::copysign(1, s) * y) / std::abs(s));
        const double ahead = -(x * c + y * s), beside = std::abs(x * s - y * c);
        const bool meets = ahead > 0 && beside < kRadius;
        if (std::hypot(x, y) > kRadius)
          sum += meets ? ahead - std::sqrt(kRadius * kRadius - beside * beside) : wall;
      }
  EXPECT_NEAR(value_of("dynamic_traversability", context_of(world)), sum / 100 / 8 / (2 * 0.25),
              1e-9);
}

double crossing_flow(const Movers& movers, const Path& path) {
  const World world = room_with(movers);
  return value_of("crossing_flow", context_with_path(world, path));
}

TEST(CrossingFlow, CountsCrossingsOfTheShortestPathInTheFirst12Seconds) {
  const Path straight = {{0.5, 2.5}, {4.5, 2.5}};
  // Up and down every 4 s: 3 rounds, 6 crossings.
  const Mover to_and_fro{"a", 0.2, {{0, {2, 1}}, {2, {2, 4}}, {4, {2, 1}}}, MoverEnd::Loop};
  EXPECT_DOUBLE_EQ(crossing_flow({to_and_fro}, straight), 6 / 12.0);
  const Mover beside{"b", 0.2, {{0, {4.8, 1}}, {2, {4.8, 4}}}, MoverEnd::Stop};
  const Mover late{"c", 0.2, {{12.5, {2, 1}}, {14, {2, 4}}}, MoverEnd::Stop};
  EXPECT_DOUBLE_EQ(crossing_flow({to_and_fro, beside, late}, straight), 6 / 12.0);
}

TEST(CrossingFlow, CountsACornerOfThePathOrOfTheMoverOnce) {
  const Path corner = {{0.5, 2.5}, {2, 2.5}, {4.5, 2.5}};
  const Mover through_corner{"a", 0.2, {{0, {2, 1}}, {2, {2, 4}}}, MoverEnd::Stop};
  EXPECT_DOUBLE_EQ(crossing_flow({through_corner}, corner), 1 / 12.0);
  const Mover turning_on_path{"b", 0.2, {{0, {1, 1}}, {2, {1, 2.5}}, {4, {1, 4}}}, MoverEnd::Stop};
  EXPECT_DOUBLE_EQ(crossing_flow({turning_on_path}, corner), 1 / 12.0);
  const Mover touching{"c", 0.2, {{0, {1, 4}}, {2, {1, 2.5}}, {4, {3, 4}}}, MoverEnd::Stop};
  const double touches = 12 * crossing_flow({touching}, corner);
  EXPECT_TRUE(touches == 0 || touches == 2) << touches;
}

TEST(MoverDescriptors, AreNaWhereNothingMoves) {
  const World world = room_with({});
  for (const std::string& id : mover_descriptor_ids())
    EXPECT_EQ(descriptor(id).compute(context_with_path(world, {{0.5, 2.5}, {4.5, 2.5}})).reason(),
              "no moving obstacles")
        << id;
  EXPECT_EQ(mover_descriptor_ids().size(), 3U);
}

}  // namespace
}  // namespace slalom
