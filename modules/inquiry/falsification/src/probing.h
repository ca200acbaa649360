// SPDX-License-Identifier: BSD-3-Clause
#pragma once

#include "isolated_trials.h"

#include <slalom/core/random.h>
#include <slalom/falsification/fairness.h>

#include <memory>
#include <optional>

namespace slalom {

/// A pose in a world in which two methods answer the same observation with different commands.
struct CommandDifference {
  std::shared_ptr<const World> world;
  mrpt::math::TPose2D pose;
  mrpt::math::TPoint2D goal;
  bool in_run = false;  ///< it comes in the run from this pose, not in the first step
};

/// Compares commands of the method and of the first witness, its reference.
class StepProbe {
 public:
  StepProbe(const FalsificationSetup& setup, MethodPool& methods)
      : setup_(setup), methods_(methods) {}

  /// The first difference in single steps at random poses near obstacles, each after a reset. None
  /// for methods that use tracks or the map, which a single observation does not have.
  std::optional<CommandDifference> find_in_steps(const std::shared_ptr<const World>& world,
                                                 RandomEngine& engine);
  /// Whether there is one in the run of the reference, whose observations the method gets as well,
  /// so that its memory is that of a run.
  std::optional<CommandDifference> find_in_run(const std::shared_ptr<const World>& world);

 private:
  bool draw(const World& world, RandomEngine& engine, CommandDifference& probe) const;
  Command command(std::size_t method, const CommandDifference& probe,
                  const Observation& observation);

  const FalsificationSetup& setup_;
  MethodPool& methods_;
};

/// A scenario in which the robot comes to the pose by itself, the one of this number from 1. The
/// first one starts at the pose, if that is fair, the others up to 1.2 m behind it; from the sixth
/// on they are turned and shifted a little. None if no such start is fair.
std::unique_ptr<World> approach(const CommandDifference& difference,
                                const FalsificationSetup& setup, const FairnessOptions& fairness,
                                int number, RandomEngine& engine);

}  // namespace slalom
