#pragma once

#include <slalom/analysis/cell.h>

#include <string>
#include <vector>

namespace slalom {

/// A step: from this ratio to the best on, the method is within it in that share of scenarios.
struct ProfileStep {
  double ratio = 1;
  double share = 0;
};

struct PerformanceProfile {
  std::string method;
  std::size_t without_value = 0;   ///< scenarios that it has no value in: within no ratio
  std::vector<ProfileStep> steps;  ///< by increasing ratio; the first is at 1 (share of wins)
};

struct ProfileTable {
  Column column;
  std::size_t scenarios = 0;  ///< in which some method has a value
  std::vector<PerformanceProfile> profiles;
};

/// Performance profiles (Dolan and More 2002) of a metric over scenarios: r = value / best of all
/// methods, or best / value where more is better. Throws Error (Usage) for a metric without
/// direction or with values that are not positive.
ProfileTable build_profiles(const RunColumns& table, const std::string& metric);

}  // namespace slalom
