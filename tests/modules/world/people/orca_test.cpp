// SPDX-License-Identifier: BSD-3-Clause

#include "orca.h"

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// A person of radius 0.5 at the origin who walks along x, and one that comes towards it on the
/// line y = `aside`.
Neighborhood encounter(double aside, double share) {
  Neighborhood around;
  around.self = {{0, 0}, {1, 0}, 0.5};
  around.wanted = {1, 0};
  around.max_speed = 2;
  around.neighbors.push_back({{{4, aside}, {-1, 0}, 0.5}, 1, share, true, false});
  return around;
}

/// m: the least distance of the centers within the horizon.
double least_distance(const Neighborhood& around, const TPoint2D& v, double horizon) {
  const CrowdDisc& other = around.neighbors[0].disc;
  double least = 1e9;
  for (double t = 0; t <= horizon; t += 0.001)
    least = std::min(least, (other.position + (other.velocity - v) * t).norm());
  return least;
}

TEST(Orca, AvoidsAPersonWhoDoesNot) {
  PeopleSettings settings;
  settings.horizon = 4;
  const Neighborhood around = encounter(0.2, 1);
  EXPECT_LT(least_distance(around, around.wanted, settings.horizon), 1);
  const TPoint2D v = orca_velocity(around, settings);
  EXPECT_NEAR(least_distance(around, v, settings.horizon), 1, 1e-3);
  EXPECT_LT(v.y, 0);  // away from the side of the other one
}

/// Both take half of the same change of the relative velocity.
TEST(Orca, SharesTheAvoidance) {
  PeopleSettings settings;
  settings.horizon = 4;
  const TPoint2D all = orca_velocity(encounter(0.2, 1), settings) - TPoint2D(1, 0);
  const TPoint2D half = orca_velocity(encounter(0.2, 0.5), settings) - TPoint2D(1, 0);
  EXPECT_NEAR(half.x, 0.5 * all.x, 1e-12);
  EXPECT_NEAR(half.y, 0.5 * all.y, 1e-12);
}

TEST(Orca, IgnoresThoseBeyondTheHorizonOrBehindAWall) {
  PeopleSettings settings;
  settings.horizon = 1;  // they meet after 1.5 s
  EXPECT_EQ(orca_velocity(encounter(0.2, 1), settings).y, 0);
  settings.horizon = 4;
  Neighborhood around = encounter(0.2, 1);
  around.neighbors[0].is_visible = false;
  EXPECT_EQ(orca_velocity(around, settings).y, 0);
}

/// Discs that overlap by 0.2 m part within a period: each moves by half of that.
TEST(Orca, PartsFromAPersonItOverlaps) {
  Neighborhood around = encounter(0, 0.5);
  around.self.velocity = around.wanted = {0, 0};
  around.neighbors[0].disc = {{0.8, 0}, {0, 0}, 0.5};
  PeopleSettings settings;
  const TPoint2D v = orca_velocity(around, settings);
  EXPECT_NEAR(v.x, -0.1 / settings.period, 1e-12);
  EXPECT_EQ(v.y, 0);
}

}  // namespace
}  // namespace slalom
