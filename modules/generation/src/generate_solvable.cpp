#include "solvable.h"

namespace slalom {

std::vector<Scenario> generate_solvable(const Generator& generator, const GenerationTask& task,
                                        Progress& progress) {
  SolvableSearch search(task);
  std::vector<Scenario> scenarios;
  progress.start("Generating scenarios", static_cast<std::size_t>(task.count));
  for (int i = 0; i < task.count; ++i) {
    const std::string name = search.name_of(i);
    const std::uint64_t seed =
        derive_seed(task.seed, "scenario/" + generator.name(), static_cast<std::uint64_t>(i));
    scenarios.push_back(search.find(name, [&](int attempt, std::string&) {
      RandomEngine engine(derive_seed(seed, "attempt", static_cast<std::uint64_t>(attempt)));
      return std::make_optional(generator.generate(name, engine));
    }));
    progress.advance(scenarios.size());
  }
  progress.finish();
  return scenarios;
}

}  // namespace slalom
