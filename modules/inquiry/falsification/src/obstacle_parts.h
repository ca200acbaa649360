// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/scenario.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// The obstacles of a scenario as parts that can be removed: primitives; the connected groups of
/// occupied cells of a grid, or its blocks of block x block cells; the points in squares of the
/// plane. Each mover is a part, after the others, and each person, after the movers.
class ObstacleParts {
 public:
  /// `block`: side (cells) of the blocks of a grid, 0 for connected groups (8 neighbors). Points
  /// are in squares of `block` times `resolution` (m); 0 for 32.
  ObstacleParts(const Scenario& scenario, int block, double resolution);

  std::size_t size() const { return descriptions_.size(); }
  /// The scenario with these parts only, in ascending order.
  Scenario keep(const std::vector<std::size_t>& parts) const;
  Scenario without(std::size_t part) const;
  const std::string& description(std::size_t part) const { return descriptions_[part]; }

 private:
  void divide_primitives();
  void divide_cells(int block);
  void divide_points(double side);

  Scenario scenario_;
  std::vector<std::size_t> part_of_;  ///< by obstacle: discs then polygons, cells or points
  std::vector<std::string> descriptions_;
  std::size_t static_parts_ = 0;  ///< without movers and people
};

}  // namespace slalom
