// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <vector>

namespace reactive {

/// Shortest paths on a square grid with 8 directions, as a wavefront of integer costs. A step costs
/// 10 or 14 (diagonal) times the weight of the cell that it enters; weights are 10 or more.
struct Wavefront {
  static constexpr std::int32_t kStraight = 10, kDiagonal = 14;
  static constexpr std::int32_t kMinWeight = 10;
  static constexpr std::int32_t kUnreached = std::numeric_limits<std::int32_t>::max();
  /// Cost of a blocked cell, which nothing improves, and what is ahead of a cell of the border.
  static constexpr std::int32_t kBlocked = -1, kBorder = -1;
  static constexpr std::int32_t kBucketWidth = kStraight * kMinWeight;  ///< the cheapest step

  struct Entry {
    std::int32_t cell;
    std::int32_t cost;  ///< with which it was appended; later it may have been improved
  };

  /// Changes the grid; all values are undefined then.
  void resize(int cells_per_side);

  /// Lowers the cost of a cell, if it is higher. Cells of the border are not expanded: a path
  /// through them is longer than one beside them.
  void improve(std::size_t cell, std::int32_t cost) {
    if (cost >= costs[cell]) return;
    costs[cell] = cost;
    if (ahead[cell] == kBorder) return;
    const auto bucket = static_cast<std::size_t>(cost + ahead[cell]) / kBucketWidth;
    if (bucket >= buckets.size()) buckets.resize(bucket + 1);
    buckets[bucket].push_back({static_cast<std::int32_t>(cell), cost});
  }

  /// Removes all cells from the buckets.
  void clear();

  /// Expands cells in the order of cost plus `ahead` until the cost of `target` is final, or all
  /// that can be reached are. Vectorized for the processor at run time.
  void spread_to(std::size_t target);
  /// Expands the buckets before `end`.
  void spread_before(std::size_t end);

  /// Whether costs in this bucket are final where nothing is ahead.
  bool is_final(std::int32_t cost) const {
    return static_cast<std::size_t>(cost) / kBucketWidth < next_bucket;
  }

  int side = 0;
  std::vector<std::int32_t> costs;
  std::vector<std::int32_t> weights;  ///< those of blocked cells are not read
  /// Lower bounds of the costs from cells to the ones that matter, which no step reduces by more
  /// than its cost; kBorder for the first and last rows and columns.
  std::vector<std::int32_t> ahead;
  std::vector<std::vector<Entry>> buckets;  ///< of improved cells, by cost plus `ahead`
  std::size_t next_bucket = 0;              ///< the first one that was not expanded
};

}  // namespace reactive
