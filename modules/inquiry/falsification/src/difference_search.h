// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "probing.h"

#include <slalom/falsification/candidates.h>
#include <slalom/falsification/search.h>

#include <functional>
#include <memory>
#include <optional>

namespace slalom {

/// A small random change of a scenario that is fair; null if there is none in a few attempts.
std::unique_ptr<World> draw_changed_world(const Scenario& parent, const FalsificationSetup& setup,
                                          const FairnessOptions& fairness, RandomEngine& engine);

/// Candidates that approach a difference of commands, and then climb from the run that came
/// closest to a failure: (1+1), by the clearance that the method lost against its reference. That
/// has no gradient before the two differ, but has one then.
class DifferenceSearch {
 public:
  DifferenceSearch(const FalsificationSetup& setup, const SearchOptions& options,
                   const CandidateMix& mix, MethodPool& methods)
      : setup_(setup), options_(options), mix_(mix), probe_(setup, methods) {}

  /// Forgets what was found, so that candidates depend only on those since.
  void reset() { difference_.reset(); }
  /// Null if no difference was found. `alive` is called before each world that is probed.
  std::unique_ptr<World> draw(std::uint64_t index, const std::function<void()>& alive);
  /// The run of the method in the scenario that was drawn last, which is no failure.
  void report(const Scenario& scenario, const Trial& method, const Trial& reference);
  /// It is a failure: the next candidate approaches another difference.
  void succeed() { difference_.reset(); }

 private:
  void find_difference(std::uint64_t index, const std::function<void()>& alive);

  const FalsificationSetup& setup_;
  const SearchOptions& options_;
  const CandidateMix& mix_;
  StepProbe probe_;
  std::optional<CommandDifference> difference_;
  int candidates_ = 0;  ///< of this difference
  std::optional<Scenario> best_;
  double best_loss_ = 0;  ///< m of clearance, in the best scenario
};

}  // namespace slalom
