// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/io/packed_scenario.h>
#include <slalom/io/packed_trajectory.h>
#include <slalom/references/reference.h>
#include <slalom/results/run_record.h>

#include <string>

namespace slalom {

/// The results of a worker for one scenario.
struct ScenarioFindings {
  ScenarioRecord record;
  References references;
  PackedScenario packed = {};
};

/// The results of a worker for one run.
struct RunFindings {
  RunRecord record;
  RunTiming timing;
  PackedTrajectory trajectory;
};

/// Serialization of findings between the processes of a campaign; doubles are exact.
/// Reading throws Error (File) for invalid bytes. Trajectories and scenarios are not unpacked;
/// references are sent packed only.
std::string to_wire(const ScenarioFindings& findings);
std::string to_wire(const RunFindings& findings);
ScenarioFindings scenario_findings_from_wire(const std::string& bytes);
RunFindings run_findings_from_wire(const std::string& bytes);

}  // namespace slalom
