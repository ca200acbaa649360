// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/trajectory/path.h>

namespace slalom {

/// Hausdorff distance (m) of two non-empty polylines, over all their points (not only vertices), to
/// within 1e-6 m.
double hausdorff_distance(const Path& a, const Path& b);

/// Frechet distance (m) of two non-empty polylines (Alt and Godau 1995), to within 1e-6 m.
double frechet_distance(const Path& a, const Path& b);

}  // namespace slalom
