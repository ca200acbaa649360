#include "run_executor.h"

#include <slalom/metrics/cycle_time.h>

#include <chrono>

namespace slalom {

std::vector<RunSpec> make_plan(const Campaign& campaign) {
  const CampaignOptions& options = campaign.options;
  std::vector<RunSpec> plan;
  plan.reserve(campaign.scenarios.size() * options.methods.size() *
               static_cast<std::size_t>(options.repetitions));
  for (std::size_t i = 0; i < campaign.scenarios.size(); ++i)
    for (const std::string& method : options.methods)
      for (int repetition = 0; repetition < options.repetitions; ++repetition)
        plan.push_back({i, method, repetition,
                        run_seed(options.seed, campaign.scenarios[i].hash(), repetition)});
  return plan;
}

RunRecord blank_record(const Campaign& campaign, const RunSpec& spec) {
  const Scenario& scenario = campaign.scenarios[spec.scenario];
  RunRecord record;
  record.scenario_hash = scenario.hash();
  record.scenario_name = scenario.name();
  record.method = spec.method;
  record.repetition = spec.repetition;
  record.seed = spec.seed;
  return record;
}

RunFindings RunExecutor::execute(const RunSpec& spec) {
  const auto begin = std::chrono::steady_clock::now();
  const CampaignOptions& options = campaign_.options;
  const World& place = world(spec.scenario);
  const SimulationResult result = simulate(place, options.setup, spec.seed, method(spec.method));
  RunFindings findings;
  findings.record = blank_record(campaign_, spec);
  evaluate(place, references_[spec.scenario], result, findings);
  findings.timing.values = cycle_time_statistics(result.cycle_seconds);
  findings.timing.wall_seconds =
      std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
  return findings;
}

const World& RunExecutor::world(std::size_t scenario) {
  if (!world_ || world_scenario_ != scenario) {
    world_ = std::make_unique<World>(campaign_.scenarios[scenario],
                                     campaign_.options.setup.simulation.resolution);
    world_scenario_ = scenario;
  }
  return *world_;
}

Method& RunExecutor::method(const std::string& name) {
  std::unique_ptr<Method>& method = methods_[name];
  if (!method) {
    method = campaign_.methods.create(
        name, {campaign_.ini, "method." + name, campaign_.options.setup.robot,
               campaign_.options.setup.sensor});
  }
  return *method;
}

void RunExecutor::evaluate(const World& world, const References& references,
                           const SimulationResult& result, RunFindings& findings) const {
  const CampaignOptions& options = campaign_.options;
  RunRecord& record = findings.record;
  record.outcome = to_string(result.outcome);
  record.outcome_detail = result.detail;
  record.trajectory_hash = result.trajectory.hash();
  findings.trajectory = result.trajectory;
  const MetricContext context = make_metric_context(
      world, options.setup.robot, result.trajectory, result.outcome, references,
      options.setup.simulation.max_time, options.setup.simulation.goal_tolerance);
  for (const std::string& id : options.metrics) {
    const Metric& wanted = metric(id);
    record.metrics[id] = {wanted.info().version, wanted.compute(context)};
  }
}

RunFindings findings_without_trajectory(const Campaign& campaign, const RunSpec& spec,
                                        Outcome outcome, const std::string& detail) {
  RunFindings findings;
  findings.record = blank_record(campaign, spec);
  findings.record.outcome = to_string(outcome);
  findings.record.outcome_detail = detail;
  const bool methods_fault = outcome == Outcome::MethodCrash || outcome == Outcome::MethodDeadline;
  for (const std::string& id : campaign.options.metrics) {
    const bool counts_failures = id == "success" || id == "spl";
    const Value value = methods_fault && counts_failures
                            ? Value::of(0)
                            : Value::na("outcome: " + findings.record.outcome);
    findings.record.metrics[id] = {metric(id).info().version, value};
  }
  return findings;
}

}  // namespace slalom
