// SPDX-License-Identifier: BSD-3-Clause
#include "center_distances.h"

#include <slalom/scenario/distance_field.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <numeric>
#include <utility>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// Number of columns transformed together, so that memory is read in full cache lines.
constexpr int kBlock = 16;
/// Factor that compensates for rounding to single precision: the result is a lower bound.
constexpr double kRoundedDown = 1 - 1e-7;
constexpr double kMaxSegmentLength = 1e12;  ///< m
/// The largest number of cells to the next occupied one that is counted.
constexpr std::int32_t kFar = 65535;
static_assert(4.0 * kFar * kFar > kMaxGridCells, "the border is nearer than kFar");

/// Twice the gap between the center of a cell and the square `steps` cells further on.
std::int64_t doubled_gap(std::int32_t steps) {
  return steps == 0 ? 0 : 2 * std::int64_t{steps} - 1;
}

/// Requires b > 0. Floating point division is many times faster than integer division, and as exact
/// while a is an exact double: a / b is an integer or at least 1 / b below the next one, which is
/// more than the rounding error.
std::int64_t floor_divide(std::int64_t a, std::int64_t b) {
  constexpr std::int64_t kExact = std::int64_t{1} << 52;
  if (a >= 0 && a < kExact)
    return static_cast<std::int64_t>(static_cast<double>(a) / static_cast<double>(b));
  const std::int64_t quotient = a / b;
  return quotient - (a % b < 0 ? 1 : 0);
}

/// Lower envelope of parabolas over one column, in doubled cell units. For an occupied square that
/// is not in the row of the center the nearest point is on its lower or upper edge: so each
/// horizontal edge between two rows (at the odd coordinate 2 e - 1, e = 0..rows) is a site whose
/// value is the smaller of both rows' squared horizontal gaps; centers lie at even coordinates 2 y.
/// (A square's far edge is never nearer than its near one, so nothing is underestimated.) All
/// numbers are integers, so the result is exact.
class ColumnEnvelope {
 public:
  explicit ColumnEnvelope(int rows) : rows_(rows), sites_(rows + 1), until_(rows + 1) {}

  /// `row_gap2`: the doubled horizontal gaps, squared, of rows 0..rows-1, replaced by the squares
  /// of the doubled distances.
  void transform(std::int64_t* row_gap2) {
    int count = 0;
    for (int e = 0; e <= rows_; ++e) {
      const Site site{2 * e - 1, edge_value(row_gap2, e)};
      while (count > 0 && last_use(sites_[count - 1], site) <= (count > 1 ? until_[count - 2] : -1))
        --count;
      if (count > 0) until_[count - 1] = last_use(sites_[count - 1], site);
      sites_[count++] = site;
    }
    for (int y = 0, k = 0; y < rows_; ++y) {
      const std::int64_t position = std::int64_t{2} * y;
      while (k + 1 < count && until_[k] < position) ++k;
      const std::int64_t away = position - sites_[k].position;
      row_gap2[y] = std::min(row_gap2[y], sites_[k].value + away * away);
    }
  }

 private:
  struct Site {
    std::int64_t position = 0, value = 0;
  };

  std::int64_t edge_value(const std::int64_t* row_gap2, int e) const {
    return e == 0 || e == rows_ ? 0 : std::min(row_gap2[e - 1], row_gap2[e]);  // 0: the border
  }

  /// The last coordinate at which site a, before b, is not above b.
  static std::int64_t last_use(const Site& a, const Site& b) {
    return floor_divide(b.value - a.value + b.position * b.position - a.position * a.position,
                        2 * (b.position - a.position));
  }

  int rows_;
  std::vector<Site> sites_;
  std::vector<std::int64_t> until_;
};

/// The first cell of a row from `first` on with this state (1: occupied, 0: free); if there is none
/// `count`, the number of cells.
std::int32_t next_cell(const std::uint8_t* cells, std::int32_t first, std::int32_t count,
                       int state) {
  const void* found = std::memchr(cells + first, state, static_cast<std::size_t>(count - first));
  return found == nullptr
             ? count
             : static_cast<std::int32_t>(static_cast<const std::uint8_t*>(found) - cells);
}

double length(double x, double y) {
  return std::sqrt(x * x + y * y);
}

/// The part of a segment (in cells) between two heights, as an interval of x.
struct Span {
  double low, high;
};

Span span_between(const TPoint2D& a, const TPoint2D& b, double y_low, double y_high) {
  const TPoint2D &low = a.y <= b.y ? a : b, &high = a.y <= b.y ? b : a;
  const double rise = high.y - low.y;
  const auto x_at = [&](double y) {
    return low.x + std::clamp((y - low.y) / rise, 0.0, 1.0) * (high.x - low.x);
  };
  if (y_low > high.y) return {high.x, high.x};
  if (y_high < low.y) return {low.x, low.x};
  const double x0 = rise > 0 ? x_at(y_low) : low.x, x1 = rise > 0 ? x_at(y_high) : high.x;
  return {std::min(x0, x1), std::max(x0, x1)};
}

double distance_to_cell(const TPoint2D& p, int cx, int cy) {
  return length(std::max({0.0, cx - p.x, p.x - (cx + 1)}),
                std::max({0.0, cy - p.y, p.y - (cy + 1)}));
}

/// Distance between the segment a-b, which does not meet the cell's inside, and the cell: attained
/// at an end of the segment or at a corner of the cell.
double distance_to_cell(const TPoint2D& a, const TPoint2D& b, int cx, int cy) {
  double nearest = std::min(distance_to_cell(a, cx, cy), distance_to_cell(b, cx, cy));
  for (int corner = 0; corner < 4; ++corner) {
    const TPoint2D p(cx + (corner & 1), cy + (corner >> 1));
    nearest = std::min(nearest, distance_to_segment(p, a, b));
  }
  return nearest;
}

}  // namespace

DistanceField::DistanceField(const Occupancy& occupancy, ArrayReader* written)
    : size_x_(occupancy.size_x()),
      size_y_(occupancy.size_y()),
      resolution_(occupancy.resolution()),
      origin_(occupancy.origin()) {
  if (written != nullptr) {
    const std::size_t cells = occupancy.cells().size();
    at_center_ = written->read<float>(cells);
    to_left_ = written->read<std::uint16_t>(cells);
    to_right_ = written->read<std::uint16_t>(cells);
    return;
  }
  fill_rows(occupancy);
  at_center_ = SharedArray<float>(distances_at_centers());
}

void DistanceField::write(ArrayWriter& writer) const {
  writer.write(at_center_);
  writer.write(to_left_);
  writer.write(to_right_);
}

/// The counts within a run of free cells are always the same, and are copied.
void DistanceField::fill_rows(const Occupancy& occupancy) {
  std::vector<std::uint16_t> up(static_cast<std::size_t>(std::min(size_x_, kFar)));
  std::iota(up.begin(), up.end(), std::uint16_t{1});
  const std::vector<std::uint16_t> down(up.rbegin(), up.rend());
  std::vector<std::uint16_t> to_left(occupancy.cells().size()), to_right(to_left.size());
  for (int cy = 0; cy < size_y_; ++cy) {
    const std::uint8_t* cells = occupancy.cells().data() + index(0, cy);
    std::uint16_t *left = to_left.data() + index(0, cy), *right = to_right.data() + index(0, cy);
    for (std::int32_t end = 0; end < size_x_;) {
      const std::int32_t first = next_cell(cells, end, size_x_, 0);
      end = next_cell(cells, first, size_x_, 1);
      const std::int32_t counted = std::min(end - first, kFar);
      std::copy_n(up.begin(), counted, left + first);
      std::copy_n(down.end() - counted, counted, right + end - counted);
      std::fill(left + first + counted, left + end, std::uint16_t{kFar});
      std::fill(right + first, right + end - counted, std::uint16_t{kFar});
    }
  }
  to_left_ = SharedArray<std::uint16_t>(std::move(to_left));
  to_right_ = SharedArray<std::uint16_t>(std::move(to_right));
}

std::vector<float> DistanceField::distances_at_centers() const {
  std::vector<float> distances(to_left_.size());
  if (fill_center_distances(to_left_.data(), to_right_.data(), size_x_, size_y_, resolution_,
                            distances.data()))
    return distances;
  ColumnEnvelope envelope(size_y_);
  std::vector<std::int64_t> columns(static_cast<std::size_t>(size_y_) * kBlock);
  for (int first = 0; first < size_x_; first += kBlock) {
    const int count = std::min(kBlock, size_x_ - first);
    const auto entry = [&](int i, int cy) -> std::int64_t& {
      return columns[static_cast<std::size_t>(i) * static_cast<std::size_t>(size_y_) +
                     static_cast<std::size_t>(cy)];
    };
    for (int cy = 0; cy < size_y_; ++cy)
      for (int i = 0; i < count; ++i) {
        const std::size_t at = index(first + i, cy);
        const std::int64_t gap = doubled_gap(std::min(to_left_[at], to_right_[at]));
        entry(i, cy) = gap * gap;
      }
    for (int i = 0; i < count; ++i) envelope.transform(&entry(i, 0));
    for (int cy = 0; cy < size_y_; ++cy)
      for (int i = 0; i < count; ++i)
        distances[index(first + i, cy)] =
            static_cast<float>(0.5 * resolution_ * std::sqrt(static_cast<double>(entry(i, cy))));
  }
  return distances;
}

TPoint2D DistanceField::to_cells(const TPoint2D& q) const {
  return {(q.x - origin_.x) / resolution_, (q.y - origin_.y) / resolution_};
}

double DistanceField::wall_distance(const TPoint2D& at) const {
  const double gap = std::min({at.x, at.y, size_x_ - at.x, size_y_ - at.y});
  return gap > 0 ? gap : 0;  // also for NaN
}

/// Compares squares: the root is monotonic, rounded too, and that of a square is exact.
double DistanceField::clearance(const TPoint2D& q) const {
  const TPoint2D at = to_cells(q);
  const double wall = wall_distance(at);
  if (wall == 0) return 0;
  double nearest = wall * wall;
  const int cx = static_cast<int>(at.x), cy = static_cast<int>(at.y);
  const double x = at.x - cx;
  const auto look = [&](int row, double gap_y) {
    const std::size_t i = index(cx, row);
    const double left = to_left_[i] - 1 + x, right = to_right_[i] - x;
    const double gap_x = std::max(0.0, std::min(left, right));
    nearest = std::min(nearest, gap_x * gap_x + gap_y * gap_y);
  };
  const auto is_near = [&](double gap_y) { return gap_y * gap_y < nearest; };
  look(cy, 0);
  for (int row = cy + 1; row < size_y_ && is_near(row - at.y); ++row) look(row, row - at.y);
  for (int row = cy - 1; row >= 0 && is_near(at.y - (row + 1)); --row) look(row, at.y - (row + 1));
  return std::sqrt(nearest) * resolution_;
}

double DistanceField::outline_clearance(const std::vector<TPoint2D>& corners) const {
  double nearest = clearance(corners.front());
  for (std::size_t i = 0; i < corners.size() && nearest > 0; ++i)
    nearest = segment_clearance(corners[i], corners[(i + 1) % corners.size()], nearest);
  return nearest;
}

double DistanceField::clearance_lower_bound(const TPoint2D& q) const {
  const TPoint2D at = to_cells(q);
  if (wall_distance(at) == 0) return 0;
  const int cx = static_cast<int>(at.x), cy = static_cast<int>(at.y);
  const double to_center = resolution_ * length(at.x - (cx + 0.5), at.y - (cy + 0.5));
  return std::max(0.0, kRoundedDown * at_center(cx, cy) - to_center);
}

double DistanceField::segment_clearance(const TPoint2D& a, const TPoint2D& b, double limit) const {
  const double segment = length(b.x - a.x, b.y - a.y);
  if (!(limit > 0) || !(segment < kMaxSegmentLength)) return 0;
  // All points within (bound - limit) of a point with that lower bound have enough clearance: march
  // from a.
  double done = 0;
  while (done < segment) {
    const double fraction = done / segment;
    const double spare =
        clearance_lower_bound({a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y)}) - limit;
    if (spare < resolution_) break;
    done += spare;
  }
  if (segment > 0 && done >= segment) return limit;
  const double fraction = segment > 0 ? done / segment : 0;
  const TPoint2D rest(a.x + fraction * (b.x - a.x), a.y + fraction * (b.y - a.y));
  return std::min(limit, resolution_ * exact_segment_distance(to_cells(rest), to_cells(b),
                                                              limit / resolution_));
}

/// In each row the nearest cells are the first occupied ones to the left and right of the segment's
/// part in it (or of its nearest end, for rows above and below): moving a cell away along its row
/// moves it away from the segment, as the distance between convex sets is convex.
double DistanceField::exact_segment_distance(const TPoint2D& a, const TPoint2D& b,
                                             double limit) const {
  double nearest = std::min({limit, wall_distance(a), wall_distance(b)});
  if (nearest == 0) return 0;
  const double low = std::min(a.y, b.y), high = std::max(a.y, b.y);
  // The line of the segment bounds the distance from below, which spares most cells the exact one.
  constexpr double kRounding = 1e-6;  // cells
  const double segment = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y));
  const TPoint2D normal =
      segment > 0 ? TPoint2D((a.y - b.y) / segment, (b.x - a.x) / segment) : TPoint2D(0, 0);
  const double half_cell = 0.5 * (std::abs(normal.x) + std::abs(normal.y)) + kRounding;
  const auto look_at = [&](int cx, int cy) {
    const double across =
        std::abs(normal.x * (cx + 0.5 - a.x) + normal.y * (cy + 0.5 - a.y)) - half_cell;
    if (across < nearest) nearest = std::min(nearest, distance_to_cell(a, b, cx, cy));
  };
  const int first = std::max(0, static_cast<int>(std::floor(low - nearest)) - 1);
  const int last = std::min(size_y_ - 1, static_cast<int>(std::floor(high + nearest)) + 1);
  for (int row = first; row <= last; ++row) {
    const double gap_y = std::max({0.0, row - high, low - (row + 1)});
    if (gap_y >= nearest) continue;
    const Span span = span_between(a, b, row, row + 1);
    const int left = static_cast<int>(span.low), right = static_cast<int>(span.high);
    if (occupied_from(left, row) <= right) {  // a cell above, below or on the segment
      nearest = gap_y;
      if (nearest == 0) return 0;
      continue;
    }
    look_at(occupied_up_to(left, row), row);
    look_at(occupied_from(right, row), row);
  }
  return nearest;
}

int DistanceField::occupied_up_to(int cx, int cy) const {
  while (to_left_[index(cx, cy)] == kFar) cx -= kFar - 1;
  return cx - to_left_[index(cx, cy)];
}

int DistanceField::occupied_from(int cx, int cy) const {
  while (to_right_[index(cx, cy)] == kFar) cx += kFar - 1;
  return cx + to_right_[index(cx, cy)];
}

}  // namespace slalom
