// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_means.h"

#include <slalom/analysis/performance_profile.h>
#include <slalom/core/error.h>

#include <algorithm>

namespace slalom {
namespace {

void require_positive(const std::vector<std::optional<double>>& means, const std::string& metric) {
  for (const auto& value : means) {
    if (!value || *value > 0) continue;
    throw usage_error("--profile", "'" + metric + "' has nonpositive values",
                      "a positive metric, such as time_to_goal");
  }
}

/// Steps from the ratios of the scenarios with a value.
std::vector<ProfileStep> steps_of(std::vector<double> ratios, std::size_t scenarios) {
  std::sort(ratios.begin(), ratios.end());
  std::vector<ProfileStep> steps = {{1, 0}};
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    const double fraction = static_cast<double>(i + 1) / static_cast<double>(scenarios);
    if (ratios[i] > steps.back().ratio) steps.push_back({ratios[i], fraction});
    steps.back().fraction = fraction;
  }
  return steps;
}

}  // namespace

ProfileTable build_profiles(const ResultTable& table, const std::string& metric) {
  ProfileTable result;
  result.column = resolve_columns(table, {metric})[0];
  const Direction direction = result.column.info.direction;
  if (direction == Direction::None) {
    throw usage_error("--profile", "'" + metric + "' has no direction",
                      "a metric with a direction (up or down is better)");
  }
  std::vector<std::vector<std::optional<double>>> means;
  for (std::uint32_t method = 0; method < table.methods.size(); ++method) {
    means.push_back(scenario_means(table, method, require_metric(table, metric)));
    require_positive(means.back(), metric);
    result.profiles.push_back({table.methods[method], 0, {}});
  }
  std::vector<std::vector<double>> ratios(means.size());
  for (std::size_t scenario = 0; scenario < table.scenario_hashes.size(); ++scenario) {
    std::optional<double> best;
    for (const auto& method : means) {
      if (!method[scenario]) continue;
      const double value = *method[scenario];
      const bool better = !best || (direction == Direction::Up ? value > *best : value < *best);
      if (better) best = value;
    }
    if (!best) {
      ++result.left_out;
      continue;
    }
    ++result.scenarios;
    for (std::size_t i = 0; i < means.size(); ++i) {
      if (!means[i][scenario]) {
        ++result.profiles[i].without_value;
        continue;
      }
      const double value = *means[i][scenario];
      ratios[i].push_back(direction == Direction::Up ? *best / value : value / *best);
    }
  }
  for (std::size_t i = 0; i < ratios.size(); ++i) {
    result.profiles[i].steps =
        steps_of(std::move(ratios[i]), std::max<std::size_t>(1, result.scenarios));
  }
  return result;
}

}  // namespace slalom
