// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/map_formats/map_task.h>

/// The task file of an exported map.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] { parse_map_task(fuzz::text_of(data, size), "input"); });
  return 0;
}
