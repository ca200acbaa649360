#include <slalom/analysis/summary.h>

#include <set>

namespace slalom {
namespace {

/// Outcomes in the order in which tables show them.
std::vector<std::string> occurring_outcomes(const ResultTable& table) {
  std::set<std::string> names;
  for (const RunRecord& run : table.runs) names.insert(run.outcome);
  std::vector<std::string> ordered;
  if (names.erase("success") > 0) ordered.emplace_back("success");
  ordered.insert(ordered.end(), names.begin(), names.end());
  return ordered;
}

MethodSummary summarise(const ResultTable& table, const std::string& method,
                        const std::vector<Column>& columns, const AnalysisOptions& options) {
  MethodSummary summary;
  summary.method = method;
  std::vector<std::size_t> runs;
  for (std::size_t i = 0; i < table.runs.size(); ++i) {
    if (table.runs[i].method != method) continue;
    runs.push_back(i);
    ++summary.outcomes[table.runs[i].outcome];
  }
  summary.n = runs.size();
  for (const Column& column : columns) {
    const std::string label = method + "/summary/" + column.info.id;
    summary.cells.push_back(make_cell(table, runs, column, options, label));
  }
  return summary;
}

}  // namespace

SummaryTable build_summary(const ResultTable& table, const std::vector<std::string>& column_ids,
                           const AnalysisOptions& options) {
  require_valid(options);
  SummaryTable summary;
  summary.columns = resolve_columns(table, column_ids);
  summary.outcomes = occurring_outcomes(table);
  summary.confidence = options.confidence;
  for (const std::string& method : method_names(table)) {
    summary.methods.push_back(summarise(table, method, summary.columns, options));
  }
  return summary;
}

}  // namespace slalom
