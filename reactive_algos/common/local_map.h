// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/clearance_map.h"
#include "common/cost_to_go.h"
#include "common/plugin.h"
#include "common/rolling_memory.h"

#include <utility>
#include <vector>

namespace reactive {

/// Options of a local map.
struct MapOptions {
  double half_size = 8;      ///< m, from the robot to the map's border
  double band = 0.8;         ///< m: maximum distance that is computed
  double resolution = 0.05;  ///< m, cells of memory and map
};

constexpr double kCheckMargin = 0.01;  ///< m beyond the robot's radius, of checks and paths

/// A band of a map of this resolution for costs of the clearance up to `comfort` and checks up to
/// `margin` beyond the robot's radius. Cells beyond the band do not change interpolated values
/// below either of these, for the centers of interpolated cells are less than 1.5 cells apart.
inline double clearance_band(const Robot& robot, double margin, double comfort,
                             double resolution = MapOptions().resolution) {
  return robot.radius + std::max(margin + kCheckMargin, comfort) + 1.5 * resolution;
}

/// Local obstacle map: points of past scans in the odometry frame, and the distances to them in a
/// square that has all of them and the goal, as far as it may.
class LocalMap {
 public:
  LocalMap(const MapOptions& options, const Robot& robot);

  void clear() { memory_.clear(); }
  void take_over(LocalMap& before) { memory_ = std::move(before.memory_); }
  void update(const Observation& observation);
  const ClearanceMap& clearance() const { return clearance_; }
  const std::vector<Point>& points() const { return memory_.points(); }  ///< odometry frame

 private:
  Robot robot_;
  double band_;
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
  /// not close narrow passages. Costs to go are read within `reach` m of the robot.
  LocalPlanner(const PathCosts& costs, double min_clearance, double reach)
      : costs_(costs), min_clearance_(min_clearance), cost_to_go_(reach) {}
  /// The same for a robot whose checks have this margin (m), and whose paths cost more where its
  /// clearance is below `comfort` m.
  LocalPlanner(const Robot& robot, double margin, double comfort, double reach)
      : LocalPlanner({robot.radius + margin + kCheckMargin, robot.radius + comfort},
                     robot.radius + kCheckMargin, reach) {}

  /// Plans a path to `goal` (odometry frame); the waypoint is at most `look_ahead` meters along it,
  /// for which the reach is at least CostToGo::kPathReach * look_ahead.
  Waypoint find(const LocalMap& map, const Pose& pose, const Point& goal, double look_ahead);
  CostToGo& cost_to_go() { return cost_to_go_; }

 private:
  PathCosts costs_;
  double min_clearance_;
  CostToGo cost_to_go_;
};

}  // namespace reactive
