// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "family_samples.h"

#include <slalom/generation/rooms.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom {
namespace {

RoomPlan plan(std::uint64_t seed, const RoomsOptions& options) {
  RandomEngine engine(seed);
  return sample_rooms(engine, options);
}

/// The number of connected components of rooms.
int components(const RoomPlan& plan) {
  std::vector<int> group(plan.rooms.size());
  std::iota(group.begin(), group.end(), 0);
  for (const RoomWall& wall : plan.walls) {
    if (!wall.door) continue;
    const int a = group[std::size_t(wall.a)], b = group[std::size_t(wall.b)];
    std::replace(group.begin(), group.end(), a, b);
  }
  std::sort(group.begin(), group.end());
  return int(std::unique(group.begin(), group.end()) - group.begin());
}

TEST(SampleRooms, RoomsTileTheWorkspaceAndHaveTheMinimumSize) {
  const RoomsOptions options;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    double area = 0;
    int corridors = 0;
    for (const Bounds& room : plan(seed, options).rooms) {
      area += room.area();
      const double side = std::min(room.width(), room.height());
      const bool corridor = std::abs(side - options.corridor_width) < 1e-9;
      corridors += corridor ? 1 : 0;
      EXPECT_TRUE(corridor || side >= options.min_room - 1e-9) << side;
      EXPECT_TRUE(corridor || side < 2 * options.min_room);
    }
    EXPECT_NEAR(area, options.width * options.height, 1e-9);
    EXPECT_EQ(corridors, 1);
  }
}

TEST(SampleRooms, DoorsFormASpanningTreeWithoutExtraDoors) {
  RoomsOptions options;
  options.extra_doors = 0;
  for (std::uint64_t seed = 0; seed < 30; ++seed) {
    const RoomPlan drawn = plan(seed, options);
    EXPECT_EQ(components(drawn), 1);
    const auto doors = std::count_if(drawn.walls.begin(), drawn.walls.end(),
                                     [](const RoomWall& wall) { return wall.door.has_value(); });
    EXPECT_EQ(doors, std::ptrdiff_t(drawn.rooms.size()) - 1);
  }
}

TEST(RoomsFamily, DoorsHaveTheGivenWidth) {
  // The obstacle nearest to the center of a door is a door post, at half the width.
  RoomsOptions options;
  for (const double width : {0.8, 1.1}) {
    options.door_width = width;
    const auto generator = family("rooms", "door_width = " + std::to_string(width) + "\n");
    for (std::uint64_t seed = 1; seed < 10; ++seed) {
      RandomEngine engine(seed);
      const Scenario scenario = generator->generate("x", engine);
      for (const RoomWall& wall : plan(seed, options).walls) {
        if (!wall.door) continue;
        EXPECT_NEAR(wall.door->second - wall.door->first, width, 1e-12);
        const double along = (wall.door->first + wall.door->second) / 2;
        const mrpt::math::TPoint2D middle = wall.vertical ? mrpt::math::TPoint2D(wall.at, along)
                                                          : mrpt::math::TPoint2D(along, wall.at);
        double nearest = 10;
        for (const Polygon& piece : scenario.primitives().polygons)
          nearest = std::min(nearest, distance(middle, piece));
        EXPECT_NEAR(nearest, width / 2, 1e-9);
      }
    }
  }
}

TEST(RoomsFamily, RejectsInvalidOptions) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "g.ini:2: [generator.rooms] door_width:",
                           {"does not fit", "expected at most min_room and corridor_width"},
                           [] { family("rooms", "door_width = 2\n"); }));
  EXPECT_EQ(refusal("rooms", "door_width = 2\ncorridors = 0\n"), "no error");
  EXPECT_NE(refusal("rooms", "width = 1e12\nheight = 1e-6\nmargin = 0\n").find("min_room"),
            std::string::npos);
  EXPECT_NE(refusal("rooms", "width = 1e5\nheight = 1e5\n").find("min_room"), std::string::npos);
}

}  // namespace
}  // namespace slalom
