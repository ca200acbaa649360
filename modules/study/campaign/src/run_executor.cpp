// SPDX-License-Identifier: BSD-3-Clause
#include "command_journal.h"
#include "run_executor.h"
#include "scripted_method.h"

#include <slalom/campaign/measure.h>
#include <slalom/core/error.h>
#include <slalom/metrics/cycle_time.h>
#include <slalom/results/method_failures.h>
#include <slalom/workers/process_state.h>

#include <algorithm>
#include <chrono>
#include <optional>

namespace slalom {
namespace {

/// Forwards a replayed run to an observer with the outcome of the original run. (When a script
/// ends, the simulator reports method_error, whatever the original outcome was.)
class OutcomeOverride : public RunObserver {
 public:
  OutcomeOverride(Outcome outcome, std::string detail, RunObserver* next)
      : outcome_(outcome), detail_(std::move(detail)), next_(next) {}

  void on_start(const NavigationTask& task) override {
    if (next_ != nullptr) next_->on_start(task);
  }
  void on_cycle(const Observation& observation, const Command& command,
                const mrpt::math::TPose2D& pose) override {
    if (next_ != nullptr) next_->on_cycle(observation, command, pose);
  }
  void on_end(const SimulationResult& result) override {
    if (next_ == nullptr) return;
    SimulationResult overridden = result;
    apply(overridden);
    next_->on_end(overridden);
  }
  void apply(SimulationResult& result) const {
    if (result.outcome == outcome_) return;
    // A worker may also have failed when the simulation had ended.
    if (result.outcome != Outcome::MethodError)
      result.detail = detail_ + ", after the end of the run";
    result.outcome = outcome_;
  }

 private:
  Outcome outcome_;
  std::string detail_;
  RunObserver* next_;
};

/// The commands that repeat a run alone, from the list and the .ini of its campaign.
std::string reproduction(const Campaign& campaign, const RunSpec& spec) {
  return "slalom-scenarios select LIST.scenarios --ids " +
         campaign.scenarios[spec.scenario].hash() +
         " -o one.scenarios && slalom-simulate run CAMPAIGN.ini --scenarios one.scenarios"
         " -o one.results --seed " +
         std::to_string(campaign.options.seed) + " --set campaign.methods=" + spec.method +
         " --set campaign.repetitions=" + std::to_string(spec.repetition + 1);
}

}  // namespace

std::vector<RunSpec> make_plan(const Campaign& campaign) {
  const CampaignOptions& options = campaign.options;
  std::vector<RunSpec> plan;
  plan.reserve(campaign.scenarios.size() * campaign.methods.size() *
               static_cast<std::size_t>(options.repetitions));
  for (std::size_t i = 0; i < campaign.scenarios.size(); ++i)
    for (const NamedMethod& method : campaign.methods)
      for (int repetition = 0; repetition < options.repetitions; ++repetition)
        plan.push_back({i, method.name, repetition,
                        run_seed(options.seed, campaign.scenarios[i].hash(), repetition)});
  return plan;
}

RunRecord make_run_record(const Campaign& campaign, const RunSpec& spec) {
  const Scenario& scenario = campaign.scenarios[spec.scenario];
  RunRecord record;
  record.scenario_hash = scenario.hash();
  record.scenario_name = scenario.name();
  record.method = spec.method;
  record.repetition = spec.repetition;
  record.seed = spec.seed;
  return record;
}

RunExecutor::RunExecutor(const Campaign& campaign, const std::vector<References>& references,
                         bool own_process)
    : campaign_(campaign), references_(references), own_process_(own_process) {
  std::fegetenv(&floating_point_);
}

RunFindings RunExecutor::execute(const RunSpec& spec, SharedTaskLog& log) {
  const auto begin = std::chrono::steady_clock::now();
  const SimulationResult result = simulate_run(spec, log);
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  if (is_method_failure(to_string(result.outcome))) {
    log.retire_worker();
    methods_.erase(spec.method);  // in case there is no worker process
  }
  record(spec, log.contents(), result);
  RunFindings findings = evaluate(spec, result);
  findings.timing.values = cycle_time_statistics(result.cycle_seconds, cycle_limit());
  findings.timing.values.insert(result.figures.begin(), result.figures.end());
  findings.timing.wall_seconds = elapsed.count();
  return findings;
}

/// The time limit of a control cycle: the cycle deadline if set, else the control period.
double RunExecutor::cycle_limit() const {
  const RunSetup& setup = campaign_.options;
  return setup.deadline.cycle_deadline > 0 ? setup.deadline.cycle_deadline
                                           : setup.simulation.control_period;
}

RunSetup RunExecutor::setup_in(std::size_t scenario) const {
  RunSetup setup = campaign_.options;
  setup.simulation.max_time = time_limit(setup, references_[scenario]);
  return setup;
}

SimulationResult RunExecutor::simulate_run(const RunSpec& spec, SharedTaskLog& log) {
  std::string reason;
  Method* built = nullptr;
  try {
    built = &method(spec.method);
  } catch (const std::exception& error) {
    reason = reason_of(error);
  }
  if (built != nullptr) return simulate_contained(spec, *built, log);
  ScriptedMethod failing({}, reason);
  return simulate_contained(spec, failing, log);
}

/// Neither the construction of a method nor its run affects the arithmetic of the simulator before,
/// or of anything after.
SimulationResult RunExecutor::simulate_contained(const RunSpec& spec, Method& method,
                                                 SharedTaskLog& log) {
  std::fesetenv(&floating_point_);
  const World& scenario_world = world(spec.scenario);
  std::optional<ProcessState> before;
  if (own_process_) before.emplace();
  CommandJournal journal(log);
  SimulationResult result = simulate(scenario_world, setup_in(spec.scenario), spec.seed, method,
                                     &journal, people_alone());
  std::fesetenv(&floating_point_);
  if (before && !before->restore()) log.retire_worker();
  return result;
}

RunFindings RunExecutor::reconstruct(const RunSpec& spec, const std::string& log, Outcome outcome,
                                     const std::string& detail) {
  const SimulationResult result = replay(spec, log, outcome, detail, nullptr);
  record(spec, log, result);
  return evaluate(spec, result);
}

SimulationResult RunExecutor::replay(const RunSpec& spec, const std::string& log, Outcome outcome,
                                     const std::string& detail, RunObserver* observer) {
  RunSetup setup = setup_in(spec.scenario);
  setup.deadline = {};  // deadlines applied to the original run only
  ScriptedMethod script(CommandJournal::read(log, setup.robot), detail);
  OutcomeOverride outcome_override(outcome, detail, observer);
  const World& scenario_world = world(spec.scenario);
  SimulationResult result =
      simulate(scenario_world, setup, spec.seed, script, &outcome_override, people_alone());
  outcome_override.apply(result);
  return result;
}

/// Records a run by replaying its commands. The recording does not depend on whether the method
/// crashed, and runs that are not recorded cause no overhead.
void RunExecutor::record(const RunSpec& spec, const std::string& log,
                         const SimulationResult& result) {
  for (const RunRecorder& recorder : campaign_.recorders) {
    if (!is_recorded(recorder.runs, result.outcome)) continue;
    const auto observer = recorder.make(campaign_.scenarios[spec.scenario], spec);
    replay(spec, log, result.outcome, result.detail, observer.get());
  }
}

const World& RunExecutor::world(std::size_t scenario) {
  if (!world_ || world_scenario_ != scenario) {
    people_alone_.reset();
    world_ = std::make_unique<World>(campaign_.scenarios[scenario],
                                     campaign_.options.simulation.resolution);
    // All tables before a method can change the floating-point environment.
    world_->distance_field();
    world_->ray_caster();
    world_scenario_ = scenario;
  }
  return *world_;
}

void RunExecutor::use_tables(std::size_t scenario, const SharedArray<std::byte>& tables) {
  if (world_ && world_scenario_ == scenario) return;
  people_alone_.reset();
  world_.reset();
  world_ = std::make_unique<World>(campaign_.scenarios[scenario],
                                   campaign_.options.simulation.resolution, tables);
  world_scenario_ = scenario;
}

/// The ways of people, and their motion without a robot, are computed once for all runs in the
/// scenario.
PeopleAlone* RunExecutor::people_alone() {
  if (!people_alone_ && !world_->scenario().people().empty())
    people_alone_ = std::make_unique<PeopleAlone>(*world_, campaign_.options.people);
  return people_alone_.get();
}

Method& RunExecutor::method(const std::string& name) {
  std::unique_ptr<Method>& method = methods_[name];
  if (!method) {
    const auto named = std::find_if(campaign_.methods.begin(), campaign_.methods.end(),
                                    [&](const NamedMethod& one) { return one.name == name; });
    method = named->make(campaign_.options.robot, campaign_.options.sensor);
  }
  return *method;
}

RunFindings RunExecutor::evaluate(const RunSpec& spec, const SimulationResult& result) {
  const std::string violation =
      bound_violation(campaign_.options, world(spec.scenario), references_[spec.scenario],
                      result.trajectory, result.outcome);
  if (!violation.empty())
    return findings_without_run(campaign_, spec, Outcome::InfrastructureError,
                                violation + "; to reproduce: " + reproduction(campaign_, spec));
  RunFindings findings;
  findings.record = make_run_record(campaign_, spec);
  RunRecord& record = findings.record;
  record.outcome = to_string(result.outcome);
  record.outcome_detail = result.detail;
  const std::string lack =
      lack_of_time(campaign_.options, world(spec.scenario), references_[spec.scenario]);
  if (!lack.empty()) record.outcome_detail += "; " + lack;
  record.trajectory_hash = result.trajectory.hash();
  record.metrics = measure_run(campaign_.options, world(spec.scenario), references_[spec.scenario],
                               result.trajectory, result.outcome, result.movers, result.hindrances);
  if (campaign_.options.record.trajectories != StoredTrajectories::None)
    findings.trajectory = result.trajectory;
  return findings;
}

RunFindings findings_without_run(const Campaign& campaign, const RunSpec& spec, Outcome outcome,
                                 const std::string& detail) {
  RunFindings findings;
  findings.record = make_run_record(campaign, spec);
  findings.record.outcome = to_string(outcome);
  findings.record.outcome_detail = detail;
  for (const std::string& id : campaign.options.metrics)
    findings.record.metrics[id] = {metric(id).info.version,
                                   Value::na("outcome: " + findings.record.outcome)};
  return findings;
}

}  // namespace slalom
