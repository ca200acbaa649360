#pragma once

#include "contained_trials.h"

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
};

/// Compares single steps of the method and of the first witness, its reference, at random poses
/// near obstacles, each after a reset. Finds differences that depend on one observation; those that
/// depend on earlier ones are not seen.
class StepProbe {
 public:
  StepProbe(const TestBench& bench, BenchMethods& methods) : bench_(bench), methods_(methods) {}

  /// The first difference at the poses that are drawn in this world.
  std::optional<CommandDifference> find(const std::shared_ptr<const World>& world,
                                        RandomEngine& engine);

 private:
  bool draw(const World& world, RandomEngine& engine, CommandDifference& probe) const;
  Command command(std::size_t method, const CommandDifference& probe, double speed,
                  const mrpt::obs::CObservation2DRangeScan& scan);

  const TestBench& bench_;
  BenchMethods& methods_;
};

/// A scenario in which the robot comes to the pose by itself: the start is up to 1.2 m behind it,
/// sometimes turned and shifted a little. None if no such start is fair.
std::unique_ptr<World> approach(const CommandDifference& difference, const TestBench& bench,
                                const FairnessOptions& fairness, RandomEngine& engine);

}  // namespace slalom
