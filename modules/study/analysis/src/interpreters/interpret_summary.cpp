// SPDX-License-Identifier: BSD-3-Clause
#include "../text/acceptance.h"
#include "row_table.h"

#include <slalom/analysis/common_scenarios.h>
#include <slalom/analysis/interpreter.h>
#include <slalom/analysis/method_overview.h>
#include <slalom/analysis/summary.h>

#include <algorithm>

namespace slalom {
namespace {

/// A table per metric whose means over all runs are not comparable.
void add_common_scenarios(Interpretation& found, const ResultTable& table,
                          const AnalysisQuery& query) {
  for (const CommonScenarios& common :
       build_common_scenarios(table, query.metrics, query.comparison.analysis)) {
    const std::string& metric = common.column.info.id;
    RowTable exact(metric + "_on_common_scenarios", title_of(common)),
        view(metric + "_on_common_scenarios", title_of(common));
    for (std::size_t i = 0; i < common.cells.size(); ++i) {
      if (!query.method.empty() && table.methods[i] != query.method) continue;
      for (RowTable* rows : {&exact, &view}) {
        rows->begin_row();
        rows->add("method", Field{table.methods[i]});
      }
      exact.add_cell(metric, common.cells[i]);
      view.add("n", common.cells[i].available);
      view.add_statement(common.column.info, common.cells[i]);
    }
    found.tables.push_back(exact.table());
    found.views.push_back(view.table());
  }
}

std::vector<std::string> overview_sentences(const ResultTable& table, const AnalysisQuery& query) {
  const std::vector<PairedComparison> family =
      directed_comparisons(table, resolve_columns(table, query.metrics), query.comparison);
  const std::vector<CrossTable> tables =
      build_cross_tables(table, query.rows, query.metrics, query.comparison.analysis);
  std::vector<std::string> sentences;
  if (query.method.empty())
    sentences.push_back(leader_sentence(table, family, query.comparison.analysis));
  for (const MethodOverview& overview :
       build_overview(table, tables, family, query.comparison.analysis))
    if (query.method.empty() || overview.standing.method.method == query.method)
      sentences.push_back(overview.sentence);
  sentences.erase(std::remove(sentences.begin(), sentences.end(), ""), sentences.end());
  return sentences;
}

}  // namespace

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
      view.add_statement(summary.columns[i].info, method.cells[i]);
      view.add(metric + ".na", method.cells[i].n - method.cells[i].available);
    }
  }
  Interpretation found{{exact.table()}, {view.table()}, {}, true};
  add_common_scenarios(found, results[0], query);
  found.remarks = overview_sentences(results[0], query);
  for (std::string& sentence :
       acceptance_sentences(results[0], query.method, query.comparison.analysis.confidence))
    found.remarks.push_back(std::move(sentence));
  return found;
}

}  // namespace slalom
