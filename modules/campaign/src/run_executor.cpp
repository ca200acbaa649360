#include "command_journal.h"
#include "run_executor.h"
#include "scripted_method.h"

#include <slalom/campaign/measure.h>
#include <slalom/core/error.h>
#include <slalom/metrics/cycle_time.h>

#include <chrono>

namespace slalom {
namespace {

bool is_methods_failure(Outcome outcome) {
  return outcome == Outcome::MethodError || outcome == Outcome::MethodInvalidCommand ||
         outcome == Outcome::MethodDeadline;
}

/// Passes a repeated run on to an observer, ended as the run that it repeats: a script that comes
/// to its end looks like a method_error, whatever the reason was.
class EndedAs : public RunObserver {
 public:
  EndedAs(Outcome outcome, RunObserver* next) : outcome_(outcome), next_(next) {}

  void on_start(const Task& task) override {
    if (next_ != nullptr) next_->on_start(task);
  }
  void on_cycle(const Observation& observation, const Command& command,
                const mrpt::math::TPose2D& pose) override {
    if (next_ != nullptr) next_->on_cycle(observation, command, pose);
  }
  void on_end(const SimulationResult& result) override {
    if (next_ == nullptr) return;
    SimulationResult ended = result;
    apply(ended);
    next_->on_end(ended);
  }
  void apply(SimulationResult& result) const {
    if (result.outcome == Outcome::MethodError) result.outcome = outcome_;
  }

 private:
  Outcome outcome_;
  RunObserver* next_;
};

}  // namespace

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

RunFindings RunExecutor::execute(const RunSpec& spec, TaskNotes& notes) {
  const auto begin = std::chrono::steady_clock::now();
  CommandJournal journal(notes);
  const SimulationResult result = drive(spec, journal);
  const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begin;
  if (is_methods_failure(result.outcome)) notes.retire_worker();
  record(spec, notes.contents(), result);
  RunFindings findings = evaluate(spec, result);
  findings.timing.values = cycle_time_statistics(result.cycle_seconds, cycle_limit());
  findings.timing.wall_seconds = taken.count();
  return findings;
}

/// A method that takes longer than this cannot keep pace: the limit on a cycle, else its period.
double RunExecutor::cycle_limit() const {
  const RunSetup& setup = campaign_.options.setup;
  return setup.deadline.cycle_deadline > 0 ? setup.deadline.cycle_deadline
                                           : setup.simulation.control_period;
}

SimulationResult RunExecutor::drive(const RunSpec& spec, RunObserver& observer) {
  const World& place = world(spec.scenario);
  const RunSetup& setup = campaign_.options.setup;
  std::string reason;
  try {
    return simulate(place, setup, spec.seed, method(spec.method), &observer);
  } catch (const Error& cannot_be_built) {
    reason = cannot_be_built.what();
  }
  ScriptedMethod none({}, reason);
  return simulate(place, setup, spec.seed, none, &observer);
}

RunFindings RunExecutor::reconstruct(const RunSpec& spec, const std::string& notes, Outcome outcome,
                                     const std::string& detail) {
  const SimulationResult result = drive_again(spec, notes, outcome, detail, nullptr);
  record(spec, notes, result);
  return evaluate(spec, result);
}

SimulationResult RunExecutor::drive_again(const RunSpec& spec, const std::string& notes,
                                          Outcome outcome, const std::string& detail,
                                          RunObserver* observer) {
  RunSetup setup = campaign_.options.setup;
  setup.deadline = {};  // what counts is how long the method took, not its repetition
  ScriptedMethod script(CommandJournal::read(notes, setup.robot), detail);
  EndedAs ended(outcome, observer);
  SimulationResult result = simulate(world(spec.scenario), setup, spec.seed, script, &ended);
  ended.apply(result);
  return result;
}

/// A run is recorded by driving it again under its own commands: the same bytes whether the method
/// lived or died, and nothing is spent on runs that are not recorded.
void RunExecutor::record(const RunSpec& spec, const std::string& notes,
                         const SimulationResult& result) {
  if (!campaign_.recorder || !campaign_.options.record.wants(result.outcome)) return;
  const std::unique_ptr<RunObserver> recorder = campaign_.recorder(spec);
  drive_again(spec, notes, result.outcome, result.detail, recorder.get());
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

RunFindings RunExecutor::evaluate(const RunSpec& spec, const SimulationResult& result) {
  RunFindings findings;
  findings.record = blank_record(campaign_, spec);
  RunRecord& record = findings.record;
  record.outcome = to_string(result.outcome);
  record.outcome_detail = result.detail;
  record.trajectory_hash = result.trajectory.hash();
  record.metrics = measure_run(campaign_.options, world(spec.scenario), references_[spec.scenario],
                               result.trajectory, result.outcome);
  findings.trajectory = result.trajectory;
  return findings;
}

RunFindings findings_without_run(const Campaign& campaign, const RunSpec& spec, Outcome outcome,
                                 const std::string& detail) {
  RunFindings findings;
  findings.record = blank_record(campaign, spec);
  findings.record.outcome = to_string(outcome);
  findings.record.outcome_detail = detail;
  for (const std::string& id : campaign.options.metrics)
    findings.record.metrics[id] = {metric(id).info().version,
                                   Value::na("outcome: " + findings.record.outcome)};
  return findings;
}

}  // namespace slalom
