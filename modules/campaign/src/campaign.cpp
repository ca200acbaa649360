#include "command_journal.h"
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
  const WorkerTask task = [&](std::size_t i, TaskNotes&) {
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

/// What a task that did not come to its end says about the method.
Outcome outcome_of(const TaskResult& result) {
  using Status = TaskResult::Status;
  if (result.status == Status::TimedOut) return Outcome::MethodDeadline;
  // The simulator catches what methods throw: what comes through is a fault of ours.
  if (result.status == Status::Threw) return Outcome::InfrastructureError;
  return Outcome::MethodCrash;
}

RunFindings findings_of(const Campaign& campaign, const RunSpec& spec, const TaskResult& result,
                        RunExecutor& executor) {
  if (auto findings = read_payload(result, run_findings_from_wire)) return std::move(*findings);
  const Outcome outcome = outcome_of(result);
  if (outcome == Outcome::InfrastructureError)
    return findings_without_run(campaign, spec, outcome, result.detail);
  const bool damaged = result.status == TaskResult::Status::Done;
  return executor.reconstruct(spec, result.notes, outcome,
                              damaged ? "its worker's answer was damaged" : result.detail);
}

PoolOptions pool_for_methods(const CampaignOptions& options, int workers) {
  const LimitsSection& limits = options.limits;
  PoolOptions pool;
  pool.workers = workers;
  pool.task_wall_time = limits.run_wall_time;
  pool.task_cpu_time = limits.run_cpu_time;
  pool.memory_mb = limits.memory_mb;
  pool.keep_errors = limits.method_errors;
  pool.notes_size = CommandJournal::size_for(options.setup.simulation);
  if (limits.deadline.deadline_policy == "fail") pool.silence = limits.deadline.cycle_deadline;
  return pool;
}

/// Second stretch: every method in every place.
bool run_methods(const Campaign& campaign, CampaignSink& sink, const Execution& execution,
                 const std::vector<References>& references, CampaignSummary& summary) {
  const std::vector<RunSpec> plan = make_plan(campaign);
  RunExecutor executor(campaign, references);  // each worker has its own copy from the fork on
  const WorkerTask task = [&](std::size_t i, TaskNotes& notes) {
    const References& known = references[plan[i].scenario];
    return to_wire(known.shortest
                       ? executor.execute(plan[i], notes)
                       : findings_without_run(campaign, plan[i], Outcome::UnsolvableScenario,
                                              known.shortest_reason));
  };
  const auto receive = [&](std::size_t i, TaskResult&& result) {
    RunFindings findings = findings_of(campaign, plan[i], result, executor);
    if (campaign.options.record.trajectories == "none") findings.trajectory.samples.clear();
    sink.add_run(findings.record, findings.timing, findings.trajectory);
    ++summary.runs;
    ++summary.outcomes[findings.record.outcome];
    execution.progress.advance(i + 1);
  };
  execution.progress.start("Running methods", plan.size());
  const bool complete =
      run_in_workers(plan.size(), pool_for_methods(campaign.options, execution.workers), task,
                     receive, execution.interrupted);
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
  const WorkerTask task = [&](std::size_t i, TaskNotes&) -> std::string {
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
  PoolOptions pool = pool_for_methods(campaign.options, 1);
  pool.fresh_process = true;
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
