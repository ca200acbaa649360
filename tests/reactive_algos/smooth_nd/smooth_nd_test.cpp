// SPDX-License-Identifier: BSD-3-Clause
#include "holonomic_scenes.h"
#include "smooth_nd/smooth_nd.h"

#include <gtest/gtest.h>

namespace smooth_nd {
namespace {

using namespace reactive;

TEST(Threat, GrowsFromTheBorderOfTheSafetyZone) {
  EXPECT_EQ(threat(0.3, 0.2), 0);
  EXPECT_NEAR(threat(0.1, 0.2), 0.5, 1e-12);
  EXPECT_EQ(threat(0, 0.2), 1);
}

TEST(Deflection, TurnsAwayInProportionToTheThreat) {
  Sectors sectors = sectors_with({});
  // One sector at 61.5 degrees with threat 0.5: half of 180 - 61.5 degrees, to the right.
  sectors.free_distances[80] = 0.1;
  EXPECT_NEAR(deflection(sectors, 0, 0.2), -0.5 * (180 - 61.5) * kDegree, 1e-9);
  EXPECT_EQ(deflection(sectors_with({}), 0, 0.2), 0);
}

TEST(Deflection, OfWallsOnBothSidesCancels) {
  EXPECT_NEAR(deflection(sectors_with({{60, 120, 0.1}, {-120, -60, 0.1}}), 0, 0.2), 0, 1e-9);
}

TEST(SmoothNd, MovesStraightToATargetInItsValley) {
  EXPECT_NEAR(SmoothNd().decide(sectors_with({{90, 120, 0.5}}), target_at(20)).direction,
              20 * kDegree, 1e-9);
}

TEST(SmoothNd, PassesADoorBetweenCloseWalls) {
  // Walls within the safety zone on both sides of a door of 24 degrees.
  const Sectors door = sectors_with({{-170, -12, 0.1}, {12, 170, 0.1}});
  const Decision decision = SmoothNd().decide(door, target_at(0));
  EXPECT_NEAR(decision.direction, 0, 2 * kDegree);
  EXPECT_GT(decision.speed, 0.5);
}

TEST(SmoothNd, EntersAValleyBesideABlock) {
  const double direction =
      SmoothNd().decide(sectors_with({{-60, 30, 0.3}}), target_at(0)).direction;
  EXPECT_NEAR(direction, 30 * kDegree + 0.45, 1e-9);
}

TEST(SmoothNd, KeepsItsSideWithoutAValley) {
  SmoothNd method;
  const Sectors wall = sectors_with({{-91, 91, 0.1}});
  EXPECT_NEAR(method.decide(wall, target_at(-10)).direction, -M_PI / 2, 1e-9);
  EXPECT_NEAR(method.decide(wall, target_at(10)).direction, -M_PI / 2, 1e-9);
}

TEST(SmoothNd, HasMinimumSpeedWithoutAValley) {
  EXPECT_LE(SmoothNd().decide(sectors_with({{-181, 181, 0.03}}), target_at(0)).speed,
            kMinSpeedFraction);
}

}  // namespace
}  // namespace smooth_nd
