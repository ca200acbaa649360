// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <limits>
#include <string>
#include <vector>

namespace slalom {

/// A MovingAI map (.map, "type octile": Sturtevant, "Benchmarks for Grid-Based Pathfinding", 2012)
/// as an occupancy grid with its lower left corner at (0, 0) and cells of `cell_size` m. '.' and
/// 'G' are free, '@', 'O' and 'T' occupied. Line ends may be LF or CRLF. Maps with swamp ('S') or
/// water ('W') are rejected, because passing them depends on the neighboring terrain. Throws Error:
/// Usage for an invalid cell size, File with line and reason for an invalid file.
mrpt::maps::COccupancyGridMap2D read_moving_ai_map(const std::string& path, double cell_size);

/// One problem of a MovingAI scenario file, in cells; (0, 0) is the upper left cell.
struct MovingAiProblem {
  int bucket = 0;  ///< difficulty: published length / 4
  int map_width = 0, map_height = 0;
  int start_x = 0, start_y = 0, goal_x = 0, goal_y = 0;
  /// Length in cells of the shortest path of a point over 8-connected cell centers: diagonals have
  /// length sqrt 2 and require that both adjacent cells are free.
  double published_length = 0;
  int line = 0;  ///< in the file
};

/// Reads the problems of a MovingAI scenario file (.scen), columns separated by tabs or spaces.
/// Throws Error (File) with line and reason.
std::vector<MovingAiProblem> read_moving_ai_problems(const std::string& path);

/// Selects problems of a file.
struct ProblemSelection {
  int first_bucket = 0, last_bucket = std::numeric_limits<int>::max();
  int count = 0;  ///< maximum number, evenly spread over the buckets; 0 for all
};

/// The selected problems in file order, without those whose start equals the goal.
std::vector<MovingAiProblem> select_problems(const std::vector<MovingAiProblem>& problems,
                                             const ProblemSelection& choice);

}  // namespace slalom
