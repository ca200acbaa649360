// SPDX-License-Identifier: BSD-3-Clause
#include "barn_enclosed.h"

#include <algorithm>
#include <array>
#include <set>
#include <utility>
#include <vector>

namespace slalom {
namespace {

class EnclosedCells {
 public:
  explicit EnclosedCells(NpyTable& grid)
      : grid_(grid), component_(grid.values.size(), kNone), filled_(1, false) {
    for (std::size_t cell = 0; cell < component_.size(); ++cell)
      if (grid_.values[cell] != 1 && component_[cell] == kNone) add_component(cell);
  }

  void fill() {
    while (const std::size_t component = least_consistent()) filled_[component] = false;
    for (std::size_t cell = 0; cell < component_.size(); ++cell)
      if (filled_[component_[cell]]) grid_.values[cell] = 1;
  }

 private:
  static constexpr std::size_t kNone = 0;  // of occupied cells; 0 is never filled

  bool at_border(std::size_t cell) const {
    const std::size_t row = cell / grid_.columns, column = cell % grid_.columns;
    return row == 0 || row + 1 == grid_.rows || column == 0 || column + 1 == grid_.columns;
  }

  std::array<std::size_t, 8> neighbors(std::size_t cell) const {  // of one inside the border
    const std::size_t above = cell - grid_.columns, below = cell + grid_.columns;
    return {above - 1, above, above + 1, cell - 1, cell + 1, below - 1, below, below + 1};
  }

  /// The free cells connected with a cell; to be filled unless they reach the border.
  void add_component(std::size_t cell) {
    const std::size_t component = filled_.size();
    bool is_enclosed = true;
    std::vector<std::size_t> open{cell};
    component_[cell] = component;
    while (!open.empty()) {
      const std::size_t at = open.back();
      open.pop_back();
      if (at_border(at)) {
        is_enclosed = false;
        continue;
      }
      for (const std::size_t next : neighbors(at)) {
        if (grid_.values[next] == 1 || component_[next] == component) continue;
        component_[next] = component;
        open.push_back(next);
      }
    }
    filled_.push_back(is_enclosed);
  }

  bool is_occupied(std::size_t cell) const {
    return grid_.values[cell] == 1 || filled_[component_[cell]];
  }

  /// The filled component beside the most cylinders that would not be written; 0 if there are none.
  std::size_t least_consistent() const {
    std::vector<int> conflicts(filled_.size(), 0);
    for (std::size_t cell = 0; cell < component_.size(); ++cell) {
      if (grid_.values[cell] != 1 || at_border(cell)) continue;
      const auto around = neighbors(cell);
      if (!std::all_of(around.begin(), around.end(), [&](auto next) { return is_occupied(next); }))
        continue;
      std::set<std::size_t> beside;
      for (const std::size_t next : around) beside.insert(component_[next]);
      for (const std::size_t component : beside) conflicts[component] += filled_[component] ? 1 : 0;
    }
    const auto most = std::max_element(conflicts.begin(), conflicts.end());
    return *most == 0 ? kNone : static_cast<std::size_t>(most - conflicts.begin());
  }

  NpyTable& grid_;
  std::vector<std::size_t> component_;
  std::vector<bool> filled_;
};

}  // namespace

void fill_enclosed(NpyTable& grid) {
  EnclosedCells(grid).fill();
}

}  // namespace slalom
