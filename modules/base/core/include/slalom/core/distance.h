// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/core/math.h>

#include <cmath>

namespace slalom {

/// Distance of two points or poses in the plane, in their unit. math::hypot() rounds better than
/// MRPT's distance() and norm(), on which the last bits of results would depend.
template <typename A, typename B>
double distance_between(const A& a, const B& b) {
  return math::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace slalom
