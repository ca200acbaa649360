// SPDX-License-Identifier: BSD-3-Clause
#include "contours.h"
#include "random_worlds.h"

#include <slalom/core/error.h>
#include <slalom/scenario/convert.h>

#include <gtest/gtest.h>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Cells drawn as text, the top row first.
Occupancy drawn(const std::vector<std::string>& rows, double resolution = 1) {
  Occupancy cells(static_cast<int>(rows[0].size()), static_cast<int>(rows.size()), resolution,
                  {0, 0});
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      const auto& row = rows[rows.size() - 1 - static_cast<std::size_t>(cy)];
      cells.set_occupied(cx, cy, row[static_cast<std::size_t>(cx)] == '#');
    }
  return cells;
}

Occupancy reconstruct(const Occupancy& cells, std::vector<Polygon> polygons, double resolution) {
  const Bounds b = cells.bounds();
  Primitives obstacles;
  obstacles.polygons = std::move(polygons);
  const double x = (b.x_min + b.x_max) / 2, y = (b.y_min + b.y_max) / 2;
  return make_occupancy(Scenario::continuous("copy", b, obstacles, {x, y, 0}, {x, y}), resolution);
}

double area(const std::vector<Polygon>& polygons) {
  double sum = 0;
  for (const Polygon& polygon : polygons) sum += signed_area(polygon);
  return sum;
}

/// Random connected cells: islands with holes, islands in holes, thin walls.
Occupancy blobs(RandomEngine& random) {
  Occupancy cells(uniform_int(random, 1, 40), uniform_int(random, 1, 40),
                  uniform_real(random, 0.03, 0.4),
                  {uniform_real(random, -9, 9), uniform_real(random, -9, 9)});
  for (int i = uniform_int(random, 1, 12); i > 0; --i) {
    const double x = uniform_real(random, 0, cells.size_x());
    const double y = uniform_real(random, 0, cells.size_y());
    const double outer = uniform_real(random, 1, 12), inner = uniform_real(random, 0, 1.2) * outer;
    for (int cy = 0; cy < cells.size_y(); ++cy)
      for (int cx = 0; cx < cells.size_x(); ++cx) {
        const double gap = std::hypot(cx + 0.5 - x, cy + 0.5 - y);
        if (gap < outer && gap > inner) cells.set_occupied(cx, cy, true);
        if (gap < 0.5 * inner) cells.set_occupied(cx, cy, false);
      }
  }
  return cells;
}

Occupancy any_cells(RandomEngine& random, int round) {
  return round % 3 == 0 ? testing::random_occupancy(random, 24) : blobs(random);
}

TEST(Contours, TraceASingleCellWithTheInset) {
  const auto polygons = trace_contours(drawn({"...", ".#.", "..."}, 2));
  ASSERT_EQ(polygons.size(), 1U);
  const double inset = 2 * kContourInset;
  const std::vector<TPoint2D> expected = {{2 + inset, 2 + inset},
                                          {4 - inset, 2 + inset},
                                          {4 - inset, 4 - inset},
                                          {2 + inset, 4 - inset}};
  ASSERT_EQ(polygons[0].vertices.size(), 4U);
  for (const TPoint2D& corner : expected) {
    double nearest = 9;
    for (const TPoint2D& v : polygons[0].vertices)
      nearest = std::min(nearest, std::hypot(v.x - corner.x, v.y - corner.y));
    EXPECT_LT(nearest, 1e-12);
  }
}

TEST(Contours, SeparateCellsThatMeetAtACorner) {
  EXPECT_EQ(trace_contours(drawn({"....", "..#.", ".#..", "...."})).size(), 2U);
}

TEST(Contours, CutAnObstacleWithAHoleIntoSimpleParts) {
  const auto polygons = trace_contours(drawn({".....", ".###.", ".#.#.", ".###.", "....."}));
  EXPECT_EQ(polygons.size(), 2U);  // one row cuts the ring
  for (const Polygon& polygon : polygons) EXPECT_TRUE(is_simple(polygon));
  EXPECT_NEAR(area(polygons), 8, 20 * kContourInset);
  for (const Polygon& polygon : polygons) EXPECT_FALSE(contains(polygon, {2.5, 2.5}));
  // No gap where the parts meet: each point of the ring's center line is covered.
  for (double along = 1.5; along <= 3.5; along += 1e-3)
    for (const TPoint2D& p : {TPoint2D(1.5, along), TPoint2D(3.5, along), TPoint2D(along, 1.5)})
      EXPECT_TRUE(std::any_of(polygons.begin(), polygons.end(),
                              [&](const Polygon& polygon) { return contains(polygon, p); }));
}

TEST(Contours, ReachTheBorderOfTheWorkspace) {
  const auto polygons = trace_contours(drawn({"##", "##"}));
  ASSERT_EQ(polygons.size(), 1U);
  EXPECT_EQ(signed_area(polygons[0]), 4);
}

TEST(Contours, AreEmptyForAnEmptyGrid) {
  EXPECT_TRUE(trace_contours(drawn({"...", "..."})).empty());
}

TEST(Contours, ReproduceTheCells) {
  RandomEngine random(11);
  for (int round = 0; round < 600; ++round) {
    const Occupancy cells = any_cells(random, round);
    const auto polygons = trace_contours(cells);
    for (const Polygon& polygon : polygons) {
      ASSERT_TRUE(is_simple(polygon)) << round;
      ASSERT_GT(signed_area(polygon), 0) << round;
    }
    const Occupancy copy = reconstruct(cells, polygons, cells.resolution());
    ASSERT_EQ(copy.size_x(), cells.size_x());
    ASSERT_EQ(copy.cells(), cells.cells()) << round;
  }
}

std::vector<TPoint2D> samples_of_outlines(const std::vector<Polygon>& polygons, double spacing) {
  std::vector<TPoint2D> samples;
  for (const Polygon& polygon : polygons)
    for (std::size_t i = 0, j = polygon.vertices.size() - 1; i < polygon.vertices.size(); j = i++) {
      const TPoint2D a = polygon.vertices[j], edge = polygon.vertices[i] - a;
      const double pieces = std::ceil(std::hypot(edge.x, edge.y) / spacing);
      for (double k = 0; k < pieces; ++k) samples.push_back(a + edge * (k / pieces));
    }
  return samples;
}

/// The largest distance from a sample to the area of the polygons.
double farthest(const std::vector<TPoint2D>& samples, const std::vector<Polygon>& polygons) {
  double largest = 0;
  for (const TPoint2D& p : samples) {
    double nearest = 1e9;
    for (const Polygon& polygon : polygons) {
      nearest = std::min(nearest, distance(p, polygon));
      if (nearest == 0) break;
    }
    largest = std::max(largest, nearest);
  }
  return largest;
}

TEST(Contours, StayWithinTheToleranceOfTheCellsWhenSimplified) {
  RandomEngine random(12);
  std::size_t exact_vertices = 0, fewer_vertices = 0;
  for (int round = 0; round < 60; ++round) {
    const Occupancy cells = any_cells(random, round);
    const double tolerance = uniform_real(random, 0.1, 2) * cells.resolution();
    std::vector<Polygon> squares;  // the cells themselves
    for (int cy = 0; cy < cells.size_y(); ++cy)
      for (int cx = 0; cx < cells.size_x(); ++cx)
        if (cells.occupied(cx, cy))
          squares.push_back({{cells.to_world(cx, cy), cells.to_world(cx + 1, cy),
                              cells.to_world(cx + 1, cy + 1), cells.to_world(cx, cy + 1)}});
    const auto polygons = trace_contours(cells, tolerance);
    for (const Polygon& polygon : polygons) ASSERT_TRUE(is_simple(polygon));
    const double spacing = 0.25 * cells.resolution();
    ASSERT_EQ(polygons.empty(), squares.empty());
    EXPECT_LE(farthest(samples_of_outlines(polygons, spacing), squares), tolerance) << round;
    EXPECT_LE(farthest(samples_of_outlines(squares, spacing), polygons), tolerance) << round;
    for (const Polygon& polygon : polygons) fewer_vertices += polygon.vertices.size();
    for (const Polygon& polygon : trace_contours(cells)) exact_vertices += polygon.vertices.size();
  }
  EXPECT_LT(fewer_vertices, exact_vertices);
}

TEST(Contours, RefuseInvalidTolerances) {
  for (const double tolerance : {-1.0, std::nan(""), HUGE_VAL})
    EXPECT_THROW(trace_contours(drawn({"#"}), tolerance), Error);
}

Scenario grid_of(const Occupancy& cells, RandomEngine& random) {
  const Bounds b = cells.bounds();
  Primitives obstacles;
  obstacles.polygons = trace_contours(cells);
  const TPoint2D s = testing::random_point(random, b), g = testing::random_point(random, b);
  return convert(Scenario::continuous("grid", b, obstacles, {s.x, s.y, 1}, g), Representation::Grid,
                 cells.resolution());
}

TEST(Convert, TurnsAGridIntoPolygonsAndBack) {
  RandomEngine random(13);
  for (int round = 0; round < 200; ++round) {
    const Scenario grid = grid_of(any_cells(random, round), random);
    const Scenario polygons = convert(grid, Representation::Continuous, 1);
    EXPECT_EQ(polygons.representation(), Representation::Continuous);
    EXPECT_EQ(polygons.bounds(), grid.bounds());
    const double resolution = static_cast<double>(grid.grid_map()->getResolution());
    EXPECT_EQ(convert(polygons, Representation::Grid, resolution).hash(), grid.hash()) << round;
  }
}

TEST(Convert, ReproducesTheCellsAlthoughMrptRoundsTheResolution) {
  RandomEngine random(14);
  Occupancy cells(400, 300, 0.05, {-4, 7});
  for (int i = 0; i < 5000; ++i)
    cells.set_occupied(uniform_int(random, 0, 399), uniform_int(random, 0, 299), true);
  const Scenario grid = grid_of(cells, random);
  const Scenario polygons = convert(grid, Representation::Continuous, 1);
  EXPECT_EQ(convert(polygons, Representation::Grid, 0.05).hash(), grid.hash());
}

TEST(Convert, TurnsPointsIntoDiscs) {
  mrpt::maps::CSimplePointsMap map;
  map.insertPoint(1, 2);
  map.insertPoint(3, 0.5);
  const Scenario points = Scenario::points("posts", {0, 0, 4, 3}, map, {1, 1, 0}, {3, 2});
  ConversionOptions options;
  options.point_radius = 0.125;
  const Scenario discs = convert(points, Representation::Continuous, options);
  ASSERT_EQ(discs.primitives().discs.size(), 2U);
  EXPECT_EQ(discs.primitives().discs[1].center, TPoint2D(3, 0.5));
  EXPECT_EQ(discs.primitives().discs[1].radius, 0.125);
  options.point_radius = 0;
  options.resolution = 0.5;
  EXPECT_EQ(convert(points, Representation::Continuous, options).primitives().discs[0].radius,
            0.25);
  options.resolution = 0;
  EXPECT_THROW(convert(points, Representation::Continuous, options), Error);
}

}  // namespace
}  // namespace slalom
