#pragma once

#include <cmath>

namespace slalom {

/// Distance of two points or poses in the plane, in their unit. std::hypot() rounds better than
/// MRPT's distance() and norm(), on which the last bits of results would depend.
template <typename A, typename B>
double distance_between(const A& a, const B& b) {
  return std::hypot(a.x - b.x, a.y - b.y);
}

}  // namespace slalom
