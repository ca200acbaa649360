// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "difference_search.h"
#include "isolated_trials.h"

#include <slalom/falsification/candidates.h>
#include <slalom/falsification/search.h>

#include <vector>

namespace slalom {

/// Consecutive candidates of one strategy, executed in one process.
struct SearchBatch {
  SearchStrategy strategy = SearchStrategy::Random;
  std::uint64_t begin = 0, end = 0;  ///< indexes
};

/// A candidate that was run.
struct CandidateRun {
  std::uint64_t index = 0;
  std::string scenario;  ///< serialized
  Trial trial;
  bool complete = false;   ///< false: the process died during this run
  bool witnessed = false;  ///< a witness reaches the goal; only of failures
};

/// Draws and runs the candidates of batches. A worker process has a copy of its own.
class BatchRunner {
 public:
  BatchRunner(const FalsificationSetup& setup, const SearchOptions& options);

  /// Adaptive candidates are changed ones of these; the reference must remain valid.
  void set_parents(const std::vector<SearchState::NearMiss>& parents) { parents_ = &parents; }
  /// Logs the beginning and the end of each run; `begun` gets a heartbeat for each.
  void execute(const SearchBatch& batch, SharedTaskLog& log, SharedTaskLog& begun);
  /// One candidate; a probed one depends on those since the last batch began. Whether it is a
  /// failure, and a witness reaches the goal.
  bool run(SearchStrategy strategy, std::uint64_t index, SharedTaskLog& log);

  bool is_failure(Outcome outcome) const;

 private:
  std::unique_ptr<World> draw(SearchStrategy strategy, std::uint64_t index, SharedTaskLog& log);
  std::unique_ptr<World> draw_adaptive(std::uint64_t index, SharedTaskLog& log);
  std::unique_ptr<World> draw_of_surrogate(std::uint64_t index, SharedTaskLog& log);
  std::unique_ptr<World> draw_changed(std::uint64_t index) const;
  bool has_witness(const World& world);

  const FalsificationSetup& setup_;
  const SearchOptions& options_;
  CandidateMix mix_;
  MethodPool methods_;
  DifferenceSearch hunt_;
  const std::vector<SearchState::NearMiss>* parents_ = nullptr;
};

/// The runs in the log of a batch.
std::vector<CandidateRun> read_batch_log(const std::string& log);

}  // namespace slalom
