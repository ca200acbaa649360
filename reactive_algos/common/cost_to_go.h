#pragma once

#include "common/clearance_map.h"

#include <cstdint>
#include <vector>

namespace reactive {

/// Constraints and costs of paths.
struct PathCosts {
  double clearance = 0.25;    ///< m, minimum clearance of the path
  double comfort = 0.5;       ///< m: below this clearance the path cost increases
  double comfort_weight = 2;  ///< relative increase at the minimum clearance
};

/// A navigation function: for each cell of a map the length of the shortest path to the goal,
/// computed by a wavefront from the goal (NF1 of Barraquand, Langlois and Latombe 1992, with
/// Dijkstra's algorithm). Unseen cells count as free. Beyond the map, paths are straight lines.
class CostToGo {
 public:
  /// Expands the wavefront from `goal` until `slack` meters beyond `robot`. If the robot is too
  /// close to an obstacle, the cells around it can be entered at a high cost.
  void compute(const ClearanceMap& map, const Point& goal, const Point& robot,
               const PathCosts& costs, double slack = 2);

  /// Remaining path length, m; kUnreached if not reached.
  double at(const Point& p) const;
  bool reached(const Point& p) const { return at(p) < kUnreached; }
  /// Cells from `from` along the descent to the goal or the border, at most `length` meters.
  std::vector<Point> path(const Point& from, double length) const;

  static constexpr double kUnreached = 1e6;

 private:
  struct Entry {
    std::int32_t cell;
    std::int32_t cost;
  };
  void weigh(const Point& robot, const PathCosts& costs);
  void seed(const Point& goal);
  void seed_border(const Point& goal);
  void spread(const Point& robot, double slack);
  void expand(const Entry& entry);
  void push(std::int32_t cell, std::int32_t cost);
  double cell_cost(int x, int y) const;  ///< m; kUnreached if not reached
  bool nearest_reached(const Point& from, int& x, int& y) const;

  const ClearanceMap* map_ = nullptr;
  std::vector<std::int32_t> cost_;    ///< in hundredths of a cell
  std::vector<std::int32_t> weight_;  ///< cost factor of a cell, in tenths; 0: blocked
  std::vector<std::vector<Entry>> buckets_;
};

/// Whether a disc of `clearance` can move straight from a to b.
bool line_is_free(const ClearanceMap& map, const Point& a, const Point& b, double clearance);

/// The farthest point of a path that is visible from its start `from`.
Point farthest_visible(const ClearanceMap& map, const Point& from, const std::vector<Point>& path,
                       double clearance);

}  // namespace reactive
