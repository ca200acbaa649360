// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cell.h>

#include <string>
#include <vector>

namespace slalom {

/// A step of a profile: the fraction of scenarios with a ratio to the best of at most `ratio`.
struct ProfileStep {
  double ratio = 1;
  double fraction = 0;
};

struct PerformanceProfile {
  std::string method;
  std::size_t without_value = 0;  ///< scenarios without a value; they count as not within any ratio
  std::vector<ProfileStep> steps;  ///< by increasing ratio; the first at 1 (fraction of wins)
};

struct ProfileTable {
  Column column;
  std::size_t scenarios = 0;  ///< in which some method has a value
  std::size_t left_out = 0;   ///< in which none has
  std::vector<PerformanceProfile> profiles;
};

/// Performance profiles (Dolan and More 2002) of a metric over scenarios: r = value / best of all
/// methods, or best / value if more is better. Throws Error (Usage) for a metric without
/// direction or with values that are not positive.
ProfileTable build_profiles(const ResultTable& table, const std::string& metric);

}  // namespace slalom
