#pragma once

#include "common/clearance_map.h"
#include "common/cost_to_go.h"
#include "common/plugin.h"
#include "common/rolling_memory.h"

namespace reactive {

/// Options of a local map.
struct MapOptions {
  double half_size = 8;      ///< m, from the robot to the map's border
  double resolution = 0.05;  ///< m, cells of memory and map
  double band = 0.8;         ///< m: maximum distance that is computed
};

/// Local obstacle map: points of past scans in the odometry frame, and the distances to them.
class LocalMap {
 public:
  LocalMap(const MapOptions& options, const Robot& robot);

  void clear() { memory_.clear(); }
  void update(const Observation& observation);
  const ClearanceMap& clearance() const { return clearance_; }

 private:
  Robot robot_;
  RollingMemory memory_;
  ClearanceMap clearance_;
};

/// Intermediate target on the path to a goal.
struct Waypoint {
  Point position;         ///< odometry frame
  bool is_goal = false;   ///< the goal itself, visible
  bool reachable = true;  ///< false: no path is known; the position is the goal
};

/// Plans paths on a local map.
class LocalPlanner {
 public:
  /// Clearances from costs.clearance down to `min_clearance` are tried, so that small map errors do
  /// not close narrow passages.
  explicit LocalPlanner(const PathCosts& costs, double min_clearance)
      : costs_(costs), min_clearance_(min_clearance) {}

  /// Plans a path to `goal` (odometry frame); the waypoint is at most `look_ahead` meters along it.
  Waypoint find(const LocalMap& map, const Pose& pose, const Point& goal, double look_ahead);
  const CostToGo& cost_to_go() const { return cost_to_go_; }

 private:
  PathCosts costs_;
  double min_clearance_;
  CostToGo cost_to_go_;
};

}  // namespace reactive
