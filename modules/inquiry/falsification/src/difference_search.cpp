// SPDX-License-Identifier: BSD-3-Clause
#include "difference_search.h"

#include <slalom/generation/mutation.h>

#include <array>

namespace slalom {
namespace {

constexpr int kApproaches = 10;
constexpr int kClimbs = 5;             // after the approaches, or the run with the difference
constexpr int kWithoutDivergence = 3;  // candidates after which no run reaches the difference

/// Mutations of obstacles and of the task; those that change much, or the workspace, lead away from
/// the parent.
constexpr std::array kMutations = {Mutation::Move,      Mutation::Resize, Mutation::Remove,
                                   Mutation::Duplicate, Mutation::Add,    Mutation::MoveStartGoal};

std::optional<Scenario> changed(const Scenario& parent, const FalsificationSetup& setup,
                                RandomEngine& engine) {
  MutationLimits limits;
  limits.robot_radius = setup.run.robot.shape().enclosing_radius();
  limits.resolution = setup.run.simulation.resolution;
  limits.min_distance = 4 * limits.robot_radius;
  if (!parent.people().empty() && uniform_int(engine, 0, 1) == 0)
    return mutate_people(parent, limits, engine);
  const int which = uniform_int(engine, 0, static_cast<int>(kMutations.size()) - 1);
  return mutate(parent, kMutations[static_cast<std::size_t>(which)], limits, engine);
}

}  // namespace

std::unique_ptr<World> draw_changed_world(const Scenario& parent, const FalsificationSetup& setup,
                                          const FairnessOptions& fairness, RandomEngine& engine) {
  const auto child = changed(parent, setup, engine);
  if (!child) return nullptr;
  auto world = std::make_unique<World>(*child, setup.run.simulation.resolution);
  return has_fair_geometry(*world, setup.run.robot, fairness) ? std::move(world) : nullptr;
}

void DifferenceSearch::find_difference(std::uint64_t index, const std::function<void()>& alive) {
  constexpr std::uint64_t kWorlds = 40;
  difference_.reset();
  best_.reset();
  candidates_ = 0;
  const std::uint64_t seed = derive_seed(options_.seed, "probed", index);
  for (std::uint64_t i = 0; i < kWorlds && !difference_; ++i) {
    alive();
    const std::shared_ptr<const World> world =
        draw_fair_world(mix_, setup_, options_.fairness, seed, i);
    RandomEngine engine(derive_seed(seed, "poses", i));
    difference_ = i % 2 == 0 ? probe_.find_in_steps(world, engine) : probe_.find_in_run(world);
  }
}

std::unique_ptr<World> DifferenceSearch::draw(std::uint64_t index,
                                              const std::function<void()>& alive) {
  const int before_climbs = difference_ && difference_->in_run ? 1 : kApproaches;
  const bool is_over = candidates_ >= before_climbs + kClimbs ||
                       (candidates_ >= kWithoutDivergence && !best_.has_value());
  if (!difference_ || is_over) find_difference(index, alive);
  if (!difference_) return nullptr;
  RandomEngine engine(derive_seed(options_.seed, "approach", index));
  ++candidates_;
  if (difference_->in_run && candidates_ == 1)
    return std::make_unique<World>(difference_->world->scenario(),
                                   setup_.run.simulation.resolution);
  if (!difference_->in_run && candidates_ <= kApproaches)
    return approach(*difference_, setup_, options_.fairness, candidates_, engine);
  constexpr int kAttempts = 20;
  for (int attempt = 0; attempt < kAttempts && best_; ++attempt)
    if (auto world = draw_changed_world(*best_, setup_, options_.fairness, engine)) return world;
  difference_.reset();
  return nullptr;
}

void DifferenceSearch::report(const Scenario& scenario, const Trial& method,
                              const Trial& reference) {
  if (!difference_ || is_same_run(method, reference)) return;
  const double loss = reference.clearance - method.clearance;
  if (best_ && loss < best_loss_) return;
  best_ = scenario;
  best_loss_ = loss;
}

}  // namespace slalom
