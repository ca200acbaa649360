// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>
#include <slalom/scenario/distance_field.h>
#include <slalom/scenario/geometry.h>

#include <functional>

namespace slalom {

/// Options of all generators on the positions of start and goal.
struct StartGoalOptions {
  double clear_radius = 0.6;  ///< m, clearance around start and goal
  double min_distance = 8;    ///< m, straight-line distance from start to goal
  double margin = 0.7;        ///< m, from start and goal to the workspace border

  void visit(OptionVisitor& v);
};

/// Start and goal of a scenario.
struct StartGoal {
  mrpt::math::TPoint2D start, goal;
};

/// Samples a position uniformly from the bounds less `margin` (m) on each side.
mrpt::math::TPoint2D sample_position(RandomEngine& engine, const Bounds& bounds, double margin = 0);

/// Whether a position is valid as start or goal.
using PositionFilter = std::function<bool(const mrpt::math::TPoint2D& position)>;

/// Samples a start and a goal uniformly from the positions within the margin that `is_valid`
/// accepts (all if empty), at least min_distance apart. Returns opposite corners if no such pair is
/// found in a bounded number of draws.
StartGoal sample_start_goal(RandomEngine& engine, const Bounds& bounds,
                            const StartGoalOptions& options, const PositionFilter& is_valid = {});

/// The same with the start in one rectangle and the goal in another; the margin applies to both.
StartGoal sample_start_goal(RandomEngine& engine, const Bounds& starts, const Bounds& goals,
                            const StartGoalOptions& options, const PositionFilter& is_valid = {});

/// Accepts positions at least `radius` (m) from the obstacles, which must outlive the filter.
PositionFilter clearance_filter(const Primitives& obstacles, double radius);
PositionFilter clearance_filter(const DistanceField& field, double radius);

/// The start pose with a random heading within 45 degrees of the goal's bearing, in (-pi, pi].
mrpt::math::TPose2D start_pose(RandomEngine& engine, const StartGoal& start_goal);

/// Wraps `angle` (rad, in (-3 pi, 3 pi)) to (-pi, pi]; angles already in range are returned
/// unchanged.
double wrap_angle(double angle);

}  // namespace slalom
