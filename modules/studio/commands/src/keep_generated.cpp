// SPDX-License-Identifier: BSD-3-Clause

#include "keep_generated.h"

namespace slalom {

std::vector<std::size_t> keep_generated(ScenarioList& list,
                                        const std::vector<GeneratedScenario>& part) {
  std::vector<std::size_t> already_present;
  list.in_transaction([&] {
    for (std::size_t i = 0; i < part.size(); ++i) {
      const GeneratedScenario& generated = part[i];
      if (!list.add(generated.scenario, {generated.generator, generated.seed, {}}))
        already_present.push_back(i);
      for (const KeyedValue& value : generated.values)
        list.store_value(generated.scenario.hash(), value);
    }
  });
  return already_present;
}

std::vector<KeyedValue> generated_values(const World& world, const DescribeOptions& options) {
  MemoryDescriptorStore store;
  return describe_world(world, options, store);
}

}  // namespace slalom
