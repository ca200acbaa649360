#pragma once

#include <slalom/references/any_angle.h>

#include <cstdint>
#include <vector>

namespace slalom {

/// A vertex at which a path may turn: exactly one of its four cells is blocked, the one in quadrant
/// (side_x, side_y), each -1 or +1.
struct Corner {
  int x = 0, y = 0;
  int side_x = 0, side_y = 0;
};

/// A maximal run of free cells in a row: cells first .. last - 1, so x in [first, last].
struct FreeRun {
  int first = 0, last = 0;
};

/// The rows of a CellGrid prepared for interval search: runs of free cells and corners, by row.
class CellRows {
 public:
  explicit CellRows(const CellGrid& grid);

  bool is_blocked(int cx, int cy) const { return grid_.is_blocked(cx, cy); }
  int size_x() const { return grid_.size_x; }
  int size_y() const { return grid_.size_y; }

  /// The run of the free cell (cx, cy).
  FreeRun run(int cx, int cy) const;

  /// The runs of row cy that overlap [low, high] by more than a point, left to right.
  template <typename Visit>
  void for_runs(int cy, double low, double high, Visit visit) const;

  const std::vector<Corner>& corners() const { return corners_; }
  /// Indexes [begin, end) of the corners on line y with low <= x <= high.
  std::pair<std::size_t, std::size_t> corners_between(int y, double low, double high) const;

 private:
  std::size_t index(int cx, int cy) const {
    return static_cast<std::size_t>(cy) * static_cast<std::size_t>(grid_.size_x) +
           static_cast<std::size_t>(cx);
  }
  void find_runs();
  void find_corners();

  const CellGrid& grid_;
  /// Per cell: first and one past the last cell of the maximal run of cells of the same kind.
  std::vector<std::int32_t> run_first_, run_last_;
  std::vector<Corner> corners_;              ///< by y, then x
  std::vector<std::size_t> corners_of_row_;  ///< index of the first corner of each line
};

template <typename Visit>
void CellRows::for_runs(int cy, double low, double high, Visit visit) const {
  constexpr double kMinWidth = 1e-9;  // cells; a touching point is not a passage
  if (cy < 0 || cy >= grid_.size_y) return;
  int cx = low > 0 ? static_cast<int>(low) : 0;
  while (cx < grid_.size_x && cx < high - kMinWidth) {
    const std::size_t i = index(cx, cy);
    if (!is_blocked(cx, cy) && run_last_[i] > low + kMinWidth)
      visit(FreeRun{run_first_[i], run_last_[i]});
    cx = run_last_[i];
  }
}

}  // namespace slalom
