#include "compression.h"
#include "fuzz_target.h"

#include <slalom/io/scenario_list.h>

namespace {

void read(const std::string& bytes) {
  using namespace slalom;
  fuzz::read_or_refuse([&] {
    const Scenario scenario = deserialize_scenario(bytes, "input");
    const Scenario again = deserialize_scenario(serialize(scenario), "again");
    fuzz::expect(again.hash() == scenario.hash(), "bytes that were written read back the same");
  });
}

}  // namespace

/// What a list keeps of a scenario: as it is, and behind the compression's checksum.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const std::string bytes = slalom::fuzz::text_of(data, size);
  read(bytes);
  read(slalom::compress(bytes));
  return 0;
}
