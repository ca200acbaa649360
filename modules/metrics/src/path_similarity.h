#pragma once

#include <slalom/trajectory/path.h>

namespace slalom {

/// Hausdorff distance (m) of two paths that are not empty: the farthest that any point of either,
/// vertex or not, is from the other; to within 1e-6 m.
double hausdorff_distance(const Path& a, const Path& b);

/// Frechet distance (m) of two paths that are not empty: the shortest leash with which one can walk
/// along a and another along b, neither ever going back (Alt and Godau 1995); to within 1e-6 m.
double frechet_distance(const Path& a, const Path& b);

}  // namespace slalom
