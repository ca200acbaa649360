// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/cost_to_go.h"
#include "common/robot.h"
#include "dwa_local_planner/footprint.h"
#include "dwa_local_planner/parameters.h"

#include <vector>

namespace dwa_local_planner {

/// `count` (2 or more) values from `low` to `high`, equally spaced, and 0 if it lies between them.
std::vector<double> evenly_spaced(double low, double high, int count);

/// The velocities that can be reached from `measured` within `period` s and the limits of the
/// parameters, of which none may be 0.
std::vector<reactive::Twist> velocity_samples(const Parameters& parameters,
                                              const reactive::Twist& measured, double period);

/// Costs of trajectories: those of the path and of the goal are distances over the cells of the
/// costmap, at the end of the trajectory and at a point ahead of it.
class TrajectoryScorer {
 public:
  TrajectoryScorer(const Parameters& parameters, const reactive::Robot& robot);

  /// path: from the robot to the local goal; not empty. `map` is used until the next call.
  void prepare(const reactive::Costmap& map, const reactive::Pose& pose,
               const std::vector<reactive::Point>& path);

  /// The cost of keeping these velocities, < 0 if that is not possible or more than `limit`.
  double cost(const reactive::Twist& twist, double limit);

  const Footprint& footprint() const { return footprint_; }

 private:
  double obstacle_cost(const reactive::Twist& twist, double limit, reactive::Pose& end) const;

  Parameters parameters_;
  Footprint footprint_;
  reactive::CostToGo path_, goal_, goal_front_;
  const reactive::Costmap* map_ = nullptr;
  reactive::Pose pose_;
  bool aligns_ = true;
};

}  // namespace dwa_local_planner
