// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/geometry.h"
#include "common/map_kernels.h"

#include <cstddef>
#include <vector>

namespace reactive {

/// Distance to the closest obstacle point, on a square grid around a center: exact at the cell
/// centers, bilinear between them, at most `band`.
class ClearanceMap {
 public:
  /// half_size, resolution, band: m.
  ClearanceMap(double half_size, double resolution, double band);

  void build(const Point& center, const std::vector<Point>& points);
  /// The same in a square from `low` with this side (m), if that is less.
  void build(const Point& low, double side, const std::vector<Point>& points);

  double at(const Point& p) const;  ///< m; `band` outside the square
  /// The same at `count` positions (x, y). Arrays have padded(count) elements.
  void at(const double* x, const double* y, std::size_t count, double* clearances) const {
    interpolate(frame_, band_, cells_.data(), x, y, count, clearances);
  }
  int side() const { return frame_.side; }
  double resolution() const { return frame_.resolution; }
  const Point& origin() const { return frame_.origin; }  ///< lower left corner
  double band() const { return band_; }
  float cell(int x, int y) const { return cells_[index(x, y)]; }
  const std::vector<float>& cells() const { return cells_; }  ///< by index(), and unused ones
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(frame_.side) +
           static_cast<std::size_t>(x);
  }
  Point center_of(int x, int y) const {
    return {frame_.origin.x + (x + 0.5) * frame_.resolution,
            frame_.origin.y + (y + 0.5) * frame_.resolution};
  }
  bool cell_at(const Point& p, int& x, int& y) const;  ///< false outside the square

 private:
  double half_size_, band_;
  GridFrame frame_;
  std::vector<float> cells_;
};

}  // namespace reactive
