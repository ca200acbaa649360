// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/map_formats/moving_ai.h>

/// The same bytes as a map and as its problem file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const fuzz::InputFile file("city.map", fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] {
    const auto map = read_moving_ai_map(file.path(), 0.5);
    fuzz::expect(map.getSizeX() > 0 && map.getSizeY() > 0, "a map has cells");
  });
  fuzz::read_or_refuse([&] { select_problems(read_moving_ai_problems(file.path()), {0, 9, 3}); });
  return 0;
}
