// SPDX-License-Identifier: BSD-3-Clause
#include "scenario_survey.h"

#include <slalom/campaign/measure.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/people/crowd.h>
#include <slalom/references/exact_shortest.h>

namespace slalom {
namespace {

/// P* by exact search, independent of the planner.
KnownPath exact_path(const CampaignOptions& options, const World& world,
                     const References& references) {
  if (!references.shortest) return {{}, 0, references.shortest_reason};
  const ShortestPath& shortest = *references.shortest;
  if (shortest.planner == kExactPlanner) return {shortest.path, shortest.length, ""};
  const Scenario& scenario = world.scenario();
  std::string reason;
  const auto exact = exact_shortest_path({world,
                                          options.robot.shape().inscribed_radius(),
                                          {scenario.start().x, scenario.start().y},
                                          scenario.goal()},
                                         reason);
  return exact ? KnownPath{exact->path, exact->length, ""} : KnownPath{{}, 0, reason};
}

}  // namespace

ScenarioFindings survey_scenario(const Campaign& campaign, const Scenario& scenario) {
  const CampaignOptions& options = campaign.options;
  const World world(scenario, options.simulation.resolution);
  if (!scenario.people().empty()) check_people(world, scenario.people());
  ScenarioFindings findings;
  findings.record = {scenario.hash(), scenario.name(), {}};
  findings.references = find_references(options, campaign.planner, world);
  const References& references = findings.references;
  DescriptorContext context{world, options.robot.shape(), options.sensor.max_range,
                            search_once([&] { return exact_path(options, world, references); }),
                            options.exact_confinement};
  if (references.safest) context.bottleneck = references.safest->bottleneck;
  for (const std::string& id : options.descriptors) {
    const Descriptor& enabled = descriptor(id);
    findings.record.descriptors[id] = {enabled.info.version, enabled.compute(context)};
  }
  findings.packed = {scenario, references};
  return findings;
}

}  // namespace slalom
