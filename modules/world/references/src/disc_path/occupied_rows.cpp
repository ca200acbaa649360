// SPDX-License-Identifier: BSD-3-Clause
#include "occupied_rows.h"

namespace slalom::disc_path {

OccupiedRows::OccupiedRows(const Occupancy& cells)
    : cells_(cells),
      width_(static_cast<std::size_t>(cells.size_x()) + 1),
      next_(new std::int32_t[width_ * static_cast<std::size_t>(cells.size_y())]),
      is_prepared_(static_cast<std::size_t>(cells.size_y())),
      runs_(static_cast<std::size_t>(cells.size_y())) {}

void OccupiedRows::prepare(int y) const {
  const std::size_t row = static_cast<std::size_t>(y);
  std::int32_t* next = next_.get() + row * width_;
  const std::uint8_t* cells = cells_.cells().data() + cells_.index(0, y);
  std::int32_t nearest = size_x();
  next[size_x()] = nearest;
  for (int x = size_x() - 1; x >= 0; --x) {
    if (cells[x] != 0) nearest = x;
    next[x] = nearest;
  }
  is_prepared_[row] = 1;
}

const std::vector<Run>& OccupiedRows::runs(int y) const {
  std::vector<Run>& runs = runs_[static_cast<std::size_t>(y)];
  if (!runs.empty()) return runs;
  const std::int32_t* next = next_occupied(y);
  runs.push_back({-1, 0});
  for (int x = next[0]; x < size_x(); x = next[runs.back().last]) {
    int end = x + 1;
    while (end < size_x() && next[end] == end) ++end;
    runs.push_back({x, end});
  }
  runs.push_back({size_x(), size_x() + 1});
  return runs;
}

namespace {

/// One side of the area that a disc sweeps from p up to q, right (+1) or left (-1): a part of a
/// circle about p, a straight edge, a part of a circle about q.
class SweptSide {
 public:
  SweptSide(int side, const Vector& p, const Vector& q, const Vector& direction, double radius)
      : side_(side), p_(p), q_(q), radius_(radius) {
    const Vector normal(side * direction.y, -side * direction.x);
    edge_x_ = p.x + normal.x * radius;
    edge_begin_ = p.y + normal.y * radius;
    edge_end_ = q.y + normal.y * radius;
    peak_ = normal.y < 0 ? q.y : p.y;
    constexpr double kHorizontal = 1e-300;
    slope_ = direction.y > kHorizontal ? direction.x / direction.y : 0;
  }

  /// The farthest x at heights within [low, high].
  double reach(double low, double high) const {
    const double y = std::clamp(peak_, low, high);
    if (y <= edge_begin_) return p_.x + side_ * half_width(y - p_.y);
    if (y >= edge_end_) return q_.x + side_ * half_width(y - q_.y);
    return edge_x_ + slope_ * (y - edge_begin_);
  }

 private:
  double half_width(double dy) const {
    const double square = radius_ * radius_ - dy * dy;
    return square > 0 ? std::sqrt(square) : 0;
  }

  int side_;
  Vector p_, q_;
  double radius_, slope_ = 0;
  double edge_x_ = 0, edge_begin_ = 0, edge_end_ = 0;  ///< x at its begin, heights of both ends
  double peak_ = 0;                                    ///< the height at which the side is farthest
};

}  // namespace

bool is_sweep_free(const OccupiedRows& rows, Vector p, Vector q, double radius) {
  if (p.y > q.y) std::swap(p, q);
  const double low = p.y - radius, high = q.y + radius;
  if (low < 0 || high > rows.size_y()) return false;
  const double length = norm(q - p);
  const Vector d = length > 0 ? (q - p) * (1 / length) : Vector(1, 0);
  const SweptSide left(-1, p, q, d, radius), right(+1, p, q, d, radius);
  const int last = static_cast<int>(std::ceil(high)) - 1;
  for (int y = static_cast<int>(low); y <= last; ++y) {
    const double from = std::max<double>(y, low), to = std::min<double>(y + 1, high);
    if (!rows.is_free(y, left.reach(from, to), right.reach(from, to))) return false;
  }
  return true;
}

}  // namespace slalom::disc_path
