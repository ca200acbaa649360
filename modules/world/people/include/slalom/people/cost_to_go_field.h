// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/people/people_settings.h>
#include <slalom/scenario/world.h>

#include <cstdint>
#include <optional>
#include <vector>

namespace slalom {

/// Ways to a point for discs of a radius: the shortest ones over cells with room for them (steps to
/// 8 neighbors). Ties are broken by the direction of the goal, then by `side`, so that a scenario
/// that is turned by 90 degrees has the same ways, and a mirrored one those of the other side.
class CostToGoField {
 public:
  /// `world` has to exist as long as the field.
  CostToGoField(const World& world, const mrpt::math::TPoint2D& goal, double radius,
                PeopleSide side);

  const mrpt::math::TPoint2D& goal() const { return goal_; }
  /// The farthest point of the way from p to the goal to which a person can walk straight. It is
  /// the goal where there is no way. A `previous` target to which the person still can walk
  /// straight is kept, and moved on along its way: this takes a quarter of the time.
  mrpt::math::TPoint2D target(const mrpt::math::TPoint2D& p,
                              const std::optional<mrpt::math::TPoint2D>& previous = {}) const;
  /// m, of the way from p straight to a target of it, and on to the goal.
  double length(const mrpt::math::TPoint2D& p, const mrpt::math::TPoint2D& target) const;

 private:
  struct Cell {
    int x = 0, y = 0;
  };
  std::vector<std::int64_t> costs() const;
  void choose_steps(const std::vector<std::int64_t>& costs);
  Cell cell_at(const mrpt::math::TPoint2D& p, double shift) const;
  bool has_room(const Cell& cell) const;
  bool can_walk(const mrpt::math::TPoint2D& from, const mrpt::math::TPoint2D& to) const;
  /// The cell with a way that is nearest to p, up to `reach` cells away.
  std::optional<Cell> nearest_with_way(const mrpt::math::TPoint2D& p, int reach) const;
  Cell next(const Cell& cell) const;
  mrpt::math::TPoint2D farthest_from(const mrpt::math::TPoint2D& p, const Cell& nearest) const;
  mrpt::math::TPoint2D further(const mrpt::math::TPoint2D& p, mrpt::math::TPoint2D target) const;
  std::uint8_t step(const Cell& cell) const { return steps_[occupancy_.index(cell.x, cell.y)]; }

  const Occupancy& occupancy_;
  const DistanceField& field_;
  const RayCaster& caster_;
  mrpt::math::TPoint2D goal_;
  double radius_;
  int side_;  ///< sign of a turn to it, counter-clockwise
  /// The cells that contain the goal, several if it lies on a border: the first and last one.
  Cell goal_first_, goal_last_;
  std::vector<std::uint8_t> steps_;  ///< per cell, index of the next direction
};

}  // namespace slalom
