// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"
#include "npy.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const NpyTable table = parse_npy(fuzz::text_of(data, size), "input");
    fuzz::expect(table.values.size() == table.rows * table.columns,
                 "a table has rows x columns values");
  });
  return 0;
}
