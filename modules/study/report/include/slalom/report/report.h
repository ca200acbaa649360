// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/analysis/bins.h>
#include <slalom/analysis/cell.h>
#include <slalom/report/reported_cluster.h>
#include <slalom/results/result_table.h>
#include <slalom/robot/robot_model.h>
#include <slalom/simulation/simulate.h>

#include <cstdint>
#include <string>
#include <vector>

namespace slalom {

/// Contents of a report or of a table on a terminal.
struct ReportOptions {
  std::vector<BinSpec> rows;         ///< one set of cross tables per entry
  std::vector<std::string> columns;  ///< metric ids
  AnalysisOptions analysis;
  RobotModel robot;                            ///< drawn at start and goal, and along runs
  SensorModel sensor;                          ///< for the drawn scan
  SimulationOptions simulation;                ///< of the campaign
  PeopleSettings people;                       ///< likewise: they walk as they did in each run
  std::size_t planned_runs = 0;                ///< of the complete campaign; 0 if it is not known
  std::vector<ReportedCluster> clusters = {};  ///< of failures, each with a page
  /// For the commands that the first screen proposes: the .ini of the campaign with its overrides
  /// ("my.ini", "--set", "robot.radius=0.3"); empty: none are proposed.
  std::vector<std::string> campaign = {};
  std::string output = {};  ///< of the campaign, as it was typed
  std::string focus = {};   ///< the method that these commands are about; empty: any
  std::uint64_t seed = 1;   ///< of the campaign
  bool generates = false;   ///< its scenarios, so that there can be more of them
};

/// The options from the sections [analysis], [robot], [simulation] and [people] of the campaign in
/// the manifest. Defaults: density:q4 (or all), and success, optimality and safety as far as the
/// results contain them, with 95 % intervals.
ReportOptions report_options(const ResultTable& runs);

/// Writes a report that works offline into `directory`: report.json with all numbers, the same data
/// as scripts in data/, and the static pages that draw it (index.html, method.html, runs.html,
/// run.html, and cluster.html if there are clusters); docs/guide/report.md documents them.
/// index.html shows the summary and the cross tables even if scripts are disabled. `results`: a
/// result file, or a folder with the shards of a campaign; `runs`: those in it, with all
/// quantities. The output is deterministic, except for wall-clock columns. Throws Error (Usage) for
/// unknown descriptors or metrics, Error (Job) when it cannot write.
void write_report(const std::string& results, ResultTable runs, const ReportOptions& options,
                  const std::string& directory);

/// The first screen of that report as a page of its own, for notebooks: without scripts, what
/// failures have in common, and pictures; links are texts. `results` is "" for runs that are in no
/// file.
std::string first_screen(const std::string& results, ResultTable runs,
                         const ReportOptions& options);

/// One page with all pages and data of the report, or of the reports, that write_report() has
/// written into `directory`: for mail. Links to rawlogs are left out. Throws Error (File).
std::string packed_report(const std::string& directory);

/// Removes what write_report() has written into `directory`, if anything. Throws Error (Job).
void remove_report(const std::string& directory);

}  // namespace slalom
