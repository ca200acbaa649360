// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/people/wall_runs.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

/// The runs of one line of a grid of `length` cells. side(i): 1 where the free cell is on the side
/// of the greater coordinate, -1 on the other one, 0 where there is no edge.
template <typename Side, typename Add>
void add_runs(int length, const Side& side, const Add& add) {
  for (int first = 0; first < length;) {
    const int here = side(first);
    int end = first + 1;
    while (end < length && side(end) == here) ++end;
    if (here != 0) add(first, end, here);
    first = end;
  }
}

}  // namespace

std::vector<WallRun> find_wall_runs(const Occupancy& cells) {
  std::vector<WallRun> runs;
  const auto side = [](bool before, bool after) { return int{before} - int{after}; };
  for (int y = 0; y <= cells.size_y(); ++y)
    add_runs(
        cells.size_x(), [&](int x) { return side(cells.occupied(x, y - 1), cells.occupied(x, y)); },
        [&](int x, int end, int free) {
          runs.push_back({cells.to_world(x, y), cells.to_world(end, y), TPoint2D(0, free)});
        });
  for (int x = 0; x <= cells.size_x(); ++x)
    add_runs(
        cells.size_y(), [&](int y) { return side(cells.occupied(x - 1, y), cells.occupied(x, y)); },
        [&](int y, int end, int free) {
          runs.push_back({cells.to_world(x, y), cells.to_world(x, end), TPoint2D(free, 0)});
        });
  return runs;
}

WallRuns::WallRuns(const Occupancy& occupancy, double reach)
    : runs_(find_wall_runs(occupancy)),
      bounds_(occupancy.bounds()),
      bucket_(std::max(1.0, reach)),
      columns_(static_cast<int>(std::ceil(bounds_.width() / bucket_))),
      rows_(static_cast<int>(std::ceil(bounds_.height() / bucket_))),
      buckets_(index(columns_ - 1, rows_ - 1) + 1) {
  const double wide = reach * (1 + 1e-9);  // for rounding
  for (std::size_t i = 0; i < runs_.size(); ++i) {
    const auto& [a, b, to_free] = runs_[i];
    for (int y = row(a.y - wide); y <= row(b.y + wide); ++y)
      for (int x = column(a.x - wide); x <= column(b.x + wide); ++x)
        buckets_[index(x, y)].push_back(i);
  }
}

int WallRuns::column(double x) const {
  return static_cast<int>(std::clamp(std::floor((x - bounds_.x_min) / bucket_), 0.0,
                                     static_cast<double>(columns_ - 1)));
}

int WallRuns::row(double y) const {
  return static_cast<int>(
      std::clamp(std::floor((y - bounds_.y_min) / bucket_), 0.0, static_cast<double>(rows_ - 1)));
}

std::size_t WallRuns::index(int column, int row) const {
  return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
         static_cast<std::size_t>(column);
}

const std::vector<std::size_t>& WallRuns::near(const TPoint2D& p) const {
  return buckets_[index(column(p.x), row(p.y))];
}

}  // namespace slalom
