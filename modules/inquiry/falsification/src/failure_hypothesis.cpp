// SPDX-License-Identifier: BSD-3-Clause
#include "failure_hypothesis.h"

namespace slalom {

const Judgment& FailureTest::judge(const Scenario& scenario) {
  const auto found = known_.find(scenario.hash());
  if (found != known_.end()) return found->second;
  return known_[scenario.hash()] = decide(scenario);
}

const Trial& FailureTest::trial(const Scenario& scenario) {
  return trials_.trial(World(scenario, setup_.run.simulation.resolution), 0);
}

Judgment FailureTest::decide(const Scenario& scenario) {
  if (exhausted()) return {false, "not run: the limit of runs is reached"};
  const World world(scenario, setup_.run.simulation.resolution);
  const GeometryReport geometry = judge_geometry(world, setup_.run.robot, fairness_);
  if (!geometry.violation.empty()) {
    ++unfair_;
    return {false, geometry.violation};
  }
  ++runs_;
  const Trial& run = trials_.trial(world, 0);
  if (run.outcome != outcome_) return {false, setup_.method.name + ": " + to_string(run.outcome)};
  if (!needs_witness(fairness_, scenario, outcome_)) return {true, "the same failure"};
  std::string reason;
  for (const std::size_t i : setup_.witnesses_in(scenario)) {
    ++runs_;
    const Outcome outcome = trials_.trial(world, i).outcome;
    if (outcome == Outcome::Success) return {true, "the same failure"};
    reason += (reason.empty() ? "" : ", ") + setup_.witness_name(i) + ": " + to_string(outcome);
  }
  return {false, reason.empty() ? "no witness is named" : reason};
}

}  // namespace slalom
