// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/core/distance.h>
#include <slalom/scenario/geometry.h>

#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The one obstacle as a square or disc of this width around its center.
struct Obstacle {
  TPoint2D center;
  double width = 0;
  double turn = 0;  ///< rad, of a box
  bool is_disc = false;
};

Obstacle obstacle_of(const Scenario& scenario) {
  const Primitives& all = scenario.primitives();
  EXPECT_EQ(all.discs.size() + all.polygons.size(), 1U);
  if (!all.discs.empty()) return {all.discs[0].center, 2 * all.discs[0].radius, 0, true};
  const auto& v = all.polygons[0].vertices;
  EXPECT_EQ(v.size(), 4U);
  const double side = distance_between(v[0], v[1]);
  // Equal sides and diagonals: a square.
  for (std::size_t i = 1; i < 4; ++i)
    EXPECT_NEAR(distance_between(v[i], v[(i + 1) % 4]), side, kRoundingError);
  EXPECT_NEAR(distance_between(v[0], v[2]), distance_between(v[1], v[3]), kRoundingError);
  return {(v[0] + v[2]) * 0.5, side, std::atan2(v[1].y - v[0].y, v[1].x - v[0].x), false};
}

TEST(Avoid, TheObstacleIsAheadOfTheStartAsTheOptionsSay) {
  const auto generator = family("avoid",
                                "min_size = 0.4\nmax_size = 0.6\ndisc_fraction = 0.5\n"
                                "min_start_distance = 1.5\nmax_start_distance = 2\n"
                                "min_offset = 0.1\nmax_offset = 0.2\ngoal_distance = 2\n"
                                "min_angle_deg = 10\nmax_angle_deg = 20\n");
  RandomEngine engine(4);
  int left = 0, turned_left = 0, discs = 0;
  double least_turn = 9, most_turn = -9;
  for (int i = 0; i < 200; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Obstacle obstacle = obstacle_of(scenario);
    expect_within(obstacle.width, 0.4, 0.6);
    const auto& start = scenario.start();
    expect_within(obstacle.center.x - start.x, 1.5, 2);
    const double offset = obstacle.center.y - start.y;
    expect_within(std::abs(offset), 0.1, 0.2);
    expect_angle_within(start.phi, 10, 20);
    EXPECT_EQ(scenario.goal().y, start.y);
    EXPECT_NEAR(scenario.goal().x - obstacle.center.x, 2, kRoundingError);
    // Half of the least width is the largest offset: the straight path always leads through it.
    EXPECT_LT(cast_ray(scenario.primitives(), scenario.bounds(), {start.x, start.y}, 0, 9),
              scenario.goal().x - start.x);
    left += offset > 0 ? 1 : 0;
    turned_left += start.phi > 0 ? 1 : 0;
    discs += obstacle.is_disc ? 1 : 0;
    if (obstacle.is_disc) continue;
    least_turn = std::min(least_turn, obstacle.turn);
    most_turn = std::max(most_turn, obstacle.turn);
  }
  // Both alike: 200 throws of a coin are within 60 and 140 but once in 10^8.
  EXPECT_NEAR(left, 100, 40);
  EXPECT_NEAR(turned_left, 100, 40);
  EXPECT_NEAR(discs, 100, 40);
  // A square looks the same after a quarter turn. All of 60 turns miss a tenth of it but once in
  // 500.
  EXPECT_GE(least_turn, 0);
  EXPECT_LT(least_turn, M_PI / 20);
  EXPECT_GT(most_turn, M_PI / 2 * 0.9);
  EXPECT_LE(most_turn, M_PI / 2);
}

TEST(Avoid, StartAndGoalAreClearAndWithinTheMargins) {
  const auto generator = family("avoid");
  RandomEngine engine(7);
  for (int i = 0; i < 200; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const Primitives& all = scenario.primitives();
    for (const TPoint2D& p : {TPoint2D(scenario.start().x, scenario.start().y), scenario.goal()}) {
      for (const Disc& disc : all.discs) EXPECT_GE(distance(p, disc), 0.6);
      for (const Polygon& box : all.polygons) EXPECT_GE(distance(p, box), 0.6);
      EXPECT_GE(p.x, 0.8 - kRoundingError);
      EXPECT_LE(p.x, 10 - 0.8 + kRoundingError);
      // In the middle quarter of 8 m.
      EXPECT_GE(p.y, 3);
      EXPECT_LE(p.y, 5);
    }
  }
}

TEST(Avoid, EveryDrawOfTheDefaultsIsSolvable) {
  expect_solvable("avoid", 1);
}

TEST(Avoid, OptionsWithoutARangeGiveDistinctScenarios) {
  expect_distinct("avoid",
                  "min_size = 0.5\nmax_size = 0.5\nmin_start_distance = 2\n"
                  "max_start_distance = 2\nmax_offset = 0\nmax_angle_deg = 0\n"
                  "disc_fraction = 1\n");
}

TEST(Avoid, RejectsInvalidOptions) {
  expect_refusals(
      "avoid",
      {{"min_size = 2\n", "max_size: is less than min_size"},
       {"max_size = 3\n", "clear_radius: reaches the obstacle"},
       {"clear_radius = 1.5\n", "clear_radius: reaches the obstacle"},
       {"goal_distance = 1\n", "clear_radius: reaches the obstacle"},
       {"min_offset = 1\n", "max_offset: is less than min_offset"},
       {"max_offset = 2.5\n", "max_offset: places the obstacle outside the workspace"},
       {"max_start_distance = 1\n", "max_start_distance: is less than min_start_distance"},
       {"max_start_distance = 6\n", "max_start_distance: start and goal do not fit"},
       {"min_angle_deg = 40\n", "max_angle_deg: is less than min_angle_deg"},
       {"height = 2\n", "margin: leaves no room for the straight path"},
       {"min_distance = 8.5\n", "min_distance: start and goal cannot be min_distance apart"}});
}

}  // namespace
}  // namespace slalom
