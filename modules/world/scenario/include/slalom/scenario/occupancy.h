// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/array_stream.h>
#include <slalom/scenario/scenario.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// The binary occupancy of a workspace on square cells, as used by sensing, collision checking and
/// search. A cell is a closed square; cells outside are occupied (the border is a wall). Cell (cx,
/// cy) covers [x_min + cx res, x_min + (cx+1) res] x [y_min + cy res, ...].
class Occupancy {
 public:
  Occupancy(int size_x, int size_y, double resolution, mrpt::math::TPoint2D origin);

  int size_x() const { return size_x_; }
  int size_y() const { return size_y_; }
  double resolution() const { return resolution_; }
  const mrpt::math::TPoint2D& origin() const { return origin_; }  ///< lower left corner, m
  Bounds bounds() const;

  /// For other processes; reading makes a copy. Throws Error when what was written is malformed.
  void write(ArrayWriter& writer) const;
  static Occupancy read(ArrayReader& reader);

  bool inside(int cx, int cy) const { return cx >= 0 && cy >= 0 && cx < size_x_ && cy < size_y_; }
  bool occupied(int cx, int cy) const { return !inside(cx, cy) || cells_[index(cx, cy)] != 0; }
  void set_occupied(int cx, int cy, bool occupied);  ///< requires inside(cx, cy)
  std::size_t index(int cx, int cy) const {
    return static_cast<std::size_t>(cy) * static_cast<std::size_t>(size_x_) +
           static_cast<std::size_t>(cx);
  }
  /// Row-major cells, 1 occupied, 0 free.
  const std::vector<std::uint8_t>& cells() const { return cells_; }

  /// World to cell units: (p - origin) / resolution. The integer part is the cell.
  mrpt::math::TPoint2D to_cells(const mrpt::math::TPoint2D& p) const {
    return {(p.x - origin_.x) / resolution_, (p.y - origin_.y) / resolution_};
  }
  mrpt::math::TPoint2D to_world(double x_cells, double y_cells) const {
    return {origin_.x + x_cells * resolution_, origin_.y + y_cells * resolution_};
  }
  mrpt::math::TPoint2D cell_center(int cx, int cy) const { return to_world(cx + 0.5, cy + 0.5); }

  std::size_t count_occupied() const;

 private:
  int size_x_, size_y_;
  double resolution_;
  mrpt::math::TPoint2D origin_;
  std::vector<std::uint8_t> cells_;
};

/// The occupancy of a scenario. A grid scenario keeps its own cells (resolution is ignored);
/// primitives occupy every cell whose closed square they touch; a point occupies the cell that
/// contains it. Throws Error (Usage) when resolution is not positive or more than 400 million cells
/// would result.
Occupancy make_occupancy(const Scenario& scenario, double resolution);

/// `scenario` in another representation (same name, start, goal). Resolution (m) is the cell size
/// of a grid made from primitives or points, and the spacing of points made from primitives or
/// cells: points lie on the boundary of obstacles (of cells: at the centers of occupied cells that
/// have a free 4-neighbor). The same as convert() of convert.h with tolerance 0 and discs of half
/// the resolution for points. Throws the same.
Scenario convert(const Scenario& scenario, Representation to, double resolution);

}  // namespace slalom
