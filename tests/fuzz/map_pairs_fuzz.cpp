// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/map_formats/map_pairs.h>

#include <cmath>

/// Files of pairs of start and goal, with and without a start for goals alone.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const std::string text = fuzz::text_of(data, size);
  for (const auto& start :
       {std::optional<mrpt::math::TPose2D>(), std::optional(mrpt::math::TPose2D())})
    fuzz::read_or_refuse([&] {
      for (const MapPair& pair : parse_map_pairs(text, "input", start))
        fuzz::expect(std::isfinite(pair.start.x) && std::isfinite(pair.goal.y), "poses are finite");
    });
  return 0;
}
