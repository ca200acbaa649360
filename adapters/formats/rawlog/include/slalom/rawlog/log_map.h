// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/rawlog/log_objects.h>

#include <mrpt/maps/COccupancyGridMap2D.h>
#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <string>
#include <vector>

namespace slalom {

/// How the surroundings of a drive become a grid.
struct LogMapOptions {
  double resolution = 0.05;      ///< m, cell size of a grid that is built from scans
  double robot_radius = 0.25;    ///< m; what the robot covered is free
  bool unknown_is_free = false;  ///< else those stay unknown that are 4 radii from the drive
  BagSelection topics = {};      ///< of a bag
};

/// The surroundings of a drive, and where it began and ended.
struct LogMap {
  mrpt::maps::COccupancyGridMap2D grid;
  mrpt::math::TPose2D start;       ///< m, rad; frame of the grid
  mrpt::math::TPoint2D goal;       ///< m
  std::vector<std::string> notes;  ///< human-readable: of what, and what was assumed
};

/// Whether this file is a bag of ROS or has the name of a rawlog.
bool is_log(const std::string& path);

/// The map that a bag has, an OccupancyGrid, with the robot's poses in its frame by the transforms;
/// of another log, a grid of its scans along the odometry, in the frame of the odometry, which is
/// interpolated at their times. Scans count where the robot has moved by 0.1 m or 0.1 rad.
///
/// Throws Error (File) as load_log(), for a log without scans, odometry or motion, and if the grid
/// had more than 400 million cells.
LogMap load_log_map(const std::string& path, const LogMapOptions& options);

/// The grid of the scans along the odometry, of a log that was read from `path`, also of a bag that
/// has a map. Throws Error (File) as load_log_map(), naming `path`.
LogMap map_of_scans(const LogObjects& log, const std::string& path, const LogMapOptions& options);

}  // namespace slalom
