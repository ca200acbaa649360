// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/shared_array.h>
#include <slalom/scenario/occupancy.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// Exact Euclidean distance to the occupied closed squares of an Occupancy (and to the border of
/// the workspace).
class DistanceField {
 public:
  /// Computes the field, or uses the tables that write() wrote for this occupancy, where they are.
  /// Throws Error (Job) when these are malformed.
  explicit DistanceField(const Occupancy& occupancy, ArrayReader* written = nullptr);
  void write(ArrayWriter& writer) const;

  /// d at the center of a cell (m): distance to the nearest occupied closed square; 0 if occupied.
  double at_center(int cx, int cy) const { return at_center_[index(cx, cy)]; }
  /// The distances at all cell centers, row-major (m).
  const SharedArray<float>& centers() const { return at_center_; }

  /// d(q) (m) at any point; 0 on or in an occupied square and outside the workspace.
  double clearance(const mrpt::math::TPoint2D& q) const;

  /// Distance (m) from the segment a-b to the nearest occupied square, if it is below `limit`,
  /// otherwise `limit`.
  double segment_clearance(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b,
                           double limit) const;

  /// Distance (m) from the outline of a polygon to the nearest occupied square. Obstacles
  /// completely inside the polygon are ignored.
  double outline_clearance(const std::vector<mrpt::math::TPoint2D>& corners) const;

  /// A fast lower bound of clearance(q) (m), from the center of the cell that contains q.
  double clearance_lower_bound(const mrpt::math::TPoint2D& q) const;

 private:
  std::size_t index(int cx, int cy) const {
    return static_cast<std::size_t>(cy) * static_cast<std::size_t>(size_x_) +
           static_cast<std::size_t>(cx);
  }
  void fill_rows(const Occupancy& occupancy);
  std::vector<float> distances_at_centers() const;
  mrpt::math::TPoint2D to_cells(const mrpt::math::TPoint2D& q) const;
  /// Distance (cells) to the border of the grid; 0 on it and outside.
  double wall_distance(const mrpt::math::TPoint2D& at) const;
  double exact_segment_distance(const mrpt::math::TPoint2D& a, const mrpt::math::TPoint2D& b,
                                double limit) const;
  /// The column of the nearest occupied cell of the row on the left (right), or the cell's own; -1
  /// (the number of columns) if there is none.
  int occupied_up_to(int cx, int cy) const;
  int occupied_from(int cx, int cy) const;

  int size_x_, size_y_;
  double resolution_;
  mrpt::math::TPoint2D origin_;
  SharedArray<float> at_center_;
  /// Per cell: number of cells to the nearest occupied cell of its row on the left (right); 0 if
  /// the cell is occupied itself, at most 65,535, which is further than any point of a grid is from
  /// its border.
  SharedArray<std::uint16_t> to_left_, to_right_;
};

}  // namespace slalom
