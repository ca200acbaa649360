// SPDX-License-Identifier: BSD-3-Clause
#include <slalom/generation/generate_mix.h>

namespace slalom {

std::vector<Scenario> generate_solvable(const Generator& generator,
                                        const GenerationSettings& settings, Progress& progress) {
  // Non-owning: the caller's generator outlives this call.
  const std::shared_ptr<const Generator> borrowed(&generator, [](const Generator*) {});
  MixSettings mix;
  mix.each = settings;
  DistinctScenarios distinct;
  generate_mix({{borrowed, 1, settings.seed, settings.name_prefix}}, mix, progress,
               [&](std::vector<GeneratedScenario>& batch) { return distinct.add(batch); });
  return distinct.take();
}

}  // namespace slalom
