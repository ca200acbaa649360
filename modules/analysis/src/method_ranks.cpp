#include <slalom/analysis/method_ranks.h>
#include <slalom/analysis/scenario_means.h>
#include <slalom/core/error.h>

#include <algorithm>

namespace slalom {

MethodRanks build_method_ranks(const RunColumns& table, const std::string& metric,
                               const AnalysisOptions& options) {
  require_valid(options);
  MethodRanks ranks;
  ranks.column = resolve_columns(table, {metric})[0];
  ranks.methods = table.methods;
  ranks.alpha = 1 - options.confidence;
  const Direction direction = ranks.column.info.direction;
  if (direction == Direction::None) {
    throw usage_error("ranks", "'" + metric + "' has no direction",
                      "a metric that is better up or down");
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
    if (row.size() == means.size()) values.push_back(row);
    if (row.size() != means.size() && !row.empty()) ++ranks.left_out;
  }
  if (means.size() < 2 || values.size() < 2) {
    throw usage_error("ranks", "fewer than two methods with two scenarios in common in " + metric,
                      "more runs, or a metric that failed runs have too, such as spl");
  }
  ranks.test = friedman_test(values, direction == Direction::Up, ranks.alpha);
  return ranks;
}

}  // namespace slalom
