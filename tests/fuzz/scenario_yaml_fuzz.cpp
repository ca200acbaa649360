// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/io/scenario_yaml.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const Scenario scenario = scenario_from_yaml(fuzz::text_of(data, size), "input");
    const Scenario copy = scenario_from_yaml(scenario_to_yaml(scenario), "copy");
    fuzz::expect(copy.hash() == scenario.hash(),
                 "scenarios do not change when written as YAML and read");
  });
  return 0;
}
