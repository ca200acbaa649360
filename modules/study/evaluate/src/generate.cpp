// SPDX-License-Identifier: BSD-3-Clause
#include "callback_progress.h"

#include <slalom/core/available_cores.h>
#include <slalom/generation/generate_mix.h>

namespace slalom {

std::vector<Scenario> generate(std::shared_ptr<const Generator> family, int count,
                               std::uint64_t seed, const Options& options) {
  const std::string name = family->name();
  MixSettings mix;
  mix.each.count = count;
  mix.each.robot_radius = options.robot.shape().enclosing_radius();
  mix.each.footprint = options.robot.turning_polygon();
  mix.each.resolution = options.simulation.resolution;
  mix.jobs = worker_count(options.workers);
  mix.walkers = options.walkers;
  mix.people = options.generated_people;
  mix.each.goal_headings = options.goal_headings;
  CallbackProgress progress(options);
  DistinctScenarios distinct;
  generate_mix({{std::move(family), 1, source_seed(seed, name), name}}, mix, progress,
               [&](std::vector<GeneratedScenario>& batch) { return distinct.add(batch); });
  return distinct.take();
}

}  // namespace slalom
