// SPDX-License-Identifier: BSD-3-Clause
#include "compression.h"
#include "fuzz_target.h"

#include <slalom/references/reference_codec.h>
#include <slalom/trajectory/trajectory_codec.h>

namespace {

void read(const std::string& bytes) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const References references = references_from_bytes(bytes, "input");
    fuzz::expect(
        to_bytes(references_from_bytes(to_bytes(references), "copy")) == to_bytes(references),
        "references do not change when written and read");
  });
  fuzz::read_or_refuse([&] {
    const Trajectory trajectory = trajectory_from_bytes(bytes, "input");
    fuzz::expect(
        to_bytes(trajectory_from_bytes(to_bytes(trajectory), "copy")) == to_bytes(trajectory),
        "trajectories do not change when written and read");
  });
}

}  // namespace

/// References and trajectories as workers send them, and compressed as in result files.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = slalom::fuzz::text_of(data, size);
  read(bytes);
  slalom::fuzz::read_or_refuse([&] { read(slalom::decompress(bytes, "input")); });
  return 0;
}
