#pragma once

#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace slalom {

/// Positions without time, joined by straight segments (m, world frame).
using Path = std::vector<mrpt::math::TPoint2D>;

double length(const Path& path);

/// Distance from p to the nearest point of the path; requires a path that is not empty.
double distance_to_path(const mrpt::math::TPoint2D& p, const Path& path);

/// Points along the path at most `spacing` apart, its vertices included.
Path resample(const Path& path, double spacing);

}  // namespace slalom
