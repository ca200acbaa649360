// SPDX-License-Identifier: BSD-3-Clause
#include "../descriptor_parameters.h"
#include "barn_field.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::math::TPoint2D;

constexpr double kBarnCell = 0.15;  // m
constexpr double kMaxCells = 4e6;
constexpr int kDilation = 2;  // cells on each side: 5 x 5

/// Marks the cells of a grid that contain obstacles.
class ObstacleRasterizer {
 public:
  ObstacleRasterizer(const TPoint2D& corner, double cell_size, int rows, int columns,
                     std::vector<std::uint8_t>& cells)
      : corner_(corner), size_(cell_size), rows_(rows), columns_(columns), cells_(cells) {}

  /// Marks cells within `box` whose center is closer than half a cell to the obstacle, reduced by
  /// 0.1 % because an obstacle may lie exactly between two cells.
  template <typename Distance>
  void mark(const Bounds& box, Distance distance) {
    const double half = size_ / 2 * 0.999;
    const int row_end = last(box.x_max - corner_.x, rows_),
              column_end = last(box.y_max - corner_.y, columns_);
    for (int row = first(box.x_min - corner_.x); row <= row_end; ++row)
      for (int column = first(box.y_min - corner_.y); column <= column_end; ++column) {
        std::uint8_t& cell = at(row, column);
        if (cell == 0 && distance(center(row, column)) < half) cell = 1;
      }
  }

  void mark_cell_of(const TPoint2D& p) {
    const double row = std::floor((p.x - corner_.x) / size_),
                 column = std::floor((p.y - corner_.y) / size_);
    if (row >= 0 && row < rows_ && column >= 0 && column < columns_)
      at(static_cast<int>(row), static_cast<int>(column)) = 1;
  }

 private:
  int first(double from) const {
    return static_cast<int>(std::clamp(std::floor(from / size_) - 1, 0.0, 1e9));
  }
  int last(double to, int count) const {
    return static_cast<int>(std::clamp(std::floor(to / size_) + 1, -1.0, count - 1.0));
  }
  TPoint2D center(int row, int column) const {
    return {corner_.x + (row + 0.5) * size_, corner_.y + (column + 0.5) * size_};
  }
  std::uint8_t& at(int row, int column) {
    return cells_[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
                  static_cast<std::size_t>(column)];
  }

  TPoint2D corner_;
  double size_;
  int rows_, columns_;
  std::vector<std::uint8_t>& cells_;
};

Bounds box_of(const Polygon& polygon) {
  const TPoint2D& p = polygon.vertices.front();
  Bounds box{p.x, p.y, p.x, p.y};
  for (const TPoint2D& v : polygon.vertices) {
    box.x_min = std::min(box.x_min, v.x);
    box.y_min = std::min(box.y_min, v.y);
    box.x_max = std::max(box.x_max, v.x);
    box.y_max = std::max(box.y_max, v.y);
  }
  return box;
}

double distance_to_box(const TPoint2D& p, const Bounds& box) {
  return math::hypot(std::max({box.x_min - p.x, 0.0, p.x - box.x_max}),
                     std::max({box.y_min - p.y, 0.0, p.y - box.y_max}));
}

void mark_primitives(const Primitives& obstacles, ObstacleRasterizer& marker) {
  for (const Disc& disc : obstacles.discs) {
    const TPoint2D& c = disc.center;
    const double r = disc.radius;
    marker.mark({c.x - r, c.y - r, c.x + r, c.y + r},
                [&](const TPoint2D& p) { return distance(p, disc); });
  }
  for (const Polygon& polygon : obstacles.polygons)
    marker.mark(box_of(polygon), [&](const TPoint2D& p) { return distance(p, polygon); });
}

/// Merges runs of occupied cells into one box, so that a wall costs as much as a cell.
void mark_grid(const Occupancy& cells, ObstacleRasterizer& marker) {
  for (int cy = 0; cy < cells.size_y(); ++cy)
    for (int cx = 0; cx < cells.size_x(); ++cx) {
      if (!cells.occupied(cx, cy)) continue;
      const int begin = cx;
      while (cx + 1 < cells.size_x() && cells.occupied(cx + 1, cy)) ++cx;
      const TPoint2D low = cells.to_world(begin, cy), high = cells.to_world(cx + 1, cy + 1);
      const Bounds box{low.x, low.y, high.x, high.y};
      marker.mark(box, [&](const TPoint2D& p) { return distance_to_box(p, box); });
    }
}

/// Points at equal distances of at most `spacing` along the path, both ends included.
std::vector<TPoint2D> equal_steps(const KnownPath& known, double spacing) {
  const Path& path = known.path;
  double total = 0;
  for (std::size_t i = 1; i < path.size(); ++i) total += distance_between(path[i], path[i - 1]);
  const auto steps = static_cast<std::size_t>(std::max(1.0, std::ceil(total / spacing)));
  std::vector<TPoint2D> points = {path.front()};
  double before = 0;  // length up to path[i - 1]
  for (std::size_t i = 1; i < path.size(); ++i) {
    const double piece = distance_between(path[i], path[i - 1]);
    while (points.size() < steps) {
      const double at =
          total * static_cast<double>(points.size()) / static_cast<double>(steps) - before;
      if (at > piece || piece <= 0) break;
      points.push_back(path[i - 1] + (path[i] - path[i - 1]) * (at / piece));
    }
    before += piece;
  }
  if (path.size() > 1) points.push_back(path.back());
  return points;
}

}  // namespace

BarnField::BarnField(const DescriptorContext& context) {
  if (const PublishedPathPtr& published = context.world.scenario().published_path()) {
    set_up(*published);
  } else {
    const KnownPath& shortest = context.shortest();
    reason_ = shortest.path.empty() ? shortest.reason : "";
    if (reason_.empty()) set_up(context.world, shortest);
  }
  if (!reason_.empty()) return;
  cells_.assign(static_cast<std::size_t>(rows_) * static_cast<std::size_t>(columns_), 0);
  mark(context.world);
  dilate();
}

void BarnField::set_up(const PublishedPath& published) {
  corner_ = {published.field.x_min, published.field.y_min};
  cell_size_ = published.cell_size;
  rows_ = published.size_x();
  columns_ = published.size_y();
  points_ = published.points;
}

void BarnField::set_up(const World& world, const KnownPath& shortest) {
  const Bounds& bounds = world.scenario().bounds();
  const double rows = std::ceil(bounds.width() / kBarnCell - 1e-3),
               columns = std::ceil(bounds.height() / kBarnCell - 1e-3);
  if (!(rows * columns <= kMaxCells)) {
    reason_ = "the workspace has more than 4 million cells of 0.15 m";
    return;
  }
  corner_ = {bounds.x_min, bounds.y_min};
  cell_size_ = kBarnCell;
  rows_ = std::max(1, static_cast<int>(rows));
  columns_ = std::max(1, static_cast<int>(columns));
  points_ = equal_steps(shortest, kBarnCell);
}

void BarnField::mark(const World& world) {
  const Scenario& scenario = world.scenario();
  ObstacleRasterizer marker(corner_, cell_size_, rows_, columns_, cells_);
  switch (scenario.representation()) {
    case Representation::Continuous:
      return mark_primitives(scenario.primitives(), marker);
    case Representation::Grid:
      return mark_grid(world.occupancy(), marker);
    case Representation::Points: {
      const auto &x = scenario.point_map()->getPointsBufferRef_x(),
                 &y = scenario.point_map()->getPointsBufferRef_y();
      for (std::size_t i = 0; i < x.size(); ++i) marker.mark_cell_of({x[i], y[i]});
    }
  }
}

/// Separable dilation by a square: along one axis, then along the other.
void BarnField::dilate() {
  for (const bool along_rows : {true, false}) {
    const std::vector<std::uint8_t> before = cells_;
    for (int row = 0; row < rows_; ++row)
      for (int column = 0; column < columns_; ++column) {
        const std::size_t here =
            static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column);
        if (before[here] == 0) continue;
        for (int k = -kDilation; k <= kDilation; ++k) {
          const int r = along_rows ? row + k : row, c = along_rows ? column : column + k;
          if (inside(r, c))
            cells_[static_cast<std::size_t>(r) * static_cast<std::size_t>(columns_) +
                   static_cast<std::size_t>(c)] = 1;
        }
      }
  }
}

Value BarnField::mean(const CellValue& value, const std::string& no_value) const {
  if (!reason_.empty()) return Value::na(reason_);
  double sum = 0;
  std::size_t count = 0;
  for (const TPoint2D& p : points_) {
    const double row = std::floor((p.x - corner_.x) / cell_size_),
                 column = std::floor((p.y - corner_.y) / cell_size_);
    const auto found = value(static_cast<int>(std::clamp(row, 0.0, rows_ - 1.0)),
                             static_cast<int>(std::clamp(column, 0.0, columns_ - 1.0)));
    if (!found) continue;
    sum += *found;
    ++count;
  }
  return count == 0 ? Value::na(no_value) : Value::of(sum / static_cast<double>(count));
}

const BarnField& barn_field(const DescriptorContext& context) {
  if (!context.barn_field) context.barn_field = std::make_shared<const BarnField>(context);
  return *context.barn_field;
}

const std::vector<TPoint2D>& barn_path(const DescriptorContext& context) {
  const PublishedPathPtr& published = context.world.scenario().published_path();
  return published ? published->points : context.shortest().path;
}

std::string descriptors::averaged_path(const DescriptorContext& context) {
  if (const PublishedPathPtr& published = context.world.scenario().published_path())
    return "path=published " + published->hash();
  return join_parameters({robot, resolution}, context);
}

}  // namespace slalom
