#pragma once

#include "common/sectors.h"

#include <vector>

namespace reactive {

/// A valley of a nearness diagram: directions between two gaps (jumps of the way from one sector to
/// the next), into which at least one of them rises. Ends that rise are where the robot can pass
/// beside an obstacle.
struct Valley {
  Opening span;
  bool rises_low = false, rises_high = false;  ///< at its lower, at its upper end
};

/// All valleys. Gaps are jumps of more than `gap`, and where ways become shorter than `passable`;
/// between two gaps either all sectors are passable or none.
std::vector<Valley> find_valleys(const Sectors& sectors, double gap, double passable);

/// How the free walking area is chosen: the valley with a rising gap nearest to the target, or that
/// holds the target; null where there is none. What stands beyond `horizon` before the target does
/// not count yet.
struct Choice {
  const Valley* valley = nullptr;
  bool holds_target = false;  ///< the way to the target is free within it
  bool low_end = false;       ///< the end that is nearer to the target is the lower one
};
Choice choose_valley(const std::vector<Valley>& valleys, const Sectors& sectors,
                     const Point& target, double horizon);

}  // namespace reactive
