#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/cell.h>
#include <slalom/io/result_file.h>
#include <slalom/robot/robot_model.h>

#include <string>
#include <vector>

namespace slalom {

/// What a report (or a table on a terminal) shows.
struct ReportOptions {
  std::vector<BinSpec> rows;         ///< one set of cross tables each
  std::vector<std::string> columns;  ///< metric ids
  AnalysisOptions analysis;
  RobotModel robot;          ///< drawn at start and goal, and along runs
  SensorModel sensor;        ///< whose scan is drawn
  double resolution = 0.05;  ///< m, of the model in which runs were judged
};

/// As the sections [analysis] and [robot] of the campaign in the manifest ask; where they say
/// nothing: density:q4 (or all), and success, optimality and safety as far as the results have
/// them, with 95 % intervals.
ReportOptions report_options(const ResultTable& table);

/// Writes a report that opens offline: `directory`/index.html with inline styles and pictures and
/// no scripts, whose cells lead to runs.html (the runs of a cell) and run.html (one run, replayed);
/// with more than 200 scenarios, or more than 6 MB of pictures, the pictures stand on pages
/// scenarios-1.html, ... beside it. Shows counts and versions, a summary per method, cross tables
/// with findings, every scenario with its reference paths and all methods' trajectories, and the
/// manifest. The same result file and options give the same bytes, apart from wall-clock columns.
/// Throws Error (Usage) for unknown descriptors or metrics, Error (Job) when it cannot write.
void write_html_report(const ResultFile& file, const ReportOptions& options,
                       const std::string& directory);

}  // namespace slalom
