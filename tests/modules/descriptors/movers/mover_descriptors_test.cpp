#include "../small_worlds.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

/// An empty room of 5 m x 5 m, whose lattice points are at 0.5, 1.5, ... 4.5 m.
World room_with(const Movers& movers, const Primitives& obstacles = {}) {
  return {Scenario::continuous("room", {0, 0, 5, 5}, obstacles, {0.5, 2.5, 0}, {4.5, 2.5})
              .with_movers(movers),
          0.1};
}

double survivability(const Movers& movers, const Primitives& obstacles = {}) {
  const World world = room_with(movers, obstacles);
  return value_of("survivability", context_of(world));
}

TEST(Survivability, IsTheMeanTimeUntilAMoverTouchesARobotThatStands) {
  // Along the middle row at 1 m/s; reach 0.5 m. Its points are touched after 0, 0.5, 1.5, 2.5, 3.5
  // s; the other 20 are 1 m away or more: never, which counts as 12 s.
  const Movers movers{{"a", 0.25, {{0, {0.5, 2.5}}, {4, {4.5, 2.5}}}, MoverEnd::Stop}};
  EXPECT_NEAR(survivability(movers), (0 + 0.5 + 1.5 + 2.5 + 3.5 + 20 * 12) / 25, 1e-12);
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
  const Movers movers{{"a", 0.25, {{0, {0.5, 2.5}}, {4, {4.5, 2.5}}}, MoverEnd::Stop}};
  EXPECT_NEAR(survivability(movers, obstacles), (0 + 0.5 + 2.5 + 3.5 + 20 * 12) / 24, 1e-12);
  obstacles.discs[0].radius = 4;
  const World full = room_with(movers, obstacles);
  EXPECT_EQ(descriptor("survivability").compute(context_of(full)).reason(),
            "the robot fits at no lattice point");
}

TEST(Survivability, EqualsTheTimesOfASampledMotion) {
  RandomEngine engine(7);
  constexpr double kStep = 1e-3, kHorizon = 12;
  for (int trial = 0; trial < 20; ++trial) {
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
    for (double y = 0.5; y < 5; ++y)
      for (double x = 0.5; x < 5; ++x) {
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
    EXPECT_NEAR(survivability(movers), sum / 25, 0.02) << trial;
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
  // A disc of 0.2 m that stands in the middle. The middle point has 0; of the others it shortens
  // one ray of each that is in its row, column or on a diagonal: from up to 4.5 m (to the opposite
  // wall) to their distance minus 0.2 m.
  const World world = room_with({{"a", 0.2, {{0, {2.5, 2.5}}}, MoverEnd::Stop}});
  const double diagonal = std::sqrt(2.0);
  double lost = 4 * 2.5 + 4 * 2.5 * diagonal;  // the rays of the middle
  for (const double away : {1.0, 2.0}) {
    lost += 4 * ((2.5 + away) - (away - 0.2));
    lost += 4 * ((2.5 + away) * diagonal - (away * diagonal - 0.2));
  }
  const double expected =
      value_of("traversability", context_of(world)) - lost / 8 / 25 / (2 * 0.25);
  EXPECT_NEAR(value_of("dynamic_traversability", context_of(world)), expected, 1e-9);
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
