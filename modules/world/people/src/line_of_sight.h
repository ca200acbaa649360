// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "vectors.h"

#include <slalom/scenario/ray_caster.h>

namespace slalom {

/// Whether no wall is between two points, which are not that close to walls themselves.
inline bool is_in_sight(const RayCaster& caster, const mrpt::math::TPoint2D& from,
                        const mrpt::math::TPoint2D& to) {
  constexpr double kRounding = 1e-6;  // m
  const mrpt::math::TPoint2D offset = to - from;
  const double distance = norm(offset);
  return distance <= kRounding ||
         caster.cast(from, offset * (1 / distance), distance) >= distance - kRounding;
}

}  // namespace slalom
