#include "map_readers.h"
#include "turned_grid.h"

#include <slalom/core/error.h>
#include <slalom/core/text.h>
#include <slalom/scenario/grid_map.h>

#include <algorithm>
#include <cmath>

namespace slalom {
namespace {

using mrpt::maps::COccupancyGridMap2D;
using mrpt::math::TPoint2D;

/// Overlaps below this (in cells) are none: the rounding of a quarter turn.
constexpr double kSlack = 1e-6;
using Cell = COccupancyGridMap2D::cellType;  // MRPT's own scale: turning into probabilities rounds

/// Unit cells of a turned grid over those of an upright one, both in cells about a common corner.
class Turn {
 public:
  Turn(const COccupancyGridMap2D& grid, double yaw)
      : grid_(grid), cos_(std::cos(yaw)), sin_(std::sin(yaw)) {
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
  Cell free_under(int x, int y) const {
    const TPoint2D center(low_.x + x + 0.5, low_.y + y + 0.5);
    const TPoint2D old(center.x * cos_ + center.y * sin_, center.y * cos_ - center.x * sin_);
    const double reach = half_reach();
    const int x0 = cell(old.x - reach), x1 = cell(old.x + reach);
    const int y0 = cell(old.y - reach), y1 = cell(old.y + reach);
    Cell least = COccupancyGridMap2D::p2l(1.0F);
    for (int cy = y0; cy <= y1; ++cy)
      for (int cx = x0; cx <= x1; ++cx)
        if (overlaps(old, cx, cy)) least = std::min(least, old_cell(cx, cy));
    return least;
  }

 private:
  static int cell(double at) { return static_cast<int>(std::floor(at)); }

  /// Half the extent of a turned unit cell along an axis of the other grid.
  double half_reach() const { return 0.5 * (std::abs(cos_) + std::abs(sin_)); }

  /// Two squares overlap unless an axis of one of them parts them.
  bool overlaps(const TPoint2D& center, int cx, int cy) const {
    const double dx = cx + 0.5 - center.x, dy = cy + 0.5 - center.y;
    const double most = 0.5 + half_reach() - kSlack;
    return std::abs(dx) < most && std::abs(dy) < most && std::abs(dx * cos_ - dy * sin_) < most &&
           std::abs(dx * sin_ + dy * cos_) < most;
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

COccupancyGridMap2D turned_grid(const COccupancyGridMap2D& grid, double yaw,
                                const std::string& where) {
  const Turn turn(grid, yaw);
  if (turn.columns() * turn.rows() > static_cast<double>(kMaxCells))
    throw file_error(where, "has too many cells when turned by " + format_number(yaw) + " rad",
                     "at most " + std::to_string(kMaxCells) + " cells");
  const double resolution = grid.getResolution();
  auto result = make_grid_map(
      static_cast<int>(turn.columns()), static_cast<int>(turn.rows()), resolution,
      {grid.getXMin() + turn.low().x * resolution, grid.getYMin() + turn.low().y * resolution});
  for (int y = 0; y < static_cast<int>(result.getSizeY()); ++y)
    for (int x = 0; x < static_cast<int>(result.getSizeX()); ++x)
      result.getRow(y)[x] = turn.free_under(x, y);
  return result;
}

}  // namespace slalom
