// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "family.h"

#include <slalom/generation/straight_path.h>

#include <mrpt/math/TPose2D.h>

namespace slalom {

/// m, added to distances so that rounding makes none less than required.
constexpr double kRounding = 1e-9;

/// -1 or 1.
double sample_side(RandomEngine& engine);

/// The start heading (rad, in (-pi, pi]) for an axis along x.
double sample_angle(RandomEngine& engine, const StartAngleOptions& options);

/// Start, place and goal are on an axis along x, in the middle quarter of the height, anywhere
/// relative to the cells of grids.
struct StraightPath {
  mrpt::math::TPose2D start;
  mrpt::math::TPoint2D place, goal;
};

StraightPath sample_straight_path(RandomEngine& engine, const StraightPathOptions& options);

/// m, from the path to the border on either side, at least.
inline double room_beside(const StraightPathOptions& options) {
  return 3 * options.height / 8;
}

void expect_valid(const FamilyChecks& checks, const StartAngleOptions& options);
void expect_valid(const FamilyChecks& checks, const StraightPathOptions& options);

}  // namespace slalom
