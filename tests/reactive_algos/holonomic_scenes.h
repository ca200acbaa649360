// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/sectors.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace reactive {

constexpr std::size_t kSectors = 120;  // 3 degrees each
constexpr double kDegree = M_PI / 180;

/// An interval of directions, in degrees, with a limited free distance.
struct Block {
  double low, high, free_distance;
};

/// Free except for the blocks.
inline Sectors sectors_with(const std::vector<Block>& blocks) {
  Sectors sectors{std::vector<double>(kSectors, 1.0), 1.0};
  for (std::size_t k = 0; k < kSectors; ++k)
    for (const Block& block : blocks) {
      const double at = sectors.direction(k) / kDegree;
      if (at > block.low && at < block.high)
        sectors.free_distances[k] = std::min(sectors.free_distances[k], block.free_distance);
    }
  return sectors;
}

/// A target in a direction in degrees, by default at the limit of the sectors.
inline Point target_at(double degrees, double distance = 0.98) {
  return {distance * std::cos(degrees * kDegree), distance * std::sin(degrees * kDegree)};
}

}  // namespace reactive
