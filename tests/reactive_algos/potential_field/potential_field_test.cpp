// SPDX-License-Identifier: BSD-3-Clause
#include "holonomic_scenes.h"
#include "potential_field/potential_field.h"

#include <gtest/gtest.h>

namespace potential_field {
namespace {

using namespace reactive;

TEST(Repulsion, IsTheFirasFunction) {
  // eta (1 / 0.5 - 1 / 1) / 0.5^2 = 4 eta.
  EXPECT_NEAR(repulsion(0.5, 0.1, 1), 0.4, 1e-12);
  EXPECT_EQ(repulsion(1.0, 0.1, 1), 0);
  EXPECT_TRUE(std::isfinite(repulsion(0, 0.1, 1)));
}

TEST(RepulsionOf, IsOneForcePerObstacleOfAnyWidth) {
  const Parameters parameters;
  const Point narrow = repulsion_of(sectors_with({{-3, 3, 0.2}}), parameters);
  const Point wide = repulsion_of(sectors_with({{-60, 60, 0.2}, {-3, 3, 0.15}}), parameters);
  const double eta = repulsion_gain(parameters);
  const double expected = repulsion(0.15, eta, parameters.influence);
  EXPECT_NEAR(std::hypot(wide.x, wide.y), expected, 1e-9);
  EXPECT_NEAR(std::hypot(narrow.x, narrow.y), repulsion(0.2, eta, parameters.influence), 1e-9);
  EXPECT_LT(narrow.x, 0);
}

TEST(PotentialField, MovesStraightWithoutNearObstacles) {
  const Decision decision = PotentialField().decide(sectors_with({}), target_at(-30));
  EXPECT_NEAR(decision.direction, -30 * kDegree, 1e-9);
  EXPECT_EQ(decision.speed, 1);
}

TEST(PotentialField, IsRepelledByAnObstacleBeside) {
  EXPECT_LT(PotentialField().decide(sectors_with({{30, 60, 0.1}}), target_at(0)).direction, 0);
}

TEST(PotentialField, StopsWhereAnObstacleAheadBalancesTheGoal) {
  Sectors sectors = sectors_with({});
  sectors.free_distances[60] = Parameters().clearance;  // centered 1.5 degrees to the left
  const Decision decision = PotentialField().decide(sectors, target_at(1.5));
  EXPECT_EQ(decision.speed, 0);
  Parameters parameters;
  parameters.attraction = 3;
  parameters.clearance = 0.1;
  EXPECT_NEAR(repulsion(0.1, repulsion_gain(parameters), parameters.influence), 3, 1e-12);
  parameters.clearance = parameters.influence;
  EXPECT_THROW(PotentialField{parameters}, slalom::Error);
}

}  // namespace
}  // namespace potential_field
