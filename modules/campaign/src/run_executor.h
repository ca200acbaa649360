#pragma once

#include "wire.h"

#include <slalom/campaign/campaign.h>
#include <slalom/scenario/world.h>

#include <map>
#include <memory>

namespace slalom {

/// One run of the plan.
struct RunSpec {
  std::size_t scenario = 0;  ///< index into Campaign::scenarios
  std::string method;
  int repetition = 0;
  std::uint64_t seed = 0;
};

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

  RunFindings execute(const RunSpec& spec);

 private:
  const World& world(std::size_t scenario);
  Method& method(const std::string& name);
  void evaluate(const World& world, const References& references, const SimulationResult& result,
                RunFindings& findings) const;

  const Campaign& campaign_;
  const std::vector<References>& references_;
  std::map<std::string, std::unique_ptr<Method>> methods_;
  std::unique_ptr<World> world_;
  std::size_t world_scenario_ = 0;
};

/// The record of a run that left no trajectory (crash, deadline, unsolvable scenario): metrics that
/// count failures count it, all others are NA because of the outcome.
RunFindings findings_without_trajectory(const Campaign& campaign, const RunSpec& spec,
                                        Outcome outcome, const std::string& detail);

}  // namespace slalom
