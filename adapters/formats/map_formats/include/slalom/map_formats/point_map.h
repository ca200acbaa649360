// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <mrpt/maps/CSimplePointsMap.h>

#include <cmath>
#include <string>

namespace slalom {

/// How point maps are converted to scenarios.
struct PointMapOptions {
  double margin = 0.5;                         ///< m, from the outermost points to the bounds
  double z_min = -HUGE_VAL, z_max = HUGE_VAL;  ///< m, height range of obstacles, if z is given
};

/// Whether the name ends in .txt, .xyz, .pts or .csv.
bool is_point_map(const std::string& path);

/// Reads obstacle points, one per line: x y, or x y z and more columns, separated by blanks, commas
/// or semicolons, in m. Empty lines and comments (# or %) are skipped; the first line may be the
/// number of points (.pts), or name the columns: x, y and z are read then, wherever they are.
/// Throws Error (File): file, line, what was expected.
mrpt::maps::CSimplePointsMap read_point_map(const std::string& path,
                                            const PointMapOptions& options);
mrpt::maps::CSimplePointsMap parse_point_map(const std::string& text, const std::string& where,
                                             const PointMapOptions& options);

/// A scenario of the points, named after the file, with bounds `margin` around them; start and goal
/// are in the lower left corner until set by with_start_goal().
Scenario point_map_scenario(const std::string& path, const PointMapOptions& options);

}  // namespace slalom
