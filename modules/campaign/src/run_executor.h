#pragma once

#include "wire.h"

#include <slalom/campaign/campaign.h>
#include <slalom/scenario/world.h>

#include <map>
#include <memory>

namespace slalom {

/// All runs in the order of the plan: by scenario, then method, then repetition.
std::vector<RunSpec> make_plan(const Campaign& campaign);

/// A record with everything known before the run.
RunRecord blank_record(const Campaign& campaign, const RunSpec& spec);

/// Executes runs one after another in a worker process; keeps the methods and the last scenario's
/// tables between runs.
class RunExecutor {
 public:
  RunExecutor(const Campaign& campaign, const std::vector<References>& references)
      : campaign_(campaign), references_(references) {}

  /// Drives a run under its method; notes every command, and that the worker must be replaced when
  /// the method failed.
  RunFindings execute(const RunSpec& spec, TaskNotes& notes);

  /// The findings of a run whose process died: driven again, without the method, under the commands
  /// that it had noted.
  RunFindings reconstruct(const RunSpec& spec, const std::string& notes, Outcome outcome,
                          const std::string& detail);

 private:
  const World& world(std::size_t scenario);
  Method& method(const std::string& name);
  SimulationResult drive(const RunSpec& spec, RunObserver& observer);
  double cycle_limit() const;  ///< s
  SimulationResult drive_again(const RunSpec& spec, const std::string& notes, Outcome outcome,
                               const std::string& detail, RunObserver* observer);
  void record(const RunSpec& spec, const std::string& notes, const SimulationResult& result);
  RunFindings evaluate(const RunSpec& spec, const SimulationResult& result);

  const Campaign& campaign_;
  const std::vector<References>& references_;
  std::map<std::string, std::unique_ptr<Method>> methods_;
  std::unique_ptr<World> world_;
  std::size_t world_scenario_ = 0;
};

/// The record of a run that never began (unsolvable scenario, a fault of ours): all metrics are NA
/// because of the outcome.
RunFindings findings_without_run(const Campaign& campaign, const RunSpec& spec, Outcome outcome,
                                 const std::string& detail);

}  // namespace slalom
