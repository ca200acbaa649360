#pragma once

#include <mrpt/maps/COccupancyGridMap2D.h>

#include <string>

namespace slalom {

/// How plain images become maps: pixels darker than the threshold are obstacles.
struct ImageMapOptions {
  double resolution = 0;  ///< m a pixel; must be given
  int threshold = 128;    ///< grey value, 1 to 255
  bool negate = false;    ///< pixels at or above the threshold are obstacles instead
};

/// How map files become occupancy grids.
struct MapImportOptions {
  double simplemap_resolution = 0.05;  ///< m, of grids built from simplemaps
  bool unknown_is_free = false;  ///< otherwise what was never seen stays unknown, that is occupied
  double cell_size = 0;          ///< m, of maps that do not say it (MovingAI)
  ImageMapOptions image = {};
};

/// Reads a map as an occupancy grid, by the end of its name:
/// - .gridmap, .gridmap.gz: MRPT's COccupancyGridMap2D;
/// - .simplemap, .simplemap.gz: MRPT's poses with laser scans, from which MRPT builds the grid;
/// - .yaml, .yml: ROS map_server, image PGM (P5, P2) or what MRPT can load (PNG);
/// - .map: MovingAI;
/// - .pgm, .png, .jpg, .jpeg, .bmp: an image, its lower left corner at (0, 0).
/// Cells hold the probability of being free; above 0.5 is free, 0.5 is unknown. Throws Error
/// (File): file, what, what was expected; sizes are checked before memory is taken.
mrpt::maps::COccupancyGridMap2D load_map(const std::string& path, const MapImportOptions& options);

/// load_map() with the defaults.
mrpt::maps::COccupancyGridMap2D load_occupancy_grid(const std::string& path);

}  // namespace slalom
