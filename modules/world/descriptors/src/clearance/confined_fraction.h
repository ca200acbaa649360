// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/world.h>

namespace slalom {

/// Fractional part of the golden ratio; its multiples distribute rotations of ray fans evenly.
constexpr double kGoldenRatio = 0.6180339887498949;

double fractional_part(double x);  ///< x - floor(x)

/// Fraction of 64 equally spaced directions, rotated by `turn` times their spacing, in which a ray
/// from `point` hits an obstacle closer than `range` (m).
double confined_fraction(const World& world, const mrpt::math::TPoint2D& point, double range,
                         double turn);

/// Mean over the free space of the exact fraction of directions with an obstacle closer than
/// `range` (m), by Gauss-Legendre quadrature within each free cell (4 x 4 points if an occupied
/// cell is within two cells, else 2 x 2); 0 without free cells. Time: proportional to free cells
/// times boundary edges.
double exact_confinement(const Occupancy& cells, double range);

}  // namespace slalom
