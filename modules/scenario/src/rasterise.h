#pragma once

#include <slalom/scenario/occupancy.h>

namespace slalom {

/// Occupies every cell whose closed square the obstacle touches. Touching is judged with a
/// tolerance of 1e-9 of a cell, in favour of touching, so that rounding never opens a gap.
void rasterise(const Disc& disc, Occupancy& cells);
void rasterise(const Polygon& polygon, Occupancy& cells);

}  // namespace slalom
