#pragma once

#include <slalom/scenario/scenario.h>

#include <string>
#include <vector>

namespace slalom {

/// How worlds of the BARN data set become scenarios.
struct BarnOptions {
  /// Which worlds of a folder: "0,5,10-19,0-299/even" (even, odd, or a number: every so many from
  /// the first on); empty for all.
  std::string worlds;
  /// Continuous: a disc for each cylinder. Grid: the cells of 0.15 m themselves.
  Representation representation = Representation::Continuous;
};

/// Whether this is a grid of BARN (grid_7.npy) or a folder of its data (with grid_files in it, or
/// with grids themselves).
bool is_barn(const std::string& path);

/// Worlds of BARN (Perille et al., "Benchmarking Metric Ground Navigation", 2020) in the order of
/// their numbers, named barn_7, with BARN's task: start (-2.25, 3) facing +y, goal (-2.25, 13).
///
/// `path` is a grid or a folder. A grid (30 x 30 rows and columns, 1 an obstacle) becomes cylinders
/// of radius 0.075 m at x = -4.425 + 0.15 row, y = 5.175 + 0.15 column, with walls of the same
/// cylinders beside and behind the start, as in BARN's own worlds; the workspace is x -4.5 to 0, y
/// 0 to 15. The path of that number (path_7.npy, beside the grid or in path_files) comes along as
/// published path. A map (map_pgm_7.pgm, beside the grid or in map_files) must show the same
/// obstacles. Throws Error: File for what cannot be read or contradicts itself, Usage for worlds
/// that are not there.
std::vector<Scenario> import_barn(const std::string& path, const BarnOptions& options);

}  // namespace slalom
