// SPDX-License-Identifier: BSD-3-Clause
#include "error_text.h"
#include "family_samples.h"

#include <slalom/generation/maze.h>

#include <cmath>

namespace slalom {
namespace {

/// The number of cells reachable from the first.
int reachable(const Maze& maze) {
  std::vector<bool> seen(static_cast<std::size_t>(maze.columns() * maze.rows()), false);
  std::vector<std::pair<int, int>> waiting;
  int count = 0;
  const auto enter = [&](int x, int y) {
    const auto i = static_cast<std::size_t>(y) * static_cast<std::size_t>(maze.columns()) +
                   static_cast<std::size_t>(x);
    if (seen[i]) return;
    seen[i] = true;
    ++count;
    waiting.emplace_back(x, y);
  };
  enter(0, 0);
  while (!waiting.empty()) {
    const auto [x, y] = waiting.back();
    waiting.pop_back();
    if (x + 1 < maze.columns() && maze.open_right(x, y)) enter(x + 1, y);
    if (x > 0 && maze.open_right(x - 1, y)) enter(x - 1, y);
    if (y + 1 < maze.rows() && maze.open_above(x, y)) enter(x, y + 1);
    if (y > 0 && maze.open_above(x, y - 1)) enter(x, y - 1);
  }
  return count;
}

TEST(SampleMaze, WithoutLoopsIsASpanningTreeOfTheCells) {
  RandomEngine engine(3);
  for (const auto& [columns, rows] : {std::pair(1, 1), {1, 7}, {7, 1}, {2, 2}, {9, 5}, {30, 30}}) {
    const Maze maze = sample_maze(engine, columns, rows, 0);
    EXPECT_EQ(maze.count_open(), columns * rows - 1);
    EXPECT_EQ(reachable(maze), columns * rows);
  }
}

TEST(SampleMaze, OpensTheLoopFractionOfTheOtherWalls) {
  RandomEngine engine(3);
  // 8 x 6 cells have 7 * 6 + 8 * 5 = 82 walls, 47 of them opened for a perfect maze: 35 are left.
  EXPECT_EQ(sample_maze(engine, 8, 6, 0.2).count_open(), 47 + 7);
  EXPECT_EQ(sample_maze(engine, 8, 6, 1).count_open(), 82);
}

TEST(MazeFamily, PassagesHaveTheGivenWidth) {
  const auto maze = family("maze",
                           "columns = 1\nrows = 8\npassage = 1\nwall = 0.2\n"
                           "min_distance = 4\nloop_fraction = 0\n");
  RandomEngine engine(3);
  // A maze of one column has no walls but the border: 8 cells of 1.2 m.
  const Scenario corridor = maze->generate("x", engine);
  EXPECT_TRUE(corridor.primitives().polygons.empty());
  EXPECT_NEAR(corridor.bounds().y_max, 8 * 1.2, 1e-12);
  // In the middle of a cell the nearest wall is half a passage away, or (the border, where half a
  // wall's thickness is missing) a little more.
  const Scenario scenario =
      family("maze", "passage = 1\nwall = 0.2\nloop_fraction = 0\n")->generate("x", engine);
  for (int y = 1; y < 7; ++y)
    for (int x = 1; x < 7; ++x) {
      double nearest = 10;
      for (const Polygon& wall : scenario.primitives().polygons)
        nearest = std::min(nearest, distance({(x + 0.5) * 1.2, (y + 0.5) * 1.2}, wall));
      EXPECT_GE(nearest, 0.5 - 1e-9);
      EXPECT_LE(nearest, std::hypot(0.5, 0.5) + 1e-9);
    }
}

TEST(MazeFamily, RejectsInvalidOptions) {
  EXPECT_TRUE(throws_error(ErrorKind::Usage, "g.ini:2: [generator.maze] clear_radius:",
                           {"passage", "expected less than half of passage"},
                           [] { family("maze", "clear_radius = 0.6\n"); }));
  EXPECT_NE(refusal("maze", "loop_fraction = 2\n").find("loop_fraction"), std::string::npos);
  EXPECT_NE(refusal("maze", "columns = 100000\n").find("columns"), std::string::npos);
}

}  // namespace
}  // namespace slalom
