#include "path_similarity.h"

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Shares of a segment, from `low` to `high`; empty where low > high.
struct Interval {
  double low = 1, high = 0;
  bool empty() const { return low > high; }
};

double distance(const TPoint2D& a, const TPoint2D& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

/// Where the segment from a to b is within `reach` of p.
Interval within(const TPoint2D& p, const TPoint2D& a, const TPoint2D& b, double reach) {
  const TPoint2D ab = b - a, pa = a - p;
  const double square = ab.x * ab.x + ab.y * ab.y, dot = pa.x * ab.x + pa.y * ab.y;
  const double rest = pa.x * pa.x + pa.y * pa.y - reach * reach;
  if (square <= 0) return rest <= 0 ? Interval{0, 1} : Interval{};
  const double discriminant = dot * dot - square * rest;
  if (discriminant < 0) return {};
  const double root = std::sqrt(discriminant);
  const Interval on_line{(-dot - root) / square, (-dot + root) / square};
  return {std::max(0.0, on_line.low), std::min(1.0, on_line.high)};
}

/// What of a free interval can be reached from the opposite side, reachable in `from`, without
/// going back.
Interval onward(const Interval& free, const Interval& from) {
  if (from.empty()) return {};
  return {std::max(free.low, from.low), free.high};
}

/// Whether a leash of one length is enough: the free space diagram of two paths, column by column.
class Leash {
 public:
  Leash(const Path& a, const Path& b, double length) : a_(a), b_(b), length_(length) {}

  bool is_enough() {
    if (distance(a_.front(), b_.front()) > length_ || distance(a_.back(), b_.back()) > length_)
      return false;
    enter();
    for (std::size_t i = 0; i + 1 < a_.size(); ++i)
      if (!cross(i)) return false;
    return !left_.empty() && !left_.back().empty() && left_.back().high >= 1;
  }

 private:
  /// The first column's left side: as far as b can be walked while a waits at its start.
  void enter() {
    left_.assign(b_.size() - 1, Interval{});
    for (std::size_t j = 0; j < left_.size(); ++j) {
      const Interval free = within(a_[0], b_[j], b_[j + 1], length_);
      if (free.empty() || free.low > 0) break;
      left_[j] = free;
      if (free.high < 1) break;
    }
    lowest_open_ = true;
  }

  /// From the left side of column i to its right side. False where nothing can be reached there.
  bool cross(std::size_t i) {
    Interval below;
    if (lowest_open_) {
      below = within(b_[0], a_[i], a_[i + 1], length_);
      if (below.low > 0) below = {};
      lowest_open_ = !below.empty() && below.high >= 1;
    }
    bool any = false;
    for (std::size_t j = 0; j < left_.size(); ++j) {
      if (left_[j].empty() && below.empty()) continue;
      const Interval right = within(a_[i + 1], b_[j], b_[j + 1], length_);
      const Interval above = within(b_[j + 1], a_[i], a_[i + 1], length_);
      const Interval from_left = left_[j];
      left_[j] = below.empty() ? onward(right, from_left) : right;
      below = from_left.empty() ? onward(above, below) : above;
      any = any || !left_[j].empty();
    }
    return any;
  }

  const Path& a_;
  const Path& b_;
  double length_;
  std::vector<Interval> left_;  ///< reachable on the left side of the column, by pieces of b
  bool lowest_open_ = true;     ///< whether a can be walked so far while b waits at its start
};

/// Two points at least.
Path as_walk(const Path& path) {
  return path.size() > 1 ? path : Path{path.front(), path.front()};
}

}  // namespace

double frechet_distance(const Path& first, const Path& second) {
  constexpr double kTolerance = 1e-6;  // m
  const Path a = as_walk(first), b = as_walk(second);
  const auto is_enough = [&](double length) { return Leash(a, b, length).is_enough(); };
  double low = std::max(
      {distance(a.front(), b.front()), distance(a.back(), b.back()), hausdorff_distance(a, b)});
  if (is_enough(low + kTolerance)) return low;
  double high = 2 * low + kTolerance;
  while (!is_enough(high)) {
    low = high;
    high *= 2;
  }
  while (high - low > kTolerance) {
    const double middle = 0.5 * (low + high);
    (is_enough(middle) ? high : low) = middle;
  }
  return high;
}

}  // namespace slalom
