// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/path.h>

#include <vector>

namespace slalom {

/// Removes points less than 1 mm from the previous retained one: their directions are rounding
/// noise.
Path without_close_points(const Path& path);

/// Sum of the absolute changes of direction between segments (rad) of at least 1 mm; a reversal is
/// pi.
double rotation(const Path& path);

/// Curvatures (1/m) along the path: of circles through three consecutive points (Menger) at an arc
/// length of 0.1 m. The points lie on a smooth curve through the path's points, so that the values
/// do not depend on the sampling of the path. Empty for a path of less than 0.2 m.
std::vector<double> curvatures(const Path& path);

}  // namespace slalom
