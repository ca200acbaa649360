// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/measure.h>
#include <slalom/simulation/simulate.h>

#include <optional>
#include <string>
#include <vector>

namespace slalom {

/// The log of any robot as a run in a scenario.
struct EvaluatedLog {
  SimulationResult run;  ///< the log up to its outcome
  std::map<std::string, VersionedValue> metrics;
  std::vector<std::string> notes;  ///< sentences about the position of the log in the scenario
};

/// Computes the enabled metrics of a log. Its outcome is determined as in simulation, see
/// evaluate_trajectory(), or given; then the complete log is evaluated. `planner` may be null. The
/// log must have samples.
EvaluatedLog evaluate_log(const CampaignOptions& options, const ReferencePlanner* planner,
                          const World& world, const Trajectory& log,
                          std::optional<Outcome> outcome);

/// {"scenario": {"hash", "name"}, "outcome", "outcome_detail", "trajectory": its hash, "notes",
/// "metrics": {id: {"value" or "na", "version"}}} on one line.
std::string render_json(const EvaluatedLog& log, const Scenario& scenario);

}  // namespace slalom
