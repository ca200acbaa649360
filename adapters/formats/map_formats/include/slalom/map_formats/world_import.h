// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// How worlds of simulators are converted to scenarios.
struct WorldOptions {
  double margin = 0.5;  ///< m, from the outermost obstacles to the bounds
  /// m, the heights in which the robot meets obstacles: what ends below or begins above is left
  /// out.
  double z_min = 0.05, z_max = 2;
};

/// A world of a simulator as a scenario named after its file.
struct ImportedWorld {
  Scenario scenario;  ///< start and goal are in the lower left corner unless the world states both
  /// The task, as far as the world states it.
  std::optional<mrpt::math::TPose2D> start = {};
  std::optional<mrpt::math::TPoint2D> goal = {};
  std::string message = {};  ///< what is left out, in one line, "" if nothing
};

/// Whether the name ends in .world, .sdf or .xml, or this is a YAML file with the key `world`.
bool is_world(const std::string& path);

/// Reads a world of Gazebo (.world, .sdf), of Stage (.world), of mvsim (.xml) or of ir-sim (.yaml).
///
/// Gazebo: Collision shapes become obstacles, exactly if they are upright: boxes and polylines
/// polygons, cylinders and spheres discs; of others the convex hull of their part in the heights of
/// the options, of cylinders around a polygon of 32 corners. Actors with waypoints become moving
/// obstacles. Meshes, heightmaps, models with plugins, which may move them, and models whose files
/// are not beside the world are left out.
///
/// mvsim: walls, vertical planes and blocks become polygons; with an occupancy grid, its cells that
/// they touch. The first vehicle is the start. A file that Slalom exported gives the same grid.
///
/// Stage: the first bitmap becomes a grid, models without one polygons, the first robot the start.
///
/// ir-sim: circles become discs, rectangles, polygons and line strings (0.02 m wide) polygons;
/// start and goal are those of the first robot, the workspace is the world. Throws Error (File):
/// file, line, what was expected.
ImportedWorld import_world(const std::string& path, const WorldOptions& options);

}  // namespace slalom
