#pragma once

#include "common/clearance_map.h"

#include <cstdint>
#include <vector>

namespace reactive {

/// Where a path may run and what it costs.
struct PathCosts {
  double clearance = 0.25;    ///< m, of the path's points from obstacles, at least
  double comfort = 0.5;       ///< m: below this clearance a way counts as longer
  double comfort_weight = 2;  ///< how many times longer, at the least clearance
};

/// A navigation function: for each cell of a map the length of the shortest way to the goal, found
/// by a wave from the goal (NF1 of Barraquand, Langlois and Latombe 1992, with Dijkstra's order and
/// lengths). What was not seen counts as free. Beyond the map ways are straight.
class CostToGo {
 public:
  /// Wave from `goal` until it has passed `robot` by `slack` metres. When the robot itself stands
  /// too near to something, cells about it are entered at a high price.
  void compute(const ClearanceMap& map, const Point& goal, const Point& robot,
               const PathCosts& costs, double slack = 2);

  /// m; kUnreached where the wave did not come.
  double at(const Point& p) const;
  bool reached(const Point& p) const { return at(p) < kUnreached; }
  /// Cells from `from` down to the goal or the border, at most `length` metres.
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
  double cell_cost(int x, int y) const;  ///< m; kUnreached where the wave did not come
  bool nearest_reached(const Point& from, int& x, int& y) const;

  const ClearanceMap* map_ = nullptr;
  std::vector<std::int32_t> cost_;    ///< in hundredths of a cell
  std::vector<std::int32_t> weight_;  ///< of entering a cell, in tenths; 0: never
  std::vector<std::vector<Entry>> buckets_;
};

/// Whether a disc of `clearance` can move straight from a to b.
bool line_is_free(const ClearanceMap& map, const Point& a, const Point& b, double clearance);

/// The farthest point of a path, from its beginning at `from`, to which the line is free.
Point farthest_visible(const ClearanceMap& map, const Point& from, const std::vector<Point>& path,
                       double clearance);

}  // namespace reactive
