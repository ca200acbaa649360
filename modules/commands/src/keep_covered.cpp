#include <slalom/commands/keep_covered.h>

namespace slalom {
namespace {

std::string tag_of(const BinReport& bin) {
  std::string tag = "bin";
  for (const std::size_t slot : bin.position) tag += "_" + std::to_string(slot);
  return tag;
}

}  // namespace

void keep_covered(ScenarioList& list, const CoveragePlan& plan, const CoverageResult& result) {
  list.in_one_step([&] {
    for (const CoveredScenario& covered : result.scenarios) {
      const std::string tag = tag_of(result.bins[covered.bin]);
      list.add(covered.scenario, {"coverage", covered.seed, {tag}});
      for (const GeneratedValue& value : covered.values)
        list.keep(covered.scenario.hash(), value.id, value.version, value.parameters, value.value);
    }
    list.set_note("coverage", render_coverage(plan, result));
  });
}

}  // namespace slalom
