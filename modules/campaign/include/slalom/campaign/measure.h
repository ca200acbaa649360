#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/references/reference.h>
#include <slalom/results/run_record.h>
#include <slalom/scenario/world.h>
#include <slalom/trajectory/trajectory.h>

#include <map>
#include <string>

namespace slalom {

/// The reference paths of a place as a campaign finds them (`planner` null: the exact search
/// alone). Meant for a process of its own: OMPL's random generators are seeded once per process.
References find_references(const CampaignOptions& options, const ReferencePlanner* planner,
                           const World& world);

/// The metrics of a run that a campaign computes, by id.
std::map<std::string, VersionedValue> measure_run(const CampaignOptions& options,
                                                  const World& world, const References& references,
                                                  const Trajectory& trajectory, Outcome outcome);

}  // namespace slalom
