#include "common/clearance_map.h"

#include <algorithm>

namespace reactive {

ClearanceMap::ClearanceMap(double half_size, double resolution, double band)
    : resolution_(resolution),
      band_(band),
      side_(2 * static_cast<int>(std::ceil(half_size / resolution))),
      cells_(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_),
             static_cast<float>(band)) {}

void ClearanceMap::build(const Point& center, const std::vector<Point>& points) {
  // Cells are aligned to the frame while the square moves, so that values do not fluctuate.
  const double half = 0.5 * side_;
  origin_ = {(std::floor(center.x / resolution_) - half) * resolution_,
             (std::floor(center.y / resolution_) - half) * resolution_};
  std::fill(cells_.begin(), cells_.end(), static_cast<float>(band_ * band_));
  for (const Point& p : points) stamp(p);
  for (float& value : cells_) value = std::sqrt(value);
}

void ClearanceMap::stamp(const Point& p) {
  const double x = (p.x - origin_.x) / resolution_ - 0.5, y = (p.y - origin_.y) / resolution_ - 0.5;
  const double reach = band_ / resolution_;
  const int x0 = std::max(0, static_cast<int>(std::ceil(x - reach)));
  const int x1 = std::min(side_ - 1, static_cast<int>(std::floor(x + reach)));
  const int y0 = std::max(0, static_cast<int>(std::ceil(y - reach)));
  const int y1 = std::min(side_ - 1, static_cast<int>(std::floor(y + reach)));
  const auto r = static_cast<float>(resolution_);
  for (int row = y0; row <= y1; ++row) {
    const float dy = (static_cast<float>(row) - static_cast<float>(y)) * r;
    const float dy2 = dy * dy;
    float* const cells = &cells_[index(0, row)];
    for (int column = x0; column <= x1; ++column) {
      const float dx = (static_cast<float>(column) - static_cast<float>(x)) * r;
      const float squared = dx * dx + dy2;
      cells[column] = squared < cells[column] ? squared : cells[column];
    }
  }
}

bool ClearanceMap::cell_at(const Point& p, int& x, int& y) const {
  const double cx = std::floor((p.x - origin_.x) / resolution_);
  const double cy = std::floor((p.y - origin_.y) / resolution_);
  if (!(cx >= 0 && cy >= 0 && cx < side_ && cy < side_)) return false;
  x = static_cast<int>(cx);
  y = static_cast<int>(cy);
  return true;
}

double ClearanceMap::at(const Point& p) const {
  const double x = (p.x - origin_.x) / resolution_ - 0.5, y = (p.y - origin_.y) / resolution_ - 0.5;
  if (!(x >= 0 && y >= 0 && x < side_ - 1 && y < side_ - 1)) return band_;
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const double fx = x - ix, fy = y - iy;
  const float* const low = &cells_[index(ix, iy)];
  const float* const high = low + side_;
  const double bottom = low[0] + fx * (low[1] - low[0]);
  const double top = high[0] + fx * (high[1] - high[0]);
  return bottom + fy * (top - bottom);
}

}  // namespace reactive
