// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/robot/footprint.h>
#include <slalom/scenario/world.h>

#include <mrpt/math/TPose2D.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// A path of a polygon that turns in place and drives straight ahead.
struct FootprintPath {
  /// From the start; from one to the next the robot turns, or drives in its direction.
  std::vector<mrpt::math::TPose2D> poses;
  double length = 0;  ///< m, of the way of the center
};

/// Searches for a path on which a robot that turns in place and drives forward keeps `margin` (m)
/// from all obstacles, checked as the motion of a run is. It ends at most a sixth of the robot's
/// half width from the goal, with any heading. nullopt with `reason` if none was found: that is no
/// proof that there is none, unless a disc in the robot has no path.
///
/// Method: shortest paths of discs of half the width and more, driven along; where the robot does
/// not pass on them, weighted A* on a lattice of positions around the start and 32 directions from
/// one of them to others, guided by distances among cells that are wide enough for half the width.
std::optional<FootprintPath> find_footprint_path(const World& world, const Footprint& footprint,
                                                 const mrpt::math::TPose2D& start,
                                                 const mrpt::math::TPoint2D& goal, double margin,
                                                 std::string& reason);

}  // namespace slalom
