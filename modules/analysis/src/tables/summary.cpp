#include <slalom/analysis/summary.h>

namespace slalom {
namespace {

MethodSummary summarize(const ResultTable& table, std::uint32_t method,
                        const std::vector<Column>& columns, const AnalysisOptions& options) {
  MethodSummary summary;
  summary.method = table.methods[method];
  std::vector<std::size_t> runs, by_outcome(table.outcomes.size(), 0);
  for (std::size_t run = 0; run < table.size(); ++run) {
    if (table.method[run] != method) continue;
    runs.push_back(run);
    ++by_outcome[table.outcome[run]];
  }
  summary.n = runs.size();
  for (std::size_t index = 0; index < by_outcome.size(); ++index) {
    if (by_outcome[index] > 0) summary.outcomes[table.outcomes[index]] = by_outcome[index];
  }
  for (const Column& column : columns) {
    const std::string label = summary.method + "/summary/" + column.info.id;
    const ValueColumn& values = *find_metric(table, column.info.id);
    summary.cells.push_back(make_cell(table, runs, values, options, label));
  }
  return summary;
}

}  // namespace

SummaryTable build_summary(const ResultTable& table, const std::vector<std::string>& column_ids,
                           const AnalysisOptions& options) {
  require_valid(options);
  SummaryTable summary;
  summary.columns = resolve_columns(table, column_ids);
  summary.outcomes = table.outcomes;
  summary.confidence = options.confidence;
  for (std::uint32_t method = 0; method < table.methods.size(); ++method) {
    summary.methods.push_back(summarize(table, method, summary.columns, options));
  }
  return summary;
}

}  // namespace slalom
