#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <limits>
#include <string>
#include <vector>

namespace slalom {

/// A MovingAI map (.map, "type octile": Sturtevant, "Benchmarks for Grid-Based Pathfinding", 2012)
/// as an occupancy grid with its lower left corner at (0, 0) and cells of `cell_size` m. '.' and
/// 'G' are free, '@', 'O' and 'T' occupied. Line ends may be LF or CRLF. Maps with swamp ('S') or
/// water ('W') are refused: whether those are free depends on from where one comes. Throws Error:
/// Usage for a cell size that is none, File with line and reason for a file that is not such a map.
mrpt::maps::COccupancyGridMap2D read_moving_ai_map(const std::string& path, double cell_size);

/// One problem of a MovingAI scenario file: cells, (0, 0) the upper left one.
struct MovingAiProblem {
  int bucket = 0;  ///< of difficulty: published length / 4
  int map_width = 0, map_height = 0;
  int start_x = 0, start_y = 0, goal_x = 0, goal_y = 0;
  /// Cells, of the shortest path of a point over 8-connected cell centres: diagonals of sqrt 2,
  /// only where both cells beside them are free.
  double published_length = 0;
  int line = 0;  ///< of the file
};

/// The problems of a MovingAI scenario file (.scen), columns separated by tabs or spaces. Throws
/// Error (File) with line and reason.
std::vector<MovingAiProblem> read_moving_ai_problems(const std::string& path);

/// Which problems of a file.
struct ProblemChoice {
  int first_bucket = 0, last_bucket = std::numeric_limits<int>::max();
  int count = 0;  ///< at most so many, evenly spread over those in the buckets; 0 for all
};

/// The chosen ones in their order, those that end where they begin left out.
std::vector<MovingAiProblem> choose_problems(const std::vector<MovingAiProblem>& problems,
                                             const ProblemChoice& choice);

}  // namespace slalom
