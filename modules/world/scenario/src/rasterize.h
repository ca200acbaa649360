// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/occupancy.h>

namespace slalom {

/// Occupies every cell whose closed square the obstacle touches. Touching is tested with a
/// tolerance of 1e-9 cells, in favor of touching, so that rounding never opens a gap.
void rasterize(const Disc& disc, Occupancy& cells);
void rasterize(const Polygon& polygon, Occupancy& cells);

}  // namespace slalom
