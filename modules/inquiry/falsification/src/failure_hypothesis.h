// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "isolated_trials.h"

#include <slalom/falsification/fairness.h>

#include <map>
#include <string>

namespace slalom {

/// Whether a scenario is accepted, and otherwise the reason.
struct Judgment {
  bool accepted = false;
  std::string reason;  ///< "the same failure", "mine: success", "bottleneck 1.2 robot widths, ..."
};

/// Decides whether a scenario shows a given failure, fairly. Each scenario is judged once: first
/// its geometry, then the method, then the witnesses.
class FailureTest {
 public:
  FailureTest(TrialSource& trials, const FalsificationSetup& setup, Outcome outcome,
              const FairnessOptions& fairness, std::size_t max_runs)
      : trials_(trials),
        setup_(setup),
        outcome_(outcome),
        fairness_(fairness),
        max_runs_(max_runs) {}

  const Judgment& judge(const Scenario& scenario);
  const Trial& trial(const Scenario& scenario);  ///< of the method

  std::size_t runs() const { return runs_; }      ///< of the method and of witnesses
  std::size_t unfair() const { return unfair_; }  ///< refused for their geometry, without a run
  bool exhausted() const { return runs_ >= max_runs_; }  ///< whatever is new is refused

 private:
  Judgment decide(const Scenario& scenario);

  TrialSource& trials_;
  const FalsificationSetup& setup_;
  Outcome outcome_;
  FairnessOptions fairness_;
  std::size_t max_runs_, runs_ = 0, unfair_ = 0;
  std::map<std::string, Judgment> known_;  ///< by scenario hash
};

}  // namespace slalom
