#include <slalom/generation/generate_mix.h>

#include <set>

namespace slalom {

std::vector<Scenario> generate_solvable(const Generator& generator, const GenerationTask& task,
                                        Progress& progress) {
  // The caller's generator outlives this call, so nobody has to own it.
  const std::shared_ptr<const Generator> borrowed(&generator, [](const Generator*) {});
  MixTask mix;
  mix.each = task;
  std::set<std::string> hashes;
  std::vector<Scenario> scenarios;
  generate_mix({{borrowed, 1, task.seed, task.name_prefix}}, mix, progress,
               [&](GeneratedScenario& generated) {
                 if (!hashes.insert(generated.scenario.hash()).second) return false;
                 scenarios.push_back(std::move(generated.scenario));
                 return true;
               });
  return scenarios;
}

}  // namespace slalom
