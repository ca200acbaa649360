// SPDX-License-Identifier: BSD-3-Clause
#include "family.h"
#include "walls.h"

#include <slalom/generation/maze.h>

#include <algorithm>

namespace slalom {
namespace {

/// Closed walls as rectangles; collinear adjacent walls are merged.
class MazeWalls {
 public:
  MazeWalls(const Maze& maze, double pitch, double thickness)
      : maze_(maze), pitch_(pitch), half_(thickness / 2) {}

  std::vector<Polygon> polygons() {
    for (int x = 0; x + 1 < maze_.columns(); ++x)
      for (int y = 0; y < maze_.rows(); ++y)
        if (!maze_.open_right(x, y)) {
          const int first = y;
          while (y + 1 < maze_.rows() && !maze_.open_right(x, y + 1)) ++y;
          const double at = (x + 1) * pitch_;
          add(at, first * pitch_, at, (y + 1) * pitch_);
        }
    for (int y = 0; y + 1 < maze_.rows(); ++y)
      for (int x = 0; x < maze_.columns(); ++x)
        if (!maze_.open_above(x, y)) {
          const int first = x;
          while (x + 1 < maze_.columns() && !maze_.open_above(x + 1, y)) ++x;
          const double at = (y + 1) * pitch_;
          add(first * pitch_, at, (x + 1) * pitch_, at);
        }
    return std::move(polygons_);
  }

 private:
  /// The wall along a line, extended by half its thickness at both ends so that corners are closed.
  void add(double x_min, double y_min, double x_max, double y_max) {
    polygons_.push_back(rectangle(x_min - half_, y_min - half_, x_max + half_, y_max + half_));
  }

  const Maze& maze_;
  double pitch_, half_;
  std::vector<Polygon> polygons_;
};

class MazeGenerator : public Generator {
 public:
  explicit MazeGenerator(const MazeOptions& options) : options_(options) {}

  std::string name() const override { return "maze"; }

  Scenario generate(const std::string& scenario_name, RandomEngine& engine) const override {
    const double pitch = options_.passage + options_.wall;
    const Bounds workspace = {0, 0, options_.columns * pitch, options_.rows * pitch};
    const Maze maze = sample_maze(engine, options_.columns, options_.rows, options_.loop_fraction);
    Primitives walls;
    walls.polygons = MazeWalls(maze, pitch, options_.wall).polygons();
    const StartGoal start_goal =
        sample_start_goal(engine, workspace, options_.start_goal,
                          clearance_filter(walls, options_.start_goal.clear_radius));
    const auto start = start_pose(engine, start_goal);
    return Scenario::continuous(scenario_name, workspace, std::move(walls), start, start_goal.goal);
  }

 private:
  MazeOptions options_;
};

}  // namespace

Maze::Maze(int columns, int rows)
    : columns_(columns),
      rows_(rows),
      right_(static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows), false),
      above_(right_) {}

int Maze::count_open() const {
  return static_cast<int>(std::count(right_.begin(), right_.end(), true) +
                          std::count(above_.begin(), above_.end(), true));
}

Maze sample_maze(RandomEngine& engine, int columns, int rows, double loop_fraction) {
  std::vector<CellPair> walls;
  for (int cell = 0; cell < columns * rows; ++cell) {
    if (cell % columns + 1 < columns) walls.emplace_back(cell, cell + 1);
    if (cell / columns + 1 < rows) walls.emplace_back(cell, cell + columns);
  }
  const std::vector<bool> open = open_walls(engine, columns * rows, walls, loop_fraction);
  Maze maze(columns, rows);
  for (std::size_t i = 0; i < walls.size(); ++i) {
    const int column = walls[i].first % columns, row = walls[i].first / columns;
    const bool is_right = columns > 1 && walls[i].second == walls[i].first + 1;
    is_right ? maze.set_open_right(column, row, open[i])
             : maze.set_open_above(column, row, open[i]);
  }
  return maze;
}

void MazeOptions::visit(OptionVisitor& v) {
  v.option("columns", columns, "-", "cells from left to right", Range::between(1, 500));
  v.option("rows", rows, "-", "cells from bottom to top", Range::between(1, 500));
  v.option("passage", passage, "m", "free width between walls", Range::positive());
  v.option("wall", wall, "m", "thickness of walls", Range::positive());
  v.option("loop_fraction", loop_fraction, "-",
           "fraction of the walls of a perfect maze that are opened", Range::between(0, 1));
  start_goal.visit(v);
}

std::unique_ptr<Generator> make_generator(const MazeOptions& given,
                                          const GeneratorContext& context) {
  const FamilyChecks checks(MazeOptions::kFamily, context);
  const auto options = checks.scaled(given);
  checks.expect(options.passage > 2 * options.start_goal.clear_radius, "clear_radius",
                "is too large for the passages", "less than half of passage");
  const double pitch = options.passage + options.wall;
  checks.expect_start_goal_fit(options.start_goal, options.columns * pitch, options.rows * pitch);
  return std::make_unique<MazeGenerator>(options);
}

}  // namespace slalom
