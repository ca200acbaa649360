// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/summary.h>
#include <slalom/analysis/table_sums.h>
#include <slalom/results/privileged.h>

namespace slalom {
namespace {

void add_summary_medians(SummaryTable& summary, const ResultTable& table, double confidence) {
  std::vector<std::vector<std::size_t>> runs(table.methods.size());
  for (std::size_t run = 0; run < table.size(); ++run) runs[table.method[run]].push_back(run);
  for (MethodSummary& method : summary.methods) {
    const std::uint32_t index = index_of_method(table, method.method);
    for (std::size_t i = 0; i < method.cells.size(); ++i)
      add_medians(method.cells[i], table, runs[index],
                  *find_metric(table, summary.columns[i].info.id), confidence);
  }
}

}  // namespace

SummaryTable build_summary(const ResultTable& table, const std::vector<std::string>& column_ids,
                           const AnalysisOptions& options) {
  require_valid(options);
  resolve_columns(table, column_ids);  // throws for an unknown one
  TableSums sums({bin_rows({}, table)}, column_ids);
  sums.add(table);
  SummaryTable summary = sums.summary(0, options);
  summary.outcomes = table.outcomes;
  summary.footnote = privileged_footnote(table);
  if (options.medians) add_summary_medians(summary, table, options.confidence);
  return summary;
}

}  // namespace slalom
