// SPDX-License-Identifier: BSD-3-Clause
#include "fuzz_target.h"

#include <slalom/falsification/search.h>

/// The file from which slalom-falsify continues a search.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const std::string written =
        to_bytes(search_state_from_bytes(fuzz::text_of(data, size), "input"));
    fuzz::expect(to_bytes(search_state_from_bytes(written, "copy")) == written,
                 "searches do not change when read and written");
  });
  return 0;
}
