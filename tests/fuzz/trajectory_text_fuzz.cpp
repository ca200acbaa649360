// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/io/trajectory_file.h>

/// Trajectory logs as CSV or TUM.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  for (const bool lateral : {false, true})
    fuzz::read_or_refuse([&] {
      const auto log = trajectory_from_text(fuzz::text_of(data, size), "input", lateral);
      fuzz::expect(log.trajectory.samples.size() >= 2, "a trajectory has two samples or more");
    });
  return 0;
}
