// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "unsafe_departures.h"

#include <functional>

namespace slalom::arrival {

/// Points connected by straight motions that are free of static obstacles. Node 0 is the start.
struct Roadmap {
  std::function<mrpt::math::TPoint2D(int)> position;
  /// The neighbors of a node, which may be found when they are first asked for.
  std::function<std::vector<int>(int)> neighbors;
  std::function<bool(int)> is_goal;
  /// A lower bound (m) of the distance from a node to the goal that no edge shortens by more than
  /// its length.
  std::function<double(int)> rest;
};

/// A stay at a node: from the arrival there until the departure to the next.
struct Stay {
  int node = 0;
  double arrival = 0, departure = 0;  ///< s
};

/// Earliest arrival at a goal of a disc that leaves the start at time 0, moves along the edges of
/// the roadmap at `speed` (m/s) and waits at nodes. Empty if it cannot arrive until `horizon` (s).
/// Safe-interval path planning (Phillips and Likhachev 2011), with exact intervals: a state is a
/// node with one of its maximal safe intervals, and of each only the earliest arrival matters.
std::vector<Stay> search_safe_intervals(const Roadmap& roadmap, const Traffic& traffic,
                                        double speed, double horizon);

}  // namespace slalom::arrival
