// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/io/movers_file.h>

/// Recorded positions as CSV or obsmat.txt.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const std::string text = fuzz::text_of(data, size);
  for (const MoversFileOptions options :
       {MoversFileOptions{}, MoversFileOptions{0.3, 1.5, 0}, MoversFileOptions{0.3, 2, 15}})
    fuzz::read_or_refuse([&] {
      const Movers movers = movers_from_text(text, "input", options);
      fuzz::expect(!movers.empty(), "a file has a mover");
      for (const Mover& mover : movers) {
        fuzz::expect(mover.waypoints.back().t >= 0, "a mover is there during the run");
        fuzz::expect(mover.waypoints.size() < 2 || mover.waypoints[1].t > 0,
                     "positions before the beginning are dropped");
      }
    });
  return 0;
}
