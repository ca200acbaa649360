// SPDX-License-Identifier: BSD-3-Clause

#include "departure.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace slalom {
namespace {

/// A disc at (5, 5) with radius 0.5 m in a workspace of 10 m x 10 m, the goal at (9, 5).
World disc_with(const Movers& movers) {
  Primitives obstacles;
  obstacles.discs = {{{5, 5}, 0.5}};
  const Scenario scenario =
      Scenario::continuous("disc", {0, 0, 10, 10}, obstacles, {1, 5, 0}, {9, 5});
  return {scenario.with_movers(movers), 0.05};
}

/// A sample each 0.5 s, at 0.4 m/s.
Trajectory through(const std::vector<mrpt::math::TPose2D>& poses) {
  Trajectory trajectory;
  for (std::size_t i = 0; i < poses.size(); ++i)
    trajectory.samples.push_back({0.5 * static_cast<double>(i), poses[i], 0.4, 0, 0, 0});
  return trajectory;
}

/// Passes the disc on its left side, seen from the start.
const Trajectory kPasses = through({{1, 5, 0}, {3, 5, 0}, {3.5, 6, 0}, {7, 6, 0}, {9, 5, 0}});

/// The default robot has a radius of 0.25 m. 0.2 m beyond the corner at (3, 5) it is 0.18 m from
/// the path, whose next part rises 2 m per m; 1 m beyond it 0.89 m.
Trajectory straight_on(double heading) {
  return through({{1, 5, 0}, {2, 5, 0}, {3, 5, 0}, {3.2, 5, 0}, {4, 5, heading}, {4.2, 5, 0}});
}

TEST(Departure, IsTheFirstSampleFartherThanTheRadiusFromThePath) {
  const World world = disc_with({});
  const auto ahead = find_departure(world, {}, {}, straight_on(0), kPasses);
  ASSERT_TRUE(ahead);
  EXPECT_EQ(ahead->t, 2);
  EXPECT_EQ(ahead->speed, 0.4);
  EXPECT_NEAR(ahead->goal_bearing, 0, 1e-12);
  EXPECT_NEAR(ahead->obstacle_bearing, 0, 5 * M_PI / 180);
  EXPECT_NEAR(ahead->clearance, 0.25, 0.05) << "from x = 4.25 to 4.5, in cells of 0.05 m";
  const auto turned = find_departure(world, {}, {}, straight_on(M_PI / 2), kPasses);
  EXPECT_NEAR(turned->goal_bearing, -M_PI / 2, 1e-12);
  EXPECT_NEAR(turned->obstacle_bearing, -M_PI / 2, 5 * M_PI / 180);
}

TEST(Departure, KnowsMoversThatAreNearerThanObstacles) {
  // Its edge is 0.05 m to the left of the robot at 2 s, and it leaves at 3 s.
  const Mover mover = {"m", 0.3, {{0, {4, 5.6}}, {3, {4, 5.6}}}, MoverEnd::Vanish};
  const auto departure = find_departure(disc_with({mover}), {mover}, {}, straight_on(0), kPasses);
  ASSERT_TRUE(departure);
  EXPECT_TRUE(departure->is_mover);
  EXPECT_NEAR(departure->clearance, 0.05, 1e-12);
  EXPECT_NEAR(departure->obstacle_bearing, M_PI / 2, 1e-12);
  const Mover gone = {"m", 0.3, {{0, {4, 5.6}}, {1, {4, 5.6}}}, MoverEnd::Vanish};
  EXPECT_FALSE(find_departure(disc_with({gone}), {gone}, {}, straight_on(0), kPasses)->is_mover);
}

TEST(Departure, IsNoneOfARunThatStopsOnThePath) {
  const Trajectory stops = through({{1, 5, 0}, {2, 5.2, 0}, {2, 5.2, 1}});
  EXPECT_FALSE(find_departure(disc_with({}), {}, {}, stops, kPasses));
  EXPECT_EQ(departure_text("nd", "gap", std::nullopt), "nd does not leave the path of gap");
}

TEST(Departure, IsASentence) {
  const Departure departure = {3.2, 0.45, 12.4 * M_PI / 180, -60 * M_PI / 180, 0.25, false};
  EXPECT_EQ(departure_text("nd", "gap", departure),
            "nd leaves the path of gap after 3.20 s at 0.45 m/s; goal 12 degrees to the left, "
            "nearest obstacle 60 degrees to the right, 0.25 m away");
  EXPECT_EQ(departure_text("nd", "gap", Departure{0, 0, 0.001, M_PI, 0, true}),
            "nd leaves the path of gap after 0.00 s at 0.00 m/s; goal straight ahead, nearest "
            "moving obstacle "
            "straight behind, 0.00 m away");
}

}  // namespace
}  // namespace slalom
