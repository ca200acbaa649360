// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/scenario/occupancy.h>

#include <array>
#include <cstdint>
#include <vector>

namespace slalom {

/// The column and row of a cell of a grid.
struct CellIndex {
  int cx, cy;
};

/// The occupied cells, divided into 4-connected parts that have no holes: each component that
/// encloses free cells (8-connected) is cut along the minimal set of rows that intersects every
/// hole.
class CellParts {
 public:
  explicit CellParts(const Occupancy& cells);

  /// The number of the part of an occupied cell inside the grid; -1 for free cells.
  std::int32_t part(int cx, int cy) const { return labels_[cells_.index(cx, cy)]; }
  /// Whether (cx, cy) is a cell of that part (false outside the grid).
  bool belongs(int cx, int cy, std::int32_t part) const {
    return cells_.inside(cx, cy) && this->part(cx, cy) == part;
  }
  /// The leftmost cell of the lowest row of each part.
  const std::vector<CellIndex>& first_cells() const { return first_cells_; }
  const Occupancy& cells() const { return cells_; }

 private:
  struct RowSpan {
    int first, last;
  };
  using Cuts = std::vector<std::vector<int>>;  ///< by component: rows whose lower border is a cut

  template <typename Connected>
  void label_components(bool occupied, const std::vector<CellIndex>& steps,
                        const Connected& connected);
  Cuts find_cuts();

  const Occupancy& cells_;
  std::vector<std::int32_t> labels_;
  std::vector<CellIndex> first_cells_;
  std::vector<RowSpan> spans_;   ///< rows of each component of the last labeling
  std::vector<bool> at_border_;  ///< whether it has a cell on the grid's border
};

}  // namespace slalom
