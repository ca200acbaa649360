// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/campaign/campaign_options.h>
#include <slalom/references/reference.h>
#include <slalom/scenario/scenario.h>
#include <slalom/simulation/run_observer.h>

#include <cstddef>
#include <cstdint>
#include <functional>
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

/// How runs are recorded in files.
struct RunRecorder {
  RecordedRuns runs = RecordedRuns::None;  ///< those that are recorded
  std::string folder;                      ///< workers in a sandbox can write there too
  /// Creates the observer that records a run. Called in worker processes, or in the calling process
  /// for runs whose worker process died.
  std::function<std::unique_ptr<RunObserver>(const Scenario&, const RunSpec&)> make;
};

/// The plan: every method runs every scenario `repetitions` times.
struct Campaign {
  CampaignOptions options;
  std::vector<Scenario> scenarios;            ///< with distinct content hashes
  std::vector<NamedMethod> methods;           ///< with distinct names
  const ReferencePlanner* planner = nullptr;  ///< null: exact search only
  std::vector<RunRecorder> recorders = {};
};

/// The seed of a run. It is the same for all methods, so that they are exposed to the same noise,
/// and independent of the other scenarios, methods and repetitions.
std::uint64_t run_seed(std::uint64_t campaign_seed, const std::string& scenario_hash,
                       int repetition);

}  // namespace slalom
