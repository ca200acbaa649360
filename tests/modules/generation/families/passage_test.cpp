// SPDX-License-Identifier: BSD-3-Clause
#include "family_samples.h"

#include <slalom/scenario/geometry.h>

#include <cmath>

namespace slalom {
namespace {

TEST(Passage, TheRobotFacesTheGapAsTheOptionsSay) {
  const auto generator = family("passage",
                                "min_width = 0.7\nmax_width = 0.9\nwall = 0.2\n"
                                "min_start_distance = 1\nmax_start_distance = 2\n"
                                "min_offset = 0.3\nmax_offset = 0.4\n"
                                "min_angle_deg = 10\nmax_angle_deg = 20\n");
  RandomEngine engine(4);
  int left = 0, turned_left = 0;
  for (int i = 0; i < 200; ++i) {
    const Scenario scenario = generator->generate("x", engine);
    const auto& walls = scenario.primitives().polygons;
    ASSERT_EQ(walls.size(), 2U);
    double low = 0, high = scenario.bounds().y_max, near = scenario.bounds().x_max, far = 0;
    for (const auto& corner : walls[0].vertices) {
      low = std::max(low, corner.y);
      near = std::min(near, corner.x);
      far = std::max(far, corner.x);
    }
    for (const auto& corner : walls[1].vertices) high = std::min(high, corner.y);
    EXPECT_NEAR(far - near, 0.2, 1e-12);
    expect_within(high - low, 0.7, 0.9);
    const auto& start = scenario.start();
    expect_within(near - start.x, 1, 2);
    const double offset = start.y - (low + high) / 2;
    expect_within(std::abs(offset), 0.3, 0.4);
    expect_angle_within(start.phi, 10, 20);
    EXPECT_NEAR(scenario.goal().y, (low + high) / 2, 1e-12);
    EXPECT_NEAR(scenario.goal().x - far, std::max(near - start.x, start.x + 3 - far), 1e-12);
    left += offset > 0 ? 1 : 0;
    turned_left += start.phi > 0 ? 1 : 0;
  }
  // Both sides alike: 200 throws of a coin are within 60 and 140 but once in 10^8.
  EXPECT_NEAR(left, 100, 40);
  EXPECT_NEAR(turned_left, 100, 40);
}

TEST(Passage, OptionsWithoutARangeGiveDistinctScenarios) {
  expect_distinct("passage",
                  "min_width = 0.9\nmax_width = 0.9\nmin_start_distance = 2\n"
                  "max_start_distance = 2\nmax_offset = 0\nmax_angle_deg = 0\n");
}

TEST(Passage, RejectsInvalidOptions) {
  expect_refusals(
      "passage",
      {{"min_width = 2\n", "max_width: is less than min_width"},
       {"max_width = 5\n", "max_width: leaves no wall beside the gap"},
       {"min_offset = 1\n", "max_offset: is less than min_offset"},
       {"max_offset = 1.5\n", "max_offset: places the start outside the margins"},
       {"max_start_distance = 4.5\n", "max_start_distance: places the start outside the margins"},
       {"min_angle_deg = 40\n", "max_angle_deg: is less than min_angle_deg"},
       {"clear_radius = 1.6\n", "clear_radius: reaches the wall"},
       {"min_distance = 6\n", "min_distance: start and goal cannot be min_distance apart"}});
}

}  // namespace
}  // namespace slalom
