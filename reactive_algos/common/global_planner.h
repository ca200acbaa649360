// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/cost_to_go.h"
#include "common/costmap.h"
#include "common/plugin.h"

#include <vector>

namespace reactive {

/// Paths with the least sum of costs over a costmap, by Dijkstra's algorithm, as ROS's navfn plans
/// them; unseen cells are free.
class GlobalPlanner {
 public:
  /// The cells from `start` to `goal`, then the goal itself; empty if there is no path. Beyond the
  /// map the path is straight.
  std::vector<Point> plan(const Costmap& map, const Point& start, const Point& goal);

 private:
  static constexpr double kReach = 1;  // m around the robot: farther cells are on the path only

  CostToGo cost_to_go_{kReach};
};

/// The costmap of a global planner. It moves with the robot over what was sensed; with a known map
/// it covers that map, with its obstacles and those that were sensed.
class GlobalCostmap {
 public:
  /// half_size: m, without a known map.
  GlobalCostmap(double half_size, double resolution, const Inflation& inflation);

  void set_known(const KnownMap& map);
  void take_over(GlobalCostmap& before);
  void build(const Point& robot, const std::vector<Point>& sensed);
  const Costmap& costs() const { return costs_; }

 private:
  double half_size_, resolution_;
  Costmap costs_;
  bool known_ = false;
  Point center_;               ///< of the known map
  std::vector<Point> points_;  ///< of the known map, then those that were sensed
  std::size_t known_points_ = 0;
};

}  // namespace reactive
