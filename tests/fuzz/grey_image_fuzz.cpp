// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"
#include "map_readers.h"

/// Complete PGM images, and the headers of other formats.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const std::string bytes = fuzz::text_of(data, size);
  fuzz::read_or_refuse([&] {
    const GrayImage image = parse_pgm(bytes, "input");
    fuzz::expect(image.pixels.size() ==
                     static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                 "the number of pixels equals width x height");
  });
  fuzz::read_or_refuse([&] { check_image_size(bytes, "input"); });
  return 0;
}
