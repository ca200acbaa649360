#pragma once

#include <slalom/scenario/scenario.h>

#include <mrpt/maps/CSimplePointsMap.h>

#include <cmath>
#include <string>

namespace slalom {

/// How point maps become scenarios.
struct PointMapOptions {
  double margin = 0.5;                         ///< m, from the outermost points to the bounds
  double z_min = -HUGE_VAL, z_max = HUGE_VAL;  ///< m, heights that are obstacles, where known
};

/// Whether the name ends in .txt, .xyz, .pts or .csv.
bool is_point_map(const std::string& path);

/// Obstacle points, one a line: x y, or x y z and more columns, parted by blanks, commas or
/// semicolons, in m. Empty lines and what follows # or % are left out; a .pts may begin with the
/// number of its points. Throws Error (File): file, line, what was expected.
mrpt::maps::CSimplePointsMap read_point_map(const std::string& path,
                                            const PointMapOptions& options);
mrpt::maps::CSimplePointsMap parse_point_map(const std::string& text, const std::string& where,
                                             const PointMapOptions& options);

/// The points as a place, named after the file, its bounds `margin` around them; start and goal in
/// its lower left corner until with_task() is told better.
Scenario point_map_scenario(const std::string& path, const PointMapOptions& options);

}  // namespace slalom
