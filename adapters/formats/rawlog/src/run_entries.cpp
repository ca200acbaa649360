// SPDX-License-Identifier: BSD-3-Clause
#include "rawlog_format.h"
#include "run_entries.h"

#include <slalom/core/text.h>

namespace slalom {

Manifest entries_of(const RunManifest& run) {
  Manifest entries = run.more;
  entries[keys::kFormat] = kFormatVersion;
  entries[keys::kCampaignIni] = run.campaign_ini;
  entries[keys::kScenarioName] = run.scenario_name;
  entries[keys::kScenarioHash] = run.scenario_hash;
  entries[keys::kScenarioYaml] = run.scenario_yaml;
  entries[keys::kMethod] = run.method;
  entries[keys::kRepetition] = std::to_string(run.repetition);
  entries[keys::kSeed] = std::to_string(run.seed);
  return entries;
}

void add_task(Manifest& entries, const NavigationTask& task) {
  entries[keys::kStart] = format_numbers({task.start.x, task.start.y, task.start.phi});
  entries[keys::kGoal] = format_numbers({task.goal.x, task.goal.y});
  entries[keys::kGoalTolerance] = format_number(task.goal_tolerance);
  if (task.goal_heading)
    entries[keys::kGoalHeading] = format_numbers({*task.goal_heading, task.goal_heading_tolerance});
  entries[keys::kControlPeriod] = format_number(task.control_period);
  entries[keys::kTaskSeed] = std::to_string(task.seed);
}

Manifest entries_of(const SimulationResult& result) {
  return {{keys::kOutcome, to_string(result.outcome)},
          {keys::kDetail, result.detail},
          {keys::kTrajectoryHash, result.trajectory.hash()}};
}

}  // namespace slalom
