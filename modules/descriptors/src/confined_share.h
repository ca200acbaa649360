#pragma once

#include <slalom/scenario/world.h>

namespace slalom {

/// The golden ratio's fraction: multiples of it turn fans of rays evenly.
constexpr double kGoldenRatio = 0.6180339887498949;

double fraction(double x);  ///< x - floor(x)

/// Share of 64 directions, evenly round the circle and turned by `turn` of the angle between two of
/// them, in which a ray from `place` meets something nearer than `range` (m).
double confined_share(const World& world, const mrpt::math::TPoint2D& place, double range,
                      double turn);

/// Mean over the centres of all free cells of the exact share of directions in which something is
/// nearer than `range` (m); 0 without free cells. Takes time in proportion to free cells times
/// pieces of outline.
double exact_confinement(const Occupancy& cells, double range);

}  // namespace slalom
