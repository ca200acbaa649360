// SPDX-License-Identifier: BSD-3-Clause
#include "map_readers.h"
#include "rotated_grid.h"

#include <slalom/core/error.h>
#include <slalom/core/math.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;

/// Tolerance of overlaps (cells), for rounding errors of rotations by 90 degrees.
constexpr double kSlack = 1e-6;
using Cell = COccupancyGridMap2D::cellType;  // MRPT's log odds: conversion to probabilities rounds

/// Maps cells of a rotated grid to cells of the original grid, both in cells from a common corner.
class GridRotation {
 public:
  GridRotation(const COccupancyGridMap2D& grid, double yaw)
      : grid_(grid), cos_(math::cos(yaw)), sin_(math::sin(yaw)) {
    const double w = grid.getSizeX(), h = grid.getSizeY();
    const double xs[] = {0, w * cos_, w * cos_ - h * sin_, -h * sin_};
    const double ys[] = {0, w * sin_, w * sin_ + h * cos_, h * cos_};
    low_ = {*std::min_element(xs, xs + 4), *std::min_element(ys, ys + 4)};
    high_ = {*std::max_element(xs, xs + 4), *std::max_element(ys, ys + 4)};
  }

  double columns() const { return std::max(1.0, std::ceil(high_.x - low_.x - kSlack)); }
  double rows() const { return std::max(1.0, std::ceil(high_.y - low_.y - kSlack)); }
  const TPoint2D& low() const { return low_; }

  /// The smallest probability under the new cell (x, y).
  Cell min_free_at(int x, int y) const {
    const TPoint2D center(low_.x + x + 0.5, low_.y + y + 0.5);
    const TPoint2D old(center.x * cos_ + center.y * sin_, center.y * cos_ - center.x * sin_);
    const double half = half_extent();
    const int x0 = cell(old.x - half), x1 = cell(old.x + half);
    const int y0 = cell(old.y - half), y1 = cell(old.y + half);
    Cell min_free = COccupancyGridMap2D::p2l(1.0F);
    for (int cy = y0; cy <= y1; ++cy)
      for (int cx = x0; cx <= x1; ++cx)
        if (overlaps(old, cx, cy)) min_free = std::min(min_free, old_cell(cx, cy));
    return min_free;
  }

 private:
  static int cell(double at) { return static_cast<int>(std::floor(at)); }

  /// Half the extent of a rotated unit cell along an axis of the other grid.
  double half_extent() const { return 0.5 * (std::abs(cos_) + std::abs(sin_)); }

  /// Separating axis test of two squares.
  bool overlaps(const TPoint2D& center, int cx, int cy) const {
    const double dx = cx + 0.5 - center.x, dy = cy + 0.5 - center.y;
    const double limit = 0.5 + half_extent() - kSlack;
    return std::abs(dx) < limit && std::abs(dy) < limit &&
           std::abs(dx * cos_ - dy * sin_) < limit && std::abs(dx * sin_ + dy * cos_) < limit;
  }

  Cell old_cell(int cx, int cy) const {
    const bool within = cx >= 0 && cy >= 0 && cx < static_cast<int>(grid_.getSizeX()) &&
                        cy < static_cast<int>(grid_.getSizeY());
    return within ? grid_.getRow(cy)[cx] : COccupancyGridMap2D::p2l(0.5F);
  }

  const COccupancyGridMap2D& grid_;
  double cos_, sin_;
  TPoint2D low_, high_;
};

}  // namespace

COccupancyGridMap2D rotated_grid(const COccupancyGridMap2D& grid, double yaw,
                                 const std::string& where) {
  const GridRotation rotation(grid, yaw);
  if (rotation.columns() * rotation.rows() > static_cast<double>(kMaxCells))
    throw file_error(where, "has too many cells when rotated by " + format_number(yaw) + " rad",
                     "at most " + std::to_string(kMaxCells) + " cells");
  const double resolution = grid.getResolution();
  auto result = make_grid_map(static_cast<int>(rotation.columns()),
                              static_cast<int>(rotation.rows()), resolution,
                              {grid.getXMin() + rotation.low().x * resolution,
                               grid.getYMin() + rotation.low().y * resolution});
  for (int y = 0; y < static_cast<int>(result.getSizeY()); ++y)
    for (int x = 0; x < static_cast<int>(result.getSizeX()); ++x)
      result.getRow(y)[x] = rotation.min_free_at(x, y);
  return result;
}

}  // namespace slalom
