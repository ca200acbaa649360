// SPDX-License-Identifier: BSD-3-Clause
#include "isolated_trials.h"
#include "obstacle_parts.h"
#include "shrinker.h"

#include <slalom/core/distance.h>
#include <slalom/core/math.h>
#include <slalom/falsification/candidates.h>
#include <slalom/falsification/neighbors.h>

#include <algorithm>
#include <array>
#include <cmath>

namespace slalom {
namespace {

/// Quantities that neighbors have in common: the logarithms of the sides of the workspace and of
/// the distance from start to goal.
using TaskSize = std::array<double, 3>;

TaskSize task_size(const Scenario& scenario) {
  const mrpt::math::TPoint2D start(scenario.start().x, scenario.start().y);
  return {math::log(scenario.bounds().width()), math::log(scenario.bounds().height()),
          math::log(std::max(1e-3, distance_between(start, scenario.goal())))};
}

double difference_of(const TaskSize& a, const TaskSize& b) {
  return std::abs(a[0] - b[0]) + std::abs(a[1] - b[1]) + std::abs(a[2] - b[2]);
}

std::vector<Scenario> successes_of_mix(TrialSource& trials, const FalsificationSetup& setup,
                                       const NeighborOptions& options, std::size_t runs) {
  const CandidateMix mix(setup.run.robot);
  const std::uint64_t seed = derive_seed(options.seed, "neighbors");
  std::vector<Scenario> successes;
  for (std::size_t i = 0; i < runs; ++i) {
    const auto world = draw_fair_world(mix, setup, options.fairness, seed, i);
    if (trials.trial(*world, 0).outcome == Outcome::Success) successes.push_back(world->scenario());
  }
  return successes;
}

/// Takes the nearest of `successes` that are left.
class Matcher {
 public:
  explicit Matcher(std::vector<Scenario> successes) : left_(std::move(successes)) {
    for (const Scenario& scenario : left_) sizes_.push_back(task_size(scenario));
  }
  std::vector<Scenario> take(const Scenario& failure, std::size_t count) {
    const TaskSize size = task_size(failure);
    std::vector<Scenario> taken;
    while (taken.size() < count && !left_.empty()) {
      const auto nearest = std::min_element(
          sizes_.begin(), sizes_.end(), [&size](const TaskSize& a, const TaskSize& b) {
            return difference_of(a, size) < difference_of(b, size);
          });
      const auto at = left_.begin() + (nearest - sizes_.begin());
      taken.push_back(std::move(*at));
      left_.erase(at);
      sizes_.erase(nearest);
    }
    return taken;
  }

 private:
  std::vector<Scenario> left_;
  std::vector<TaskSize> sizes_;
};

}  // namespace

std::optional<std::vector<std::vector<Scenario>>> successful_neighbors(
    const FalsificationSetup& setup, const std::vector<Scenario>& failures,
    const NeighborOptions& options) {
  std::vector<Scenario> successes;
  IsolatedTrials trials(setup, options.interrupted);
  const auto job = [&](TrialSource& source) {
    successes =
        successes_of_mix(source, setup, options, failures.size() * options.runs_per_failure);
  };
  if (!trials.execute(job)) return std::nullopt;
  Matcher matcher(std::move(successes));
  std::vector<std::vector<Scenario>> neighbors;
  for (const Scenario& failure : failures)
    neighbors.push_back(matcher.take(failure, options.per_failure));
  return neighbors;
}

std::vector<Scenario> one_removal_variants(const Scenario& scenario, double resolution) {
  const bool continuous = scenario.representation() == Representation::Continuous;
  const ObstacleParts parts(scenario, continuous ? 0 : kFinestBlock, resolution);
  std::vector<Scenario> variants;
  for (std::size_t i = 0; i < parts.size(); ++i) variants.push_back(parts.without(i));
  return variants;
}

}  // namespace slalom
