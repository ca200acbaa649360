// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/descriptors/descriptor.h>

#include <mrpt/math/TPoint2D.h>

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// Input of BARN's difficulty metrics (Perille et al., "Benchmarking Metric Ground Navigation",
/// 2020): a grid of square cells in which obstacles are dilated by 5 x 5 cells, and the points of a
/// path. Rows are along x, columns along y; cells outside are free.
///
/// For a published path these are its cells and its points. Otherwise the cells have 0.15 m, from
/// the lower left corner of the workspace, and the points are on P* at equal distances of at most a
/// cell. A cell is an obstacle if one is within half a cell of its center, or if it contains a
/// point of a point map.
class BarnField {
 public:
  /// Does not throw. Without a path, `reason` is set.
  explicit BarnField(const DescriptorContext& context);

  const std::string& reason() const { return reason_; }  ///< empty if a path exists
  int rows() const { return rows_; }
  int columns() const { return columns_; }
  bool inside(int row, int column) const {
    return row >= 0 && row < rows_ && column >= 0 && column < columns_;
  }
  /// Requires inside(row, column).
  bool blocked(int row, int column) const {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)] != 0;
  }

  /// The mean of a value over the points of the path, without points that have none; NA with reason
  /// `no_value` if no point has one, or with reason().
  using CellValue = std::function<std::optional<double>(int row, int column)>;
  Value mean(const CellValue& value, const std::string& no_value) const;

 private:
  void set_up(const PublishedPath& published);
  void set_up(const World& world, const KnownPath& shortest);
  void mark(const World& world);
  void dilate();

  std::string reason_;
  mrpt::math::TPoint2D corner_;
  double cell_size_ = 0;
  int rows_ = 0, columns_ = 0;
  std::vector<std::uint8_t> cells_;
  std::vector<mrpt::math::TPoint2D> points_;
};

/// The field of the context, which it makes once.
const BarnField& barn_field(const DescriptorContext& context);

/// The path that BARN's metrics are averaged over: the published one, or P* (m).
const std::vector<mrpt::math::TPoint2D>& barn_path(const DescriptorContext& context);

}  // namespace slalom
