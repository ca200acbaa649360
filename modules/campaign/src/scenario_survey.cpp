#include "scenario_survey.h"

#include <slalom/campaign/measure.h>

namespace slalom {

ScenarioFindings survey_scenario(const Campaign& campaign, const Scenario& scenario) {
  const CampaignOptions& options = campaign.options;
  const World world(scenario, options.setup.simulation.resolution);
  ScenarioFindings findings;
  findings.record = {scenario.hash(), scenario.name(), {}};
  findings.references = find_references(options, campaign.planner, world);
  const References& references = findings.references;
  const auto shortest_length = [&references] {
    return references.shortest ? Value::of(references.shortest->exact_length)
                               : Value::na(references.shortest_reason);
  };
  const DescriptorContext context{world, options.setup.robot.shape().inscribed_radius(),
                                  options.setup.sensor.max_range, shortest_length};
  for (const std::string& id : options.descriptors) {
    const Descriptor& wanted = descriptor(id);
    findings.record.descriptors[id] = {wanted.info().version, wanted.compute(context)};
  }
  return findings;
}

}  // namespace slalom
