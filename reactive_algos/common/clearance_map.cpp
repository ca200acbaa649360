// SPDX-License-Identifier: BSD-3-Clause
#include "common/clearance_map.h"

#include <algorithm>

namespace reactive {
namespace {

/// An even number.
int cells_of(double side, double resolution) {
  return 2 * static_cast<int>(std::ceil(0.5 * side / resolution));
}

}  // namespace

ClearanceMap::ClearanceMap(double half_size, double resolution, double band)
    : half_size_(half_size),
      band_(band),
      frame_{resolution, cells_of(2 * half_size, resolution), {}},
      cells_(padded(index(0, frame_.side)) + kMaxLanes, static_cast<float>(band)) {}

void ClearanceMap::build(const Point& center, const std::vector<Point>& points) {
  // Cells are aligned to the frame while the square moves, so that values do not fluctuate.
  frame_.side = cells_of(2 * half_size_, frame_.resolution);
  const double half = 0.5 * frame_.side;
  frame_.origin = {(std::floor(center.x / frame_.resolution) - half) * frame_.resolution,
                   (std::floor(center.y / frame_.resolution) - half) * frame_.resolution};
  fill_clearances(frame_, band_, points, cells_);
}

void ClearanceMap::build(const Point& low, double side, const std::vector<Point>& points) {
  frame_.side = cells_of(std::min(side, 2 * half_size_), frame_.resolution);
  frame_.origin = {std::floor(low.x / frame_.resolution) * frame_.resolution,
                   std::floor(low.y / frame_.resolution) * frame_.resolution};
  fill_clearances(frame_, band_, points, cells_);
}

bool ClearanceMap::cell_at(const Point& p, int& x, int& y) const {
  const double cx = std::floor((p.x - frame_.origin.x) / frame_.resolution);
  const double cy = std::floor((p.y - frame_.origin.y) / frame_.resolution);
  if (!(cx >= 0 && cy >= 0 && cx < frame_.side && cy < frame_.side)) return false;
  x = static_cast<int>(cx);
  y = static_cast<int>(cy);
  return true;
}

double ClearanceMap::at(const Point& p) const {
  const double x = (p.x - frame_.origin.x) / frame_.resolution - 0.5;
  const double y = (p.y - frame_.origin.y) / frame_.resolution - 0.5;
  if (!(x >= 0 && y >= 0 && x < frame_.side - 1 && y < frame_.side - 1)) return band_;
  const int ix = static_cast<int>(x), iy = static_cast<int>(y);
  const double fx = x - ix, fy = y - iy;
  const float* const low = &cells_[index(ix, iy)];
  const float* const high = low + frame_.side;
  const double bottom = low[0] + fx * (low[1] - low[0]);
  const double top = high[0] + fx * (high[1] - high[0]);
  return bottom + fy * (top - bottom);
}

}  // namespace reactive
