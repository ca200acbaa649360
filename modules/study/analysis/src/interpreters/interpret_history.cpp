// SPDX-License-Identifier: BSD-3-Clause
#include "row_table.h"

#include <slalom/analysis/campaign_settings.h>
#include <slalom/analysis/cell_text.h>
#include <slalom/analysis/history.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/core/text.h>

namespace slalom {
namespace {

DataTable changed_table(const std::string& name, const std::string& title,
                        const std::vector<ChangedRun>& changed,
                        const std::vector<ResultTable>& results) {
  RowTable rows(name, title);
  for (const ChangedRun& one : changed) {
    const ResultTable& result = results[one.result];
    rows.begin_row();
    rows.add("scenario", Field{result.scenario_names[result.scenario[one.run]]});
    rows.add("run", Field{run_id(result, one.run)});
    rows.add("before", Field{one.before});
    rows.add("now", Field{one.now});
  }
  return rows.table();
}

DataTable history_table(const HistoryCurve& curve, const std::vector<ResultTable>& results,
                        bool exact) {
  const std::string& metric = curve.column.info.id;
  RowTable rows(curve.method + "_" + metric, curve.method + ": " + metric + " by result file");
  for (const HistoryPoint& point : curve.points) {
    rows.begin_row();
    rows.add("results", Field{results[point.result].source});
    if (exact) {
      rows.add_cell(metric, point.cell);
    } else {
      rows.add_shown_cell(curve.column.info, point.cell);
    }
    rows.add_change(point.change);
  }
  return rows.table();
}

void add_change_remarks(Interpretation& found, const History& history, const std::string& since) {
  const std::size_t successes = history.new_successes.size();
  if (history.untold_runs > 0)
    found.remarks.push_back(since + ": new failures cannot be told in " +
                            count_text(history.untold_runs, "run") +
                            " of the same scenarios: no outcome and no success");
  if (history.compared_runs > 0 || history.untold_runs == 0)
    found.remarks.push_back(since + ": " + count_text(history.new_failures.size(), "new failure") +
                            " and " + std::to_string(successes) + " new success" +
                            (successes == 1 ? "" : "es") + " in " +
                            count_text(history.compared_runs, "run") + " of the same scenarios");
}

}  // namespace

Interpretation interpret_history(const std::vector<ResultTable>& results,
                                 const AnalysisQuery& query) {
  const History history = build_history(results, query.metrics, query.comparison, query.method);
  const std::string since =
      results.back().source + " against " + results[results.size() - 2].source;
  Interpretation found;
  found.remarks = difference_sentences(results);
  const auto add = [&](const std::string& name, const std::string& title,
                       const std::vector<ChangedRun>& changed) {
    found.tables.push_back(changed_table(name, title, changed, results));
    if (!changed.empty()) found.views.push_back(found.tables.back());
  };
  if (history.compared_runs > 0 || history.untold_runs == 0) {
    add("new_failures", "New failures: " + since, history.new_failures);
    add("new_successes", "New successes: " + since, history.new_successes);
  }
  for (const HistoryCurve& curve : history.curves) {
    found.tables.push_back(history_table(curve, results, true));
    found.views.push_back(history_table(curve, results, false));
  }
  add_change_remarks(found, history, since);
  for (const HistoryCurve& curve : history.curves)
    for (const HistoryPoint& point : curve.points)
      if (point.change) found.remarks.push_back(verdict_sentence(*point.change));
  return found;
}

}  // namespace slalom
