// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign.h>
#include <slalom/core/progress.h>
#include <slalom/io/packed_scenario.h>
#include <slalom/io/packed_trajectory.h>
#include <slalom/results/privileged.h>
#include <slalom/results/run_record.h>

#include <cstddef>
#include <functional>
#include <map>
#include <optional>
#include <string>

namespace slalom {

/// Receives the results of a campaign as they are obtained: scenarios before runs, each in any
/// order. What it already has, from an earlier part of the same campaign, is not computed again.
class CampaignSink {
 public:
  virtual ~CampaignSink() = default;
  /// The references of a scenario that the sink has; none otherwise.
  virtual std::optional<References> known_references(const Scenario&) { return std::nullopt; }
  virtual bool has_run(const Scenario&, const RunSpec&) { return false; }
  /// A line before the first run, without which its results would be misunderstood.
  virtual void warn(const std::string&) {}
  virtual void add_scenario(const ScenarioRecord& record, const References& references,
                            const PackedScenario& packed) = 0;
  virtual void add_run(const RunRecord& run, const RunTiming& timing,
                       const PackedTrajectory& trajectory) = 0;
};

/// Execution settings; none of them affects deterministic results.
struct Execution {
  int workers = 1;
  Progress& progress;
  std::function<bool()> interrupted;  ///< polled; null: never interrupted
  bool in_process = false;            ///< without worker processes and their limits
  bool process_per_run = false;       ///< a worker process for each run

  bool is_interrupted() const { return interrupted && interrupted(); }
};

struct CampaignSummary {
  bool complete = false;                        ///< false when interrupted
  std::size_t runs = 0;                         ///< that were executed
  std::map<std::string, std::size_t> outcomes;  ///< these runs by outcome
  std::size_t infrastructure_errors() const;
};

/// Builds every method once in a separate process, so that an invalid option, class or library is
/// reported before the first run. Throws Error (Usage) with the method's origin. Returns the
/// methods that use tracks or the map.
PrivilegedMethods check_methods(const Campaign& campaign);

/// Computes the descriptors and references of every scenario (in processes of their own), then runs
/// every method on it in worker processes, except what the sink already has. The records do not
/// depend on the number of workers.
CampaignSummary run_campaign(const Campaign& campaign, CampaignSink& sink,
                             const Execution& execution);

}  // namespace slalom
