// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/cross_table.h>
#include <slalom/analysis/method_overview.h>
#include <slalom/analysis/summary.h>
#include <slalom/core/error.h>
#include <slalom/report/report.h>
#include <slalom/results/method_failures.h>

#include <nlohmann/json.hpp>

#include <string>
#include <vector>

namespace slalom {

using OrderedJson = nlohmann::ordered_json;

/// The "format" of report.json; increases when fields change their meaning.
constexpr int kReportFormat = 1;

/// The runs behind a number of the report: runs.html#cell-INDEX.
struct RunGroup {
  std::string title;
  std::vector<std::size_t> runs;  ///< indexes into the runs
};

/// Input of the pages: the results, and the tables that they show with and without scripts.
struct ReportInput {
  const ResultTable& runs;
  const ReportOptions& options;
  SummaryTable summary;
  std::vector<std::vector<CrossTable>> tables;  ///< per row specification, one table per method
  MethodFailures failures;                      ///< of the runs, if they are known
  /// In success and the columns with a direction; and the methods by success. Empty for selected
  /// scenarios.
  std::vector<PairedComparison> comparisons;
  std::vector<MethodOverview> overview;

  /// Whether a search has selected the scenarios. They are a sample of no environment: the report
  /// counts outcomes, and has no intervals or tests.
  bool is_selected() const { return !options.clusters.empty(); }
};

/// Throws Error (Usage) for unknown ids.
ReportInput make_report_input(const ResultTable& runs, const ReportOptions& options);

/// report.json except "scenarios", "runs" and "groups". Extends `groups`.
OrderedJson report_data(const ReportInput& input, std::vector<RunGroup>& groups);

/// "overview" of report.json: the first screen.
OrderedJson overview_json(const ReportInput& input);
/// Sentences about methods that begin the first screen.
OrderedJson headlines_json(const ReportInput& input);

/// "comparisons", "completion", "ranks", "profiles" and "validity" of report.json; the metrics are
/// those in which methods can be better.
OrderedJson comparisons_json(const ResultTable& runs, const std::vector<PairedComparison>& family);
OrderedJson completion_json(const ResultTable& runs);
OrderedJson ranks_json(const ResultTable& runs, const std::vector<std::string>& metrics,
                       const AnalysisOptions& options);
OrderedJson profiles_json(const ResultTable& runs, const std::vector<std::string>& metrics);
OrderedJson validity_json(const ResultTable& runs, const std::vector<std::string>& metrics,
                          const AnalysisOptions& options);

/// Appends what `make` returns, if the results support it.
template <typename Make>
void add_if_supported(OrderedJson& list, Make make) {
  try {
    list.push_back(make());
  } catch (const Error&) {
    return;  // too few methods, scenarios or values
  }
}

/// "clusters" of report.json.
OrderedJson clusters_json(const std::vector<ReportedCluster>& clusters);

/// "campaign" if it has no name.
std::string campaign_name(const Manifest& manifest);

/// The metrics that are not wall-clock times: "metrics" of report.json.
std::vector<const ValueColumn*> repeatable_metrics(const ResultTable& runs);

/// Rounded to six significant digits, a third of the size; a missing value is its reason.
OrderedJson rounded_json(double number);
OrderedJson rounded_json(const ValueColumn& values, std::size_t row);

/// One line. ASCII only, so that it is also an expression of JavaScript, in which some Unicode
/// characters are line terminators. Invalid UTF-8 bytes are replaced.
std::string json_text(const OrderedJson& json);

}  // namespace slalom
