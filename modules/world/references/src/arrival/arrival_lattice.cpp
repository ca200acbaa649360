// SPDX-License-Identifier: BSD-3-Clause
#include "arrival_lattice.h"

#include <slalom/core/distance.h>
#include <slalom/scenario/contact.h>

#include <algorithm>
#include <cmath>

namespace slalom::arrival {

using mrpt::math::TPoint2D;

namespace {

/// Depth (m) in the goal region at which motions end, for rounding errors.
constexpr double kEntryDepth = 1e-9;

}  // namespace

bool GoalRegion::contains(const TPoint2D& p) const {
  return distance_between(p, goal) <= tolerance;
}

double GoalRegion::distance(const TPoint2D& p) const {
  return std::max(0.0, distance_between(p, goal) - tolerance);
}

Path GoalRegion::cut(const Path& path) const {
  Path result{path.front()};
  for (std::size_t i = 1; i < path.size() && !contains(result.back()); ++i) {
    const TPoint2D p = path[i - 1] - goal, d = path[i] - path[i - 1];
    const double a = disc_path::dot(d, d), b = disc_path::dot(p, d),
                 depth = tolerance - kEntryDepth;
    const double discriminant = b * b - a * (disc_path::dot(p, p) - depth * depth);
    const double fraction =
        a > 0 && depth > 0 && discriminant >= 0 ? (-b - std::sqrt(discriminant)) / a : 1.0;
    result.push_back(path[i - 1] + d * (fraction >= 0 && fraction < 1 ? fraction : 1.0));
  }
  return result;
}

Lattice::Lattice(const Occupancy& cells, double robot_radius, const Path& path,
                 const GoalRegion& region, double spacing)
    : cells_(cells),
      rows_(cells),
      radius_((robot_radius - kContactTolerance) / cells.resolution()),
      region_(region),
      spacing_(spacing),
      nodes_(path),
      path_size_(static_cast<int>(path.size())) {
  for (int i = 0; i < path_size_; ++i) path_nodes_.emplace(nearest(position(i)), i);
}

bool Lattice::is_free(const TPoint2D& p, const TPoint2D& q) const {
  return disc_path::is_sweep_free(rows_, cells_.to_cells(p), cells_.to_cells(q), radius_);
}

Lattice::Index Lattice::nearest(const TPoint2D& p) const {
  const TPoint2D offset = p - nodes_.front();
  return {static_cast<int>(std::lround(offset.x / spacing_)),
          static_cast<int>(std::lround(offset.y / spacing_))};
}

int Lattice::node_at(const Index& index) {
  const auto [found, is_new] = lattice_.try_emplace(index, -1);
  if (is_new) {
    const TPoint2D p = nodes_.front() + TPoint2D(index.first, index.second) * spacing_;
    if (is_free(p, p)) {
      found->second = static_cast<int>(nodes_.size());
      nodes_.push_back(p);
    }
  }
  return found->second;
}

/// Along the path without a test, which rounding errors could fail.
void Lattice::connect_path(int node, std::vector<int>& found) const {
  if (node >= path_size_) return;
  if (node > 0) found.push_back(node - 1);
  if (node + 1 < path_size_) found.push_back(node + 1);
}

/// Straight toward the goal, from wherever the region is in sight.
void Lattice::connect_goal(int node, std::vector<int>& found) {
  const TPoint2D offset = position(node) - region_.goal;
  const double length = distance_between(position(node), region_.goal);
  if (length <= region_.tolerance) return;
  const double depth = std::max(0.0, region_.tolerance - kEntryDepth);
  const TPoint2D entry = region_.goal + offset * (depth / length);
  if (!is_free(position(node), entry)) return;
  found.push_back(static_cast<int>(nodes_.size()));
  nodes_.push_back(entry);
}

void Lattice::connect(int node, int other, std::vector<int>& found) const {
  if (other < 0 || other == node) return;
  const TPoint2D &p = position(node), &q = position(other);
  if (p != q && is_free(p, q)) found.push_back(other);
}

const std::vector<int>& Lattice::neighbors(int node) {
  const auto [entry, is_new] = neighbors_.try_emplace(node);
  std::vector<int>& found = entry->second;
  if (!is_new) return found;
  // Straight and diagonal steps and the knight's moves between them.
  constexpr int kReach = 2;
  const Index here = nearest(position(node));
  connect_path(node, found);
  connect_goal(node, found);
  for (int dy = -kReach; dy <= kReach; ++dy)
    for (int dx = -kReach; dx <= kReach; ++dx) {
      const Index there{here.first + dx, here.second + dy};
      const auto [first, last] = path_nodes_.equal_range(there);
      for (auto near = first; near != last; ++near)
        if (node >= path_size_ || std::abs(near->second - node) > 1)
          connect(node, near->second, found);
      const bool is_multiple = dx % 2 == 0 && dy % 2 == 0 && (dx != 0 || dy != 0);
      if (!is_multiple) connect(node, node_at(there), found);
    }
  return found;
}

}  // namespace slalom::arrival
