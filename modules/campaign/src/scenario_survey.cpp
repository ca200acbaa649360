#include "scenario_survey.h"

#include <slalom/core/random.h>

namespace slalom {

ScenarioFindings survey_scenario(const Campaign& campaign, const Scenario& scenario) {
  const CampaignOptions& options = campaign.options;
  const World world(scenario, options.setup.simulation.resolution);
  ScenarioFindings findings;
  findings.record = {scenario.hash(), scenario.name(), {}};
  // Of a polygon the inscribed disc: wherever the polygon fits, so does the disc, so that no run
  // can be shorter than the reference.
  const double radius = options.setup.robot.shape().inscribed_radius();
  const PlanningProblem problem{
      world, radius, {scenario.start().x, scenario.start().y}, scenario.goal()};
  findings.references =
      compute_references(problem, campaign.planner, options.reference_gap,
                         derive_seed(options.seed, "reference/" + scenario.hash()));
  const References& references = findings.references;
  const auto shortest_length = [&references] {
    return references.shortest ? Value::of(references.shortest->length)
                               : Value::na(references.shortest_reason);
  };
  const DescriptorContext context{world, radius, options.setup.sensor.max_range, shortest_length};
  for (const std::string& id : options.descriptors) {
    const Descriptor& wanted = descriptor(id);
    findings.record.descriptors[id] = {wanted.info().version, wanted.compute(context)};
  }
  return findings;
}

}  // namespace slalom
