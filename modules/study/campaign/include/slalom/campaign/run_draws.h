// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/scenario/scenario.h>

#include <cstddef>
#include <functional>
#include <optional>
#include <string>

namespace slalom {

/// One run: its scenario and, unless they are those of all runs, its options.
struct RunDraw {
  Scenario scenario;
  std::optional<CampaignOptions> options = std::nullopt;
};

/// Draws the run with an index; none if it finds no scenario that the robot can solve. The same
/// index must give the same run. Executed in worker processes.
using DrawRun = std::function<std::optional<RunDraw>(std::size_t index)>;

/// The stored part of a run. Hashes are empty where there is no scenario, and that of the
/// trajectory also where the method's process died.
struct DrawnRun {
  Outcome outcome = Outcome::InfrastructureError;
  std::string detail, scenario_hash, trajectory_hash;
  std::optional<double> value;  ///< of the metric; none if it is not available
  double cycle_time = 0;        ///< ms of wall-clock time; 99 % quantile of the control cycles
  bool lacks_time = false;      ///< lack_of_time(); never received
};

/// How runs are executed; neither workers nor interruption affect a run.
struct DrawExecution {
  int workers = 1;
  std::function<bool()> interrupted = nullptr;  ///< polled
  std::string metric = {};                      ///< id of one that needs no safest path; "": none
};

/// Runs a method in scenarios that are drawn when they are needed, without descriptors, and with
/// the shortest path only, in worker processes with the limits of a campaign, each as a campaign
/// with these options and one repetition does. Passes the runs to `receive` in the order of their
/// indexes until it returns false, or `max_runs` of them; what workers have begun beyond that is
/// dropped. A method that crashes, or exceeds a limit, has the outcome that it has in a campaign.
/// Returns false if interrupted. Throws Error (Job) if a run cannot be executed for another reason,
/// and Error (Usage) if nobody can arrive in a scenario within [simulation] max_time.
bool run_draws(const NamedMethod& method, const CampaignOptions& options, const DrawRun& draw,
               std::size_t max_runs, const DrawExecution& execution,
               const std::function<bool(const DrawnRun&)>& receive);

}  // namespace slalom
