// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/result_file.h>
#include <slalom/report/report.h>
#include <slalom/results/result_table.h>

#include <cstddef>
#include <string>
#include <vector>

namespace slalom {

/// A failure whose smallest scenario, original and neighbors were run in one campaign. Scenarios
/// are named by their hashes.
struct ExaminedFailure {
  std::string found;                   ///< "random candidate 52 of the search"
  std::string command;                 ///< that repeats and shows it
  std::string smallest;                ///< the shrunk scenario
  std::string compared;                ///< the one to which the neighbors belong
  std::vector<std::string> neighbors;  ///< counted where the method reaches the goal
  std::size_t obstacles = 0;           ///< of the smallest scenario
  double bottleneck_width = 0;         ///< robot widths, of the smallest scenario
  /// Found independently of all other failures: only such failures are counted in contrasts.
  bool independent = true;
};

/// The examined failures of one method.
struct ExaminedFailures {
  std::string method;
  int repetition = 0;
  std::vector<ExaminedFailure> failures;
};

/// JSON, to explain the same failures again.
std::string to_json(const ExaminedFailures& examined);
/// Throws Error (File) at `where` for malformed text.
ExaminedFailures examined_failures_from_json(const std::string& text, const std::string& where);

/// Clusters of failures (cluster_failures() of the runs in the smallest scenarios), and how the
/// compared runs of each differ from their neighbors: every descriptor and every metric, against
/// the median over the neighbors, by contrast_matched(). Statements are the contrasts of
/// descriptors that hold: what differed before the run began. Metrics whose value follows from the
/// outcome are left out. Throws Error (File) for damaged results, Error (Job) where a run is
/// missing. Uses the options robot, resolution and confidence.
std::vector<ReportedCluster> explain_failures(const ResultFile& file, const ResultTable& runs,
                                              const ReportOptions& options,
                                              const ExaminedFailures& examined);

}  // namespace slalom
