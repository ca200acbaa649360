// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/mrpt_nav/holonomic_method.h>

#include <mrpt/math/TPoint2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

namespace slalom {

/// Returns the obstacle points of a scan (m, robot frame), without invalid rays.
std::vector<mrpt::math::TPoint2D> obstacle_points(const mrpt::obs::CObservation2DRangeScan& scan);

/// Returns the distance (m) that a disc of `radius` can move straight in `direction` (rad) before
/// it touches a point, at most `limit`; 0 if it would penetrate a point that it already touches.
double free_distance(const std::vector<mrpt::math::TPoint2D>& points, double direction,
                     double radius, double limit);

/// Center of sector k of n: -pi + (k + 1/2) 2 pi / n, as in MRPT's holonomic methods.
double sector_direction(std::size_t k, std::size_t n);

/// Limits the free distances (m) of the sectors outside the aperture (rad) of a scan.
void limit_unseen(std::vector<double>& distances, double aperture, UnseenSectors unseen,
                  double limit);

/// The full circle, divided evenly.
class Sectors {
 public:
  explicit Sectors(std::size_t count);

  /// free_distance() in the direction of each sector, equal to the bit.
  std::vector<double> free_distances(const std::vector<mrpt::math::TPoint2D>& points, double radius,
                                     double limit) const;

 private:
  std::vector<mrpt::math::TPoint2D> directions_;  ///< unit vectors
};

}  // namespace slalom
