// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/math/TPose2D.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom::ros {

/// A laser of a robot; what the file does not say has no value.
struct UrdfLaser {
  std::string name;          ///< of its link, with _ for what is no letter or digit
  mrpt::math::TPose2D pose;  ///< in the frame of the robot
  bool upside_down = false;
  std::optional<double> aperture, max_range, rays;  ///< rad, m, as in the file
};

/// A robot in the Unified Robot Description Format (wiki.ros.org/urdf/XML), with all joints at
/// zero. Its frame is that of the link `base_link`, or of the root.
struct UrdfRobot {
  std::string name;
  /// m, to 0.1 mm: the convex hull of the collision shapes, seen from above; circles of cylinders
  /// and spheres are polygons around them. Empty for a disc and without shapes.
  std::vector<mrpt::math::TPoint2D> footprint;
  std::optional<double> radius;     ///< m: all shapes are within an upright one around the center
  std::vector<std::string> meshes;  ///< "FILE:LINE: link" of the collision shapes that are meshes
  /// m/s and rad/s, of two driven wheels on one axis whose joints have a limit of their velocity.
  std::optional<double> max_v, max_w;
  std::vector<UrdfLaser> lasers;

  /// Throws Error (File) for what is not a URDF, with the line, and for XML that is to be expanded
  /// (xacro).
  static UrdfRobot read(const std::string& path);
};

}  // namespace slalom::ros
