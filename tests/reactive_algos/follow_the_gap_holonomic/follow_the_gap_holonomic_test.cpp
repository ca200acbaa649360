// SPDX-License-Identifier: BSD-3-Clause
#include "follow_the_gap_holonomic/follow_the_gap_holonomic.h"
#include "holonomic_scenes.h"

#include <gtest/gtest.h>

namespace follow_the_gap_holonomic {
namespace {

using namespace reactive;

TEST(GapCenter, IsTheMidpointBetweenTheObstaclesAtItsEnds) {
  const auto center = [](double right, double left) {
    const Sectors sectors =
        sectors_with({{-90, -30, right}, {30, 90, left}, {90, 181, 0.1}, {-181, -90, 0.1}});
    for (const SectorRun& run : open_runs(sectors, 0.6)) return gap_center(sectors, run);
    return 99.0;
  };
  EXPECT_NEAR(center(0.3, 0.3), 0, 1e-9);
  // Obstacle points 0.2 at -30 and 0.4 at 30 degrees: y = 0.1, x = 0.6 cos 30.
  EXPECT_NEAR(center(0.2, 0.4), std::atan2(0.1, 0.6 * std::cos(30 * kDegree)), 1e-9);
}

TEST(FinalDirection, WeightsTheGapByTheClosestObstacle) {
  // Eq. (8), alpha = 0.3: (0.3 / 0.3 * 1 + 0.2) / 2.
  EXPECT_NEAR(final_direction(1, 0.2, 0.3, 0.3), 0.6, 1e-12);
  EXPECT_NEAR(final_direction(1, 0.2, 1e9, 0.3), 0.2, 1e-6);
}

TEST(FollowTheGap, MovesStraightInFreeSpace) {
  EXPECT_NEAR(FollowTheGap().decide(sectors_with({}), target_at(-25)).direction, -25 * kDegree,
              1e-9);
}

TEST(FollowTheGap, StaysInTheSelectedGap) {
  const Sectors sectors = sectors_with({{-180, 20, 0.2}, {80, 180, 0.2}});
  const double direction = FollowTheGap().decide(sectors, target_at(-10)).direction;
  EXPECT_GE(direction, 20 * kDegree);
  EXPECT_LE(direction, 80 * kDegree);
}

TEST(FollowTheGap, SelectsTheWidestGapWithoutAGoalWeight) {
  Parameters widest;
  widest.goal_weight = 0;
  const Sectors sectors = sectors_with({{-60, -15, 0.2}, {15, 50, 0.2}, {-181, -60, 0.2}});
  EXPECT_GT(FollowTheGap(widest).decide(sectors, target_at(0)).direction, 45 * kDegree);
  EXPECT_NEAR(FollowTheGap().decide(sectors, target_at(0)).direction, 0, 1e-9);
}

TEST(FollowTheGap, KeepsItsSideWithoutAGap) {
  FollowTheGap method;
  const Sectors wall = sectors_with({{-91, 91, 0.2}});  // sectors behind are ignored
  EXPECT_NEAR(method.decide(wall, target_at(-10)).direction, -M_PI / 2, 1e-9);
  EXPECT_NEAR(method.decide(wall, target_at(10)).direction, -M_PI / 2, 1e-9);
}

}  // namespace
}  // namespace follow_the_gap_holonomic
