// SPDX-License-Identifier: BSD-3-Clause
#include "../comparison/robustness.h"
#include "row_table.h"

#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/error.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

DataTable curve_table(const RobustnessTable& table, const RobustnessCurve& curve,
                      const std::vector<ResultTable>& results, bool exact) {
  const std::string& metric = curve.column.info.id;
  RowTable rows(curve.method + "_" + metric,
                curve.method + ": " + metric + " by " + table.parameter);
  for (const RobustnessPoint& point : curve.points) {
    rows.begin_row();
    rows.add(table.parameter, std::optional(point.parameter));
    if (exact) {
      rows.add("source", Field{point.source});
      rows.add_cell(metric, point.cell);
    } else {
      rows.add_shown_cell(curve.column.info, point.cell);
    }
    rows.add_change(point.change);
    if (exact) rows.add_runs(results[point.result], point.runs);
  }
  return rows.table();
}

DataTable order_table(const RobustnessTable& table) {
  RowTable rows("order_of_methods", "Order of the methods: Kendall's tau against the first value");
  for (const RobustnessOrder& order : table.orders) {
    rows.begin_row();
    rows.add("metric", Field{order.column.info.id});
    rows.add(table.parameter, std::optional(order.parameter));
    rows.add("scenarios", order.stability.scenarios);
    rows.add("tau", order.stability.tau, order.stability.interval);
    const auto& ceiling = order.stability.ceiling;
    rows.add("noise_ceiling", ceiling ? std::optional(ceiling->mean) : std::nullopt,
             ceiling ? std::optional(ceiling->interval) : std::nullopt);
  }
  return rows.table();
}

/// A stable order is one whose interval excludes 0 from below.
std::string order_sentence(const RobustnessTable& table, const RobustnessOrder& order) {
  const RankStability& stability = order.stability;
  const std::string where = "the order of the methods in " + order.column.info.id + " at " +
                            table.parameter + " = " + format_number(order.parameter);
  if (!stability.tau) return where + " cannot be compared: all are equal, or no common scenario";
  std::string tau = "Kendall's tau " + estimate_text(*stability.tau, stability.interval, 2) +
                    " over " + count_text(stability.scenarios, "scenario");
  if (*stability.tau == 1 && stability.interval && stability.interval->low == 1)
    return where + " is that at the first value: " + tau;
  if (stability.ceiling)
    tau += "; if the true means were those seen, in the same order, it would be " +
           estimate_text(stability.ceiling->mean, stability.ceiling->interval, 2);
  if (stability.interval && stability.interval->low > 0)
    return where + " resembles that at the first value: " + tau;
  return where + " is not shown to resemble that at the first value: " + tau;
}

}  // namespace

Interpretation interpret_robustness(const std::vector<ResultTable>& results,
                                    const AnalysisQuery& query) {
  if (query.parameter.empty()) {
    throw usage_error("--robustness", "no parameter", "--parameter SECTION.KEY");
  }
  for (const ResultTable& result : results) selected_methods(result, query.method);
  const RobustnessOptions options{query.comparison, query.values,
                                  query.comparison.despite_settings};
  const RobustnessTable table =
      build_robustness(results, query.parameter, query.metrics, options, query.method);
  Interpretation found;
  for (const RobustnessCurve& curve : table.curves) {
    found.tables.push_back(curve_table(table, curve, results, true));
    found.views.push_back(curve_table(table, curve, results, false));
    for (const RobustnessPoint& point : curve.points) {
      if (point.change) found.remarks.push_back(verdict_sentence(*point.change));
    }
  }
  if (!table.orders.empty()) found.tables.push_back(order_table(table));
  if (!table.orders.empty()) found.views.push_back(found.tables.back());
  for (const RobustnessOrder& order : table.orders)
    found.remarks.push_back(order_sentence(table, order));
  return found;
}

}  // namespace slalom
