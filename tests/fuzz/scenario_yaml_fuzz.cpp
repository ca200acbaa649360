#include "fuzz_target.h"

#include <slalom/io/scenario_yaml.h>

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const Scenario scenario = scenario_from_yaml(fuzz::text_of(data, size), "input");
    const Scenario again = scenario_from_yaml(scenario_to_yaml(scenario), "again");
    fuzz::expect(again.hash() == scenario.hash(), "YAML that was written reads back the same");
  });
  return 0;
}
