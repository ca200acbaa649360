// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <mrpt/math/TPoint2D.h>

#include <cstddef>
#include <vector>

namespace slalom {

/// A half plane of velocities v (m/s): normal v >= least. In this form a problem that is turned by
/// 90 degrees or mirrored has a solution of the same bits.
struct VelocityBound {
  mrpt::math::TPoint2D normal;  ///< of length 1
  double least = 0;             ///< m/s
};

/// The velocity nearest to `wanted` among those up to `max_speed` that keep all bounds. If there is
/// none, it keeps the first `hard` bounds, and its greatest violation of another one is least (van
/// den Berg, Guy, Lin and Manocha 2011). Rest keeps the hard bounds (their `least` is at most 0);
/// it is returned where rounding leaves nothing between two of them.
mrpt::math::TPoint2D best_velocity(const std::vector<VelocityBound>& bounds, std::size_t hard,
                                   double max_speed, const mrpt::math::TPoint2D& wanted);

}  // namespace slalom
