#pragma once

#include <slalom/scenario/occupancy.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// The rays of one planar scan: `count` angles from -aperture/2 to +aperture/2 (radians, both ends
/// included, counter-clockwise) about the sensor's heading.
struct ScanGeometry {
  int count = 181;
  double aperture = 3.14159265358979323846;
  double max_range = 8.0;  ///< m

  double angle(int i) const {
    return count < 2 ? 0.0 : -0.5 * aperture + aperture * i / (count - 1);
  }
};

/// Exact ray casting on an Occupancy by free-square jumps: for each cell and quadrant the side of the
/// largest free square that starts there; a ray crosses such a square in one step. Tables are made once.
/// The range is the distance to the face (or corner) of the first occupied closed square that the ray
/// enters, computed from cell indexes, not by adding steps up.
class RayCaster {
 public:
  explicit RayCaster(const Occupancy& occupancy);

  /// Range (m) of one ray, at most max_range; 0 when the origin lies in an occupied cell or outside.
  double cast(const mrpt::math::TPoint2D& origin, double angle, double max_range) const;

  /// A whole scan from `pose` (world frame): `ranges` gets geometry.count ranges (m), each at most
  /// max_range (equal to it where nothing is hit).
  void cast_scan(const mrpt::math::TPose2D& pose, const ScanGeometry& geometry,
                 float* ranges) const;

 private:
  int size_x_, size_y_;
  double resolution_;
  mrpt::math::TPoint2D origin_;
  std::vector<std::uint16_t> squares_[4];  ///< per quadrant, with a border of occupied cells
};

}  // namespace slalom
