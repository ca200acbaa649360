// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "../disc_path/occupied_rows.h"

#include <slalom/trajectory/path.h>

#include <map>
#include <vector>

namespace slalom::arrival {

/// A disc: the positions within `tolerance` (m) of the goal.
struct GoalRegion {
  mrpt::math::TPoint2D goal;
  double tolerance = 0;

  bool contains(const mrpt::math::TPoint2D& p) const;
  /// Distance (m) of p from the region.
  double distance(const mrpt::math::TPoint2D& p) const;
  /// The part of a path that ends in the region up to where it first enters it.
  Path cut(const Path& path) const;
};

/// The roadmap of a disc among static obstacles: the points of its shortest path and of a square
/// lattice through the start, each connected to those nearby and to the goal region where the
/// straight motion is free. Its nodes are made when they are first asked for.
class Lattice {
 public:
  /// `path`, which is free, leads from the start into the region; its points become nodes, too, and
  /// are at most `spacing` (m) apart.
  Lattice(const Occupancy& cells, double robot_radius, const Path& path, const GoalRegion& region,
          double spacing);

  const mrpt::math::TPoint2D& position(int node) const {
    return nodes_[static_cast<std::size_t>(node)];
  }
  const std::vector<int>& neighbors(int node);

 private:
  using Index = std::pair<int, int>;

  bool is_free(const mrpt::math::TPoint2D& p, const mrpt::math::TPoint2D& q) const;
  Index nearest(const mrpt::math::TPoint2D& p) const;
  int node_at(const Index& index);
  void connect_path(int node, std::vector<int>& found) const;
  void connect_goal(int node, std::vector<int>& found);
  void connect(int node, int other, std::vector<int>& found) const;

  const Occupancy& cells_;
  disc_path::OccupiedRows rows_;
  double radius_;  ///< cells
  GoalRegion region_;
  double spacing_;
  Path nodes_;  ///< those of the path first
  int path_size_;
  std::map<Index, int> lattice_;               ///< -1 where the disc is not free
  std::multimap<Index, int> path_nodes_;       ///< by the nearest point of the lattice
  std::map<int, std::vector<int>> neighbors_;  ///< of those that were asked for
};

}  // namespace slalom::arrival
