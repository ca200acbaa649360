// SPDX-License-Identifier: BSD-3-Clause
#include "open_rows.h"

#include <slalom/core/math.h>

namespace slalom::disc_path {

/// The farthest distance of a point of a square to another square, (dx, dy) cells away, is
/// |(dx, dy)|.
OpenRows::OpenRows(const OccupiedRows& occupied, double radius)
    : occupied_(occupied),
      is_prepared_(static_cast<std::size_t>(occupied.size_y())),
      runs_(static_cast<std::size_t>(occupied.size_y())),
      change_(static_cast<std::size_t>(occupied.size_x()) + 1) {
  for (int dy = 0; dy < radius; ++dy) {
    int dx = static_cast<int>(std::sqrt(radius * radius - static_cast<double>(dy) * dy));
    while (math::hypot(dx, dy) >= radius) --dx;
    reach_.push_back(dx);
  }
}

const std::vector<Run>& OpenRows::runs(int y) const {
  if (y < 0 || y >= occupied_.size_y()) return none_;
  if (!is_prepared_[static_cast<std::size_t>(y)]) prepare(y);
  return runs_[static_cast<std::size_t>(y)];
}

std::vector<Run>::const_iterator OpenRows::first_after(int x, int y) const {
  const std::vector<Run>& row = runs(y);
  return std::partition_point(row.begin(), row.end(), [x](const Run& r) { return r.last <= x; });
}

const Run* OpenRows::find(int x, int y) const {
  const auto run = first_after(x, y);
  return run != runs(y).end() && run->first <= x ? &*run : nullptr;
}

/// Occupied runs are widened and counted at their ends, so that the cost does not depend on the
/// area of obstacles.
void OpenRows::prepare(int y) const {
  const int size_x = occupied_.size_x(), size_y = occupied_.size_y();
  is_prepared_[static_cast<std::size_t>(y)] = 1;
  const int rows = static_cast<int>(reach_.size()) - 1;
  if (y < rows || y + rows >= size_y) return;  // the wall below or above blocks all cells
  std::fill(change_.begin(), change_.end(), 0);
  for (int dy = -rows; dy <= rows; ++dy)
    for (const Run& run : occupied_.runs(y + dy)) {
      const int side = reach_[static_cast<std::size_t>(std::abs(dy))];
      ++change_[static_cast<std::size_t>(std::clamp(run.first - side, 0, size_x))];
      --change_[static_cast<std::size_t>(std::clamp(run.last + side, 0, size_x))];
    }
  std::vector<Run>& open = runs_[static_cast<std::size_t>(y)];
  for (int x = 0, depth = 0; x < size_x; ++x) {
    depth += change_[static_cast<std::size_t>(x)];
    if (depth > 0) continue;
    if (open.empty() || open.back().last < x) open.push_back({x, x});
    ++open.back().last;
  }
}

}  // namespace slalom::disc_path
