#include "run_executor.h"
#include "scenario_survey.h"
#include "wire.h"

#include <slalom/campaign/campaign.h>
#include <slalom/campaign/worker_pool.h>
#include <slalom/core/error.h>
#include <slalom/core/random.h>

#include <optional>

namespace slalom {
namespace {

/// The findings in a task's payload; nullopt when they are not whole (the process was corrupted).
template <typename Read>
auto read_payload(const TaskResult& result, Read read)
    -> std::optional<decltype(read(result.payload))> {
  if (result.status != TaskResult::Status::Done) return std::nullopt;
  try {
    return read(result.payload);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// First stretch: what every place is like and the best that is possible there.
bool survey_scenarios(const Campaign& campaign, CampaignSink& sink, const Execution& execution,
                      std::vector<References>& references) {
  const WorkerTask task = [&](std::size_t i) {
    return to_wire(survey_scenario(campaign, campaign.scenarios[i]));
  };
  const auto receive = [&](std::size_t i, TaskResult&& result) {
    const Scenario& scenario = campaign.scenarios[i];
    const auto findings = read_payload(result, scenario_findings_from_wire);
    if (!findings)
      throw job_error("scenario " + scenario.name(),
                      "its descriptors and references could not be computed: " + result.detail);
    references[i] = findings->references;
    sink.add_scenario(findings->record, scenario, findings->references);
    execution.progress.advance(i + 1);
  };
  execution.progress.start("Describing scenarios", campaign.scenarios.size());
  PoolOptions pool;
  pool.workers = execution.workers;
  pool.fresh_process = true;
  const bool complete =
      run_in_workers(campaign.scenarios.size(), pool, task, receive, execution.interrupted);
  execution.progress.finish();
  return complete;
}

RunFindings findings_of(const Campaign& campaign, const RunSpec& spec, const TaskResult& result) {
  if (auto findings = read_payload(result, run_findings_from_wire)) return std::move(*findings);
  if (result.status == TaskResult::Status::TimedOut)
    return findings_without_trajectory(campaign, spec, Outcome::MethodDeadline, result.detail);
  const std::string detail =
      result.status == TaskResult::Status::Done ? "its worker's answer was damaged" : result.detail;
  return findings_without_trajectory(campaign, spec, Outcome::MethodCrash, detail);
}

/// Second stretch: every method in every place.
bool run_methods(const Campaign& campaign, CampaignSink& sink, const Execution& execution,
                 const std::vector<References>& references, CampaignSummary& summary) {
  const std::vector<RunSpec> plan = make_plan(campaign);
  RunExecutor executor(campaign, references);  // each worker has its own copy from the fork on
  const WorkerTask task = [&](std::size_t i) {
    const References& known = references[plan[i].scenario];
    return to_wire(known.shortest
                       ? executor.execute(plan[i])
                       : findings_without_trajectory(campaign, plan[i], Outcome::UnsolvableScenario,
                                                     known.shortest_reason));
  };
  const auto receive = [&](std::size_t i, TaskResult&& result) {
    const RunFindings findings = findings_of(campaign, plan[i], result);
    sink.add_run(findings.record, findings.timing, findings.trajectory);
    ++summary.runs;
    ++summary.outcomes[findings.record.outcome];
    execution.progress.advance(i + 1);
  };
  execution.progress.start("Running methods", plan.size());
  PoolOptions pool;
  pool.workers = execution.workers;
  pool.task_wall_time = campaign.options.limits.run_wall_time;
  const bool complete = run_in_workers(plan.size(), pool, task, receive, execution.interrupted);
  execution.progress.finish();
  return complete;
}

}  // namespace

std::size_t CampaignSummary::infrastructure_errors() const {
  const auto found = outcomes.find(to_string(Outcome::InfrastructureError));
  return found == outcomes.end() ? 0 : found->second;
}

std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario_hash,
                       int repetition) {
  return derive_seed(campaign_seed, "run/" + scenario_hash, static_cast<std::uint64_t>(repetition));
}

void check_methods(const Campaign& campaign) {
  const std::vector<std::string>& names = campaign.options.methods;
  const WorkerTask task = [&](std::size_t i) -> std::string {
    try {
      campaign.methods.create(names[i],
                              {campaign.ini, "method." + names[i], campaign.options.setup.robot,
                               campaign.options.setup.sensor});
      return "";
    } catch (const std::exception& e) {
      return reason_of(e);
    }
  };
  const auto receive = [&](std::size_t i, TaskResult&& result) {
    if (result.status == TaskResult::Status::Done && result.payload.empty()) return;
    if (result.status == TaskResult::Status::Done)
      throw Error(Culprit::Usage, result.payload);  // already says where and what was expected
    throw usage_error(campaign.ini.where("method." + names[i]),
                      "the method could not be built: " + result.detail);
  };
  PoolOptions pool;
  pool.fresh_process = true;
  pool.task_wall_time = campaign.options.limits.run_wall_time;
  run_in_workers(names.size(), pool, task, receive, nullptr);
}

CampaignSummary run_campaign(const Campaign& campaign, CampaignSink& sink,
                             const Execution& execution) {
  CampaignSummary summary;
  std::vector<References> references(campaign.scenarios.size());
  summary.complete = survey_scenarios(campaign, sink, execution, references) &&
                     run_methods(campaign, sink, execution, references, summary);
  return summary;
}

}  // namespace slalom
