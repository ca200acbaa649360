#pragma once

#include <mrpt/math/TPoint2D.h>
#include <mrpt/obs/CObservation2DRangeScan.h>

#include <vector>

namespace slalom {

/// The obstacle points of a scan (m, robot frame), those that met nothing left out.
std::vector<mrpt::math::TPoint2D> obstacle_points(const mrpt::obs::CObservation2DRangeScan& scan);

/// How far (m) a disc of `radius` can go straight in `direction` (rad) before it touches a point,
/// at most `limit`; 0 when it would go deeper into a point that it already touches.
double free_travel(const std::vector<mrpt::math::TPoint2D>& points, double direction, double radius,
                   double limit);

/// Centre of sector k of n: -pi + (k + 1/2) 2 pi / n, as MRPT's holonomic methods count them.
double sector_direction(std::size_t k, std::size_t n);

}  // namespace slalom
