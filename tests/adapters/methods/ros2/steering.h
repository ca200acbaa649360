// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cmath>
#include <cstddef>

namespace slalom {

struct Steering {
  double v = 0, w = 0;
};

/// Away from near obstacles: each range affects the last bits of the trajectory. A range without
/// return may be the maximum range or infinite.
inline Steering steer(const float* ranges, std::size_t count, float angle_min,
                      float angle_increment) {
  double turn = 0, front = 8;
  for (std::size_t i = 0; i < count; ++i) {
    const double angle = static_cast<double>(angle_min) +
                         static_cast<double>(angle_increment) * static_cast<double>(i);
    const double range = static_cast<double>(ranges[i]);
    if (range < 2) turn -= std::sin(angle) / (0.1 + range) * (2 - range) * 0.02;
    if (std::abs(angle) < 0.4 && range < front) front = range;
  }
  return {front > 1.5 ? 0.7 : front > 0.6 ? 0.3 : 0.05, turn > 1 ? 1 : turn < -1 ? -1 : turn};
}

}  // namespace slalom
