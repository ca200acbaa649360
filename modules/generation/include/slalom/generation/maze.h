// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/generation/generator.h>
#include <slalom/generation/start_goal.h>

#include <vector>

namespace slalom {

/// Section [generator.maze]: square cells with walls between them, all connected.
struct MazeOptions {
  static constexpr char kFamily[] = "maze";
  int columns = 8, rows = 8;
  double passage = 1.2;        ///< m, free width between walls
  double wall = 0.15;          ///< m, thickness
  double loop_fraction = 0.1;  ///< fraction of the walls of a perfect maze that are opened
  StartGoalOptions start_goal = {0.35, 6, 0.5};

  void visit(OptionVisitor& v);
};

/// A perfect maze with some walls opened to form loops; start and goal anywhere between the walls.
std::unique_ptr<Generator> make_generator(const MazeOptions& options,
                                          const GeneratorContext& context = {});

/// The open walls of a maze. Cells are numbered row by row.
class Maze {
 public:
  Maze(int columns, int rows);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  /// Between a cell and the one to its right; requires column + 1 < columns.
  bool open_right(int column, int row) const { return right_[index(column, row)]; }
  /// Between a cell and the one above; requires row + 1 < rows.
  bool open_above(int column, int row) const { return above_[index(column, row)]; }
  int count_open() const;

  void set_open_right(int column, int row, bool open) { right_[index(column, row)] = open; }
  void set_open_above(int column, int row, bool open) { above_[index(column, row)] = open; }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }

  int columns_, rows_;
  std::vector<bool> right_, above_;
};

/// A random maze: cells - 1 openings that connect all cells, and `loop_fraction` of the other
/// walls, rounded.
Maze sample_maze(RandomEngine& engine, int columns, int rows, double loop_fraction);

}  // namespace slalom
