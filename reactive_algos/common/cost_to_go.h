// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/clearance_map.h"
#include "common/costmap.h"
#include "common/wavefront.h"

#include <cstddef>
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
  /// Values are read at most `reach` (m) from the robot. There they equal those of a wavefront in
  /// all directions: cells are expanded in the order of their cost plus a lower bound of that of
  /// the path from them to there (A*; Hart, Nilsson and Raphael 1968).
  explicit CostToGo(double reach = HUGE_VAL) : reach_(reach) {}

  /// Expands the wavefront from `goal` to `robot`; at() expands it on demand until `slack` meters
  /// beyond. If the robot is too close to an obstacle, the cells around it can be entered at a high
  /// cost. `map` is used until the next call.
  void compute(const ClearanceMap& map, const Point& goal, const Point& robot,
               const PathCosts& costs, double slack = 2);
  /// The same to the closest one of several goals; those outside the map do not count.
  void compute(const ClearanceMap& map, const std::vector<Point>& goals, const Point& robot,
               const PathCosts& costs, double slack = 2);
  /// The same over the costs of a costmap, weighted as in navfn: 50 + 0.8 cost per cell, infinite
  /// from the inscribed radius.
  void compute(const Costmap& map, const Point& goal, const Point& robot);

  /// Remaining path length, m; kUnreached if not reached.
  double at(const Point& p);
  bool reached(const Point& p) { return at(p) < kUnreached; }
  /// Cells from `from` along the descent to the goal or the border, at most `length` meters.
  /// Requires a reach of at least kPathReach * length.
  std::vector<Point> path(const Point& from, double length) const;

  static constexpr double kUnreached = 1e6;
  /// A step of a path is at most 1.4 cells long and reduces the cost by that of one cell or more.
  static constexpr double kPathReach = 0.4;

 private:
  static constexpr std::size_t kNoCell = static_cast<std::size_t>(-1);

  void begin(const ClearanceMap& map);
  void weigh(const PathCosts& costs);
  void spread(double slack);
  void open_around(const Point& robot);
  void bound_ahead(const Point& robot);
  void seed(const Point& goal);
  bool seed_inside(const Point& goal);
  void seed_border(const Point& goal);
  double cell_cost(int x, int y) const;  ///< m; kUnreached if not reached
  void settle(int x, int y);
  bool nearest_reached(const Point& from, int& x, int& y) const;

  double reach_;
  const ClearanceMap* map_ = nullptr;
  Wavefront front_;               ///< costs in hundredths of a cell, weights in tenths
  std::size_t end_ = 0;           ///< the first bucket beyond the slack
  double resolution_ = 0;         ///< m, of the wavefront's cells
  std::size_t target_ = kNoCell;  ///< the robot's cell
  std::size_t center_ = kNoCell;  ///< the cell for which `front_.ahead` was computed
};

/// Whether a disc of `clearance` can move straight from a to b.
bool line_is_free(const ClearanceMap& map, const Point& a, const Point& b, double clearance);

/// The farthest point of a path that is visible from its start `from`.
Point farthest_visible(const ClearanceMap& map, const Point& from, const std::vector<Point>& path,
                       double clearance);

}  // namespace reactive
