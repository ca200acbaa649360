#include "row_table.h"

#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/robustness.h>
#include <slalom/core/error.h>

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
      rows.add("n", point.cell.available);
      rows.add(metric, point.cell.estimate, point.cell.interval);
      rows.add(metric + ".na", point.cell.n - point.cell.available);
    }
    const auto& change = point.change;
    rows.add("change", change ? change->difference : std::nullopt,
             change ? change->interval : std::nullopt);
    rows.add("p_holm", change ? std::optional(change->adjusted_p) : std::nullopt);
    rows.add("verdict", Field{change ? to_string(change->verdict) : std::string()});
    if (exact) rows.add_runs(results[point.result], point.runs);
  }
  return rows.table();
}

}  // namespace

Interpretation interpret_robustness(const std::vector<ResultTable>& results,
                                    const AnalysisQuery& query) {
  if (query.parameter.empty()) {
    throw usage_error("robustness", "no parameter", "--parameter SECTION.KEY");
  }
  for (const ResultTable& result : results) selected_methods(result, query.method);
  RobustnessOptions options{query.comparison, query.values, query.allow_differences};
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
  return found;
}

}  // namespace slalom
