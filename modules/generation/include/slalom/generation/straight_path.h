// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/options.h>
#include <slalom/core/random.h>
#include <slalom/generation/start_goal.h>

namespace slalom {

/// The start heading, in families that place the start on or beside an axis.
struct StartAngleOptions {
  double min_angle_deg = 0, max_angle_deg = 30;  ///< to the axis, to either side

  void visit(OptionVisitor& v);
};

/// Common options of families in which the robot meets something at a place on its straight path to
/// the goal.
struct StraightPathOptions {
  double length = 10, height = 8;                         ///< m, along the path and across it
  double min_start_distance = 2, max_start_distance = 3;  ///< m, from the start to the place
  double goal_distance = 2.5;                             ///< m, from the place to the goal
  StartAngleOptions angle;
  StartGoalOptions start_goal = {0.6, 3, 0.8};

  void visit(OptionVisitor& v);
};

}  // namespace slalom
