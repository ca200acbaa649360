// SPDX-License-Identifier: BSD-3-Clause
#include "crowd_runs.h"

#include <gtest/gtest.h>

namespace slalom::testing {
namespace {

using mrpt::math::TPoint2D;

CostToGoField field_to(const World& world, const TPoint2D& goal,
                       PeopleSide side = PeopleSide::Right) {
  return CostToGoField(world, goal, kRadius, side);
}

TEST(CostToGoField, AimsAtAGoalInSight) {
  const World world = empty_world(5, 0.1);
  const TPoint2D target = field_to(world, {3.01, 2.02}).target({-4, -3});
  EXPECT_EQ(target.x, 3.01);
  EXPECT_EQ(target.y, 2.02);
}

/// The shortest way around the end of a wall, at the radius from it, is 2 sqrt(4 + 1.25^2) long in
/// the middle of a wall that ends at y = 1; that of a person at the same height is followed.
TEST(CostToGoField, LeadsAroundAWallWithRoomForThePerson) {
  const World world = world_with({-5, -5, 5, 5}, {rectangle(-0.1, -5, 0.1, 1)}, 0.1);
  const CostToGoField field = field_to(world, {2, 0.05});
  TPoint2D p(-2, 0.05);
  double length = 0;
  for (int k = 0; k < 100 && distance_between(p, field.goal()) > 0; ++k) {
    const TPoint2D target = field.target(p);
    EXPECT_GE(world.distance_field().segment_clearance(p, target, 1), kRadius - 1e-3);
    length += distance_between(p, target);
    p = target;
  }
  EXPECT_EQ(p.x, 2);
  const double shortest = 2 * std::hypot(1.9, 1.2);
  EXPECT_GE(length, shortest);
  EXPECT_LE(length, 1.1 * shortest);
}

TEST(CostToGoField, PassesASymmetricPillarOnTheSide) {
  const World world = world_with({-5, -5, 5, 5}, {rectangle(-1, -1, 1, 1)}, 0.125);
  const TPoint2D start(-3.5, 0), goal(3.5, 0);
  const TPoint2D right = field_to(world, goal).target(start);
  const TPoint2D left = field_to(world, goal, PeopleSide::Left).target(start);
  EXPECT_LT(right.y, -1);
  EXPECT_EQ(right.x, left.x);
  EXPECT_EQ(right.y, -left.y);
}

TEST(CostToGoField, AimsAtAGoalWithoutAWay) {
  const World world = world_with({-5, -5, 5, 5}, {rectangle(-0.1, -5, 0.1, 5)}, 0.1);
  const TPoint2D target = field_to(world, {3, 0}).target({-3, 0});
  EXPECT_EQ(target.x, 3);
}

TEST(CostToGoField, LeadsAwayFromAPlaceThatTouchesAWall) {
  const World world = world_with({-5, -5, 5, 5}, {rectangle(-0.1, -5, 0.1, 1)}, 0.1);
  const TPoint2D target = field_to(world, {3, 0}).target({-0.1 - kRadius, -2});
  EXPECT_LT(target.x, -0.1);
  EXPECT_GT(target.y, -2);
}

}  // namespace
}  // namespace slalom::testing
