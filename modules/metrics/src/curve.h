#pragma once

#include <slalom/trajectory/path.h>

#include <vector>

namespace slalom {

/// Without points less than a millimetre from the one kept before: their directions are rounding.
Path without_close_points(const Path& path);

/// Sum of the absolute changes of direction from piece to piece (rad), pieces of a millimetre or
/// more; a reversal on the spot is pi.
double rotation(const Path& path);

/// Curvatures (1/m) along the path, of circles through each three neighbours (Menger) of points
/// 0.1 m of arc length apart. Between the path's points they lie on a smooth curve, so that the
/// values do not depend on how densely the path was sampled. Empty for a path of less than 0.2 m.
std::vector<double> curvatures(const Path& path);

}  // namespace slalom
