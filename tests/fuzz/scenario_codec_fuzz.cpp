// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"
#include "fuzz_target.h"

#include <slalom/io/scenario_list.h>

namespace {

void read(const std::string& bytes) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const Scenario scenario = deserialize_scenario(bytes, "input");
    const Scenario copy = deserialize_scenario(serialize(scenario), "copy");
    fuzz::expect(copy.hash() == scenario.hash(), "scenarios do not change when written and read");
  });
}

}  // namespace

/// Scenarios as stored in lists: uncompressed and compressed.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = slalom::fuzz::text_of(data, size);
  read(bytes);
  read(slalom::compress(bytes));
  return 0;
}
