// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "wire.h"

#include <slalom/campaign/campaign.h>
#include <slalom/people/run_alone.h>
#include <slalom/scenario/world.h>
#include <slalom/workers/shared_task_log.h>

#include <cfenv>
#include <map>
#include <memory>

namespace slalom {

/// All runs in the order of the plan: by scenario, then method, then repetition.
std::vector<RunSpec> make_plan(const Campaign& campaign);

/// A record with the fields that are known before the run.
RunRecord make_run_record(const Campaign& campaign, const RunSpec& spec);

/// Executes runs sequentially in a worker process. Methods and the world of the last scenario are
/// reused between runs.
class RunExecutor {
 public:
  /// `own_process`: execute() is called in a worker process, whose state it may restore.
  RunExecutor(const Campaign& campaign, const std::vector<References>& references,
              bool own_process);

  /// Executes a run. Logs every command, and retires the worker when the method failed, or left the
  /// process in a state that cannot be restored.
  RunFindings execute(const RunSpec& spec, SharedTaskLog& log);

  /// Uses tables of World::write_tables() for the runs in a scenario that follow.
  void use_tables(std::size_t scenario, const SharedArray<std::byte>& tables);

  /// The world of a scenario, with all tables, until that of another one is asked for.
  const World& world(std::size_t scenario);

  /// Ends the life of all methods that execute() has constructed.
  void destroy_methods() { methods_.clear(); }

  /// The findings of a run whose process died, reconstructed by replaying the logged commands
  /// without the method.
  RunFindings reconstruct(const RunSpec& spec, const std::string& log, Outcome outcome,
                          const std::string& detail);

 private:
  PeopleAlone* people_alone();  ///< those in world_; null without people
  Method& method(const std::string& name);
  SimulationResult simulate_run(const RunSpec& spec, SharedTaskLog& log);
  SimulationResult simulate_contained(const RunSpec& spec, Method& method, SharedTaskLog& log);
  double cycle_limit() const;                     ///< s
  RunSetup setup_in(std::size_t scenario) const;  ///< with the time limit of its runs
  SimulationResult replay(const RunSpec& spec, const std::string& log, Outcome outcome,
                          const std::string& detail, RunObserver* observer);
  void record(const RunSpec& spec, const std::string& log, const SimulationResult& result);
  RunFindings evaluate(const RunSpec& spec, const SimulationResult& result);

  const Campaign& campaign_;
  const std::vector<References>& references_;
  bool own_process_;
  std::fenv_t floating_point_ = {};  ///< rounding mode etc. before any method
  std::map<std::string, std::unique_ptr<Method>> methods_;
  std::unique_ptr<World> world_;
  std::size_t world_scenario_ = 0;
  std::unique_ptr<PeopleAlone> people_alone_;
};

/// The record of a run that was not executed (unsolvable scenario, infrastructure error): all
/// metrics are NA with the outcome as the reason.
RunFindings findings_without_run(const Campaign& campaign, const RunSpec& spec, Outcome outcome,
                                 const std::string& detail);

}  // namespace slalom
