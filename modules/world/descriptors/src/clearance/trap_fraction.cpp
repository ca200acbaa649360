// SPDX-License-Identifier: BSD-3-Clause
#include "configuration_space.h"

#include <slalom/scenario/contact.h>

#include <algorithm>
#include <cstdint>
#include <cstdlib>
#include <utility>

namespace slalom::descriptors {
namespace {

/// Steepest descent of the distance to the goal from each cell. No step leads away from the goal in
/// either coordinate: in rows and columns outwards from the goal, the next cell's result is known.
class SteepestDescent {
 public:
  /// `free` is above 0 for each cell in F_C; the goal's cell is set free.
  SteepestDescent(const Occupancy& cells, std::vector<std::uint8_t> free, int goal_x, int goal_y)
      : cells_(cells),
        free_(std::move(free)),
        gets_stuck_(free_.size(), 0),
        goal_x_(goal_x),
        goal_y_(goal_y) {
    free_[cells.index(goal_x, goal_y)] = 1;
  }

  /// Fraction of F_C from which the descent gets stuck before the goal.
  double stuck_fraction() {
    const std::vector<int> columns = outwards(goal_x_, cells_.size_x());
    std::size_t all = 0, stuck = 0;
    for (const int y : outwards(goal_y_, cells_.size_y()))
      for (const int x : columns) {
        const std::size_t here = cells_.index(x, y);
        if (free_[here] == 0) continue;
        ++all;
        gets_stuck_[here] = descend(x, y, here);
        stuck += gets_stuck_[here];
      }
    return static_cast<double>(stuck) / static_cast<double>(all);
  }

 private:
  /// The goal and the cells after it, then those before it, downwards.
  static std::vector<int> outwards(int goal, int size) {
    std::vector<int> order;
    for (int i = goal; i < size; ++i) order.push_back(i);
    for (int i = goal - 1; i >= 0; --i) order.push_back(i);
    return order;
  }

  /// Moves to the lowest free neighbor that is lower, and returns 1 if there is none or it gets
  /// stuck from there. Diagonal steps need both adjacent cells free, so one that reduces only one
  /// coordinate is never lower than the step in that coordinate.
  std::uint8_t descend(int x, int y, std::size_t here) const {
    const int right = goal_x_ - x, up = goal_y_ - y;
    const std::ptrdiff_t dx = right > 0 ? 1 : -1, dy = up > 0 ? cells_.size_x() : -cells_.size_x();
    const auto at = static_cast<std::ptrdiff_t>(here);
    const auto free = [&](std::ptrdiff_t i) { return free_[static_cast<std::size_t>(i)] != 0; };
    const bool across = right != 0 && free(at + dx), along = up != 0 && free(at + dy);
    if (!across && !along) return right != 0 || up != 0 ? 1 : 0;
    const bool diagonal = across && along && free(at + dx + dy);
    const bool x_first = across && (!along || std::abs(right) >= std::abs(up));
    const std::ptrdiff_t step = diagonal ? dx + dy : x_first ? dx : dy;
    return gets_stuck_[static_cast<std::size_t>(at + step)];
  }

  const Occupancy& cells_;
  std::vector<std::uint8_t> free_, gets_stuck_;
  int goal_x_, goal_y_;
};

}  // namespace

/// Fraction of F_C from which steepest 8-connected descent of |q - g| gets stuck before g.
Value trap_fraction(const DescriptorContext& context) {
  const mrpt::math::TPoint2D goal = context.world.scenario().goal();
  if (context.world.distance_field().clearance(goal) < context.robot_radius() - kContactTolerance)
    return Value::na("goal is closer to an obstacle than the robot's radius");
  const Occupancy& cells = context.world.occupancy();
  const mrpt::math::TPoint2D at = cells.to_cells(goal);
  SteepestDescent descent(cells, free_headings(context).free,
                          std::min(static_cast<int>(at.x), cells.size_x() - 1),
                          std::min(static_cast<int>(at.y), cells.size_y() - 1));
  return Value::of(descent.stuck_fraction());
}

}  // namespace slalom::descriptors
