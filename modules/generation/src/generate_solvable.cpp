#include <slalom/generation/generate_mix.h>

namespace slalom {

std::vector<Scenario> generate_solvable(const Generator& generator, const GenerationTask& task,
                                        Progress& progress) {
  // The caller's generator outlives this call, so nobody has to own it.
  const std::shared_ptr<const Generator> borrowed(&generator, [](const Generator*) {});
  MixTask mix;
  mix.each = task;
  DistinctScenarios distinct;
  generate_mix({{borrowed, 1, task.seed, task.name_prefix}}, mix, progress,
               [&](std::vector<GeneratedScenario>& part) { return distinct.add(part); });
  return distinct.take();
}

}  // namespace slalom
