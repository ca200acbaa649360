// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "common/sectors.h"

#include <vector>

namespace reactive {

/// A valley of a nearness diagram: directions between two gaps (discontinuities of the free
/// distance between adjacent sectors), at least one of which is rising. At a rising end the robot
/// can pass an obstacle.
struct Valley {
  Opening span;
  bool rises_low = false, rises_high = false;  ///< at its lower and upper end
};

/// Returns all valleys. Gaps are discontinuities of more than `gap` and transitions across
/// `passable`; between two gaps either all sectors are passable or none.
std::vector<Valley> find_valleys(const Sectors& sectors, double gap, double passable);

/// The selected free walking area: the valley that contains the target, or the one with the rising
/// gap closest to the target; null if there is none. Obstacles beyond `horizon` are ignored.
struct Choice {
  const Valley* valley = nullptr;
  bool contains_target = false;  ///< the path to the target within it is free
  bool low_end = false;          ///< the lower end is the one closer to the target
};
Choice choose_valley(const std::vector<Valley>& valleys, const Sectors& sectors,
                     const Point& target, double horizon);

}  // namespace reactive
