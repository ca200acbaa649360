// SPDX-License-Identifier: BSD-3-Clause
#include "disc_arcs.h"

#include <slalom/core/math.h>

namespace slalom::disc_path {
namespace {

constexpr double kQuarter = M_PI / 2;

/// Collects the parts of an arc that occupied squares cover, in its local frame: the corner at the
/// origin, the arc in the first quadrant.
class Coverage {
 public:
  Coverage(double radius, double checked_radius) : radius_(radius), checked_(checked_radius) {}

  /// Adds the occupied cells [x0, x1] x [y0, y0 + 1], grown by the radius: four discs, two boxes.
  void add_cells(double x0, double x1, double y0) {
    const double y1 = y0 + 1;
    const double near_x = std::max({x0, -x1, 0.0}), near_y = std::max({y0, -y1, 0.0});
    if (near_x * near_x + near_y * near_y >= 4 * radius_ * radius_) return;
    for (const double x : {x0, x1})
      for (const double y : {y0, y1}) add_disc(x, y);
    add_box(x0 - checked_, x1 + checked_, y0, y1);
    add_box(x0, x1, y0 - checked_, y1 + checked_);
  }

  std::vector<Interval> uncovered() {
    std::sort(covered_.begin(), covered_.end());
    std::vector<Interval> result;
    double end = 0;
    for (const auto& [low, high] : covered_) {
      if (low > kQuarter) break;
      if (low >= end) result.emplace_back(end, low);
      end = std::max(end, high);
    }
    if (end <= kQuarter) result.emplace_back(end, kQuarter);
    return result;
  }

 private:
  void add(double low, double high) {
    if (high > low && high > 0 && low < kQuarter) covered_.emplace_back(low, high);
  }

  void add_disc(double x, double y) {
    const double square = x * x + y * y;
    if (square == 0 || square >= 4 * radius_ * radius_) return;
    const double cosine =
        (radius_ * radius_ + square - checked_ * checked_) / (2 * radius_ * std::sqrt(square));
    if (cosine >= 1) return;
    const double half = math::acos(std::max(cosine, -1.0)), middle = math::atan2(y, x);
    add(middle - half, middle + half);
  }

  void add_box(double x0, double x1, double y0, double y1) {
    if (x1 <= 0 || y1 <= 0 || x0 >= radius_ || y0 >= radius_) return;
    double low = -1, high = kQuarter + 1;  // beyond the arc
    if (x1 < radius_) low = std::max(low, math::acos(x1 / radius_));
    if (x0 > 0) high = std::min(high, math::acos(x0 / radius_));
    if (y0 > 0) low = std::max(low, math::asin(y0 / radius_));
    if (y1 < radius_) high = std::min(high, math::asin(y1 / radius_));
    add(low, high);
  }

  double radius_, checked_;
  std::vector<Interval> covered_;
};

}  // namespace

std::vector<Interval> exposed_parts(const OccupiedRows& occupied, const Arc& arc, double radius,
                                    double checked_radius) {
  Coverage coverage(radius, checked_radius);
  const int near = static_cast<int>(std::ceil(radius)),
            far = static_cast<int>(std::ceil(2 * radius));
  for (int j = -near; j < far; ++j) {
    const int y = arc.out_y > 0 ? arc.y + j : arc.y - 1 - j;
    const auto is_occupied = [&](int i) {
      return occupied.is_occupied(arc.out_x > 0 ? arc.x + i : arc.x - 1 - i, y);
    };
    // The corner's own cell is (-1, -1): what is left of it and below is farther from the arc.
    for (int i = j < 0 ? 0 : -near; i < far; ++i) {
      if (!is_occupied(i)) continue;
      const int first = i;
      while (i < far && is_occupied(i)) ++i;
      coverage.add_cells(first, i, j);
    }
  }
  return coverage.uncovered();
}

}  // namespace slalom::disc_path
