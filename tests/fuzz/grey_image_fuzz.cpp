#include "fuzz_target.h"
#include "map_readers.h"

/// PGM as a whole, and the heads of other images.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  const std::string bytes = fuzz::text_of(data, size);
  fuzz::read_or_refuse([&] {
    const GreyImage image = parse_pgm(bytes, "input");
    fuzz::expect(image.pixels.size() ==
                     static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height),
                 "an image has the pixels that its size says");
  });
  fuzz::read_or_refuse([&] { expect_possible_image(bytes, "input"); });
  return 0;
}
