#pragma once

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

}  // namespace slalom
