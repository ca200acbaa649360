#include <slalom/analysis/summary.h>

#include <set>

namespace slalom {
namespace {

/// Outcomes in the order in which tables show them.
std::vector<std::string> occurring_outcomes(const RunColumns& table) {
  std::set<std::string> names;
  for (const std::string& name : table.outcomes) names.insert(name);
  std::vector<std::string> ordered;
  if (names.erase("success") > 0) ordered.emplace_back("success");
  ordered.insert(ordered.end(), names.begin(), names.end());
  return ordered;
}

MethodSummary summarise(const RunColumns& table, std::uint32_t method,
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
  for (std::size_t place = 0; place < by_outcome.size(); ++place) {
    if (by_outcome[place] > 0) summary.outcomes[table.outcomes[place]] = by_outcome[place];
  }
  for (const Column& column : columns) {
    const std::string label = summary.method + "/summary/" + column.info.id;
    const ValueColumn& values = *find_metric(table, column.info.id);
    summary.cells.push_back(make_cell(table, runs, values, options, label));
  }
  return summary;
}

}  // namespace

SummaryTable build_summary(const RunColumns& table, const std::vector<std::string>& column_ids,
                           const AnalysisOptions& options) {
  require_valid(options);
  SummaryTable summary;
  summary.columns = resolve_columns(table, column_ids);
  summary.outcomes = occurring_outcomes(table);
  summary.confidence = options.confidence;
  for (std::uint32_t method = 0; method < table.methods.size(); ++method) {
    summary.methods.push_back(summarise(table, method, summary.columns, options));
  }
  return summary;
}

SummaryTable build_summary(const ResultTable& table, const std::vector<std::string>& column_ids,
                           const AnalysisOptions& options) {
  return build_summary(to_columns(table), column_ids, options);
}

}  // namespace slalom
