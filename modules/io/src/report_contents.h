#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/failure_taxonomy.h>
#include <slalom/analysis/paired_comparison.h>
#include <slalom/analysis/summary.h>
#include <slalom/analysis/validity.h>
#include <slalom/io/html_report.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// What more than one page of a report shows, computed once for all of them.
struct ReportContents {
  SummaryTable summary;
  std::vector<std::vector<CrossTable>> tables;  ///< by specification of rows, one per method
  /// Every pair of methods in every directed column, as one family; none where there is nothing to
  /// compare.
  std::vector<PairedComparison> comparisons;
  FailureTaxonomy endings;
  std::optional<ValidityTable> validity;  ///< none where no column has a direction
};

/// Throws Error (Usage) for unknown ids.
ReportContents make_report_contents(const RunColumns& runs, const ReportOptions& options);

/// The columns of the report in which methods can be better or worse.
std::vector<Column> directed_columns(const RunColumns& runs, const ReportOptions& options);

}  // namespace slalom
