#pragma once

#include "common/geometry.h"

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

  double at(const Point& p) const;  ///< m; `band` outside the square
  int side() const { return side_; }
  double resolution() const { return resolution_; }
  double band() const { return band_; }
  float cell(int x, int y) const { return cells_[index(x, y)]; }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) +
           static_cast<std::size_t>(x);
  }
  Point center_of(int x, int y) const {
    return {origin_.x + (x + 0.5) * resolution_, origin_.y + (y + 0.5) * resolution_};
  }
  bool cell_at(const Point& p, int& x, int& y) const;  ///< false outside the square

 private:
  void stamp(const Point& p);

  double resolution_, band_;
  int side_;
  Point origin_;  ///< lower left corner
  std::vector<float> cells_;
};

}  // namespace reactive
