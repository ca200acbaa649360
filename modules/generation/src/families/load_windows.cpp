// SPDX-License-Identifier: BSD-3-Clause
#include "load_windows.h"

#include <algorithm>

namespace slalom {

MapWindows load_windows(const FamilyChecks& checks, const MapWindowOptions& options,
                        const StartGoalOptions& start_goal) {
  checks.expect(!options.map.empty(), "map", "is empty", "a map file");
  checks.expect(static_cast<bool>(checks.context().load_map), "map",
                "cannot be loaded by this program", "a program that reads maps");
  checks.expect(options.min_free + options.min_occupied <= 1, "min_occupied",
                "contradicts min_free", "a sum of at most 1");
  const Scenario map = Scenario::grid(options.map, checks.context().load_map(options.map), {}, {});
  MapWindows windows(make_occupancy(map, map.grid_map()->getResolution()), options);
  const Bounds& all = windows.map().bounds();
  checks.expect_start_goal_fit(
      start_goal, options.width > 0 ? std::min(options.width, all.width()) : all.width(),
      options.height > 0 ? std::min(options.height, all.height()) : all.height());
  return windows;
}

}  // namespace slalom
