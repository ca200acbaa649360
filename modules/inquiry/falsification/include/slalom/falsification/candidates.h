// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include <slalom/falsification/fairness.h>
#include <slalom/generation/generator.h>

#include <cstdint>
#include <memory>
#include <vector>

namespace slalom {

/// A workspace of 6 m x 6 m with one to six obstacles (discs with log-uniform radii of 3 to 50 cm,
/// bars, parallel pairs of bars) about a straight task of 3 to 4.6 m; for a robot of radius 0.25 m,
/// all lengths are multiplied by `scale`. A candidate: it need not be solvable.
Scenario draw_micro_world(RandomEngine& engine, double scale);

/// The scenarios in which failures are searched: half of them micro-worlds, half of families of
/// generators: random and poisson_forest (two eighths each), mazes with passages of 1.2 m and 0.9
/// m, rooms and traps (an eighth each), in workspaces of 6 to 12 m. Lengths are scaled with the
/// robot.
class CandidateMix {
 public:
  explicit CandidateMix(const RobotModel& robot);
  Scenario draw(RandomEngine& engine) const;

 private:
  double scale_;
  std::vector<std::unique_ptr<Generator>> families_;  ///< with equal weights
};

/// Candidate number `index`: the first one that meets the geometric conditions, with the walkers
/// of the setup. Throws Error (Job) if a thousand attempts do not suffice.
std::unique_ptr<World> draw_fair_world(const CandidateMix& mix, const FalsificationSetup& setup,
                                       const FairnessOptions& fairness, std::uint64_t seed,
                                       std::uint64_t index);

}  // namespace slalom
