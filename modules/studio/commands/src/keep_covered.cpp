// SPDX-License-Identifier: BSD-3-Clause

#include "keep_covered.h"

namespace slalom {
namespace {

std::string tag_of(const BinReport& bin) {
  std::string tag = "bin";
  for (const std::size_t slot : bin.position) tag += "_" + std::to_string(slot);
  return tag;
}

}  // namespace

void keep_covered(ScenarioList& list, const CoveragePlan& plan, const CoverageResult& result) {
  list.in_transaction([&] {
    for (const CoveredScenario& covered : result.scenarios) {
      const std::string tag = tag_of(result.bins[covered.bin]);
      list.add(covered.scenario, {"coverage", covered.seed, {tag}});
      for (const KeyedValue& value : covered.values)
        list.store_value(covered.scenario.hash(), value);
    }
    list.set_note("coverage", render_coverage(plan, result));
  });
}

}  // namespace slalom
