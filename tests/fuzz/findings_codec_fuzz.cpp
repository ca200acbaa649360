#include "compression.h"
#include "findings_codec.h"
#include "fuzz_target.h"

namespace {

void read(const std::string& bytes) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const References references = deserialize_references(bytes, "input");
    fuzz::expect(
        serialize(deserialize_references(serialize(references), "again")) == serialize(references),
        "references that were written read back the same");
  });
  fuzz::read_or_refuse([&] {
    const Trajectory trajectory = deserialize_trajectory(bytes, "input");
    fuzz::expect(
        serialize(deserialize_trajectory(serialize(trajectory), "again")) == serialize(trajectory),
        "trajectories that were written read back the same");
  });
}

}  // namespace

/// What a result file keeps of references and trajectories.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = slalom::fuzz::text_of(data, size);
  read(bytes);
  read(slalom::compress(bytes));
  return 0;
}
