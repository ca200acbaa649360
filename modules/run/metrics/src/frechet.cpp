// SPDX-License-Identifier: BSD-3-Clause
#include "path_similarity.h"

#include <slalom/core/distance.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// An interval of the parameter of a segment; empty if low > high.
struct Interval {
  double low = 1, high = 0;
  bool empty() const { return low > high; }
};

/// The interval of the segment from a to b within `radius` of p.
Interval within(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b, double radius) {
  const TPoint2D ab = b - a, pa = a - p;
  const double square = ab.x * ab.x + ab.y * ab.y, dot = pa.x * ab.x + pa.y * ab.y;
  const double rest = pa.x * pa.x + pa.y * pa.y - radius * radius;
  if (square <= 0) return rest <= 0 ? Interval{0, 1} : Interval{};
  const double discriminant = dot * dot - square * rest;
  if (discriminant < 0) return {};
  const double root = std::sqrt(discriminant);
  const Interval on_line{(-dot - root) / square, (-dot + root) / square};
  return {std::max(0.0, on_line.low), std::min(1.0, on_line.high)};
}

/// The part of a free interval reachable monotonically from the opposite side, which is reachable
/// in `from`.
Interval onward(const Interval& free, const Interval& from) {
  if (from.empty()) return {};
  return {std::max(free.low, from.low), free.high};
}

/// Decides whether the Frechet distance of two paths is at most `limit`, by the free space diagram,
/// column by column.
class FrechetDecider {
 public:
  FrechetDecider(const Path& a, const Path& b, double limit) : a_(a), b_(b), limit_(limit) {}

  bool is_feasible() {
    if (distance_between(a_.front(), b_.front()) > limit_ ||
        distance_between(a_.back(), b_.back()) > limit_)
      return false;
    initialize();
    for (std::size_t i = 0; i + 1 < a_.size(); ++i)
      if (!propagate(i)) return false;
    return !left_.empty() && !left_.back().empty() && left_.back().high >= 1;
  }

 private:
  /// Initializes the left side of the first column: the reachable part of b with a at its start.
  void initialize() {
    left_.assign(b_.size() - 1, Interval{});
    for (std::size_t j = 0; j < left_.size(); ++j) {
      const Interval free = within(a_[0], b_[j], b_[j + 1], limit_);
      if (free.empty() || free.low > 0) break;
      left_[j] = free;
      if (free.high < 1) break;
    }
    lowest_open_ = true;
  }

  /// Propagates from the left side of column i to its right side. False if nothing is reachable
  /// there.
  bool propagate(std::size_t i) {
    Interval below;
    if (lowest_open_) {
      below = within(b_[0], a_[i], a_[i + 1], limit_);
      if (below.low > 0) below = {};
      lowest_open_ = !below.empty() && below.high >= 1;
    }
    bool any = false;
    for (std::size_t j = 0; j < left_.size(); ++j) {
      if (left_[j].empty() && below.empty()) continue;
      const Interval right = within(a_[i + 1], b_[j], b_[j + 1], limit_);
      const Interval above = within(b_[j + 1], a_[i], a_[i + 1], limit_);
      const Interval from_left = left_[j];
      left_[j] = below.empty() ? onward(right, from_left) : right;
      below = from_left.empty() ? onward(above, below) : above;
      any = any || !left_[j].empty();
    }
    return any;
  }

  const Path& a_;
  const Path& b_;
  double limit_;
  std::vector<Interval> left_;  ///< reachable on the left side of the column, by segments of b
  bool lowest_open_ = true;     ///< whether the column is reachable with b at its start
};

/// The path with at least two points.
Path as_polyline(const Path& path) {
  return path.size() > 1 ? path : Path{path.front(), path.front()};
}

}  // namespace

double frechet_distance(const Path& first, const Path& second) {
  constexpr double kTolerance = 1e-6;  // m
  const Path a = as_polyline(first), b = as_polyline(second);
  const auto is_feasible = [&](double limit) { return FrechetDecider(a, b, limit).is_feasible(); };
  double low = std::max({distance_between(a.front(), b.front()),
                         distance_between(a.back(), b.back()), hausdorff_distance(a, b)});
  if (is_feasible(low + kTolerance)) return low;
  double high = 2 * low + kTolerance;
  while (!is_feasible(high)) {
    low = high;
    high *= 2;
  }
  while (high - low > kTolerance) {
    const double middle = 0.5 * (low + high);
    (is_feasible(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace slalom
