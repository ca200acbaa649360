// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "disc_geometry.h"

#include <slalom/scenario/occupancy.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace slalom::disc_path {

/// A maximal run of cells of one kind in a row: cells first .. last - 1, so x in [first, last].
struct Run {
  int first = 0, last = 0;
};

/// The rows of an occupancy, prepared when they are first needed: they do not depend on the radius
/// of the robot.
class OccupiedRows {
 public:
  explicit OccupiedRows(const Occupancy& cells);

  int size_x() const { return cells_.size_x(); }
  int size_y() const { return cells_.size_y(); }
  bool is_occupied(int x, int y) const { return cells_.occupied(x, y); }

  /// Whether no occupied square reaches into the open interval (low, high) of row y. Cells outside
  /// are occupied.
  bool is_free(int y, double low, double high) const {
    if (y < 0 || y >= size_y() || low < 0 || high > size_x()) return false;
    return next_occupied(y)[static_cast<int>(low)] >= high;
  }

  /// The occupied runs of row y from left to right, with the walls at x = 0 and x = size_x().
  const std::vector<Run>& runs(int y) const;

 private:
  /// Per cell of row y the first occupied cell at or right of it; size_x() if there is none.
  const std::int32_t* next_occupied(int y) const {
    const std::size_t row = static_cast<std::size_t>(y);
    if (!is_prepared_[row]) prepare(y);
    return next_.get() + row * width_;
  }
  void prepare(int y) const;

  const Occupancy& cells_;
  std::size_t width_;
  /// Not initialized: rows that are never needed cost nothing.
  std::unique_ptr<std::int32_t[]> next_;
  mutable std::vector<char> is_prepared_;
  mutable std::vector<std::vector<Run>> runs_;
};

/// Whether the open disc of this radius, moved from p to q, touches no occupied square. Exact: the
/// area swept is convex, so that its part within a row projects onto one interval of x.
bool is_sweep_free(const OccupiedRows& rows, Vector p, Vector q, double radius);

}  // namespace slalom::disc_path
