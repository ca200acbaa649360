// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/inquiry/tune_search.h>
#include <slalom/statistics/statistics.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// Success with a choice of a parameter, or in a third of its range.
struct ParameterLevel {
  std::string text;  ///< the choice, or the range of the values that were tried
  std::size_t configurations = 0;
  double rate = 0;  ///< mean over these
  Interval interval;
};

struct ParameterEffect {
  std::size_t parameter = 0;
  std::vector<ParameterLevel> levels;  ///< from low to high; only those that were tried
};

/// The mean success by levels of each parameter, while the others are spread evenly over the space:
/// that of the first iteration of a search, with the scenarios in which all of its configurations
/// were run. Later runs are left out, since the better configurations have more of them, and later
/// configurations, since their parameters depend on each other.
///
/// Intervals are of the mean over configurations in these scenarios, which are the same for all
/// levels: levels can be compared, but the rates are not those in other scenarios.
std::vector<ParameterEffect> main_effects(const ParameterSpace& space, const TuneResult& result,
                                          double confidence);

}  // namespace slalom
