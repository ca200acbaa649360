// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <arena_file.h>

/// A scenario of Arena.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const ArenaScenario scenario = arena_scenario_from_text(fuzz::text_of(data, size), "input");
    for (const Mover& mover : scenario.movers)
      fuzz::expect(mover.present(0), "people are there from the begin");
  });
  return 0;
}
