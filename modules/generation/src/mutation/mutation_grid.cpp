// SPDX-License-Identifier: BSD-3-Clause
#include "scene_mutation.h"

#include <slalom/core/math.h>
#include <slalom/scenario/grid_map.h>
#include <slalom/scenario/occupancy.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Changes the cells of a grid.
class GridMutator {
 public:
  GridMutator(const Scenario& parent, const MutationLimits& limits, RandomEngine& engine)
      : parent_(parent), limits_(limits), engine_(engine), cells_(make_occupancy(parent, 0)) {}

  bool apply(Mutation mutation) {
    switch (mutation) {
      case Mutation::Add:
        return stamp(true);
      case Mutation::Remove:
        return stamp(false);
      case Mutation::ResizeAll:
        return dilate(uniform_int(engine_, 0, 1) == 1);
      case Mutation::Carve:
        return along_path(false);
      case Mutation::Fill:
        return along_path(true);
      default:
        return false;
    }
  }

  void clear_start_goal() {
    const double clearance_margin = limits_.robot_radius + 2 * cells_.resolution();
    set_disc({parent_.start().x, parent_.start().y}, clearance_margin, false);
    set_disc(parent_.goal(), clearance_margin, false);
  }

  Scenario scenario() const {
    mrpt::maps::COccupancyGridMap2D map = one_cell_map();
    map.copyMapContentFrom(*parent_.grid_map());
    for (int cy = 0; cy < cells_.size_y(); ++cy)
      for (int cx = 0; cx < cells_.size_x(); ++cx)
        map.setCell(cx, cy, cells_.occupied(cx, cy) ? 0.0f : 1.0f);
    return Scenario::grid(parent_.name(), map, parent_.start(), parent_.goal())
        .with_rest_of(parent_);
  }

 private:
  double side() const { return std::min(parent_.bounds().width(), parent_.bounds().height()); }

  void set_disc(const TPoint2D& center, double radius, bool occupied) {
    const TPoint2D at = cells_.to_cells(center);
    const double reach = radius / cells_.resolution();
    for (int cy = static_cast<int>(at.y - reach); cy <= static_cast<int>(at.y + reach); ++cy)
      for (int cx = static_cast<int>(at.x - reach); cx <= static_cast<int>(at.x + reach); ++cx)
        if (cells_.inside(cx, cy) && math::hypot(cx + 0.5 - at.x, cy + 0.5 - at.y) <= reach)
          cells_.set_occupied(cx, cy, occupied);
  }

  bool stamp(bool occupied) {
    const Bounds& b = parent_.bounds();
    const double largest = sample_log_uniform(engine_, 2 * cells_.resolution(), side() / 4);
    for (int i = 1 << uniform_int(engine_, 0, 5); i > 0; --i) {
      const double x = uniform_real(engine_, b.x_min, b.x_max);
      const double y = uniform_real(engine_, b.y_min, b.y_max);
      set_disc({x, y}, uniform_real(engine_, largest / 3, largest), occupied);
    }
    return true;
  }

  /// Dilates or erodes the occupied cells by one cell.
  bool dilate(bool grows) {
    const Occupancy before = cells_;
    for (int cy = 0; cy < cells_.size_y(); ++cy)
      for (int cx = 0; cx < cells_.size_x(); ++cx)
        for (const auto& [dx, dy] : {std::pair{1, 0}, {-1, 0}, {0, 1}, {0, -1}})
          if (before.inside(cx + dx, cy + dy) && before.occupied(cx + dx, cy + dy) == grows)
            cells_.set_occupied(cx, cy, grows);
    return true;
  }

  /// Frees the cells near a path, or occupies a fraction of the blocks away from it.
  bool along_path(bool fills) {
    const auto path = sample_path(parent_.bounds(), parent_.start(), parent_.goal(), engine_);
    const double clearance_margin = limits_.robot_radius + 2 * cells_.resolution();
    const double half =
        sample_log_uniform(engine_, clearance_margin, std::max(clearance_margin, side() / 4));
    const double fraction = uniform_real(engine_, 0.1, 1.1);
    const int block = uniform_int(engine_, 1, 16);
    for (int by = 0; by < cells_.size_y(); by += block)
      for (int bx = 0; bx < cells_.size_x(); bx += block) {
        const bool drawn = uniform_real(engine_, 0, 1) < fraction;
        if (!fills || drawn) change_block(bx, by, block, path, half, fills);
      }
    return true;
  }

  void change_block(int bx, int by, int block, const std::vector<TPoint2D>& path, double half,
                    bool fills) {
    for (int cy = by; cy < std::min(by + block, cells_.size_y()); ++cy)
      for (int cx = bx; cx < std::min(bx + block, cells_.size_x()); ++cx)
        if ((distance(cells_.cell_center(cx, cy), path) >= half) == fills)
          cells_.set_occupied(cx, cy, fills);
  }

  const Scenario& parent_;
  const MutationLimits& limits_;
  RandomEngine& engine_;
  Occupancy cells_;
};

}  // namespace

std::optional<Scenario> mutate_grid(const Scenario& parent, Mutation mutation,
                                    const MutationLimits& limits, RandomEngine& engine) {
  GridMutator mutator(parent, limits, engine);
  if (!mutator.apply(mutation)) return std::nullopt;
  mutator.clear_start_goal();
  return mutator.scenario();
}

}  // namespace slalom
