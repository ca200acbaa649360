// SPDX-License-Identifier: BSD-3-Clause
#include "map_files.h"
#include "map_readers.h"
#include "rotated_grid.h"

#include <slalom/core/random.h>
#include <slalom/scenario/geometry.h>
#include <slalom/scenario/grid_map.h>

#include <gtest/gtest.h>

#include <cmath>

namespace slalom {
namespace {

using Map = mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;

Map random_grid(RandomEngine& random, int max_size) {
  Map map = make_grid_map(uniform_int(random, 1, max_size), uniform_int(random, 1, max_size),
                          uniform_real(random, 0.05, 0.5),
                          {uniform_real(random, -5, 5), uniform_real(random, -5, 5)});
  for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y)
    for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x) {
      const int kind = uniform_int(random, 0, 9);
      if (kind < 2) map.setCell(x, y, kind == 0 ? 0.0F : 0.5F);
    }
  return map;
}

/// The point (u, v) (m) from the grid's corner, rotated about that corner.
TPoint2D rotated(const Map& map, double u, double v, double yaw) {
  return {map.getXMin() + u * std::cos(yaw) - v * std::sin(yaw),
          map.getYMin() + u * std::sin(yaw) + v * std::cos(yaw)};
}

float cell_at(const Map& map, const TPoint2D& p) {
  return map.getCell(map.x2idx(static_cast<float>(p.x)), map.y2idx(static_cast<float>(p.y)));
}

TEST(RotatedGrid, IsExactForMultiplesOf90Degrees) {
  RandomEngine random(3);
  for (int round = 0; round < 100; ++round) {
    const Map map = random_grid(random, 12);
    const double r = map.getResolution();
    for (int quarters = -4; quarters <= 4; ++quarters) {
      const Map again = rotated_grid(map, quarters * M_PI / 2, "map.yaml");
      const bool upright = quarters % 2 == 0;
      ASSERT_EQ(again.getSizeX(), upright ? map.getSizeX() : map.getSizeY());
      ASSERT_EQ(again.getSizeY(), upright ? map.getSizeY() : map.getSizeX());
      for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y)
        for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
          ASSERT_EQ(cell_at(again, rotated(map, (x + 0.5) * r, (y + 0.5) * r, quarters * M_PI / 2)),
                    map.getCell(x, y));
    }
  }
}

TEST(RotatedGrid, KeepsObstaclesAndGrowsThemByLessThanACellDiagonal) {
  RandomEngine random(4);
  for (int round = 0; round < 60; ++round) {
    const Map map = random_grid(random, 10);
    const double yaw = uniform_real(random, -7, 7), r = map.getResolution();
    const Map again = rotated_grid(map, yaw, "map.yaml");
    const auto old_square = [&](int x, int y) {
      return Polygon{{rotated(map, x * r, y * r, yaw), rotated(map, (x + 1) * r, y * r, yaw),
                      rotated(map, (x + 1) * r, (y + 1) * r, yaw),
                      rotated(map, x * r, (y + 1) * r, yaw)}};
    };
    for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y)
      for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
        for (int i = 0; i < 5; ++i) {  // every point of an old cell is at least as occupied
          const TPoint2D p = rotated(map, (x + uniform_real(random, 0.01, 0.99)) * r,
                                     (y + uniform_real(random, 0.01, 0.99)) * r, yaw);
          ASSERT_LE(cell_at(again, p), map.getCell(x, y));
        }
    for (int cy = 0; cy < static_cast<int>(again.getSizeY()); ++cy)
      for (int cx = 0; cx < static_cast<int>(again.getSizeX()); ++cx) {
        if (again.getCell(cx, cy) > 0.25F) continue;
        const TPoint2D center(again.idx2x(cx), again.idx2y(cy));
        double min_distance = 1e9;
        for (int y = 0; y < static_cast<int>(map.getSizeY()); ++y)
          for (int x = 0; x < static_cast<int>(map.getSizeX()); ++x)
            if (map.getCell(x, y) < 0.25F)
              min_distance = std::min(min_distance, distance(center, old_square(x, y)));
        ASSERT_LE(min_distance, r * std::sqrt(0.5) + 1e-5);  // half the diagonal from its center
      }
  }
}

TEST(RotatedGrid, FillsCellsOutsideTheMapAsUnknown) {
  const Map again = rotated_grid(make_grid_map(4, 4, 1, {0, 0}), M_PI / 4, "map.yaml");
  EXPECT_EQ(again.getSizeX(), 6U);  // the diagonal is 5.66 long
  EXPECT_EQ(again.getCell(0, 0), Map::l2p(Map::p2l(0.5F)));
  EXPECT_EQ(cell_at(again, rotated(again, 0, 0, 0)), Map::l2p(Map::p2l(0.5F)));
  EXPECT_EQ(cell_at(again, {0, 2.8}), Map::l2p(Map::p2l(1.0F)));
}

TEST(RotatedGrid, IsAppliedToMapsWithARotatedOrigin) {
  const MapFolder folder;
  folder.write("map.pgm", "P2 3 2 255\n254 254 0\n254 205 254\n");
  const Map map =
      read_ros_map(folder.write("map.yaml", "image: map.pgm\nresolution: 0.5\norigin: [-1, 4, " +
                                                std::to_string(M_PI / 2) + "]\n"));
  ASSERT_EQ(map.getSizeX(), 2U);  // pi to 6 digits counts as 90 degrees
  ASSERT_EQ(map.getSizeY(), 3U);
  // The black pixel's center is (1.25, 0.75) from the corner, rotated (-0.75, 1.25).
  EXPECT_LT(map.getPos(-1.75F, 5.25F), 0.1F);
  EXPECT_GT(map.getPos(-1.25F, 4.25F), 0.9F);
  EXPECT_FLOAT_EQ(map.getXMin(), -2);
  EXPECT_FLOAT_EQ(map.getYMin(), 4);
}

TEST(RotatedGrid, RejectsTooManyCells) {
  const Map line = make_grid_map(200'000, 1, 0.1, {0, 0});
  EXPECT_TRUE(throws_error(ErrorKind::File, "line.yaml: ", {"too many cells", "0.7 rad"},
                           [&] { rotated_grid(line, 0.7, "line.yaml"); }));
}

}  // namespace
}  // namespace slalom
