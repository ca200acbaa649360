#pragma once

#include "common/clearance_map.h"
#include "common/cost_to_go.h"
#include "common/plugin.h"
#include "common/rolling_memory.h"

namespace reactive {

/// How a local map is kept.
struct MapOptions {
  double half_size = 8;      ///< m, from the robot to the map's border
  double resolution = 0.05;  ///< m, cells of memory and map
  double band = 0.8;         ///< m: distances are known up to here
};

/// What a robot knows about its surroundings: points remembered from its scans in the odometry
/// frame, and the distances to them.
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

/// The nearest point to make for on the way to a goal.
struct Waypoint {
  Point position;         ///< odometry frame
  bool is_goal = false;   ///< the goal itself, in free sight
  bool reachable = true;  ///< false: no way there is known; the position is the goal all the same
};

/// Ways around what a local map holds.
class Guide {
 public:
  /// Widths that are tried from the widest down, so that a map's small errors close no door.
  explicit Guide(const PathCosts& costs, double least_clearance)
      : costs_(costs), least_clearance_(least_clearance) {}

  /// New ways to `goal` (odometry frame); waypoints lie at most `look_ahead` metres along.
  Waypoint find(const LocalMap& map, const Pose& pose, const Point& goal, double look_ahead);
  const CostToGo& cost_to_go() const { return cost_to_go_; }

 private:
  PathCosts costs_;
  double least_clearance_;
  CostToGo cost_to_go_;
};

}  // namespace reactive
