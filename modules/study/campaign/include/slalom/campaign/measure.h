// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/references/reference.h>
#include <slalom/results/run_record.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/trajectory.h>

#include <map>
#include <string>

namespace slalom {

/// The reference paths of a scenario as computed in a campaign (`planner` null: exact search only).
/// They are among static obstacles, and the earliest arrival is among movers, and among people if
/// none of them notices the robot. Other people only add to these: each lower bound, and each proof
/// that there is no path or arrival, holds among them too.
/// Call it in a separate process: OMPL seeds its random number generators once per process.
References find_references(const CampaignOptions& options, const ReferencePlanner* planner,
                           const World& world);

/// The references from which time_limit() and lack_of_time() follow, without the others.
References find_earliest(const RunSetup& setup, const World& world);

/// s, SimulationOptions::time_limit() of the runs in a scenario: the earliest possible arrival is
/// the larger of the time that the shortest path takes at full speed, and of the lower bound among
/// movers.
double time_limit(const RunSetup& setup, const References& references);

/// Whether lack_of_time() has to look at the scenario.
bool may_lack_time(const RunSetup& setup, const References& references);

/// Why no run in a scenario can end in time, which is proved, by lack_of_time_sentence(). Empty if
/// that is not known.
std::string lack_of_time(const RunSetup& setup, const World& world, const References& references);

/// The values of the enabled metrics of a run, by id. `movers` and `hindrances` as in
/// SimulationResult.
std::map<std::string, VersionedValue> measure_run(const CampaignOptions& options,
                                                  const World& world, const References& references,
                                                  const Trajectory& trajectory, Outcome outcome,
                                                  const Movers& movers,
                                                  const Hindrances& hindrances);

/// bound_violation() of a run.
std::string bound_violation(const CampaignOptions& options, const World& world,
                            const References& references, const Trajectory& trajectory,
                            Outcome outcome);

}  // namespace slalom
