// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/map_formats/world_import.h>

/// A world of Gazebo, mvsim or Stage.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const fuzz::InputFile file("room.world", fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] {
    const Scenario world = import_world(file.path(), {}).scenario;
    fuzz::expect(world.bounds().contains(world.goal()), "the goal is in the workspace");
  });
  return 0;
}
