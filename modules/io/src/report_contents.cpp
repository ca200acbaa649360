#include "report_contents.h"

#include <slalom/core/error.h>

namespace slalom {
namespace {

std::vector<PairedComparison> compare_all(const RunColumns& runs, const ReportOptions& options,
                                          const std::vector<std::string>& metrics) {
  if (runs.methods.size() < 2 || metrics.empty()) return {};
  try {
    ComparisonOptions comparison;
    comparison.analysis = options.analysis;
    return compare_methods(runs, metrics, "", comparison);
  } catch (const Error&) {
    return {};  // methods without a scenario in common
  }
}

}  // namespace

ReportContents make_report_contents(const RunColumns& runs, const ReportOptions& options) {
  std::vector<std::string> metrics;
  for (const Column& column : directed_columns(runs, options)) metrics.push_back(column.info.id);
  ReportContents contents;
  contents.summary = build_summary(runs, options.columns, options.analysis);
  for (const BinSpec& spec : options.rows)
    contents.tables.push_back(build_cross_tables(runs, {spec}, options.columns, options.analysis));
  contents.comparisons = compare_all(runs, options, metrics);
  contents.endings = build_failure_taxonomy(runs, BinSpec{}, options.analysis);
  if (!metrics.empty()) contents.validity = build_validity(runs, metrics, options.analysis);
  return contents;
}

std::vector<Column> directed_columns(const RunColumns& runs, const ReportOptions& options) {
  std::vector<Column> directed;
  for (const Column& column : resolve_columns(runs, options.columns)) {
    if (column.info.direction != Direction::None && !column.wall_clock) directed.push_back(column);
  }
  return directed;
}

}  // namespace slalom
