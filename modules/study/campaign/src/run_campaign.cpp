// SPDX-License-Identifier: BSD-3-Clause
#include "command_journal.h"
#include "run_executor.h"
#include "scenario_survey.h"
#include "wire.h"

#include <slalom/campaign/measure.h>
#include <slalom/campaign/method_pool.h>
#include <slalom/campaign/run_campaign.h>
#include <slalom/core/enum_names.h>
#include <slalom/core/error.h>
#include <slalom/results/lack_of_time.h>
#include <slalom/results/untimely_commands.h>
#include <slalom/workers/worker_pool.h>

#include <algorithm>
#include <optional>

namespace slalom {
namespace {

/// The findings in the payload of a work item; nullopt when malformed (corrupted process).
template <typename Read>
auto read_payload(const std::string& payload, Read read) -> std::optional<decltype(read(payload))> {
  try {
    return read(payload);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

/// The plan without the runs that the sink already has.
std::vector<RunSpec> remaining_plan(const Campaign& campaign, CampaignSink& sink) {
  std::vector<RunSpec> plan = make_plan(campaign);
  const auto is_known = [&](const RunSpec& spec) {
    return sink.has_run(campaign.scenarios[spec.scenario], spec);
  };
  plan.erase(std::remove_if(plan.begin(), plan.end(), is_known), plan.end());
  return plan;
}

bool are_values_of(const std::vector<std::string>& ids,
                   const std::map<std::string, VersionedValue>& values) {
  return values.size() == ids.size() &&
         std::all_of(ids.begin(), ids.end(),
                     [&](const std::string& id) { return values.count(id) == 1; });
}

/// Whether findings are those of the scenario: all that the parent of the workers compares.
bool are_findings_of(const Campaign& campaign, const Scenario& scenario,
                     const ScenarioFindings& findings) {
  const ScenarioRecord& record = findings.record;
  return record.hash == scenario.hash() && record.name == scenario.name() &&
         are_values_of(campaign.options.descriptors, record.descriptors);
}

/// First phase: descriptors and reference paths of every scenario.
bool survey_scenarios(const Campaign& campaign, CampaignSink& sink, const Execution& execution,
                      std::vector<References>& references) {
  std::vector<std::size_t> missing;
  for (std::size_t i = 0; i < campaign.scenarios.size(); ++i) {
    if (auto known = sink.known_references(campaign.scenarios[i])) {
      references[i] = std::move(*known);
    } else {
      missing.push_back(i);
    }
  }
  const WorkItem item = [&](std::size_t i, SharedTaskLog&) {
    return to_wire(survey_scenario(campaign, campaign.scenarios[missing[i]]));
  };
  std::size_t done = campaign.scenarios.size() - missing.size();
  const auto receive = [&](std::size_t i, WorkResult&& result) {
    const Scenario& scenario = campaign.scenarios[missing[i]];
    auto findings = result.status == WorkResult::Status::Done
                        ? read_payload(result.payload, scenario_findings_from_wire)
                        : std::nullopt;
    if (!findings || !are_findings_of(campaign, scenario, *findings))
      throw job_error("scenario " + scenario.name(),
                      "its descriptors and references could not be computed: " + result.detail);
    sink.add_scenario(findings->record, findings->references, findings->packed);
    references[missing[i]] = std::move(findings->references);
    execution.progress.advance(++done);
  };
  execution.progress.start("Describing scenarios", campaign.scenarios.size());
  if (done > 0) execution.progress.advance(done);
  PoolOptions pool;
  pool.schedule.workers = execution.workers;
  // Planners may have a state of their process, such as OMPL's random generators; the rest of a
  // survey has none, and no method runs there.
  pool.schedule.process_per_item = campaign.planner != nullptr;
  pool.schedule.ordered = false;
  pool.schedule.trusted = true;
  pool.schedule.in_process = execution.in_process;
  const bool complete = run_in_workers(missing.size(), pool, item, receive, execution.interrupted);
  execution.progress.finish();
  return complete;
}

/// The note on scenarios in which nobody can arrive in time.
std::string note_before_runs(const Campaign& campaign, const std::vector<References>& references) {
  LacksOfTime lacks;
  for (std::size_t i = 0; i < references.size(); ++i) {
    if (!may_lack_time(campaign.options, references[i])) continue;
    const Scenario& scenario = campaign.scenarios[i];
    const World world(scenario, campaign.options.simulation.resolution);
    std::string lack = lack_of_time(campaign.options, world, references[i]);
    if (!lack.empty()) lacks.emplace_back(scenario.name(), std::move(lack));
  }
  return lack_of_time_note(lacks, references.size());
}

/// Whether the trajectory, if it is stored, is the one that was hashed: its method may have damaged
/// the process meanwhile.
bool is_intact(const RunFindings& findings, StoredTrajectories stored) {
  const std::string& hash = findings.record.trajectory_hash;
  if (hash.empty() || stored == StoredTrajectories::None) return true;
  const auto trajectory = read_payload(findings.trajectory.bytes(), [](const std::string& bytes) {
    return PackedTrajectory::of_bytes(bytes).unpack("the trajectory of a run");
  });
  return trajectory && trajectory->hash() == hash;
}

/// Whether a worker's findings are those of the planned run. A method may have damaged its process.
bool are_findings_of(const Campaign& campaign, const RunSpec& spec, const RunFindings& findings) {
  const RunRecord& record = findings.record;
  const RunRecord planned = make_run_record(campaign, spec);
  return record.scenario_hash == planned.scenario_hash &&
         record.scenario_name == planned.scenario_name && record.method == planned.method &&
         record.repetition == planned.repetition && record.seed == planned.seed &&
         from_name<Outcome>(record.outcome) &&
         are_values_of(campaign.options.metrics, record.metrics);
}

/// The findings of a run that was not completed.
RunFindings findings_of_failure(const Campaign& campaign, const RunSpec& spec,
                                const WorkResult& result, RunExecutor& executor) {
  const Outcome outcome = outcome_of(result);
  if (outcome == Outcome::InfrastructureError)
    return findings_without_run(campaign, spec, outcome, result.detail);
  return executor.reconstruct(spec, result.log, outcome, result.detail);
}

std::size_t method_index(const Campaign& campaign, const std::string& name) {
  const auto named = std::find_if(campaign.methods.begin(), campaign.methods.end(),
                                  [&](const NamedMethod& one) { return one.name == name; });
  return static_cast<std::size_t>(named - campaign.methods.begin());
}

/// The tables of scenarios, for runs that several processes execute.
SharedInputs shared_tables(const Campaign& campaign, const std::vector<RunSpec>& plan,
                           const std::vector<References>& references, int workers,
                           RunExecutor& executor) {
  SharedInputs tables;
  if (campaign.methods.size() < 2 && workers < 2) return tables;
  tables.of = [&](std::size_t i) -> std::optional<std::size_t> {
    const std::size_t scenario = plan[i].scenario;
    const bool has_others = (i > 0 && plan[i - 1].scenario == scenario) ||
                            (i + 1 < plan.size() && plan[i + 1].scenario == scenario);
    if (!has_others || !references[scenario].unsolvable_reason().empty()) return std::nullopt;
    return scenario;
  };
  tables.make = [&](std::size_t scenario, const ArrayWriter::Sink& sink) {
    World(campaign.scenarios[scenario], campaign.options.simulation.resolution).write_tables(sink);
  };
  tables.use = [&](std::size_t scenario, const SharedArray<std::byte>& memory) {
    executor.use_tables(scenario, memory);
  };
  return tables;
}

/// Second phase: every method in every scenario.
bool run_methods(const Campaign& campaign, CampaignSink& sink, const Execution& execution,
                 const std::vector<References>& references, CampaignSummary& summary) {
  const std::size_t total = make_plan(campaign).size();
  const std::vector<RunSpec> plan = remaining_plan(campaign, sink);
  std::size_t done = total - plan.size();
  RunExecutor executor(campaign, references,
                       !execution.in_process);  // each worker has its own copy after the fork
  const WorkItem item = [&](std::size_t i, SharedTaskLog& log) {
    const References& known = references[plan[i].scenario];
    const std::string& reason = known.unsolvable_reason();
    const RunFindings findings =
        reason.empty()
            ? executor.execute(plan[i], log)
            : findings_without_run(campaign, plan[i], Outcome::UnsolvableScenario, reason);
    // An empty answer is that of a damaged process.
    return is_intact(findings, campaign.options.record.trajectories) ? to_wire(findings) : "";
  };
  std::optional<RunFindings> answer;  // of the run that is received next
  const auto is_valid = [&](std::size_t i, const std::string& payload) {
    answer = read_payload(payload, run_findings_from_wire);
    return answer && are_findings_of(campaign, plan[i], *answer);
  };
  const auto receive = [&](std::size_t i, WorkResult&& result) {
    RunFindings findings = result.status == WorkResult::Status::Done
                               ? std::move(*answer)
                               : findings_of_failure(campaign, plan[i], result, executor);
    findings.timing.output = std::move(result.output);
    sink.add_run(findings.record, findings.timing, findings.trajectory);
    ++summary.runs;
    ++summary.outcomes[findings.record.outcome];
    execution.progress.advance(++done);
  };
  execution.progress.start("Running methods", total);
  if (done > 0) execution.progress.advance(done);
  PoolOptions pool = pool_of_runs(campaign.options, execution.workers);
  pool.schedule.in_process = execution.in_process;
  pool.schedule.ordered = false;
  for (const RunRecorder& recorder : campaign.recorders)
    pool.limits.writable.push_back(recorder.folder);
  pool.schedule.groups = campaign.methods.size();
  pool.schedule.group = [&](std::size_t i) { return method_index(campaign, plan[i].method); };
  pool.inputs = shared_tables(campaign, plan, references, execution.workers, executor);
  pool.schedule.process_per_item = execution.process_per_run;
  pool.hooks.is_valid = is_valid;
  pool.hooks.at_end = [&] { executor.destroy_methods(); };
  const bool complete = run_in_workers(plan.size(), pool, item, receive, execution.interrupted);
  execution.progress.finish();
  return complete;
}

}  // namespace

std::size_t CampaignSummary::infrastructure_errors() const {
  const auto found = outcomes.find(to_string(Outcome::InfrastructureError));
  return found == outcomes.end() ? 0 : found->second;
}

PrivilegedMethods check_methods(const Campaign& campaign) {
  constexpr char kWasMade = '\0';  // begins an answer that is no message
  const std::vector<NamedMethod>& methods = campaign.methods;
  PrivilegedMethods privileged;
  const WorkItem item = [&](std::size_t i, SharedTaskLog&) -> std::string {
    try {
      const auto made = methods[i].make(campaign.options.robot, campaign.options.sensor);
      made->check();
      return {kWasMade, made->uses_tracks() ? '1' : '0', made->uses_map() ? '1' : '0'};
    } catch (const std::exception& e) {
      return reason_of(e);
    }
  };
  const auto receive = [&](std::size_t i, WorkResult&& result) {
    const std::string printed = error_printed_clause(result.output);
    if (result.status != WorkResult::Status::Done)
      throw usage_error(methods[i].where,
                        "the method could not be built: " + result.detail + printed);
    const std::string& answer = result.payload;
    const bool made = answer.size() == 3 && answer[0] == kWasMade;
    if (!made) throw Error(ErrorKind::Usage, answer + printed);  // a complete message
    privileged.add(methods[i].name, answer[1] == '1', answer[2] == '1');
  };
  PoolOptions pool = pool_of_runs(campaign.options, 1);
  pool.schedule.process_per_item = true;
  run_in_workers(methods.size(), pool, item, receive, nullptr);
  return privileged;
}

CampaignSummary run_campaign(const Campaign& campaign, CampaignSink& sink,
                             const Execution& execution) {
  CampaignSummary summary;
  std::vector<References> references(campaign.scenarios.size());
  if (!survey_scenarios(campaign, sink, execution, references)) return summary;
  if (const std::string note = note_before_runs(campaign, references); !note.empty())
    sink.warn(note);
  summary.complete = run_methods(campaign, sink, execution, references, summary);
  return summary;
}

}  // namespace slalom
