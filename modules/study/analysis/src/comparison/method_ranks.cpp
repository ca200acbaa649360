// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_means.h"

#include <slalom/analysis/method_ranks.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

#include <algorithm>

namespace slalom {

MethodRanks build_method_ranks(const ResultTable& table, const std::string& metric,
                               const AnalysisOptions& options) {
  require_valid(options);
  MethodRanks ranks;
  ranks.column = resolve_columns(table, {metric})[0];
  ranks.methods = table.methods;
  ranks.alpha = test_level(options.confidence);
  const Direction direction = ranks.column.info.direction;
  if (direction == Direction::None) {
    throw usage_error("--ranks", "'" + metric + "' has no direction",
                      "a metric with a direction (up or down is better)");
  }
  std::vector<std::vector<std::optional<double>>> means;
  for (std::uint32_t method = 0; method < table.methods.size(); ++method) {
    means.push_back(scenario_means(table, method, require_metric(table, metric)));
  }
  std::vector<std::vector<double>> values;
  for (std::size_t scenario = 0; scenario < table.scenario_hashes.size(); ++scenario) {
    std::vector<double> row;
    for (const auto& method : means) {
      if (method[scenario]) row.push_back(*method[scenario]);
    }
    if (row.size() == means.size()) {
      values.push_back(row);
    } else {
      ++(row.empty() ? ranks.without_value : ranks.left_out);
    }
  }
  if (means.size() < 2 || values.size() < 2) {
    throw usage_error("--ranks", "fewer than two methods with two scenarios in common in " + metric,
                      "more runs, or a metric that failed runs have too, such as spl");
  }
  ranks.test = friedman_test(values, direction == Direction::Up, ranks.alpha);
  return ranks;
}

std::string left_out_text(const MethodRanks& ranks) {
  std::vector<std::string> parts;
  if (ranks.left_out > 0)
    parts.push_back(std::to_string(ranks.left_out) + " in which not every method has a value");
  if (ranks.without_value > 0)
    parts.push_back(std::to_string(ranks.without_value) + " in which none has");
  return join(parts, ", ");
}

}  // namespace slalom
