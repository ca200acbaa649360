// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/map_formats/map_task.h>

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A start and a goal on a map (m, rad), and the line of the file that has them.
struct MapPair {
  std::size_t line = 0;
  mrpt::math::TPose2D start;
  mrpt::math::TPoint2D goal;
  std::optional<double> goal_heading = {};  ///< rad
};

/// Reads a file of pairs: numbers separated by commas, semicolons, blanks or tabs, a pair per line.
/// 5 or 6 numbers are x, y, phi of the start and x, y and maybe phi of the goal, 2 or 3 numbers the
/// goal alone, which needs `start`. Empty lines and those that begin with '#' are ignored, and so
/// is a first line without numbers, which names the columns. Throws Error (File) with the line and
/// what was expected, also for a file without pairs or with more than a million.
std::vector<MapPair> read_map_pairs(const std::string& path,
                                    const std::optional<mrpt::math::TPose2D>& start);
std::vector<MapPair> parse_map_pairs(const std::string& text, const std::string& where,
                                     const std::optional<mrpt::math::TPose2D>& start);

}  // namespace slalom
