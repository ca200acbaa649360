// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"
#include "map_readers.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const fuzz::InputFile file("map.gridmap", fuzz::text_of(data, size));
  fuzz::read_or_refuse([&] {
    const auto map = read_gridmap(file.path());
    fuzz::expect(map.getSizeX() > 0 && map.getSizeY() > 0, "a map has cells");
  });
  return 0;
}
