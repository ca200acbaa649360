#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/core/progress.h>
#include <slalom/descriptors/descriptor.h>
#include <slalom/methods/registry.h>
#include <slalom/metrics/metric.h>
#include <slalom/references/reference.h>
#include <slalom/results/run_record.h>
#include <slalom/scenario/scenario.h>
#include <slalom/simulation/run_observer.h>

#include <functional>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace slalom {

/// One run of the plan.
struct RunSpec {
  std::size_t scenario = 0;  ///< index into Campaign::scenarios
  std::string method;
  int repetition = 0;
  std::uint64_t seed = 0;
};

/// The plan: every method drives every scenario `repetitions` times.
struct Campaign {
  CampaignOptions options;
  std::vector<Scenario> scenarios;  ///< distinct contents
  const IniFile& ini;               ///< for the methods' own sections
  const MethodRegistry& methods;
  const ReferencePlanner* planner = nullptr;  ///< null: the exact search alone
  /// Makes the observer that records a run; null: nothing is recorded. Called in worker processes,
  /// and for runs that killed theirs in the caller's.
  std::function<std::unique_ptr<RunObserver>(const RunSpec&)> recorder = nullptr;
};

/// Takes what a campaign finds, in the order of the plan (scenario, method, repetition).
class CampaignSink {
 public:
  virtual ~CampaignSink() = default;
  virtual void add_scenario(const ScenarioRecord& record, const Scenario& scenario,
                            const References& references) = 0;
  virtual void add_run(const RunRecord& run, const RunTiming& timing,
                       const Trajectory& trajectory) = 0;
};

/// How a campaign is run; none of it changes a deterministic result.
struct Execution {
  int workers = 1;
  Progress& progress;
  std::function<bool()> interrupted;  ///< polled; null for never
};

struct CampaignSummary {
  bool complete = false;  ///< false when interrupted
  std::size_t runs = 0;
  std::map<std::string, std::size_t> outcomes;  ///< runs by outcome
  std::size_t infrastructure_errors() const;
};

/// The seed of a run: the same for all methods, so that they meet the same noise, and independent
/// of which other scenarios, methods or repetitions there are.
std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario_hash,
                       int repetition);

/// Builds every method once in a process of its own, so that a wrong option, class or library is
/// reported before anything runs. Throws Error (Usage) with the method's section.
void check_methods(const Campaign& campaign);

/// Describes every scenario and finds its references (each in a fresh process), then runs every
/// method on it in worker processes. The same campaign gives the same records with any number of
/// workers.
CampaignSummary run_campaign(const Campaign& campaign, CampaignSink& sink,
                             const Execution& execution);

}  // namespace slalom
