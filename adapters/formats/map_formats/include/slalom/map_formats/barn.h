// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <array>
#include <string>
#include <vector>

namespace slalom {

/// Start and goal in a world of BARN.
enum class BarnTask {
  Challenge,  ///< of the BARN challenge (since 2022): (-2.25, 3) facing +y to (-2.25, 13)
  /// Task of the trials with times published with the data set (scripts/run_trials.py of
  /// github.com/wangzizhao/jackal_timer): from 1 m before the first point of the published path to
  /// 0.3 m behind its last one, both displaced by (-0.15, -0.1) m from the cells; x of the start at
  /// least -3.9 and at most -0.5.
  Trials
};
constexpr auto enum_names(BarnTask) {
  return std::array{"challenge", "trials"};
}

/// How worlds of the BARN data set are imported.
struct BarnOptions {
  /// The worlds of a folder to import: "0,5,10-19,0-299/even" (even, odd, or a number N for every
  /// Nth); empty for all.
  std::string worlds;
  /// Continuous: a disc for each cylinder. Grid: the cells of 0.15 m.
  Representation representation = Representation::Continuous;
  BarnTask task = BarnTask::Challenge;
};

/// Whether this is a grid of BARN (grid_7.npy), one of its worlds as the BARN challenge distributes
/// them (world_7.world, of Gazebo), or a folder that contains grid_files, such grids or such names.
bool is_barn(const std::string& path);

/// Imports worlds of BARN (Perille et al., "Benchmarking Metric Ground Navigation", 2020), sorted
/// by number, named barn_7.
///
/// `path` is a grid, a world or a folder. A grid (30 x 30 rows and columns, 1 is an obstacle) is
/// converted to cylinders of radius 0.075 m at x = -4.425 + 0.15 row, y = 5.175 + 0.15 column, with
/// walls of the same cylinders at the sides of and behind the start, as in BARN's worlds; the
/// workspace is x -4.5 to 0, y 0 to 15. The path of the same number (path_7.npy, next to the grid
/// or in path_files) is imported as published path. A map (map_pgm_7.pgm, next to the grid or in
/// map_files) must contain the same obstacles. A world of Gazebo gives the same scenario as its
/// grid; its cylinders must be those of a grid. Throws Error: File for unreadable or inconsistent
/// files, also for the task of the trials if there is no path, Usage for worlds that do not exist.
std::vector<Scenario> import_barn(const std::string& path, const BarnOptions& options);

}  // namespace slalom
