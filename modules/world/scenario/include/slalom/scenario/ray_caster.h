// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/shared_array.h>
#include <slalom/scenario/occupancy.h>

#include <cmath>
#include <cstdint>
#include <vector>

namespace slalom {

struct ScanOrigin;

/// The rays of one planar scan: `count` angles from -aperture/2 to +aperture/2 (radians, both ends
/// included, counter-clockwise) relative to the sensor's heading.
struct ScanGeometry {
  int count = 181;
  double aperture = M_PI;
  double max_range = 8.0;  ///< m

  double angle(int i) const {
    return count < 2 ? 0.0 : -0.5 * aperture + aperture * i / (count - 1);
  }
};

/// Exact ray casting on an Occupancy from one free rectangle to the next: a table holds for each
/// cell and quadrant a free rectangle that starts there; a ray crosses it in one step.
/// The range is the smallest t >= 0 at which the ray is on or in an occupied closed square or the
/// border of the grid: a ray that only touches a corner, or that runs along the border of an
/// occupied cell, is blocked there. Touching is tested with a tolerance of 1e-9 cells at corners,
/// so that rays at special angles do not depend on rounding; a ray that passes closer than that
/// without touching may be blocked or not. Crossings are computed from cell indexes, not by
/// accumulating steps; at a corner the range is that to the nearer of its lines. So ranges do not
/// depend on the choice of rectangles.
class RayCaster {
 public:
  /// Computes the tables, or uses those that write() wrote for this occupancy, where they are.
  /// Throws Error (Job) when these are malformed.
  explicit RayCaster(const Occupancy& occupancy, ArrayReader* written = nullptr);
  void write(ArrayWriter& writer) const;

  /// Range (m) of one ray, at most max_range; 0 when the origin lies in or on an occupied cell, on
  /// the border of the workspace or outside, or is not finite.
  double cast(const mrpt::math::TPoint2D& origin, double angle, double max_range) const;
  /// The same in the direction of a unit vector.
  double cast(const mrpt::math::TPoint2D& origin, const mrpt::math::TPoint2D& direction,
              double max_range) const;

  /// A complete scan from `pose` (world frame): `ranges` gets geometry.count ranges (m), each at
  /// most max_range (equal to it where nothing is hit).
  void cast_scan(const mrpt::math::TPose2D& pose, const ScanGeometry& geometry,
                 float* ranges) const;

 private:
  /// A ray in a frame (cells) mirrored so that the ray goes up and to the right.
  struct Ray {
    double x = 0, y = 0;    ///< origin
    double dx = 0, dy = 0;  ///< direction, not negative
    const std::uint8_t* rectangles = nullptr;
  };

  std::size_t table_size() const { return 4 * plane_; }  ///< elements of `rectangles_`
  std::vector<std::uint8_t> free_rectangles(const Occupancy& occupancy) const;
  Ray make_ray(const mrpt::math::TPoint2D& origin, double cosine, double sine) const;
  bool starts_free(const Ray& ray) const;
  /// Range (cells), at most limit, of a ray that starts free.
  double trace(const Ray& ray, double limit) const;
  double trace_oblique(const Ray& ray, double limit) const;
  double trace_parallel(const std::uint8_t* rectangles, double along, double across,
                        std::size_t step_along, std::size_t step_across, int extent_shift) const;
  bool touches_corner(const std::uint8_t* rectangles, int x, int y) const;
  ScanOrigin scan_origin(const Ray& straight, double heading, double max_range) const;
  std::size_t plane_of(bool left, bool down) const {
    return plane_ * ((left ? 1U : 0U) + (down ? 2U : 0U));
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y + 1) * stride_ + static_cast<std::size_t>(x + 1);
  }

  int size_x_, size_y_;
  std::size_t stride_, plane_;
  double resolution_;
  mrpt::math::TPoint2D origin_;
  /// Four planes (rays to the right or left, up or down), each the grid mirrored so that rays go up
  /// and to the right: the codes (free_rectangles.h) of the width and height of a free rectangle
  /// whose lower left cell this is, 0 where occupied; with a border of occupied cells.
  SharedArray<std::uint8_t> rectangles_;
};

}  // namespace slalom
