// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "family_samples.h"

#include <slalom/generation/traps.h>

#include <cmath>

namespace slalom {
namespace {

TEST(Trap, IsAPocketWithOneOpening) {
  const double depth = 2, opening = 1.5, wall = 0.2;
  for (const double direction : {0.0, 1.0, -2.5}) {
    const Trap trap = {{1, 2}, direction, depth, opening};
    Primitives walls;
    walls.polygons.push_back(outline(trap, wall));
    ASSERT_TRUE(is_simple(walls.polygons[0]));
    // The outer rectangle minus the pocket.
    EXPECT_NEAR(std::abs(signed_area(walls.polygons[0])),
                (depth + wall) * (opening + 2 * wall) - depth * opening, 1e-12);
    const auto free_distance = [&](double angle) {
      return cast_ray(walls, {-50, -50, 50, 50}, {1, 2}, angle, 20);
    };
    EXPECT_EQ(free_distance(direction), 20);
    EXPECT_NEAR(free_distance(direction + M_PI), (depth - wall) / 2, 1e-9);
    EXPECT_NEAR(free_distance(direction + M_PI / 2), opening / 2, 1e-9);
    EXPECT_NEAR(free_distance(direction - M_PI / 2), opening / 2, 1e-9);
  }
}

TEST(TrapsFamily, BlocksTheStraightLineAndFacesTheStart) {
  const TrapsOptions options;
  const StartGoal start_goal = {{1, 1}, {12, 8}};
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    RandomEngine engine(seed);
    const auto traps = sample_traps(engine, options, start_goal);
    ASSERT_FALSE(traps.empty());
    Primitives walls;
    for (std::size_t i = 0; i < traps.size(); ++i) {
      walls.polygons.push_back(outline(traps[i], options.wall));
      const double to_start = std::atan2(start_goal.start.y - traps[i].center.y,
                                         start_goal.start.x - traps[i].center.x);
      EXPECT_GE(std::cos(traps[i].direction - to_start), std::cos(M_PI / 6) - 1e-9);
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GE(std::hypot(traps[i].center.x - traps[j].center.x,
                             traps[i].center.y - traps[j].center.y),
                  bounding_radius(traps[i], options.wall) +
                      bounding_radius(traps[j], options.wall) + options.gap - 1e-9);
    }
    const double straight = std::hypot(11, 7);
    EXPECT_LT(cast_ray(walls, {0, 0, 14, 10}, start_goal.start, std::atan2(7, 11), straight),
              straight);
  }
}

TEST(TrapsFamily, RejectsInvalidOptions) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "g.ini:2: [generator.traps] max_traps:",
                           {"less than min_traps", "expected at least 2"},
                           [] { family("traps", "max_traps = 1\n"); }));
  EXPECT_NE(refusal("traps", "min_depth = 9\n").find("max_depth"), std::string::npos);
  EXPECT_NE(refusal("traps", "min_opening = 9\n").find("max_opening"), std::string::npos);
}

}  // namespace
}  // namespace slalom
