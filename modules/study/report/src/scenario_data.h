// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "report_data.h"

#include <slalom/io/result_file.h>

namespace slalom {

/// A scenario with its runs, as stored in the result files.
struct ScenarioRuns {
  std::size_t scenario = 0;   ///< index into the scenarios of the columns
  std::size_t first_run = 0;  ///< index of the first record in the runs of the columns
  Scenario content;
  References references;
  std::vector<RunRecord> records;
  std::vector<Trajectory> trajectories;  ///< parallel to `records`
  std::vector<std::string> rawlogs;  ///< parallel to `records`: paths, whether they exist or not
};

/// From the files that contain the scenario, at least one. Throws Error (File).
ScenarioRuns read_scenario_runs(const std::vector<const ResultFile*>& files,
                                const ResultTable& runs, std::size_t scenario,
                                std::size_t first_run);

constexpr std::size_t kMaxSamples = 80;

/// data/s-HASH8.js: a scenario with its references and runs, as a call of slalomScenario().
/// Trajectories have the samples between which linear interpolation keeps positions and clearances
/// within 1 cm, and that of the least clearance, in integer millimeters, milliseconds and
/// milliradians; and the people as they walked in them. The safest path is simplified with a
/// tolerance of one cell. `directory`: of the report, for links to rawlogs.
std::string scenario_script(const ReportInput& input, const ScenarioRuns& content,
                            const World& world, const std::string& directory);

/// The scenario with its reference paths and all trajectories as an <svg> element.
std::string scenario_picture(const ReportInput& input, const ScenarioRuns& content);

/// The scenario with the trajectory of the run at index `i`, and in grey that of the first other
/// run that succeeds, if there is one.
std::string failure_picture(const ReportInput& input, const ScenarioRuns& content, std::size_t i);

}  // namespace slalom
