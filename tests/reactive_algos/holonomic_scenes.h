#pragma once

#include "common/sectors.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace reactive {

constexpr std::size_t kSectors = 120;  // 3 degrees each
constexpr double kDegree = kPi / 180;

/// A part of the circle, in degrees, in which the way ends early.
struct Block {
  double low, high, way;
};

/// Free but for the blocks.
inline Sectors sectors_with(const std::vector<Block>& blocks) {
  Sectors sectors{std::vector<double>(kSectors, 1.0), 1.0};
  for (std::size_t k = 0; k < kSectors; ++k)
    for (const Block& block : blocks) {
      const double at = sectors.direction(k) / kDegree;
      if (at > block.low && at < block.high) sectors.ways[k] = std::min(sectors.ways[k], block.way);
    }
  return sectors;
}

/// A target in a direction in degrees, as far as the sectors show.
inline Point target_at(double degrees, double distance = 0.98) {
  return {distance * std::cos(degrees * kDegree), distance * std::sin(degrees * kDegree)};
}

}  // namespace reactive
