// SPDX-License-Identifier: BSD-3-Clause
#include "configuration_space.h"

#include <slalom/core/math.h>
#include <slalom/scenario/contact.h>

#include <algorithm>
#include <cmath>
#include <limits>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr int kHeadings = 16;
constexpr double kTouch = 1e-9;  ///< cells; contact counts as free

/// Cells first..last of row dy, relative to the robot's cell, that it overlaps.
struct RowSpan {
  int dy, first, last;
};

/// The cells of row dy in which a side is.
RowSpan crossed_cells(const TPoint2D& a, const TPoint2D& b, int dy) {
  const double low = dy - 0.5 + kTouch, high = dy + 0.5 - kTouch;
  double first = std::numeric_limits<double>::infinity(), last = -first;
  const auto take = [&](double x) {
    first = std::min(first, x);
    last = std::max(last, x);
  };
  for (const TPoint2D& end : {a, b})
    if (end.y >= low && end.y <= high) take(end.x);
  for (const double y : {low, high})
    if ((a.y < y) != (b.y < y)) take(a.x + (y - a.y) / (b.y - a.y) * (b.x - a.x));
  if (first > last) return {dy, 0, -1};
  return {dy, static_cast<int>(std::floor(first + kTouch + 0.5)),
          static_cast<int>(std::ceil(last - kTouch + 0.5)) - 1};
}

/// The cells of row dy whose centers are inside, one span between two sides each.
std::vector<RowSpan> inner_cells(const std::vector<TPoint2D>& corners, int dy) {
  std::vector<double> sides;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const TPoint2D &a = corners[i], &b = corners[(i + 1) % corners.size()];
    if ((a.y < dy) != (b.y < dy)) sides.push_back(a.x + (dy - a.y) / (b.y - a.y) * (b.x - a.x));
  }
  std::sort(sides.begin(), sides.end());
  std::vector<RowSpan> spans;
  for (std::size_t i = 0; i + 1 < sides.size(); i += 2)
    spans.push_back(
        {dy, static_cast<int>(std::ceil(sides[i])), static_cast<int>(std::floor(sides[i + 1]))});
  return spans;
}

/// The spans of one row, joined where they overlap or follow each other.
std::vector<RowSpan> joined(std::vector<RowSpan> spans) {
  std::sort(spans.begin(), spans.end(),
            [](const RowSpan& a, const RowSpan& b) { return a.first < b.first; });
  std::vector<RowSpan> result;
  for (const RowSpan& span : spans) {
    if (span.first > span.last) continue;
    if (!result.empty() && span.first <= result.back().last + 1)
      result.back().last = std::max(result.back().last, span.last);
    else
      result.push_back(span);
  }
  return result;
}

/// The cells that a polygon around the center of a cell overlaps (corners in cells): a side is in
/// them, or their center is inside.
std::vector<RowSpan> overlapped_cells(const std::vector<TPoint2D>& corners) {
  double low = 0, high = 0;
  for (const TPoint2D& p : corners) {
    low = std::min(low, p.y);
    high = std::max(high, p.y);
  }
  std::vector<RowSpan> cells;
  for (int dy = static_cast<int>(std::floor(low + kTouch + 0.5)); dy - 0.5 < high - kTouch; ++dy) {
    std::vector<RowSpan> row = inner_cells(corners, dy);
    for (std::size_t i = 0; i < corners.size(); ++i)
      row.push_back(crossed_cells(corners[i], corners[(i + 1) % corners.size()], dy));
    row = joined(std::move(row));
    cells.insert(cells.end(), row.begin(), row.end());
  }
  return cells;
}

/// For each cell, the column of the next occupied cell of its row, itself included; the border
/// counts as occupied.
std::vector<std::int32_t> next_occupied(const Occupancy& cells) {
  std::vector<std::int32_t> next(cells.cells().size());
  for (int cy = 0; cy < cells.size_y(); ++cy) {
    std::int32_t nearest = cells.size_x();
    for (int cx = cells.size_x() - 1; cx >= 0; --cx)
      next[cells.index(cx, cy)] = nearest = cells.occupied(cx, cy) ? cx : nearest;
  }
  return next;
}

/// Counts the collision-free headings of a polygon.
class PolygonTest {
 public:
  PolygonTest(const Occupancy& cells, const Footprint& robot)
      : cells_(cells), next_occupied_(next_occupied(cells)) {
    for (int i = 0; i < kHeadings; ++i) {
      std::vector<TPoint2D> corners = robot.corners_at({0, 0, 2 * M_PI * i / kHeadings});
      for (TPoint2D& p : corners) p = p * (1 / cells.resolution());
      headings_.push_back(overlapped_cells(corners));
    }
  }

  std::uint8_t free_headings(int cx, int cy) const {
    int count = 0;
    for (const auto& rows : headings_) count += is_free(rows, cx, cy) ? 1 : 0;
    return static_cast<std::uint8_t>(count);
  }

 private:
  bool is_free(const std::vector<RowSpan>& rows, int cx, int cy) const {
    for (const RowSpan& row : rows) {
      const int y = cy + row.dy, first = cx + row.first, last = cx + row.last;
      if (!cells_.inside(first, y) || next_occupied_[cells_.index(first, y)] <= last) return false;
    }
    return true;
  }

  const Occupancy& cells_;
  std::vector<std::int32_t> next_occupied_;
  std::vector<std::vector<RowSpan>> headings_;
};

}  // namespace

FreeHeadings free_headings(const DescriptorContext& context) {
  // Distances are in single precision: a radius equal to a distance must be free.
  const auto reached = [](double radius) {
    return static_cast<float>((radius - kContactTolerance) * (1 - 1e-7));
  };
  const SharedArray<float>& distances = context.world.distance_field().centers();
  FreeHeadings result;
  result.headings = context.robot.is_disc() ? 1 : kHeadings;
  result.free.resize(distances.size());
  const float inner = reached(context.robot.inscribed_radius());
  const float outer = reached(context.robot.enclosing_radius());
  const auto all = static_cast<std::uint8_t>(result.headings);
  std::transform(distances.begin(), distances.end(), result.free.begin(),
                 [=](float distance) { return distance >= outer ? all : std::uint8_t{0}; });
  const Occupancy& cells = context.world.occupancy();
  const Bounds bounds = cells.bounds();
  // A corner farther away than the diagonal of W is always outside.
  if (context.robot.is_disc() ||
      context.robot.enclosing_radius() > math::hypot(bounds.width(), bounds.height()))
    return result;
  const PolygonTest test(cells, context.robot);
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      const std::size_t i = cells.index(cx, cy);
      if (distances[i] >= inner && distances[i] < outer)
        result.free[i] = test.free_headings(cx, cy);
    }
  return result;
}

}  // namespace slalom
