#include "row_table.h"

#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/summary.h>

namespace slalom {

Interpretation interpret_summary(const std::vector<ResultTable>& results,
                                 const AnalysisQuery& query) {
  const SummaryTable summary = build_summary(results[0], query.metrics, query.comparison.analysis);
  selected_methods(results[0], query.method);
  RowTable exact("summary", "Summary"), view("summary", "All scenarios");
  for (const MethodSummary& method : summary.methods) {
    if (!query.method.empty() && method.method != query.method) continue;
    for (RowTable* rows : {&exact, &view}) {
      rows->begin_row();
      rows->add("method", Field{method.method});
      rows->add("runs", method.n);
      for (const std::string& outcome : summary.outcomes) {
        const auto found = method.outcomes.find(outcome);
        rows->add("outcome." + outcome,
                  found == method.outcomes.end() ? std::size_t{0} : found->second);
      }
    }
    for (std::size_t i = 0; i < summary.columns.size(); ++i) {
      const std::string& metric = summary.columns[i].info.id;
      exact.add_cell(metric, method.cells[i]);
      view.add(metric, method.cells[i].estimate, method.cells[i].interval);
      view.add(metric + ".na", method.cells[i].n - method.cells[i].available);
    }
  }
  return {{exact.table()}, {view.table()}, {}, true};
}

}  // namespace slalom
