// SPDX-License-Identifier: BSD-3-Clause
#include "../descriptor_parameters.h"

#include <slalom/core/math.h>
#include <slalom/core/text.h>

#include <algorithm>
#include <cmath>
#include <numeric>

namespace slalom::descriptors {
namespace {

constexpr double kBlock = 1;        ///< m
constexpr int kMaxBlock = 1 << 29;  ///< cells; twice that fits an int

/// Entropy (bit) times the number of cells of the block x0 <= x < x1, y0 <= y < y1.
double entropy_of_block(const Occupancy& cells, int x0, int y0, int x1, int y1) {
  std::size_t occupied = 0;
  for (int y = y0; y < y1; ++y) {
    const std::uint8_t* const row = cells.cells().data() + cells.index(0, y);
    occupied = std::accumulate(row + x0, row + x1, occupied);
  }
  const double all = static_cast<double>(x1 - x0) * (y1 - y0);
  const double fraction = static_cast<double>(occupied) / all;
  if (occupied == 0 || fraction == 1) return 0;
  return -all * (fraction * math::log2(fraction) + (1 - fraction) * math::log2(1 - fraction));
}

}  // namespace

std::string block(const DescriptorContext&) {
  return "block=" + format_number(kBlock);
}

/// Mean over square blocks of the binary entropy (bit) of their occupied fraction; blocks clipped
/// by the border are weighted by their area.
Value occupancy_entropy(const DescriptorContext& context) {
  const Occupancy& cells = context.world.occupancy();
  // Blocks of one cell would have zero entropy.
  const int side = static_cast<int>(
      std::clamp(std::round(kBlock / cells.resolution()), 2.0, static_cast<double>(kMaxBlock)));
  double sum = 0;
  for (int y = 0; y < cells.size_y(); y += side)
    for (int x = 0; x < cells.size_x(); x += side)
      sum += entropy_of_block(cells, x, y, std::min(x + side, cells.size_x()),
                              std::min(y + side, cells.size_y()));
  return Value::of(sum / static_cast<double>(cells.cells().size()));
}

}  // namespace slalom::descriptors
