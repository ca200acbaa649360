// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"
#include "map_readers.h"

/// A map_server YAML with an image of 3 x 2 pixels, map.pgm.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const fuzz::InputFile image("map.pgm", "P2 3 2 255 254 254 0 254 205 254");
  std::string yaml = fuzz::text_of(data, size);
  const std::string name = "map.pgm";
  if (const std::size_t at = yaml.find(name); at != std::string::npos)
    yaml.replace(at, name.size(), image.path());
  const fuzz::InputFile file("map.yaml", yaml);
  fuzz::read_or_refuse([&] {
    const auto map = read_ros_map(file.path());
    fuzz::expect(map.getSizeX() > 0 && map.getSizeY() > 0, "a map has cells");
  });
  return 0;
}
