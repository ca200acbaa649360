#include "cell_rows.h"

#include <algorithm>
#include <cmath>

namespace slalom {

CellRows::CellRows(const CellGrid& grid) : grid_(grid) {
  find_runs();
  find_corners();
}

FreeRun CellRows::run(int cx, int cy) const {
  const std::size_t i = index(cx, cy);
  return {run_first_[i], run_last_[i]};
}

void CellRows::find_runs() {
  run_first_.resize(grid_.blocked.size());
  run_last_.resize(grid_.blocked.size());
  for (int cy = 0; cy < grid_.size_y; ++cy) {
    for (int first = 0; first < grid_.size_x;) {
      int last = first + 1;
      while (last < grid_.size_x && is_blocked(last, cy) == is_blocked(first, cy)) ++last;
      for (int cx = first; cx < last; ++cx) {
        run_first_[index(cx, cy)] = first;
        run_last_[index(cx, cy)] = last;
      }
      first = last;
    }
  }
}

void CellRows::find_corners() {
  corners_of_row_.resize(static_cast<std::size_t>(grid_.size_y) + 2);
  for (int y = 0; y <= grid_.size_y; ++y) {
    corners_of_row_[static_cast<std::size_t>(y)] = corners_.size();
    for (int x = 1; x < grid_.size_x && y > 0 && y < grid_.size_y; ++x) {
      const bool sw = is_blocked(x - 1, y - 1), se = is_blocked(x, y - 1);
      const bool nw = is_blocked(x - 1, y), ne = is_blocked(x, y);
      if (sw + se + nw + ne != 1) continue;
      corners_.push_back({x, y, se || ne ? 1 : -1, nw || ne ? 1 : -1});
    }
  }
  corners_of_row_.back() = corners_.size();
}

std::pair<std::size_t, std::size_t> CellRows::corners_between(int y, double low,
                                                              double high) const {
  const auto row = static_cast<std::size_t>(y);
  const auto begin = corners_.begin() + static_cast<std::ptrdiff_t>(corners_of_row_[row]);
  const auto end = corners_.begin() + static_cast<std::ptrdiff_t>(corners_of_row_[row + 1]);
  const auto first =
      std::lower_bound(begin, end, low, [](const Corner& c, double x) { return c.x < x; });
  const auto last =
      std::upper_bound(first, end, high, [](double x, const Corner& c) { return x < c.x; });
  return {static_cast<std::size_t>(first - corners_.begin()),
          static_cast<std::size_t>(last - corners_.begin())};
}

}  // namespace slalom
