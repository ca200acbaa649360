#pragma once

#include <slalom/generation/ends.h>
#include <slalom/generation/generator.h>

#include <vector>

namespace slalom {

/// Section [generator.maze]: square cells with walls between them, each reachable from each.
struct MazeOptions {
  int columns = 8, rows = 8;
  double passage = 1.2;     ///< m, of free width between walls
  double wall = 0.15;       ///< m, thickness
  double loop_share = 0.1;  ///< share of the walls of a perfect maze that are opened
  EndsOptions ends = {0.35, 6, 0.5};

  void visit(OptionVisitor& v);
};

/// A perfect maze with a share of loops; start and goal anywhere between the walls.
std::unique_ptr<Generator> make_maze(const IniFile& ini, const GeneratorContext& context = {});

/// Which walls of a maze are open. Cells are numbered row by row.
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

/// A random maze: cells - 1 openings that join all cells, and `loop_share` of the other walls,
/// rounded.
Maze draw_maze(RandomEngine& engine, int columns, int rows, double loop_share);

}  // namespace slalom
