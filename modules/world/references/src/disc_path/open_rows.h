// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "occupied_rows.h"

namespace slalom::disc_path {

/// The rows of open cells, prepared when they are first needed: a cell is open if some point of its
/// closed square may be free for a disc of this radius. Paths of the disc stay in open cells; not
/// every path through open cells is free.
class OpenRows {
 public:
  OpenRows(const OccupiedRows& occupied, double radius);

  /// The maximal runs of open cells of row y, which may be outside, from left to right.
  const std::vector<Run>& runs(int y) const;
  /// The run that holds cell x; nullptr if that is not open.
  const Run* find(int x, int y) const;
  /// The first run of row y that ends right of cell x.
  std::vector<Run>::const_iterator first_after(int x, int y) const;

 private:
  void prepare(int y) const;

  const OccupiedRows& occupied_;
  /// How many cells an occupied cell blocks to each side, in rows 0, 1, 2, ... above and below.
  std::vector<int> reach_;
  mutable std::vector<char> is_prepared_;
  mutable std::vector<std::vector<Run>> runs_;
  mutable std::vector<int> change_;  ///< of the number of blocking cells, along a row
  std::vector<Run> none_;
};

}  // namespace slalom::disc_path
