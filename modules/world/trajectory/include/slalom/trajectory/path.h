// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <vector>

namespace slalom {

/// A polyline of positions (m, world frame).
using Path = std::vector<mrpt::math::TPoint2D>;

double length(const Path& path);

/// Distance from p to the nearest point of the path; requires a non-empty path.
double distance_to_path(const mrpt::math::TPoint2D& p, const Path& path);

/// Points along the path with distances of at most `spacing`, including its vertices.
Path resample(const Path& path, double spacing);

}  // namespace slalom
