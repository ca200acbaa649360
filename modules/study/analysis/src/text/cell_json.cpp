// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cell_json.h>
#include <slalom/analysis/findings.h>

#include <nlohmann/json.hpp>

namespace slalom {

using nlohmann::ordered_json;

ordered_json number_or_null(const std::optional<double>& number) {
  return number ? ordered_json(*number) : ordered_json(nullptr);
}

ordered_json interval_json(const std::optional<Interval>& interval) {
  return interval ? ordered_json{interval->low, interval->high} : ordered_json(nullptr);
}

ordered_json cell_json(const Cell& cell) {
  ordered_json json = {{"n", cell.available},
                       {"na", ordered_json::object()},
                       {"mean", number_or_null(cell.estimate)},
                       {"deviation", number_or_null(cell.deviation)},
                       {"median", number_or_null(cell.median)},
                       {"median_interval", interval_json(cell.median_interval)},
                       {"interval", interval_json(cell.interval)}};
  if (!cell.interval_na.empty()) json["interval_na"] = cell.interval_na;
  for (const auto& [reason, n] : cell.na) json["na"][reason] = n;
  return json;
}

ordered_json trends_json(const CrossTable& table) {
  ordered_json json = ordered_json::array();
  for (std::size_t column = 0; column < table.trends.size(); ++column) {
    if (!table.trends[column]) continue;
    const Trend& trend = *table.trends[column];
    json.push_back({{"metric", table.columns[column].info.id},
                    {"test", to_string(trend.test.kind)},
                    {"z", trend.test.z},
                    {"p", trend.test.p},
                    {"adjusted_p", trend.adjusted_p},
                    {"bins", trend.bins},
                    {"scenarios", trend.scenarios},
                    {"shown", is_shown(trend, table.confidence)}});
  }
  return json;
}

}  // namespace slalom
