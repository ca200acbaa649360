// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/generation/random_generator.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

TEST(RandomGenerator, RespectsItsOptions) {
  RandomGeneratorOptions options;
  options.width = 8;
  options.height = 6;
  options.obstacles.min_obstacles = 5;
  options.obstacles.max_obstacles = 9;
  options.obstacles.size.min_size = 0.2;
  options.obstacles.size.max_size = 0.4;
  options.start_goal = {0.5, 4, 0.6};
  const auto generator = make_generator(options);
  RandomEngine engine(1);
  bool polygons = false, discs = false;
  for (int i = 0; i < 100; ++i) {
    const Scenario s = generator->generate("x", engine);
    EXPECT_EQ(s.bounds(), (Bounds{0, 0, 8, 6}));
    EXPECT_LE(s.primitives().discs.size() + s.primitives().polygons.size(), 9U);
    EXPECT_GE(std::hypot(s.goal().x - s.start().x, s.goal().y - s.start().y), 4);
    for (const Disc& disc : s.primitives().discs) {
      EXPECT_GE(disc.radius, 0.2);
      EXPECT_LE(disc.radius, 0.4);
      EXPECT_GE(distance({s.start().x, s.start().y}, disc), 0.5 - 1e-9);
      EXPECT_GE(distance(s.goal(), disc), 0.5 - 1e-9);
    }
    for (const Polygon& polygon : s.primitives().polygons) EXPECT_TRUE(is_simple(polygon));
    discs = discs || !s.primitives().discs.empty();
    polygons = polygons || !s.primitives().polygons.empty();
  }
  EXPECT_TRUE(discs && polygons);
}

TEST(RandomGenerator, PolygonFractionSelectsTheKindOfObstacles) {
  RandomEngine engine(1);
  RandomGeneratorOptions options;
  options.obstacles.polygon_fraction = 0;
  const auto only_discs = make_generator(options);
  EXPECT_TRUE(only_discs->generate("x", engine).primitives().polygons.empty());
  options.obstacles.polygon_fraction = 1;
  const auto only_polygons = make_generator(options);
  EXPECT_TRUE(only_polygons->generate("x", engine).primitives().discs.empty());
}

}  // namespace
}  // namespace slalom
