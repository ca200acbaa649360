#pragma once

#include <slalom/references/reference.h>
#include <slalom/results/run_record.h>
#include <slalom/trajectory/trajectory.h>

#include <string>

namespace slalom {

/// What a worker finds out about one scenario.
struct ScenarioFindings {
  ScenarioRecord record;
  References references;
};

/// What a worker finds out about one run.
struct RunFindings {
  RunRecord record;
  RunTiming timing;
  Trajectory trajectory;
};

/// Findings as bytes between processes of one campaign; doubles are kept exactly.
/// Reading throws std::exception when the bytes are not what was written.
std::string to_wire(const ScenarioFindings& findings);
std::string to_wire(const RunFindings& findings);
ScenarioFindings scenario_findings_from_wire(const std::string& bytes);
RunFindings run_findings_from_wire(const std::string& bytes);

}  // namespace slalom
