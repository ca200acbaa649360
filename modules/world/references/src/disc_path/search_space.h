// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "disc_arcs.h"
#include "open_rows.h"

namespace slalom::disc_path {

/// A problem in cells, with the tables of the search.
struct SearchSpace {
  SearchSpace(const Occupancy& cells, double radius_, const Vector& start_, const Vector& goal_)
      : radius(radius_),
        checked_radius(radius_ - kClearanceTolerance),
        start(start_),
        goal(goal_),
        occupied(cells),
        open(occupied, checked_radius),
        arcs(occupied, radius) {}

  bool is_sweep_free(const Vector& p, const Vector& q) const {
    return disc_path::is_sweep_free(occupied, p, q, checked_radius);
  }

  double radius;          ///< of the arcs
  double checked_radius;  ///< of the disc whose motions are checked
  Vector start, goal;
  OccupiedRows occupied;
  OpenRows open;
  ArcRows arcs;
};

}  // namespace slalom::disc_path
