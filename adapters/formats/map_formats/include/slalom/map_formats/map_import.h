// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>
#include <vector>

namespace slalom {

/// How plain images are converted to maps: pixels darker than the threshold are obstacles.
struct ImageMapOptions {
  double resolution = 0;  ///< m per pixel; required
  int threshold = 128;    ///< gray value, 1 to 255
  bool negate = false;    ///< pixels at or above the threshold are obstacles instead
};

/// How map files are converted to occupancy grids.
struct MapImportOptions {
  double simplemap_resolution = 0.05;  ///< m, of grids built from simplemaps
  bool unknown_is_free = false;        ///< otherwise unknown cells count as occupied
  double cell_size = 0;                ///< m, for maps without cell size (MovingAI)
  ImageMapOptions image = {};
  /// Gets lines about what was assumed or looks wrong; may be null.
  std::vector<std::string>* notes = nullptr;
};

/// Reads a map as an occupancy grid, by file extension:
/// - .gridmap, .gridmap.gz: MRPT's COccupancyGridMap2D;
/// - .simplemap, .simplemap.gz: poses with laser scans, from which MRPT builds the grid;
/// - .yaml, .yml: ROS map_server, with an image as PGM (P5, P2) or a format that MRPT loads (PNG);
/// - .map: MovingAI;
/// - .pgm, .png, .jpg, .jpeg, .bmp: an image with the lower left corner at (0, 0).
/// Cells hold the probability of being free; above 0.5 is free, 0.5 is unknown. Throws Error
/// (File): file, problem, what was expected. Sizes are checked before memory is allocated.
mrpt::maps::COccupancyGridMap2D load_map(const std::string& path, const MapImportOptions& options);

/// load_map() with default options.
mrpt::maps::COccupancyGridMap2D load_occupancy_grid(const std::string& path);

}  // namespace slalom
