// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "disc_geometry.h"

#include <queue>
#include <tuple>
#include <vector>

namespace slalom::disc_path {

/// x = a + b * y.
struct Line {
  double a = 0, b = 0;
  double at(double y) const { return a + b * y; }
};

/// The region that is visible from a root through a window on the line y = row, upwards (direction
/// +1) or downwards (-1), between two limiting rays.
struct Cone {
  int root = 0;
  int row = 0;
  int direction = 0;
  Line low, high;
};

/// In the order in which items of equal length are taken.
enum class Kind { Goal, Root, Cone };

/// Cones to expand, ordered by the least possible length f of a path through each.
class Queue {
 public:
  struct Item {
    double f = 0;
    Kind kind = Kind::Goal;
    int index = 0;                             ///< of the root, or of the cone in the queue
    bool operator<(const Item& other) const {  // for a max-heap: the smallest f first
      return std::tie(f, kind, index) > std::tie(other.f, other.kind, other.index);
    }
  };

  bool empty() const { return items_.empty(); }

  /// Whether a cone of this length may be expanded at once: in any order the search is exact, since
  /// it ends when the goal is the first item.
  bool is_near_top(double f) const {
    constexpr double kSlack = 2;  // cells
    return items_.empty() || f <= items_.top().f + kSlack;
  }

  void push(double f, Kind kind, int root) { items_.push({f, kind, root}); }

  void push(double f, const Cone& cone) {
    int index = static_cast<int>(cones_.size());
    if (unused_.empty()) {
      cones_.push_back(cone);
    } else {
      index = unused_.back();
      unused_.pop_back();
      cones_[static_cast<std::size_t>(index)] = cone;
    }
    items_.push({f, Kind::Cone, index});
  }

  Item pop() {
    const Item item = items_.top();
    items_.pop();
    if (item.kind == Kind::Cone) unused_.push_back(item.index);
    return item;
  }

  /// The cone of the item popped last.
  Cone cone(const Item& item) const { return cones_[static_cast<std::size_t>(item.index)]; }

 private:
  std::priority_queue<Item> items_;
  std::vector<Cone> cones_;
  std::vector<int> unused_;
};

}  // namespace slalom::disc_path
