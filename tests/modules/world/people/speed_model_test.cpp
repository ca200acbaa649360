// SPDX-License-Identifier: BSD-3-Clause
#include "speed_model.h"

#include <slalom/core/math.h>

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kRadius = 0.25;  // m

/// A person at the origin who wants to walk along x.
Neighborhood person_at_origin() {
  Neighborhood around;
  around.self = {{0, 0}, {0, 0}, kRadius};
  around.wanted = {1.3, 0};
  around.max_speed = 1.5;
  return around;
}

TEST(SpeedModel, WalksAsWantedWithoutOthers) {
  const TPoint2D v = speed_velocity(person_at_origin(), {});
  EXPECT_EQ(v.x, 1.3);
  EXPECT_EQ(v.y, 0);
}

/// The gap of 0.4 m over a time gap of 2 s.
TEST(SpeedModel, KeepsATimeGapToTheOneAhead) {
  Neighborhood around = person_at_origin();
  around.neighbors.push_back({{{0.9, 0}, {0, 0}, kRadius}, 1, 0.5, true, false});
  PeopleSettings settings;
  settings.time_gap = 2;
  EXPECT_NEAR(speed_velocity(around, settings).x, 0.2, 1e-12);
  around.neighbors[0].is_visible = false;
  EXPECT_EQ(speed_velocity(around, settings).x, 1.3);
}

/// A wall on the left, at a gap of 0.05 m: repelled by 5 exp(-1) times the wanted direction.
TEST(SpeedModel, IsRepelledByWalls) {
  Neighborhood around = person_at_origin();
  around.walls.push_back({{0, kRadius + 0.05}, true});
  const TPoint2D v = speed_velocity(around, {});
  EXPECT_NEAR(v.y / v.x, -5 * std::exp(-1.0), 1e-12);
  EXPECT_NEAR(v.norm(), 1.3, 1e-12);
}

TEST(SpeedModel, DoesNotWalkIntoAWall) {
  Neighborhood around = person_at_origin();
  around.walls.push_back({{kRadius + 0.03, 0}, false});
  PeopleSettings settings;
  EXPECT_NEAR(speed_velocity(around, settings).x, 0.03 / settings.wall_horizon, 1e-12);
}

/// The law of the model (Tordeux et al. 2015, equation 5): speed = (1 / density - length) / time
/// gap.
TEST(SpeedModel, WalksInASingleFileByItsLaw) {
  constexpr int kPeople = 30;
  const PeopleSettings settings;
  for (const double density : {1.0, 1.25, 1.5, 1.75}) {
    const double length = kPeople / density;
    std::vector<Neighborhood> file(kPeople);
    for (int i = 0; i < kPeople; ++i) {
      file[i].self = {{(i + 0.02 * math::sin(1.7 * i)) / density, 0}, {0, 0}, kRadius};
      file[i].wanted = {1.33, 0};
      file[i].max_speed = 1.33;
    }
    double sum = 0;
    for (int k = 0; k < 1200; ++k) {
      std::vector<TPoint2D> velocities;
      for (int i = 0; i < kPeople; ++i) {
        Neighborhood around = file[i];
        for (const int step : {-1, 1}) {
          CrowdDisc disc = file[(i + step + kPeople) % kPeople].self;
          if (i + step < 0) disc.position.x -= length;
          if (i + step >= kPeople) disc.position.x += length;
          around.neighbors.push_back({disc, step});
        }
        sort_by_place(around, settings.side);
        velocities.push_back(speed_velocity(around, settings));
      }
      for (int i = 0; i < kPeople; ++i) {
        file[i].self.position += velocities[i] * settings.period;
        if (k >= 600) sum += velocities[i].x;
      }
    }
    EXPECT_NEAR(sum / (600 * kPeople), (1 / density - 2 * kRadius) / settings.time_gap, 1e-3);
  }
}

}  // namespace
}  // namespace slalom
