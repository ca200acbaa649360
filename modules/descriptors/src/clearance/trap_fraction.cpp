#include "configuration_space.h"

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace slalom::descriptors {
namespace {

/// Steepest descent of the distance to the goal from each cell.
class SteepestDescent {
 public:
  /// `free` is above 0 for each cell in F_C; the goal's cell is set free.
  SteepestDescent(const Occupancy& cells, std::vector<std::uint8_t> free, int goal_x, int goal_y)
      : cells_(cells), free_(std::move(free)), goal_x_(goal_x), goal_y_(goal_y) {
    result_.resize(free_.size(), DescentResult::Unknown);
    free_[cells.index(goal_x, goal_y)] = 1;
    result_[cells.index(goal_x, goal_y)] = DescentResult::ReachesGoal;
  }

  /// Fraction of F_C from which the descent gets stuck before the goal.
  double stuck_fraction() {
    std::size_t all = 0, stuck = 0;
    for (int y = 0; y < cells_.size_y(); ++y)
      for (int x = 0; x < cells_.size_x(); ++x) {
        if (!free(x, y)) continue;
        ++all;
        stuck += follow(x, y) == DescentResult::GetsStuck ? 1 : 0;
      }
    return static_cast<double>(stuck) / static_cast<double>(all);
  }

 private:
  enum class DescentResult : std::uint8_t { Unknown, ReachesGoal, GetsStuck };

  bool free(int x, int y) const { return free_[cells_.index(x, y)] != 0; }

  /// Descends to a cell with a known result and assigns it to all visited cells.
  DescentResult follow(int x, int y) {
    path_.clear();
    std::size_t here = cells_.index(x, y);
    while (result_[here] == DescentResult::Unknown) {
      path_.push_back(here);
      if (!step_down(x, y)) {
        result_[here] = DescentResult::GetsStuck;
        break;
      }
      here = cells_.index(x, y);
    }
    for (const std::size_t visited : path_) result_[visited] = result_[here];
    return result_[here];
  }

  /// Moves to the lowest free neighbor that is lower. Diagonal steps need both adjacent cells free,
  /// so one that reduces only one coordinate is never lower than the step in that coordinate.
  bool step_down(int& x, int& y) const {
    const int right = goal_x_ - x, up = goal_y_ - y;
    const int dx = right > 0 ? 1 : right < 0 ? -1 : 0, dy = up > 0 ? 1 : up < 0 ? -1 : 0;
    const bool across = dx != 0 && free(x + dx, y), along = dy != 0 && free(x, y + dy);
    const bool diagonal = across && along && free(x + dx, y + dy);
    const bool x_first = across && (!along || std::abs(right) >= std::abs(up));
    if (diagonal || x_first) x += dx;
    if (diagonal || (along && !x_first)) y += dy;
    return across || along;
  }

  const Occupancy& cells_;
  std::vector<std::uint8_t> free_;
  std::vector<DescentResult> result_;
  std::vector<std::size_t> path_;
  int goal_x_, goal_y_;
};

}  // namespace

/// Fraction of F_C from which steepest 8-connected descent of |q - g| gets stuck before g.
Value trap_fraction(const DescriptorContext& context) {
  const mrpt::math::TPoint2D goal = context.world.scenario().goal();
  if (context.world.distance_field().clearance(goal) < context.robot_radius() - 1e-9)
    return Value::na("goal is closer to an obstacle than the robot's radius");
  const Occupancy& cells = context.world.occupancy();
  const mrpt::math::TPoint2D at = cells.to_cells(goal);
  SteepestDescent descent(cells, free_headings(context).free,
                          std::min(static_cast<int>(at.x), cells.size_x() - 1),
                          std::min(static_cast<int>(at.y), cells.size_y() - 1));
  return Value::of(descent.stuck_fraction());
}

}  // namespace slalom::descriptors
