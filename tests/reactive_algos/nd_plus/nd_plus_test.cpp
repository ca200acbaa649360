// SPDX-License-Identifier: BSD-3-Clause
#include "holonomic_scenes.h"
#include "nd_plus/nd_plus.h"

#include <gtest/gtest.h>

namespace nd_plus {
namespace {

using namespace reactive;

Threats threats(bool left, bool right) {
  Threats result;
  result.left = left;
  result.right = right;
  return result;
}

TEST(Situation, FollowsTheDecisionTree) {
  EXPECT_EQ(situation(threats(false, false), true, 0.1, 0.9), Situation::Hsgr);
  EXPECT_EQ(situation(threats(false, false), false, 1.0, 0.9), Situation::Hswr);
  EXPECT_EQ(situation(threats(false, false), false, 0.5, 0.9), Situation::Hsnr);
  EXPECT_EQ(situation(threats(true, true), true, 0.5, 0.9), Situation::Lsgr);
  EXPECT_EQ(situation(threats(true, false), false, 0.5, 0.9), Situation::Ls1);
  EXPECT_EQ(situation(threats(true, true), false, 0.5, 0.9), Situation::Ls2);
}

TEST(FindThreats, SelectsTheClosestOnEachSide) {
  const Threats found = find_threats(sectors_with({{30, 60, 0.1}, {-90, -60, 0.05}}), 0, 0.12);
  EXPECT_TRUE(found.left && found.right);
  EXPECT_NEAR(found.left_distance, 0.1, 1e-12);
  EXPECT_NEAR(found.right_distance, 0.05, 1e-12);
  EXPECT_LT(found.right_direction, 0);
  EXPECT_FALSE(find_threats(sectors_with({{30, 60, 0.2}}), 0, 0.12).left);
}

TEST(NdPlus, MovesStraightToAGoalInItsRegion) {
  EXPECT_NEAR(NdPlus().decide(sectors_with({{90, 150, 0.5}}), target_at(20)).direction,
              20 * kDegree, 1e-9);
}

TEST(NdPlus, PassesTheMiddleOfANarrowRegion) {
  const Sectors door = sectors_with({{-90, -9, 0.4}, {15, 90, 0.4}, {-20, 20, 0.9}});
  Sectors sectors = door;
  // Free only between -9 and 15 degrees: 24 degrees.
  for (std::size_t k = 0; k < kSectors; ++k)
    if (std::abs(sectors.direction(k)) > 85 * kDegree) sectors.free_distances[k] = 0.4;
  EXPECT_NEAR(NdPlus().decide(sectors, target_at(-20)).direction, 3 * kDegree, 1e-9);
}

TEST(NdPlus, EntersAWideRegionBesideItsGap) {
  EXPECT_NEAR(NdPlus().decide(sectors_with({{-60, 30, 0.3}}), target_at(0)).direction,
              30 * kDegree + 0.45, 1e-9);
}

TEST(NdPlus, TurnsAwayFromAThreatOnOneSide) {
  EXPECT_LT(NdPlus().decide(sectors_with({{60, 120, 0.06}}), target_at(0)).direction, 0);
  EXPECT_GT(NdPlus().decide(sectors_with({{-120, -60, 0.06}}), target_at(0)).direction, 0);
}

TEST(NdPlus, StaysInTheMiddleBetweenEqualThreats) {
  const Sectors both = sectors_with({{60, 120, 0.06}, {-120, -60, 0.06}});
  EXPECT_NEAR(NdPlus().decide(both, target_at(0)).direction, 0, 1e-9);
  const Sectors nearer_left = sectors_with({{60, 120, 0.04}, {-120, -60, 0.08}});
  EXPECT_LT(NdPlus().decide(nearer_left, target_at(0)).direction, 0);
}

TEST(NdPlus, IsSlowerInLowSafety) {
  const double safe = NdPlus().decide(sectors_with({}), target_at(0)).speed;
  EXPECT_LT(NdPlus().decide(sectors_with({{60, 120, 0.06}}), target_at(0)).speed, safe);
}

}  // namespace
}  // namespace nd_plus
