// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/references/reference.h>
#include <slalom/robot/footprint.h>

#include <mrpt/math/TPose2D.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// How a polygon moves: it turns in place and drives straight ahead, or also back, or moves in any
/// direction.
enum class PolygonMotion { Forward, Reversing, Holonomic };

/// A path of a polygon.
struct FootprintPath {
  /// From the start; from one to the next the robot turns, or moves with the same heading, or both
  /// at once if it moves in any direction.
  std::vector<mrpt::math::TPose2D> poses;
  double length = 0;                              ///< m, of the way of the center
  PolygonMotion motion = PolygonMotion::Forward;  ///< the first of its order that leads there
};

/// How far find_footprint_path() searches: among 30,000 poses where a draw that it does not solve
/// is replaced by another, or several times among as many and with finer boxes.
enum class SearchEffort { Quick, Thorough };

/// Searches for a path on which a robot that moves so keeps more than `margin` (m) from all
/// obstacles, checked as the motion of a run is; with other motions than Forward only if it
/// searches thoroughly by boxes, and only where none of the former leads there. What is found for
/// one that moves in any direction, one that reverses and turns in place can follow as closely as
/// it likes: around each pose is room, in which it moves aside by small maneuvers (Laumond 1986).
/// It ends at the goal with any heading, or where that is not found at most a sixth of the robot's
/// half width from it. nullopt with `reason` if none was found: that is a proof that there is none
/// if a disc in the robot has no path, or the robot is_obstructed().
///
/// Method: shortest paths of discs of half the width and more, driven along; where the robot does
/// not pass on them, weighted A* on a lattice of positions around the start and 32 directions from
/// one of them to others, guided by distances among cells that are wide enough for its sides, or
/// thoroughly by the boxes of is_obstructed() between a pose and the goal, if it has these. In any
/// direction among the corners of a quarter of a cell and 2 pi / 256, or of a cell and 2 pi / 32
/// where the robot may turn as it likes, guided by the smaller boxes.
std::optional<FootprintPath> find_footprint_path(const World& world, const Footprint& footprint,
                                                 const mrpt::math::TPose2D& start,
                                                 const mrpt::math::TPoint2D& goal, double margin,
                                                 std::string& reason,
                                                 SearchEffort effort = SearchEffort::Quick,
                                                 PolygonMotion motion = PolygonMotion::Forward);

/// The reason that is_obstructed() is.
constexpr char kObstructed[] = "no motion of the robot's shape leads from start to goal";

/// Whether it is proved that no motion of a polygon, of whatever drive, leads from `start` to a
/// position within `reach` (m) of `goal`: false says nothing.
///
/// Method: poses are divided into boxes, of a cell's side / `divisions` (1, 2 or 4) and of
/// 2 pi / (64 `divisions`), smaller ones only where some of the larger are closed and others not. A
/// box is closed if one square of occupied cells meets the polygon at all of its poses, which
/// separating axes decide for convex parts of the polygon that they all cover. No motion enters a
/// closed box, so that none leads where no sequence of neighbors among the others does. Scenarios
/// that would have more than 16 million boxes of 64 directions are not divided so.
bool is_obstructed(const World& world, const Footprint& footprint, const mrpt::math::TPose2D& start,
                   const mrpt::math::TPoint2D& goal, double reach, int divisions);

/// If is_obstructed() a polygon for which no planner found a path, replaces the paths of its disc
/// by that reason.
void refuse_obstructed(const PlanningProblem& problem, const Footprint& footprint, double reach,
                       References& references);

}  // namespace slalom
