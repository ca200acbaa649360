// SPDX-License-Identifier: BSD-3-Clause
#include "holonomic_scenes.h"
#include "vfh_plus/vfh_plus.h"

#include <gtest/gtest.h>

namespace vfh_plus {
namespace {

using namespace reactive;

TEST(PrimaryHistogram, DecreasesWithTheSquareOfTheDistance) {
  // a - b d^2 = 1 - (0.25 / 0.5)^2.
  const auto histogram = primary_histogram(sectors_with({{-10, 10, 0.25}}), 0.5, 1);
  EXPECT_NEAR(histogram[60], 0.75, 1e-12);
  EXPECT_EQ(histogram[0], 0);
}

TEST(PrimaryHistogram, IgnoresObstaclesBehindTheTarget) {
  EXPECT_EQ(primary_histogram(sectors_with({{-10, 10, 0.25}}), 0.5, 0.2)[60], 0);
}

TEST(UpdateBinary, KeepsTheStateBetweenTheThresholds) {
  std::vector<char> blocked;
  const Parameters parameters;  // 0.75 and 0.6
  update_binary({0.8, 0.7, 0.5}, parameters, blocked);
  EXPECT_EQ(blocked, (std::vector<char>{1, 0, 0}));
  update_binary({0.7, 0.7, 0.8}, parameters, blocked);
  EXPECT_EQ(blocked, (std::vector<char>{1, 0, 1}));
  update_binary({0.5, 0.7, 0.5}, parameters, blocked);
  EXPECT_EQ(blocked, (std::vector<char>{0, 0, 0}));
}

TEST(Candidates, OfANarrowOpeningAreItsMiddle) {
  EXPECT_EQ(candidates({0.2, 0.4}, 0.25, 0.9), std::vector<double>{0.4});
}

TEST(Candidates, OfAWideOpeningAreItsSidesAndATargetBetween) {
  // From 0 to 2 rad: 0.45 and 1.55, and the target if it is between these.
  const auto both = candidates({0, 2}, 0.2, 0.9);
  ASSERT_EQ(both.size(), 2U);
  EXPECT_NEAR(both[0], 0.45, 1e-12);
  EXPECT_NEAR(both[1], 1.55, 1e-12);
  const auto three = candidates({0, 2}, 1.2, 0.9);
  ASSERT_EQ(three.size(), 3U);
  EXPECT_EQ(three[2], 1.2);
}

TEST(VfhPlus, MovesStraightToTheTargetInFreeSpace) {
  const Decision decision = VfhPlus().decide(sectors_with({}), target_at(40));
  EXPECT_NEAR(decision.direction, 40 * kDegree, 1e-9);
  EXPECT_EQ(decision.speed, 1);
}

TEST(VfhPlus, PassesAnObstacleOnTheSideOfTheTarget) {
  const double left = VfhPlus().decide(sectors_with({{-40, 30, 0.15}}), target_at(0)).direction;
  // Half of s_max = 0.9 rad beyond the border at 30 degrees.
  EXPECT_NEAR(left, 30 * kDegree + 0.45, 1e-9);
}

TEST(VfhPlus, PassesANarrowOpeningInItsMiddle) {
  const Sectors door = sectors_with({{-90, -9, 0.2}, {15, 90, 0.2}});
  EXPECT_NEAR(VfhPlus().decide(door, target_at(0)).direction, 3 * kDegree, 1e-9);
}

TEST(VfhPlus, KeepsItsSideBetweenEqualAlternatives) {
  VfhPlus method;
  EXPECT_GT(method.decide(sectors_with({{-40, 30, 0.15}}), target_at(0)).direction, 0);
  // Now both sides are equal; without memory the right one would be chosen.
  EXPECT_GT(method.decide(sectors_with({{-30, 30, 0.15}}), target_at(0)).direction, 0);
}

TEST(VfhPlus, TurnsInSearchOfAnOpeningToOneSideWhenBlocked) {
  const Sectors blocked = sectors_with({{-181, 181, 0.1}});
  VfhPlus method;
  EXPECT_NEAR(method.decide(blocked, target_at(-10)).direction, -M_PI / 2, 1e-9);
  EXPECT_NEAR(method.decide(blocked, target_at(20)).direction, -M_PI / 2, 1e-9);
  method.decide(sectors_with({}), target_at(20));
  EXPECT_NEAR(method.decide(blocked, target_at(20)).direction, M_PI / 2, 1e-9);
}

}  // namespace
}  // namespace vfh_plus
