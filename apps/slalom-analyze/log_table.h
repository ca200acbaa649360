// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/evaluate_log.h>
#include <slalom/io/trajectory_file.h>

#include <functional>
#include <string>
#include <vector>

namespace slalom {

/// The logs that a table is about, and what their names say.
struct LogTableArguments {
  std::vector<std::string> logs;  ///< files and folders
  std::string name_pattern;       ///< "{method}_{scenario}.csv"; empty: none
  std::string scenario;           ///< file of the scenario of all logs, or
  std::string scenarios;          ///< a folder of scenarios (YAML) or a list
  std::string output;
  bool quiet = false, split = false;
};

/// The runs of a log. Throws Error.
using ReadRuns = std::function<std::vector<TrajectoryFile>(const std::string& path)>;
/// Throws Error.
using MeasureRun = std::function<EvaluatedLog(const World& world, const Trajectory& run)>;

/// Prints one table (CSV) with a row per run: its log, what the name of that says, outcome, metrics
/// and the reasons of those without a value, or why the log was refused. Throws Error (Usage) for
/// wrong arguments and at the end Error (Job) if a log was refused.
void print_log_table(const LogTableArguments& arguments, double resolution, const ReadRuns& read,
                     const MeasureRun& measure);

}  // namespace slalom
