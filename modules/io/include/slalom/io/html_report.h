#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/cell.h>
#include <slalom/io/result_file.h>

#include <string>
#include <vector>

namespace slalom {

/// What a report (or a table on a terminal) shows.
struct ReportOptions {
  std::vector<BinSpec> rows;         ///< one set of cross tables each
  std::vector<std::string> columns;  ///< metric ids
  AnalysisOptions analysis;
  double robot_radius = 0.25;  ///< m, drawn at start and goal
};

/// As the sections [analysis] and [robot] of the campaign in the manifest ask; where they say
/// nothing: density:4 (or all), and success, optimality and safety as far as the results have them,
/// with 95 % intervals.
ReportOptions report_options(const ResultTable& table);

/// Writes a report that opens offline: `directory`/index.html with inline styles and pictures and
/// no scripts; with more than 200 scenarios, or more than 6 MB of pictures, the pictures stand on
/// pages scenarios-1.html, ... beside it. Shows counts and versions, a summary per method, cross
/// tables with findings, every scenario with its reference paths and all methods' trajectories, and
/// the manifest. The same result file and options give the same bytes, apart from wall-clock
/// columns. Throws Error (Usage) for unknown descriptors or metrics, Error (Job) when it cannot
/// write.
void write_html_report(const ResultFile& file, const ReportOptions& options,
                       const std::string& directory);

}  // namespace slalom
